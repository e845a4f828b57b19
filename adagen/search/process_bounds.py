"""Lower bounds for the limbs of one process: a row is no wider than its independent joints.

A row holds joints of one kind none of which hangs on another. Where a process has two chains of
revolute joints and nothing else, no row has more than two; the bounds of the whole robot
(adagen.search.joint_bounds) would share the price of a row of four. And the first rows of a
process hold joints that are next to the base alone (adagen.search.base_row_bound).
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from math import inf
from operator import attrgetter
from typing import Literal, get_args

import numpy as np

from adagen.plan.robot import PlanJoint
from adagen.search.base_row_bound import FirstRows, Levels, together
from adagen.search.joint_bounds import JointBounds
from adagen.search.limbs import Limb
from adagen.search.sweep_bound import NOTHING, SweepBound

_MOST = 4
"""Joints in a row."""
_LEVELS = 64
"""First rows that are looked at."""
_number = attrgetter("number")

Part = Literal["inwards", "both"]
"""Which of a bound's times is asked for."""
_PARTS: tuple[Part, ...] = get_args(Part)


@dataclass(frozen=True)
class _Alike:
    """The joints of a limb that are of one kind.

    Attributes:
        count: how many there are.
        width: how many of them none of which hangs on another.
        shares: the least that they take where 0, 1, 2 and 3 joints of other limbs lie beside them
            at most.
        full: the least that they take in rows as wide as the robot has them.
        levels: how deep they are.
    """

    count: int
    width: int
    shares: tuple[SweepBound, ...]
    full: SweepBound
    levels: Levels

    @property
    def contents(self) -> tuple[object, ...]:
        """All that it consists of, to be compared with others."""
        deep = self.levels.within.tobytes(), self.levels.depth, self.levels.filling
        return self.count, self.width, self.shares, self.full, deep


@dataclass(frozen=True, eq=False)
class LimbBound:
    """The least that a limb takes, by how many of its joints can share rows.

    Attributes:
        fixed: what no row shares: joints passed towards the ground's side, the root.
        kinds: the other joints, by their kinds.
        full: all of it, in rows as wide as the robot has them.
        number: of it among those that are known.
    """

    fixed: SweepBound
    kinds: dict[str, _Alike]
    full: SweepBound
    number: int = 0

    @property
    def contents(self) -> tuple[object, ...]:
        """All that it consists of, to be compared with others."""
        kinds = ((kind, alike.contents) for kind, alike in self.kinds.items())
        return self.fixed, self.full, tuple(kinds)


@dataclass(frozen=True)
class _InCore:
    """What joints of a kind take at least, microseconds.

    Attributes:
        alone: by itself, as each process that takes part passes it.
        above: the same above its share of a full row.
        share: of a full row.
    """

    alone: float
    above: float
    share: float


