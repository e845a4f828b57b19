"""Loops and couplings as files tell them, by names, and what they are in a model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from adagen.exact import exact, rotation_from_rpy, rotation_taking_z_to
from adagen.model.loops import LOOP_WORDS, Coupling, Loop
from adagen.model.model import Frame, Model
from adagen.model.rigid import Pose

Triple = tuple[float, float, float]
WORLD = "__world__"
"""Name of the ground as an end of a loop, whatever the base."""


@dataclass(frozen=True)
class LoopEnd:
    """A frame on a link: ``xyz`` (m) and ``rpy`` (rad, fixed axes) in the frame of the link."""

    link: str
    xyz: Triple = (0.0, 0.0, 0.0)
    rpy: Triple = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class NamedLoop:
    """A loop joint between two frames.

    Attributes:
        name: its name.
        kind: a key of ``LOOP_WORDS``.
        end1: frame 1.
        end2: frame 2.
        axis: in frame 1, and the same components in frame 2; of any length but zero.
        axis2: second axis of a universal joint, in frame 2.
        tolerance: how far it may be open in a state, m and rad.
    """

    name: str
    kind: str
    end1: LoopEnd
    end2: LoopEnd
    axis: Triple = (0.0, 0.0, 1.0)
    axis2: Triple = (0.0, 0.0, 1.0)
    tolerance: float = Loop.tolerance


@dataclass(frozen=True)
class NamedCoupling:
    """Coordinates of joints that are tied: the sum of factor * q[joint] is ``offset``."""

    name: str
    terms: tuple[tuple[str, float], ...]
    offset: float = 0.0
    tolerance: float = Coupling.tolerance


def closed(
    model: Model,
    loops: Sequence[NamedLoop],
    couplings: Sequence[NamedCoupling],
    link: Callable[[str], tuple[int, Frame | None]],
    joint: Callable[[str], int],
) -> Model:
    """Return a model with further loops and couplings.

    Args:
        model: the robot.
        loops: what closes it; ends on links of the robot or on ``WORLD``.
        couplings: what ties joints of one degree of freedom.
        link: number of the link that a name belongs to, and its frame if it is fixed to that.
        joint: index of a joint.
    """

    def placed(end: LoopEnd, axis: Triple) -> tuple[int, Frame]:
        number, frame = (0, None) if end.link == WORLD else link(end.link)
        pose = Pose.home()
        if frame is not None:
            pose = pose.then(exact(frame.rotation), exact(frame.translation))
        pose = pose.then(rotation_from_rpy(end.rpy), exact(end.xyz))
        turned = pose.then(rotation_taking_z_to(axis), exact([0.0, 0.0, 0.0]))
        return number, turned.frame(end.link)

    def made(said: NamedLoop) -> Loop:
        kind = LOOP_WORDS[said.kind]
        z = (0.0, 0.0, 1.0)
        first = said.axis if kind.axes else z
        second = said.axis2 if kind.axes == 2 else first
        (link1, frame1), (link2, frame2) = placed(said.end1, first), placed(said.end2, second)
        return Loop(said.name, kind, link1, frame1, link2, frame2, said.tolerance)

    tied = [
        Coupling(c.name, tuple((joint(name), x) for name, x in c.terms), c.offset, c.tolerance)
        for c in couplings
    ]
    return replace(
        model,
        loops=(*model.loops, *map(made, loops)),
        couplings=(*model.couplings, *tied),
    )
