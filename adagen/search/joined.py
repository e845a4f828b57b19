"""Schedules whose processes are joined at cuts, by predicted time, and a bound on all of them.

That search (adagen/search/segment_search.py) prices joints one by one. What is played takes limbs
side by side and runs by columns, too, so that its own bound says nothing about the price that is
played. Under the least that each joint can take, it bounds that price as well.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from adagen.model import Model
from adagen.paper.budget import Budget
from adagen.plan.constants import joints_of
from adagen.plan.edges import on_the_way
from adagen.plan.segment import segment_of
from adagen.plan.simd_groups import KINDS
from adagen.plan.steps import Force, Kinematics
from adagen.plan.types import Process
from adagen.schedule import CostProfile, Schedule
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.costs import PRESCRIBED, StepCosts
from adagen.schedule.fold import Fold
from adagen.schedule.profile import TICKS
from adagen.schedule.search_result import Found
from adagen.schedule.segment_costs import SegmentCosts
from adagen.schedule.sweeps import Sweeps
from adagen.schedule.tree import Tie
from adagen.search.hub_bound import Hubs
from adagen.search.joint_bounds import ROWS, JointBounds
from adagen.search.limbs import Robot
from adagen.search.price import Pricing
from adagen.search.schedules import find_segments
from adagen.search.segment_bounds import SegmentBounds
from adagen.search.segment_pareto import Label, State, draft_of
from adagen.search.segment_search import FOREVER, SegmentSearch
from adagen.search.whole_limb_bounds import SweepBound, WholeLimbBounds

LONG = 128
"""Joints up to which the longest ways through chains are looked at."""

_PLAYED, _FEWEST = 2, 16
"""Joints that are priced as they are played for each expansion, and chains at least."""

_FURTHER, _SHARE = 16, 4
"""What part of the expansions goes beyond a bound that proves enough, and into schedules alone."""


def least_profile(
    profile: CostProfile, rows: Mapping[str, int], *, folded: bool = False
) -> CostProfile:
    """Return a profile in which every joint takes the least that it can, whatever lies beside it.

    Args:
        profile: a profile with the costs of steps.
        rows: how many joints of each kind can lie side by side; 1 for those not named.
        folded: whether joints of several freedoms may stand for runs of others.
    """
    steps = profile.measured
    table = dict(steps.table)
    for group, other in (
        ("kinematics", "kinematics_strips"),
        ("articulate", "articulate_columns"),
        ("accelerate", None),
    ):
        for kind in steps.kinds:
            ways = [table[f"{group}.{kind}"]]
            ways += [] if other is None else [table[f"{other}.{kind}"]]
            for count in range(2, min(rows.get(kind, 1), max(ROWS)) + 1):
                name, share = ROWS[count]
                ways.append(table[f"{group}_{name}.{kind}"] / share)
            table[f"{group}.{kind}"] = min(ways)
        if folded:
            run = 2 * min(table[f"{group}.revolute"], table[f"{group}.prismatic"])
            for kind in ("spherical", "floating"):
                table[f"{group}.{kind}"] = min(table[f"{group}.{kind}"], run)
    for kind in steps.kinds:  # carried through a run, with its handle forces
        for key in (kind, "ground"):
            price = min(table[f"propagate.{key}"], steps.carried(kind))
            table[f"propagate.{key}"] = price
        table[f"deliver.{kind}"] = min(table[f"deliver.{kind}"], table["deliver.along"])
    table["propagate.spread"] = table["deliver.load"] = table["kinematics.step"] = 0.0
    # A row on the ground is priced once.
    table["articulate.ground"] /= max(1, *(min(n, max(ROWS)) for n in rows.values()))
    for group in ("kinematics", "articulate", "accelerate"):
        for key in (PRESCRIBED, "ground"):  # priced by their kind where they lie side by side
            if f"{group}.{key}" in table:
                kinds = (table[f"{group}.{kind}"] for kind in KINDS)
                table[f"{group}.{key}"] = min(table[f"{group}.{key}"], *kinds)
    return replace(profile, steps=replace(steps, table=table))


def least_passing(least: StepCosts) -> dict[str, float]:
    """Return the least that the kinematics of a joint take that is only passed, by its kind.

    Args:
        least: the costs of steps of a ``least_profile``.
    """
    return {
        kind: min(least[f"kinematics.{kind}"], least[f"passing_strips.{kind}"])
        for kind in least.kinds
    }


@dataclass(frozen=True)
class _Joint:
    """What a joint takes beside no, one, two or three others of its kind; ticks.

    Attributes:
        kind: its kind.
        passed: its kinematics where it is only passed.
        shares: inwards and outwards, with its share of the row that it is in.
        rows: the same with the whole row.
    """

    kind: str
    passed: int
    shares: tuple[tuple[int, int], ...]
    rows: tuple[tuple[int, int], ...]


class _CutSearch(SegmentSearch):
    """The search by steps among schedules that cut the robot at all, at the least prices.

    Args:
        joints: by position; empty for no bounds of chains beyond those of their joints.
        whole_limbs: what a process takes at least up to the end of the sweep inwards for a chain,
            by its positions; ticks.
        played: what a chain takes on one process, by its positions, as far as that is known:
            both sweeps without what every process takes, ticks on a core of speed 1.
        most: chains of which that is asked at most.
    """

    def __init__(
        self,
        *arguments: Any,
        joints: Sequence[_Joint] = (),
        whole_limbs: Callable[[Sequence[int]], int],
        most: int,
        played: Callable[[Sequence[int]], tuple[int, int]],
    ) -> None:
        super().__init__(*arguments)
        self._joints = joints
        self._whole_limbs = whole_limbs
        self._most = most
        self._played = played
        self._exact: dict[Chain, tuple[int, int]] = {}
        self._known: dict[State, Label] = {}
        self._more: dict[Chain, tuple[int, int]] = {}

    def _lower(self, state: State) -> int:
        if state.processes == 1:
            return self._quick(state).time.total
        return super()._lower(state)

    def _alone(self, state: State) -> Label:
        if state.chain == WHOLE and state.processes > 1:
            return Label(Sweeps(FOREVER, 0, 0), state)
        quick = self._quick(state)
        if not self._joints:
            return quick
        if state.chain not in self._exact:
            if len(self._exact) == self._most:
                return quick
            self._exact[state.chain] = self._played(self.costs.chains.positions(state.chain))
        speed, (inwards, outwards) = self._speeds[state.first], self._exact[state.chain]
        first = round((self.costs.start + state.beyond + inwards) / speed)
        second = round(outwards / speed)
        time = quick.time
        return quick._replace(
            time=Sweeps(max(time.assembly, first), max(time.disassembly, second), time.apart)
        )

    def _quick(self, state: State) -> Label:
        """A bound for a chain on one process that needs no look at its joints together."""
        if state not in self._known:
            label = super()._alone(state)
            if self._joints:
                if state.chain not in self._more:
                    self._more[state.chain] = self._beyond_work(state.chain)
                speed = self._speeds[state.first]
                inwards, outwards = (math.floor(t / speed) for t in self._more[state.chain])
                label = label._replace(time=label.time.after(inwards, outwards))
            self._known[state] = label
        return self._known[state]

    def _beyond_work(self, chain: Chain) -> tuple[int, int]:
        """How much longer a chain takes in both sweeps than its joints by themselves at the least.

        Rows are no longer than there are joints side by side in the chain itself; joints on one way
        outwards never lie side by side; and no limb lies beside the way to the ground.
        """
        chains = self.costs.chains
        parent, positions = chains.parent, chains.positions(chain)
        width = self._widths(positions)
        total, longest = [0, 0], [0, 0]
        reached: dict[int, tuple[int, int]] = {}  # by link
        for position in positions:
            joint = self._joints[position]
            count = min(width[joint.kind], len(joint.rows)) - 1
            before, row = reached.get(parent[position], (0, 0)), joint.rows[count]
            reached[position + 1] = (before[0] + row[0], before[1] + row[1])
            for sweep in (0, 1):
                total[sweep] += joint.shares[count][sweep]
                longest[sweep] = max(longest[sweep], reached[position + 1][sweep])
        own, assembly, disassembly = self.costs.work(chain)
        way = sum(self._joints[p].passed - self.costs.passed[p] for p in chains.above(chain.top))
        most = max(total[0], longest[0], self._whole_limbs(positions))
        inwards = max(0, most - own - assembly)
        return inwards + max(0, way), max(0, max(total[1], longest[1]) - disassembly)

    def _widths(self, positions: Sequence[int]) -> dict[str, int]:
        """How many joints of each kind there are none of which hangs on another of them."""
        parent = self.costs.chains.parent
        found: dict[str, int] = {}
        inside = set(positions)
        kinds = {self._joints[position].kind for position in positions}
        for kind in sorted(kinds):
            widest: dict[int, int] = {}
            most = 0
            for position in reversed(positions):
                here = max(widest.get(position + 1, 0), self._joints[position].kind == kind)
                if parent[position] - 1 in inside:
                    widest[parent[position]] = widest.get(parent[position], 0) + here
                else:
                    most += here
            found[kind] = most
        return found


class JoinedBound:
    """What joined schedules take at least, and the one that may be the fastest.

    Args:
        model: the robot.
        seen: the robot as cuts see it.
        processes: P.
        profile: a profile with the costs of steps.
        pricing: what processes take.
        cuttable: for each joint of the folded robot whether two processes may meet there.
        whole_limbs: bounds of joints that hang together, if they are at hand.
    """

    def __init__(
        self,
        model: Model,
        seen: Fold,
        processes: int,
        profile: CostProfile,
        pricing: Pricing,
        cuttable: Sequence[bool],
        whole_limbs: WholeLimbBounds | None = None,
    ) -> None:
        robot = Robot(joints_of(model))
        self.pricing = pricing
        self._rows = whole_limbs or WholeLimbBounds(robot, profile.measured)
        self.joint_bounds = JointBounds(robot, profile.measured, whole_limbs=self._rows)
        self.seen, self.processes, self.profile = seen, processes, profile
        least = least_profile(profile, self.joint_bounds.most, folded=not seen.trivial)
        self.costs = SegmentCosts(seen.topology, least, passing=least_passing(least.measured))
        self.speeds = profile.measured.speeds(processes)
        at = np.array([cuttable[j] for j in self.costs.chains.original], dtype=np.bool_)
        self._allowed = at
        self.bounds = SegmentBounds(self.costs, at, self.speeds)

    def _search(self, expansions: int) -> _CutSearch:
        budget = Budget(expansions, None)
        original = self.costs.chains.original
        joints = [self._joint(j) for j in original] if len(original) <= LONG else []
        return _CutSearch(
            *(self.costs, self.bounds, self.speeds, budget),
            joints=joints,
            whole_limbs=self._whole_limbs,
            most=max(_FEWEST, _PLAYED * expansions // len(original)),
            played=self._segment,
        )

    def _whole_limbs(self, positions: Sequence[int]) -> int:
        """The least that a process takes up to the end of the sweep inwards, ticks."""
        if not self.seen.trivial:
            return 0
        original = self.costs.chains.original
        return math.floor(self._rows.inwards(sorted(original[p] for p in positions)) * TICKS)

    def _segment(self, positions: Sequence[int]) -> tuple[int, int]:
        """What one process takes for some joints of the folded robot and no others, ticks."""
        original, robot = self.costs.chains.original, self.joint_bounds.robot
        members = {j for position in positions for j in self.seen.joints[original[position]]}
        if not members:
            return 0, 0
        others = (j for j in range(len(robot.joints)) if j not in members)
        handles = {link for j in others for link in (robot.joints[j].parent, j + 1)} - {0}
        segment = segment_of(robot.joints, min(members), members, handles)
        reads = on_the_way(robot.joints, members)
        forces = {link: Force(0, link) for link in handles}
        steps = (*map(Kinematics, reads), *segment.inwards()[0], *segment.outwards(forces))
        process = Process(steps, reads, tuple(sorted(members)))
        inwards, outwards = self.pricing.sweeps(process)
        return round(inwards * TICKS), round(outwards * TICKS)

    def _joint(self, joint: int) -> _Joint:
        """What a joint of the folded robot takes, the joints of a run one after the other."""
        own = self.seen.joints[joint]
        kind = self.joint_bounds.robot.joints[own[0]].kind
        counts = range(1, max(ROWS) + 1) if kind in KINDS else range(1, 2)

        def ticks(of: Callable[[int, int], SweepBound], count: int) -> tuple[int, int]:
            each = [of(j, count) for j in own]
            inwards, outwards = sum(one.inwards for one in each), sum(one.outwards for one in each)
            return math.floor(inwards * TICKS), math.floor(outwards * TICKS)

        return _Joint(
            kind if len(own) == 1 else "run",
            math.floor(sum(self.joint_bounds.passing[j] for j in own) * TICKS),
            tuple(ticks(self.joint_bounds.of_row, count) for count in counts),
            tuple(ticks(self.joint_bounds.in_row, count) for count in counts),
        )

    def lower(
        self, known: float, enough: float, expansions: int, tie: Tie
    ) -> tuple[float, int, Schedule | None]:
        """Return a time that no joined schedule beats, or ``known`` where none beats that.

        Args:
            known: a time of interest, microseconds.
            enough: a greater bound is of no use, as other families may be as fast, microseconds;
                beyond it, few states are expanded in search of a schedule.
            expansions: states that may be expanded.
            tie: the preference among equals, for the schedule.

        Returns:
            The bound in microseconds, the expansions spent, and the schedule that may take so long.
        """
        search = self._search(expansions)
        if self.seen.trivial and len(self.seen.topology) <= LONG:
            search.lower = Hubs(self.costs, self._rows, max(self.speeds)).least(self.processes)
        if search.tighten(math.ceil(enough * TICKS)) and search.best is None:
            search.budget.left = min(search.budget.left, expansions // _FURTHER)
            search.tighten(math.ceil(known * TICKS))
        made = None
        if search.best is not None:
            made = self._schedule(Found(draft_of(search.best, self.costs.chains), 0, 0), tie)
        return min(known, search.lower / TICKS), search.budget.expanded, made

    def found(self, tie: Tie, expansions: int, working: int) -> Schedule:
        """Return the schedule that the search by steps finds at the least prices.

        They come nearer to what is played than those of joints one by one where runs are long.

        Args:
            tie: the preference among equals.
            expansions: states that may be expanded.
            working: processes that may have work, the first ones; the others stay idle.
        """
        expansions //= _SHARE  # no bound is asked for
        found = find_segments(self.costs, working, self._allowed, expansions)
        ranges = found.draft.ranges
        ranges[:] = [(a, self.processes if b == working else b) for a, b in ranges]
        return self._schedule(found, tie)

    def _schedule(self, found: Found, tie: Tie) -> Schedule:
        schedule = found.schedule(self.seen.topology, self.processes, self.profile, tie)
        return self.seen.unfold(schedule, self.profile)
