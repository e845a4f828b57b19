"""Search for schedules of form `ada` by predicted time, with latency and repeated kinematics.

Eq. (11) knows neither what messages take nor that every process does the kinematics of all joints
between the ground and its own. So the schedule that is optimal by Eq. (11) is where this search
begins: the joints at which ranges of processes part are moved one after the other, as long as the
whole schedule, planned and played through, gets faster.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from adagen.cost.features import joins_of
from adagen.emit.shapes import predict
from adagen.model import Model
from adagen.paper.bounds import Rules
from adagen.paper.successors import Space
from adagen.paper.tie_break import Builder
from adagen.plan import make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.steps import Join
from adagen.schedule import CostProfile, Schedule
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.search_result import Found

CANDIDATES = 16
"""Joints that are tried at each place where a range parts: the best by Eq. (11)."""
JOINTS_PLAYED = 6000
"""Joints of all schedules together that are planned and played through in one search."""

Place = tuple[int, ...]
"""Where a range of processes parts: 0 for the root side, 1 for the end side, from the root on."""


def played_schedule(
    model: Model, found: Schedule, profile: CostProfile, scalar: str = "double"
) -> Schedule:
    """Return the schedule of form `ada` of least predicted time.

    Args:
        model: the robot.
        found: the schedule that is best by Eq. (11), with the same number of processes.
        profile: a profile with costs of steps.
        scalar: "double" or "float".

    Returns:
        The schedule with the played makespan, and a lower bound on it.
    """
    search = _Played(model, found, profile, scalar)
    best = search.improved()
    lower = min(best.makespan, search.least())
    expanded = found.expanded + search.played
    names, count = ("joined" if found.processes > 1 else "alone",), search.played
    return replace(best, lower_bound=lower, expanded=expanded, families=names, candidates=count)


class _Part(NamedTuple):
    """A part of a schedule.

    Attributes:
        place: where it is.
        chain: its joints.
        first: its first process.
        processes: how many.
        above: the joint that the range above parts at; -1 for none.
        candidates: positions that its own range may part at; none if it does not.
        position: the one that it parts at.
    """

    place: Place
    chain: Chain
    first: int
    processes: int
    above: int
    candidates: list[int]
    position: int


@dataclass
class _Played:
    model: Model
    found: Schedule
    profile: CostProfile
    scalar: str
    played: int = 0
    known: dict[tuple[tuple[Place, int], ...], Schedule] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.fold = fold_of(self.model, "ada")
        rules = Rules.of(self.found.processes, "always")
        self.space = Space(self.fold.topology, self.profile.joins_only(), rules)
        self.most = max(2 * CANDIDATES, JOINTS_PLAYED // len(self.model.joints))

    def improved(self) -> Schedule:
        """Move one parting after the other while that makes the schedule faster."""
        best = self._timed(self.found)
        if self.found.processes == 1 or not len(self.fold.topology):
            return best
        cuts: dict[Place, int] = {}
        best = min(best, self._schedule(cuts), key=lambda each: each.makespan)
        moved = True
        while moved and self.played < self.most:
            moved = False
            for place in [part.place for part in self._parts(cuts) if part.candidates]:
                here = {part.place: part.candidates for part in self._parts(cuts)}
                for position in here.get(place, []):  # a parting above may have done away with it
                    moves = {**_above(cuts, place), place: position}
                    other = self._schedule(moves)
                    if other.makespan < best.makespan:
                        best, cuts, moved = other, moves, True
                    if self.played >= self.most:
                        return best
        return best

    def least(self) -> float:
        """Return a lower bound on the time of any schedule of this form, microseconds.

        Every joint is placed, joined and released by some process, at the prices of joins without
        couplings, and the processes share that evenly at best.
        """
        costs = self.profile.measured
        plan = make_plan(self.model, self.found, form="ada", scalar=self.scalar)
        work, joins = 0.0, joins_of(plan)
        for step in plan.steps_of(Join):
            joint = plan.joints[step.joint]
            join = min(costs[f"{joins}.{joint.priced_as}"], costs[f"{joins}.ground"])
            work += join + costs[f"disassemble.{joint.priced_as}"]
            work += costs["process.tangent"] * joint.tangents
        speeds = costs.speeds(self.found.processes)
        return costs["process.evaluation"] / max(speeds) + work / sum(speeds)

    def _timed(self, schedule: Schedule) -> Schedule:
        """The schedule with its predicted time."""
        self.played += 1
        plan = make_plan(self.model, schedule, form="ada", scalar=self.scalar)
        return replace(schedule, makespan=predict(plan, self.profile, "joints").makespan)

    def _schedule(self, cuts: Mapping[Place, int]) -> Schedule:
        """The schedule that parts ranges at some joints, and elsewhere as Eq. (11) has it."""
        parts = list(self._parts(cuts))
        chosen = tuple(sorted((part.place, part.position) for part in parts if part.candidates))
        if chosen not in self.known:
            self.known[chosen] = self._timed(self._built(parts))
        return self.known[chosen]

    def _built(self, parts: Iterable[_Part]) -> Schedule:
        builder = Builder(self.space)
        for part in parts:
            is_end, span = part.place[-1:] == (1,), (part.first, part.first + part.processes)
            if not part.candidates:
                builder.leaf(part.chain, part.above, is_end, span)
                continue
            joint = self.space.chains.original[part.position]
            builder.draft.hang(part.above, joint, is_end)
            builder.draft.ranges[joint] = span
        made = Found(builder.draft, 0, 0).schedule(
            self.fold.topology, self.found.processes, self.profile.joins_only(), self.found.tie
        )
        return self.fold.unfold(replace(made, profile=self.found.profile), self.space.profile)

    def _parts(self, cuts: Mapping[Place, int]) -> Iterator[_Part]:
        """Yield all parts of a schedule, level by level, root side first."""
        start: tuple[Place, Chain, int, int, int] = ((), WHOLE, 0, self.found.processes, -1)
        waiting = deque([start])
        while waiting:
            place, chain, first, processes, above = waiting.popleft()
            candidates = self._candidates(chain, processes) if processes > 1 else []
            position = cuts.get(place, candidates[0]) if candidates else -1
            yield _Part(place, chain, first, processes, above, candidates, position)
            if candidates:
                joint = self.space.chains.original[position]
                root, end = self.space.chains.split(chain, position)
                half = processes // 2
                waiting.append(((*place, 0), root, first, half, joint))
                waiting.append(((*place, 1), end, first + half, processes - half, joint))

    def _candidates(self, chain: Chain, processes: int) -> list[int]:
        """Positions to part a chain at, the best by Eq. (11) first; none with two sides: none."""
        cuts = self.space.cuts(chain)
        half = processes // 2
        left = cuts.root_work / half
        right = cuts.end_work / (processes - half)
        time = cuts.cost + np.maximum(left, right)
        fit = np.flatnonzero((cuts.root_size > 0) & (cuts.end_size > 0))
        order = fit[np.argsort(time[fit], kind="stable")]
        return [int(p) for p in cuts.position[order[:CANDIDATES]]]


def _above(cuts: Mapping[Place, int], place: Place) -> dict[Place, int]:
    """The partings that stay where they are when one moves: all but those below it."""
    return {other: p for other, p in cuts.items() if other[: len(place)] != place}
