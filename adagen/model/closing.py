"""Loops and couplings by names, as in files, and their conversion to a model."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from adagen.exact import exact, rotation_from_rpy, rotation_taking_z_to, rounded
from adagen.model.links import Frame
from adagen.model.loops import LOOP_WORDS, Coupling, Loop, open_by
from adagen.model.model import Model
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
    """Coordinates of joints that are tied: the sum of factor * q[joint] is ``offset``.

    Attributes:
        name: its name.
        terms: joints by name, each with its factor; not all of these are zero.
        offset: m or rad.
        tolerance: how far the sum may be off in a state; None: the usual, for factors near one.
    """

    name: str
    terms: tuple[tuple[str, float], ...]
    offset: float = 0.0
    tolerance: float | None = None


_ORDINARY = 10
"""Binary orders by which the largest factor of a coupling may differ from one."""


def tied(
    name: str,
    terms: Sequence[tuple[int, float]],
    offset: float,
    tolerance: float | None = None,
) -> Coupling:
    """Return a coupling whose largest factor is not far from one, by a power of two.

    Otherwise it would be rounding beside other constraints, or these beside it.

    Args:
        name: what messages call it.
        terms: joints by index, each with its factor; not all of these are zero.
        offset: of their sum.
        tolerance: of their sum; None: the usual one, of factors near one.
    """
    order = round(math.log2(max(abs(factor) for _, factor in terms)))
    by = 2.0 ** -max(min(order, 900), -900) if abs(order) > _ORDINARY else 1.0
    return Coupling(
        name,
        tuple((joint, factor * by) for joint, factor in terms),
        offset * by,
        Coupling.tolerance if tolerance is None else tolerance * by,
    )


def closed(
    model: Model,
    loops: Sequence[NamedLoop],
    couplings: Sequence[NamedCoupling],
    link: Callable[[str], tuple[int, Frame | None]],
    joint: Callable[[str], int],
) -> Model:
    """Return a model with further loops and couplings; mimic joints at them are couplings, too.

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

    def made(named: NamedLoop) -> Loop:
        kind = LOOP_WORDS[named.kind]
        z = (0.0, 0.0, 1.0)
        first = named.axis if kind.axes else z
        second = named.axis2 if kind.axes == 2 else first
        (link1, frame1), (link2, frame2) = placed(named.end1, first), placed(named.end2, second)
        turn = rounded(rotation_taking_z_to(second)).tolist() if kind.axes else []
        turn2 = tuple(map(tuple, turn))
        return Loop(named.name, kind, link1, frame1, link2, frame2, named.tolerance, turn2)

    more = [
        tied(c.name, [(joint(name), x) for name, x in c.terms], c.offset, c.tolerance)
        for c in couplings
    ]
    return _coupled_mimics(
        replace(
            model,
            loops=(*model.loops, *map(made, loops)),
            couplings=(*model.couplings, *more),
        )
    )


def _coupled_mimics(model: Model) -> Model:
    """Return a model whose mimic joints at loops are couplings, named as the joints.

    A loop cannot go over a joint that has no say in its motion; as a coupling, the mimic is one of
    the constraints.
    """
    on_loops = set().union(*(_between(model, loop) for loop in model.loops))
    on_loops |= {j for coupling in model.couplings for j, _ in coupling.terms}
    for j, joint in enumerate(model.joints):
        if joint.mimic is not None and on_loops & {j, joint.mimic.source}:
            terms = ((j, 1.0), (joint.mimic.source, -joint.mimic.multiplier))
            coupling = tied(joint.name, terms, joint.mimic.offset)
            free = replace(joint, mimic=None)
            joints = (*model.joints[:j], free, *model.joints[j + 1 :])
            couplings = (*model.couplings, coupling)
            return _coupled_mimics(replace(model, joints=joints, couplings=couplings))
    return model


def _between(model: Model, loop: Loop) -> set[int]:
    """Joints between the ends of a loop."""
    ways: list[set[int]] = []
    for link in loop.links:
        way, at = set[int](), link
        while at > 0:
            way.add(at - 1)
            at = model.joints[at - 1].parent
        ways.append(way)
    return ways[0] ^ ways[1]


def places(model: Model) -> dict[str, tuple[int, Frame | None]]:
    """Return the number of the link that each link's name belongs to, and its frame if lumped."""
    found: dict[str, tuple[int, Frame | None]] = {}
    for k, link in enumerate(model.links):
        found[link.name] = (k, None)
        found.update({frame.name: (k, frame) for frame in link.frames})
    return found


def with_loops_checked(model: Model, refusal: Callable[[Loop, str], Exception]) -> Model:
    """Return the model without loops between frames on one link, which hold by themselves.

    Args:
        model: the robot.
        refusal: makes the refusal of a loop, of which the words say why it cannot close.

    Raises:
        Exception: the refusal of a loop that no configuration can close.
    """
    kept = []
    for loop in model.loops:
        if loop.link1 != loop.link2:
            kept.append(loop)
        elif (gap := open_by(loop)) > loop.tolerance:
            raise refusal(
                loop, f"cannot close: its links are locked together, and it is open by {gap:.2g}"
            )
        sides = reach(model, loop)
        if sides is not None and sides[0] > sides[1] + loop.tolerance:
            raise refusal(
                loop,
                f"cannot close: one of its links spans {sides[0]:.3g} m, all others together "
                f"{sides[1]:.3g} m",
            )
    return replace(model, loops=tuple(kept))


def reach(model: Model, loop: Loop) -> tuple[float, float] | None:
    """Return the longest side of the polygon that a loop's links form, and all others' sum, m.

    A loop in which the first is more than the second cannot close. Corners are joints that turn
    alone; None where joints or the loop itself slide.
    """
    if loop.kind.sliding:
        return None
    sides, corners = [], {0: loop.frame1.translation, 1: loop.frame2.translation}
    links = [loop.link1, loop.link2]
    while links[0] != links[1]:
        end = 0 if links[0] > links[1] else 1  # parents come before children
        joint = model.joints[links[end] - 1]
        if joint.kind.name not in ("revolute", "spherical"):
            return None
        sides.append(float(np.linalg.norm(corners[end])))
        links[end], corners[end] = joint.parent, joint.translation
    sides.append(float(np.linalg.norm(corners[0] - corners[1])))
    return max(sides), sum(sides) - max(sides)
