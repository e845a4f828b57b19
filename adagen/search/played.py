"""Form `ada` searched under the price that is played: latency and repeated kinematics included.

Eq. (11) knows neither what messages take nor that every process does the kinematics of all joints
between the ground and its own. So the schedule that is optimal by Eq. (11) is where this search
begins: the joints at which ranges of processes part are moved one after the other, as long as the
whole schedule, planned and played through, gets faster.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from adagen.emit.predicted import predict
from adagen.model import Model
from adagen.paper.bounds import Rules
from adagen.paper.options import Space
from adagen.paper.ties import Builder
from adagen.plan import make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.steps import Join
from adagen.schedule import CostProfile, Schedule
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.found import Found

CANDIDATES = 16
"""Joints that are tried at each place where a range parts: the best by Eq. (11)."""
JOINTS_PLAYED = 6000
"""Joints of all schedules together that are planned and played through in one search."""

Place = tuple[int, ...]
"""Where a range of processes parts: 0 for the root side, 1 for the end side, from the root on."""


def played_schedule(
    model: Model, found: Schedule, profile: CostProfile, scalar: str = "double"
) -> Schedule:
    """Return the schedule of form `ada` that takes least when it is played through.

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
            for place in [place for place, _, _ in self._partings(cuts)]:
                here = {at: self._candidates(chain, p) for at, chain, p in self._partings(cuts)}
                for position in here.get(place, []):  # a parting above may have done away with it
                    moves = {**_above(cuts, place), place: position}
                    other = self._schedule(moves)
                    if other.makespan < best.makespan:
                        best, cuts, moved = other, moves, True
                    if self.played >= self.most:
                        return best
        return best

    def least(self) -> float:
        """Return the least that any schedule of this form takes, microseconds.

        Every joint is placed, joined and released by some process, at the prices of joins without
        couplings, and the processes share that evenly at best.
        """
        costs = self.profile.steps
        assert costs is not None  # as the caller has made sure
        plan = make_plan(self.model, self.found, form="ada", scalar=self.scalar)
        work = 0.0
        for process in plan.processes:
            for step in process.steps:
                match step:
                    case Join():
                        joint = plan.joints[step.joint]
                        kind = "prescribed" if joint.prescribed else joint.kind
                        join = min(costs[f"join.{kind}"], costs["join.ground"])
                        work += join + costs[f"disassemble.{kind}"]
        rate = sum(costs.speed(p) for p in range(self.found.processes))
        fastest = max(costs.speed(p) for p in range(self.found.processes))
        return costs["process.evaluation"] / fastest + work / rate

    def _timed(self, schedule: Schedule) -> Schedule:
        """The schedule with the time that it takes when it is played through."""
        self.played += 1
        plan = make_plan(self.model, schedule, form="ada", scalar=self.scalar)
        return replace(schedule, makespan=predict(plan, self.profile, "joints").makespan)

    def _schedule(self, cuts: Mapping[Place, int]) -> Schedule:
        """The schedule that parts ranges at some joints, and elsewhere as Eq. (11) has it."""
        chosen = tuple(sorted((place, p) for place, _, p in self._chosen(cuts)))
        if chosen not in self.known:
            self.known[chosen] = self._timed(self._built(cuts))
        return self.known[chosen]

    def _built(self, cuts: Mapping[Place, int]) -> Schedule:
        builder = Builder(self.space)

        def leaf(chain: Chain, above: int, is_end: bool, first: int, processes: int) -> None:
            builder.leaf(chain, above, is_end, (first, first + processes))

        def node(position: int, above: int, is_end: bool, first: int, processes: int) -> int:
            joint = self.space.chains.original[position]
            builder.hang(above, joint, is_end)
            builder.draft.ranges[joint] = (first, first + processes)
            return joint

        self._walk(cuts, leaf, node)
        made = Found(builder.draft, 0, 0).schedule(
            self.fold.topology, self.found.processes, self.profile.joins_only(), self.found.tie
        )
        return self.fold.unfold(replace(made, profile=self.found.profile), self.space.profile)

    def _walk(
        self,
        cuts: Mapping[Place, int],
        leaf: Callable[[Chain, int, bool, int, int], None],
        node: Callable[[int, int, bool, int, int], int],
    ) -> None:
        """Visit the places where ranges part, level by level, and the chains of one process."""
        waiting: deque[tuple[Place, Chain, int, int, int, bool]] = deque()
        waiting.append(((), WHOLE, 0, self.found.processes, -1, False))
        while waiting:
            place, chain, first, processes, above, is_end = waiting.popleft()
            candidates = self._candidates(chain, processes) if processes > 1 else []
            if not candidates:
                leaf(chain, above, is_end, first, processes)
                continue
            position = cuts.get(place, candidates[0])
            joint = node(position, above, is_end, first, processes)
            root, end = self.space.chains.split(chain, position)
            half = processes // 2
            waiting.append(((*place, 0), root, first, half, joint, False))
            waiting.append(((*place, 1), end, first + half, processes - half, joint, True))

    def _chosen(self, cuts: Mapping[Place, int]) -> Iterator[tuple[Place, Chain, int]]:
        """Yield the places where ranges part, with their chains and the positions taken."""
        for place, chain, processes in self._partings(cuts):
            yield place, chain, cuts.get(place, self._candidates(chain, processes)[0])

    def _partings(self, cuts: Mapping[Place, int]) -> Iterator[tuple[Place, Chain, int]]:
        """Yield the places where ranges part, with their chains and numbers of processes."""
        waiting: deque[tuple[Place, Chain, int]] = deque([((), WHOLE, self.found.processes)])
        while waiting:
            place, chain, processes = waiting.popleft()
            candidates = self._candidates(chain, processes) if processes > 1 else []
            if not candidates:
                continue
            yield place, chain, processes
            root, end = self.space.chains.split(chain, cuts.get(place, candidates[0]))
            half = processes // 2
            waiting += [((*place, 0), root, half), ((*place, 1), end, processes - half)]

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