class ProcessBounds:
    """Lower bounds of sets of limbs.

    Args:
        joint_bounds: of the robot's joints.
    """

    def __init__(self, joint_bounds: JointBounds) -> None:
        self.joint_bounds = joint_bounds
        self._known: dict[Limb, LimbBound] = {}
        self._same: dict[tuple[object, ...], LimbBound] = {}
        self._least: dict[tuple[tuple[LimbBound, ...], ...], SweepBound] = {}
        self._first: dict[tuple[str, Part, bool], FirstRows] = {}
        self._cores: dict[str, _InCore] = {}
        depths = [0] * (len(joint_bounds.robot.joints) + 1)
        for j, joint in enumerate(joint_bounds.robot.joints):
            depths[j + 1] = depths[joint.parent] + 1
        self._depth = min(max(depths), _LEVELS)

    def of(self, limb: Limb) -> LimbBound:
        """Return what a limb takes at least."""
        if limb not in self._known:  # equal limbs, as both arms, have one bound
            found = self._limb(limb)
            same = replace(found, number=len(self._same))
            self._known[limb] = self._same.setdefault(found.contents, same)
        return self._known[limb]

    def least(
        self, limbs: Iterable[LimbBound], beside: Iterable[LimbBound] | None = None
    ) -> SweepBound:
        """Return the least that limbs take, without what a process takes besides.

        Args:
            limbs: the limbs.
            beside: all limbs with which they may share rows, themselves included; by default no
                others.
        """
        own = tuple(sorted(limbs, key=_number))
        there = own if beside is None else tuple(sorted(beside, key=_number))
        if (own, there) not in self._least:  # processes of several numbers are asked for the same
            self._least[own, there] = self._of_all(own, there)
        return self._least[own, there]

    def _of_all(self, own: Sequence[LimbBound], there: Sequence[LimbBound]) -> SweepBound:
        """The least that limbs take among others with which they may share rows."""
        widths, counts = Counter[str](), Counter[str]()
        for limb in there:
            for kind, alike in limb.kinds.items():
                widths[kind] += alike.width
                counts[kind] += alike.count
        of_kind: defaultdict[str, list[_Alike]] = defaultdict(list)
        inwards = outwards = both = 0.0
        for limb in own:
            inwards += limb.fixed.inwards
            outwards += limb.fixed.outwards
            both += limb.fixed.both
            for kind, alike in limb.kinds.items():
                of_kind[kind].append(alike)
        for kind, found in of_kind.items():
            total, full = [0.0, 0.0, 0.0], [0.0, 0.0]
            others, width = counts[kind], widths[kind]
            for alike in found:  # written without calls: it runs for every set of limbs
                beside = width - alike.width
                share = alike.shares[beside if beside < _MOST else _MOST - 1]
                total[0] += share.inwards
                total[1] += share.outwards
                total[2] += share.both
                full[0] += alike.full.inwards
                full[1] += alike.full.both
                others -= alike.count
            levels = together([alike.levels for alike in found])
            first = [self._first_rows(kind, part).least(levels, others) for part in _PARTS]
            inwards += max(total[0], full[0] + first[0])
            outwards += total[1]
            both += max(total[2], full[1] + first[1])
        return SweepBound(inwards, outwards, both)

    def busiest(
        self,
        limbs: Sequence[LimbBound],
        processes: int,
        besides: Callable[[int], float],
        *,
        others: Sequence[LimbBound] = (),
    ) -> float:
        """Return the least that the busiest of some processes takes for limbs.

        Either few of them have the limbs that reach deep, and much to do; or many have, each with
        first rows of its own that are narrow. A core may grow into limbs: those that take part in
        it pass its joints one by one, and each has parts of the limbs.

        Args:
            limbs: the limbs.
            processes: that share them.
            besides: what so many of the processes take besides at least, all together.
            others: further limbs that they share, of which nothing is said but that their joints
                may be in any rows.
        """
        every = [*limbs, *others]
        rest, whole = besides(processes), sum(limb.full.both for limb in every)
        even = (whole + rest) / processes
        counts = Counter[str]()
        for limb in limbs:
            for kind, alike in limb.kinds.items():
                counts[kind] += alike.count
        if processes == 1 or not counts:
            return even
        kind = counts.most_common(1)[0][0]
        levels = [limb.kinds[kind].levels for limb in limbs if kind in limb.kinds]
        if not (deepest := max(each.depth for each in levels)):
            return even
        fillings = sum(each.filling for each in levels)
        fillings += sum(limb.kinds[kind].count for limb in others if kind in limb.kinds)
        depths = np.arange(1, deepest + 1)[:, None]
        several = np.arange(1, processes + 1)
        within = np.sum([each.within[:deepest] for each in levels], axis=0)
        first = self._first_rows(kind, "both", split=True)
        narrow = first.of((depths * several).ravel(), np.repeat(within, processes), fillings)
        narrow = narrow.reshape(deepest, processes)
        # Of those limbs they have no more for certain than what is as deep.
        before = np.concatenate([[0], within[:-1]])
        deep = (within[-1] - before) * self._of_core(kind).share
        theirs = deep[:, None] + narrow + [besides(int(n)) for n in several]
        busiest = np.maximum((whole + narrow + rest) / processes, theirs / several)
        return max(even, float(busiest.min(axis=1).max()))

    def _first_rows(self, kind: str, part: Part, *, split: bool = False) -> FirstRows:
        key = kind, part, split
        if key not in self._first:
            above, core = self._above(kind, part), self._of_core(kind)
            if split:
                above[0] = min(above[0], core.above)
            self._first[key] = FirstRows(above, core.alone if split else None)
        return self._first[key]

    def _of_core(self, kind: str) -> _InCore:
        """What joints of a kind take at least once a core has grown to them."""
        if kind not in self._cores:
            joint_bounds, most = self.joint_bounds, self.joint_bounds.most.get(kind, 1)
            own = [
                (joint_bounds.single[j].both, joint_bounds.of_row(j, most).both)
                for j in self._on_levels(kind)
            ]
            self._cores[kind] = _InCore(
                min((alone for alone, _ in own), default=0.0),
                max(0.0, min((alone - share for alone, share in own), default=0.0)),
                min((share for _, share in own), default=0.0),
            )
        return self._cores[kind]

    def _above(self, kind: str, part: Part) -> list[float]:
        """What a joint takes above its share of a full row, in a row of 1, 2, ... joints."""
        joint_bounds = self.joint_bounds
        most = joint_bounds.most.get(kind, 1)
        shares = [
            [getattr(joint_bounds.of_row(j, n), part) for n in range(1, most + 1)]
            for j in self._on_levels(kind)
        ]
        above = [[share - row[-1] for share in row] for row in shares]
        return [min(of, default=0.0) for of in zip(*above, strict=True)] or [0.0]

    def _on_levels(self, kind: str) -> list[int]:
        """The robot's joints of a kind that are on a level, as not those that fill."""
        joints = enumerate(self.joint_bounds.robot.joints)
        return [j for j, joint in joints if joint.kind == kind and not _fills(joint)]

    def _limb(self, limb: Limb) -> LimbBound:
        joints = self.joint_bounds.robot.joints
        fixed, way = NOTHING, set[int]()
        if limb.up:
            fixed = self.joint_bounds.upwards(limb)
            link = limb.link
            while link > 0:
                way.add(link - 1)
                fixed = fixed.plus(self.joint_bounds.passed[link - 1])
                link = joints[link - 1].parent
        own: defaultdict[str, list[int]] = defaultdict(list)
        for j in limb.joints:
            if j not in way:
                own[joints[j].kind].append(j)
        level = self._levels(own)
        kinds = {kind: self._alike(of, level) for kind, of in own.items()}
        full = fixed
        for alike in kinds.values():
            full = full.plus(alike.full)
        return LimbBound(fixed, kinds, full)

    def _levels(self, own: dict[str, list[int]]) -> dict[int, int]:
        """The levels of joints that are on one: 1, 2, ..., by the joints of their kind before."""
        joints, found = self.joint_bounds.robot.joints, dict[int, int]()
        every = sorted(j for each in own.values() for j in each)
        for kind in own:
            before: dict[int, int] = {}  # of each joint of the limb
            for j in every:
                before[j] = before.get(joints[j].parent - 1, 0)
                if joints[j].kind == kind and not _fills(joints[j]):
                    before[j] += 1
                    found[j] = before[j]
        return found

    def _alike(self, own: list[int], level: dict[int, int]) -> _Alike:
        """Joints of one kind, by what can lie beside each of them in the limb and beyond it."""
        joint_bounds, (width, beside) = self.joint_bounds, self._widths(own)
        most = joint_bounds.most.get(joint_bounds.robot.joints[own[0]].kind, 1)
        shares = []
        for others in range(_MOST):
            total = NOTHING
            for j in own:
                total = total.plus(joint_bounds.of_row(j, min(1 + beside[j] + others, most)))
            shares.append(total)
        full = NOTHING
        for j in own:
            full = full.plus(joint_bounds.of_row(j, most))
        deep = np.bincount(
            [level[j] for j in own if level.get(j, inf) <= self._depth], minlength=self._depth + 1
        )
        levels = Levels(
            np.cumsum(deep)[1:],
            int(deep.nonzero()[0].max(initial=0)),
            sum(j not in level for j in own),
        )
        return _Alike(len(own), width, tuple(shares), full, levels)

    def _widths(self, own: list[int]) -> tuple[int, dict[int, int]]:
        """How many joints there are none of which hangs on another: of all, and beside each one."""
        parents = [joint.parent for joint in self.joint_bounds.robot.joints]
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


def _fills(joint: PlanJoint) -> bool:
    """Whether a joint may be in any row: it takes hardly less there than in one of its own."""
    return joint.parent == 0 or joint.prescribed
