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
        shares: the least that they take in rows of 1, 2, 3 and 4 joints at most.
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
                total = total.plus(alike.shares[min(widths[kind], _MOST) - 1])
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
        found = {kind: _Alike(self._width(of), self._shares(of)) for kind, of in own.items()}
        return LimbFloor(fixed, found)

    def _shares(self, joints: Iterable[int]) -> tuple[Floor, ...]:
        own, found = list(joints), []
        for count in range(1, _MOST + 1):
            total = NOTHING
            for j in own:
                most = self.floors.most.get(self.floors.robot.joints[j].kind, 1)
                total = total.plus(self.floors.of_row(j, min(count, most)))
            found.append(total)
        return tuple(found)

    def _width(self, joints: Iterable[int]) -> int:
        """How many of some joints there are none of which hangs on another."""
        parents = [joint.parent for joint in self.floors.robot.joints]
        inside = set(joints)
        beyond: defaultdict[int, int] = defaultdict(int)  # by link
        for j in range(max(inside), -1, -1):
            here = max(beyond.pop(j + 1, 0), j in inside)
            if here:
                beyond[parents[j]] += here
        return beyond[0]
