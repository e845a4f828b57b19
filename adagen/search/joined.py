"""Schedules whose processes are joined at cuts: what the search by steps finds, and a bound on all.

That search (adagen/schedule/segment_search.py) prices joints one by one. What is played takes limbs
side by side and runs by columns, too, so that its own bound says nothing about the price that is
played. Under the least that each joint can take, it bounds that price as well.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from adagen.model import Model
from adagen.plan.abreast import KINDS
from adagen.plan.constants import joints_of
from adagen.schedule import CostProfile, Schedule
from adagen.schedule.budget import Budget
from adagen.schedule.chains import WHOLE
from adagen.schedule.costs import PRESCRIBED
from adagen.schedule.fold import Fold
from adagen.schedule.found import Found
from adagen.schedule.profile import TICKS
from adagen.schedule.segment_bounds import SegmentBounds
from adagen.schedule.segment_front import Label, State, draft_of
from adagen.schedule.segment_search import FOREVER, SegmentSearch
from adagen.schedule.segments import SegmentCosts
from adagen.schedule.sweeps import Sweeps
from adagen.schedule.tree import Tie
from adagen.search.floors import Floors
from adagen.search.limbs import Robot

_LONG = 512
"""Joints up to which the longest ways through chains are looked at."""

_ROWS = {2: ("two", 2), 3: ("four", 3), 4: ("four", 4)}


def least_profile(
    profile: CostProfile, rows: Mapping[str, int], *, folded: bool = False
) -> CostProfile:
    """Return a profile in which every joint takes the least that it can, whatever lies beside it.

    Args:
        profile: a profile with the costs of steps.
        rows: how many joints of each kind can lie side by side; 1 for those not named.
        folded: whether joints of several freedoms may stand for runs of others.
    """
    assert profile.steps is not None  # as the caller has made sure
    table = dict(profile.steps.table)
    for group, other in (
        ("kinematics", "kinematics_segments"),
        ("articulate", "articulate_columns"),
        ("accelerate", None),
    ):
        for kind in profile.steps.kinds:
            ways = [table[f"{group}.{kind}"]]
            ways += [] if other is None else [table[f"{other}.{kind}"]]
            for count in range(2, min(rows.get(kind, 1), max(_ROWS)) + 1):
                name, share = _ROWS[count]
                ways.append(table[f"{group}_{name}.{kind}"] / share)
            table[f"{group}.{kind}"] = min(ways)
        if folded:
            run = 2 * min(table[f"{group}.revolute"], table[f"{group}.prismatic"])
            for kind in ("spherical", "floating"):
                table[f"{group}.{kind}"] = min(table[f"{group}.{kind}"], run)
        for key in (PRESCRIBED, "ground"):  # priced by their kind where they lie side by side
            if f"{group}.{key}" in table:
                kinds = (table[f"{group}.{kind}"] for kind in KINDS)
                table[f"{group}.{key}"] = min(table[f"{group}.{key}"], *kinds)
    return replace(profile, steps=replace(profile.steps, table=table))


class _CutSearch(SegmentSearch):
    """The search by steps among schedules that cut the robot at all, at the least prices.

    Args:
        rows: of each position, what its joint takes with the whole row that it is in, inwards and
            outwards, ticks; empty for no such bound.
    """

    def __init__(self, *arguments: Any, rows: Sequence[tuple[int, int]] = ()) -> None:
        super().__init__(*arguments)
        self._rows = rows
        self._known: dict[State, Label] = {}

    def _alone(self, state: State) -> Label:
        if state.chain == WHOLE and state.processes > 1:
            return Label(Sweeps(FOREVER, 0, 0), state)
        if state not in self._known:
            label = super()._alone(state)
            if self._rows:
                more = self._beyond_work(state)
                label = label._replace(time=label.time.after(*more))
            self._known[state] = label
        return self._known[state]

    def _beyond_work(self, state: State) -> tuple[int, int]:
        """How much longer the longest way through a chain takes, row by row, than its shared work.

        Both are bounds: joints on one way outwards never lie side by side.
        """
        parent = self.costs.chains.parent
        reached: dict[int, tuple[int, int]] = {}  # by link
        inwards = outwards = 0
        for position in self.costs.chains.positions(state.chain):
            before = reached.get(parent[position], (0, 0))
            row = self._rows[position]
            here = reached[position + 1] = (before[0] + row[0], before[1] + row[1])
            inwards, outwards = max(inwards, here[0]), max(outwards, here[1])
        own, assembly, disassembly = self.costs.work(state.chain)
        speed = self._speeds[state.first]
        more = (max(0, inwards - own - assembly), max(0, outwards - disassembly))
        return math.floor(more[0] / speed), math.floor(more[1] / speed)


class JoinedFloor:
    """What joined schedules take at least, and those of one cut that may be fast.

    Args:
        model: the robot.
        seen: the robot as cuts see it.
        processes: P.
        profile: a profile with the costs of steps.
        cuttable: for each joint of the folded robot whether two processes may meet there.
    """

    def __init__(
        self,
        model: Model,
        seen: Fold,
        processes: int,
        profile: CostProfile,
        cuttable: Sequence[bool],
    ) -> None:
        assert profile.steps is not None  # as the caller has made sure
        robot = Robot(joints_of(model))
        self.floors = Floors(robot, profile.steps)
        self.seen, self.processes, self.profile = seen, processes, profile
        least = least_profile(profile, self.floors.most, folded=not seen.trivial)
        self.costs = SegmentCosts(seen.topology, least)
        self.speeds = tuple(profile.steps.speed(p) for p in range(processes))
        at = np.array([cuttable[j] for j in self.costs.chains.original], dtype=np.bool_)
        self.bounds = SegmentBounds(self.costs, at, self.speeds)

    def _search(self, expansions: int) -> _CutSearch:
        budget = Budget(expansions, None)
        rows = [self._row(j) for j in self.costs.chains.original]
        if len(rows) > _LONG:
            rows = []
        return _CutSearch(self.costs, self.bounds, self.speeds, budget, rows=rows)

    def _row(self, joint: int) -> tuple[int, int]:
        """What a joint of the folded robot takes with the whole rows that it is in, ticks."""
        own = [self.floors.row[j] for j in self.seen.joints[joint]]
        inwards, outwards = sum(f.inwards for f in own), sum(f.outwards for f in own)
        return math.floor(inwards * TICKS), math.floor(outwards * TICKS)

    def lower(self, known: float, expansions: int) -> tuple[float, int]:
        """Return a time that no joined schedule beats, or ``known`` where none beats that.

        Args:
            known: a time of interest, microseconds.
            expansions: states that may be expanded.

        Returns:
            The bound in microseconds, and the expansions spent.
        """
        search = self._search(expansions)
        search.tighten(math.ceil(known * TICKS))
        return min(known, search.lower / TICKS), search.budget.expanded

    def single_cuts(self, tie: Tie) -> Iterator[tuple[float, Schedule]]:
        """Yield the schedules of two processes by their bounds, and those, microseconds."""
        search, whole = self._search(1 << 30), State(WHOLE, 0, self.processes)
        cuts = sorted(set(self.bounds.options(WHOLE, self.processes).position.tolist()))
        labels = [label for cut in cuts for label in search.ways(whole, cut, 1, FOREVER)]
        for label in sorted(labels, key=lambda label: label.time.total):
            found = Found(draft_of(label, self.costs.chains), 0, 1)
            schedule = found.schedule(self.seen.topology, self.processes, self.profile, tie)
            yield label.time.total / TICKS, self.seen.unfold(schedule, self.profile)
