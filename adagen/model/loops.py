"""Closed loops: joints that join two links of the tree, and couplings of joint coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from adagen.model.links import Frame

Array = NDArray[np.float64]


@dataclass(frozen=True)
class LoopKind:
    """Constraints of a loop joint between its two frames, in axes of frame 1; its axis is z.

    Attributes:
        name: as scene files name it.
        linear: axes along which the origins stay together.
        angular: axes about which the frames do not turn against each other; of a universal joint
            z stands for the common normal of its two axes.
        axes: how many axes define it: 0, 1 or, of a universal joint, 2.
    """

    name: str
    linear: tuple[int, ...]
    angular: tuple[int, ...]
    axes: int

    @property
    def rows(self) -> int:
        """Constraints that it is."""
        return len(self.linear) + len(self.angular)

    @property
    def sliding(self) -> tuple[int, ...]:
        """Axes along which the origins move apart."""
        return tuple(k for k in range(3) if k not in self.linear)


_ALL = (0, 1, 2)
LOOP_KINDS = {
    kind.name: kind
    for kind in (
        LoopKind("weld", _ALL, _ALL, 0),
        LoopKind("spherical", _ALL, (), 0),
        LoopKind("revolute", _ALL, (0, 1), 1),
        LoopKind("prismatic", (0, 1), _ALL, 1),
        LoopKind("cylindrical", (0, 1), (0, 1), 1),
        LoopKind("universal", _ALL, (2,), 2),
        LoopKind("planar", (2,), (0, 1), 1),
    )
}
"""Kinds of loop joints by name."""

LOOP_WORDS = {**LOOP_KINDS, "point": LOOP_KINDS["spherical"]}
"""Kinds of loop joints by the words that files use."""


@dataclass(frozen=True, eq=False)
class Loop:
    """A joint that closes a loop of the tree; it carries no effort.

    Attributes:
        name: its name.
        kind: its kind.
        link1: index of the link that frame 1 is fixed to; 0 is the ground.
        frame1: its pose in that link's frame; z is the axis.
        link2: index of the link that frame 2 is fixed to.
        frame2: likewise; z is the axis, of a universal joint the second one.
        tolerance: how far it may be open in a state, m and rad.
        turn2: of frame 2 in the frame that its description has there, 3x3; empty for the same.
    """

    name: str
    kind: LoopKind
    link1: int
    frame1: Frame
    link2: int
    frame2: Frame
    tolerance: float = 1e-4
    turn2: tuple[tuple[float, ...], ...] = ()

    @property
    def links(self) -> tuple[int, int]:
        """Both links."""
        return self.link1, self.link2

    @property
    def ends(self) -> tuple[tuple[int, Frame], tuple[int, Frame]]:
        """Both links with their frames."""
        return (self.link1, self.frame1), (self.link2, self.frame2)


@dataclass(frozen=True)
class Coupling:
    """Joints of one degree of freedom whose coordinates are tied: the sum of factor * q is offset.

    Attributes:
        name: what messages call it.
        terms: joints by index, each with its factor.
        offset: m or rad.
        tolerance: how far it may be off in a state, in the same units.
    """

    name: str
    terms: tuple[tuple[int, float], ...]
    offset: float
    tolerance: float = 1e-4


def open_by(loop: Loop) -> float:
    """Return how far a loop between frames on one link is open, m and rad."""
    (one, other), kind = (loop.frame1, loop.frame2), loop.kind
    apart = one.rotation.T @ (other.translation - one.translation)
    gaps = [float(apart[k]) for k in kind.linear]
    gaps.extend(misaligned(kind, one.rotation, other.rotation))
    return max(map(abs, gaps), default=0.0)


def misaligned(kind: LoopKind, one: Array, other: Array) -> list[float]:
    """Return what the held axes of two frames are out of line by, rad to first order.

    Args:
        kind: of the loop.
        one: axes of frame 1 as columns, shape (3, 3).
        other: axes of frame 2, expressed in the same axes.
    """
    if kind.axes == 2:
        return [float(one[:, 2] @ other[:, 2])]
    if not kind.angular:
        return []
    aligned = range(3) if len(kind.angular) == 3 else (2,)
    gaps = np.concatenate([other[:, k] - one[:, k] for k in aligned])
    return [float(x) for x in gaps]
