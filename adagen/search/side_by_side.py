"""The least that one process takes for some limbs: rows are no wider than what lies side by side.

A row holds joints of one kind none of which hangs on another. Where a process has two chains of
revolute joints and nothing else, no row has more than two; the floors of the whole robot
(adagen.search.floors) would share the price of a row of four.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

from adagen.search.floors import NOTHING, Floor, Floors
from adagen.search.limbs import Limb

_MOST = 4
"""Joints in a row."""


@dataclass(frozen=True)
class _Alike:
    """The joints of a limb that are of one kind.

    Attributes:
        width: how many of them none of which hangs on another.
        shares: the least that they take where 0, 1, 2 and 3 joints of other limbs lie beside them
            at most.
    """

    width: int
    shares: tuple[Floor, ...]


@dataclass(frozen=True)
class LimbFloor:
    """The least that a limb takes, by how many of its joints can share rows.

    Attributes:
        fixed: what no row shares: joints passed towards the ground's side, the root.
        kinds: the other joints, by their kinds.
    """

    fixed: Floor
    kinds: dict[str, _Alike]


class SideBySide:
    """Floors of sets of limbs.

    Args:
        floors: of the robot's joints.
    """

    def __init__(self, floors: Floors) -> None:
        self.floors = floors
        self._known: dict[Limb, LimbFloor] = {}

    def of(self, limb: Limb) -> LimbFloor:
        """Return what a limb takes at least."""
        if limb not in self._known:
            self._known[limb] = self._limb(limb)
        return self._known[limb]

    def least(self, limbs: Iterable[LimbFloor], beside: Iterable[LimbFloor] | None = None) -> Floor:
        """Return the least that limbs take, without what a process takes besides.

        Args:
            limbs: the limbs.
            beside: all limbs with which they may share rows, themselves included; by default no
                others.
        """
        own = list(limbs)
        widths: defaultdict[str, int] = defaultdict(int)
        for limb in own if beside is None else beside:
            for kind, alike in limb.kinds.items():
                widths[kind] += alike.width
        total = NOTHING
        for limb in own:
            total = total.plus(limb.fixed)
            for kind, alike in limb.kinds.items():
                others = min(widths[kind] - alike.width, _MOST - 1)
                total = total.plus(alike.shares[others])
        return total

    def _limb(self, limb: Limb) -> LimbFloor:
        joints = self.floors.robot.joints
        fixed, way = NOTHING, set[int]()
        if limb.up:
            fixed = self.floors.upwards(limb)
            link = limb.link
            while link > 0:
                way.add(link - 1)
                fixed = fixed.plus(self.floors.passed[link - 1])
                link = joints[link - 1].parent
        own: defaultdict[str, list[int]] = defaultdict(list)
        for j in limb.joints:
            if j not in way:
                own[joints[j].kind].append(j)
        return LimbFloor(fixed, {kind: self._alike(of) for kind, of in own.items()})

    def _alike(self, own: list[int]) -> _Alike:
        """Joints of one kind, by what can lie beside each of them in the limb and beyond it."""
        floors, (width, beside) = self.floors, self._widths(own)
        most = floors.most.get(floors.robot.joints[own[0]].kind, 1)
        shares = []
        for others in range(_MOST):
            total = NOTHING
            for j in own:
                total = total.plus(floors.of_row(j, min(1 + beside[j] + others, most)))
            shares.append(total)
        return _Alike(width, tuple(shares))

    def _widths(self, own: list[int]) -> tuple[int, dict[int, int]]:
        """How many joints there are none of which hangs on another: of all, and beside each one."""
        parents = [joint.parent for joint in self.floors.robot.joints]
        inside = set(own)
        widest: defaultdict[int, int] = defaultdict(int)  # beyond each link
        beyond: dict[int, int] = {}  # of each joint and what hangs on it
        for j in range(max(inside), -1, -1):
            if here := max(widest[j + 1], j in inside):
                beyond[j] = here
                widest[parents[j]] += here
        beside: dict[int, int] = {-1: 0}  # of each joint, the ground first
        for j in sorted(beyond):
            beside[j] = beside[parents[j] - 1] + widest[parents[j]] - beyond[j]
        return widest[0], {j: beside[j] for j in own}
