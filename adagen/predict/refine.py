"""Improving a schedule of form `segment` by what its plan takes when it is played through.

The search prices chains and cuts (adagen.schedule.segments); the plan knows more: kinematics that
a process does once for several chains, waiting in either sweep, couplings between many handles. So
cuts are moved to neighbouring joints, and the sides of a cut change processes, as long as that
makes the predicted time shorter.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.segment import SegmentPlanner
from adagen.predict.simulate import predict
from adagen.schedule import CostProfile, Node, Schedule, Topology
from adagen.schedule.chains import WHOLE, Chain, Chains
from adagen.schedule.draft import Draft
from adagen.schedule.fold import Fold, fold
from adagen.schedule.restricted import joined_between_processes
from adagen.schedule.tree import loads_of, makespan_of

TRIALS = 60
"""Schedules that are played through at most."""
_LEAST = 1e-3  # share of the time that a move must bring


@dataclass(frozen=True)
class _Cut:
    """Where a chain is cut and for whom; None in its place is a chain of one process."""

    position: int
    ranges: tuple[tuple[int, int], tuple[int, int]]
    sides: tuple[_Cut | None, _Cut | None]


def refine(
    model: Model,
    schedule: Schedule,
    profile: CostProfile,
    cuttable: Sequence[bool],
    trials: int = TRIALS,
    seen: Fold | None = None,
) -> Schedule:
    """Return the schedule or a better one; what is proven of it stays the same.

    Args:
        model: the robot.
        schedule: one without shared ranges.
        profile: one with costs of steps.
        cuttable: for each joint that the search has seen, whether two processes may meet there.
        trials: schedules that may be played through.
        seen: what the search has seen of the robot, and the schedule is of; all joints if None.
    """
    seen = fold(Topology.of(model), ()) if seen is None else seen
    search = _Refinement(model, seen, schedule, profile, cuttable)
    return schedule if search.best is None else search.climb(trials)


class _Refinement:
    def __init__(
        self,
        model: Model,
        seen: Fold,
        schedule: Schedule,
        profile: CostProfile,
        cuttable: Sequence[bool],
    ) -> None:
        self.seen, self.topology = seen, seen.topology
        self.runs = [run for run in seen.joints if len(run) > 1]
        self.profile = profile
        self.schedule = schedule
        self.chains = Chains(self.topology, profile)
        self.cuttable = cuttable
        self.place = {j: p for p, j in enumerate(self.chains.original)}
        self.plan: Plan = make_plan(model, seen.unfold(schedule, profile), form="segment")
        self.joined = set(joined_between_processes(schedule.root))
        self.best = self._cut_of(schedule.root)
        self.time = predict(self.plan, profile).makespan

    def _cut_of(self, node: Node | None) -> _Cut | None:
        """Return the cuts of a schedule tree; None for a part that has none."""
        if node is None or node.joint not in self.joined:
            return None
        first, second = node.root_side, node.end_side
        if first is None or second is None:
            return None
        sides = self._cut_of(first), self._cut_of(second)
        return _Cut(self.place[node.joint], (first.processes, second.processes), sides)

    def climb(self, trials: int) -> Schedule:
        """Take the first move that helps, again and again."""
        found = self.schedule
        moved = True
        while moved and self.best is not None:
            moved = False
            for cut in self._moves(WHOLE, self.best):
                if trials == 0:
                    return found
                trials -= 1
                schedule = self._schedule(cut)
                whole = self.seen.unfold(schedule, self.profile)
                planner = SegmentPlanner(self.plan.joints, whole, self.runs)
                processes, messages = planner.plan()
                plan = replace(self.plan, processes=processes, messages=messages)
                time = predict(plan, self.profile).makespan
                if time < (1 - _LEAST) * self.time:
                    self.best, self.time, found, moved = cut, time, schedule, True
                    break
        return found

    def _moves(self, chain: Chain, cut: _Cut) -> Iterator[_Cut]:
        """Yield the cuts one move away."""
        (a, b), (root, end) = cut.ranges, self.chains.split(chain, cut.position)
        if a[1] - a[0] == b[1] - b[0]:
            by = b[0] - a[0]
            yield _Cut(cut.position, (b, a), (_moved(cut.sides[0], by), _moved(cut.sides[1], -by)))
        for position in self._near(chain, cut.position):
            sides = self.chains.split(chain, position)
            if all(
                self.chains.positions(side) and self._fits(side, inner)
                for side, inner in zip(sides, cut.sides, strict=True)
            ):
                yield replace(cut, position=position)
        first, second = cut.sides
        if first is not None:
            yield from (replace(cut, sides=(one, second)) for one in self._moves(root, first))
        if second is not None:
            yield from (replace(cut, sides=(first, two)) for two in self._moves(end, second))

    def _near(self, chain: Chain, position: int) -> Iterator[int]:
        """Yield positions of a chain next to one: above, below, beside."""
        inside = set(self.chains.positions(chain))
        parent = self.chains.parent
        above = parent[position]
        beside = [p for p in sorted(inside) if parent[p] in (above, position + 1)]
        for p in (above - 1, *beside):
            if p in inside and p != position and self.cuttable[self.chains.original[p]]:
                yield p

    def _fits(self, chain: Chain, cut: _Cut | None) -> bool:
        if cut is None:
            return True
        if cut.position not in self.chains.positions(chain):
            return False
        sides = self.chains.split(chain, cut.position)
        return all(
            self.chains.positions(side) and self._fits(side, inner)
            for side, inner in zip(sides, cut.sides, strict=True)
        )

    def _schedule(self, cut: _Cut) -> Schedule:
        draft = Draft(len(self.topology))
        draft.root = self._build(draft, WHOLE, cut, self.schedule.root.processes)
        root = draft.finish(self.topology, self.profile)
        makespan = makespan_of(root)
        lower = min(self.schedule.lower_bound, makespan)
        return replace(
            self.schedule,
            root=root,
            makespan=makespan,
            verdict="optimal" if lower >= makespan else "gap",
            gap=makespan / lower - 1.0,
            lower_bound=lower,
            loads=loads_of(root, self.schedule.processes),
        )

    def _build(
        self, draft: Draft, chain: Chain, cut: _Cut | None, processes: tuple[int, int]
    ) -> int:
        if cut is None:
            order = [self.chains.original[p] for p in reversed(self.chains.positions(chain))]
            for joint in order:
                draft.ranges[joint] = processes
            return draft.contract(self.topology, order)
        joint = self.chains.original[cut.position]
        sides = self.chains.split(chain, cut.position)
        built = [
            self._build(draft, side, inner, own)
            for side, inner, own in zip(sides, cut.sides, cut.ranges, strict=True)
        ]
        draft.ranges[joint] = processes
        draft.root_child[joint], draft.end_child[joint] = built
        return joint


def _moved(cut: _Cut | None, by: int) -> _Cut | None:
    """Return cuts for processes further up or down."""
    if cut is None:
        return None
    (a, b), (c, d) = cut.ranges
    ranges = ((a + by, b + by), (c + by, d + by))
    return _Cut(cut.position, ranges, (_moved(cut.sides[0], by), _moved(cut.sides[1], by)))
