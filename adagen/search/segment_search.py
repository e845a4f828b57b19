"""The search for schedules of form `segment`: cuts, processes, and the side that stays local.

What a chain on a range of processes can take is not one time but several: the sooner it is
assembled, the later perhaps its processes are done once the forces on it are known. So a state has
a *front*, the times of both sweeps none of which is better than another in both:

    assembly    A = up + max(A_local, A_remote + on the way)
    disassembly D = down + max(D_local, D_remote + on the way)

and the makespan is the least A + D of the whole robot. A state is a chain, its processes, and what
its process joins further up, as the kinematics towards those joints come first of all. A front is
complete up to a limit; options whose bound (adagen.search.segment_bounds) is not below the limit,
or cannot reach below the front, are ruled out.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from adagen.paper.budget import Budget, OutOfBudget
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.segment_costs import SegmentCosts
from adagen.schedule.sweeps import Sweeps, beside
from adagen.schedule.tree_prices import scaled, segment_time
from adagen.search.segment_bounds import Options, SegmentBounds
from adagen.search.segment_pareto import Label, State, add, covered

FOREVER = 1 << 62
_THIN = 6  # labels of a state that are kept where only a few options are followed


class SegmentSearch:
    """Fronts of partial chains, as far as the budget goes.

    Args:
        costs: prices of the robot's chains and cuts.
        bounds: on their times.
        speeds: of the cores of all processes.
        budget: what may be spent.
        width: options followed at each state; None for all that are not ruled out.

    Attributes:
        lower: proven lower bound on the time of the whole robot, ticks.
        best: the best way found for the whole robot.
    """

    def __init__(
        self,
        costs: SegmentCosts,
        bounds: SegmentBounds,
        speeds: tuple[float, ...],
        budget: Budget,
        width: int | None = None,
        uneven: int = 0,
    ) -> None:
        self.costs = costs
        self.bounds = bounds
        self.budget = budget
        self.width = width
        self.uneven = uneven
        self.lower = 0
        self.best: Label | None = None
        self._speeds = speeds
        self._alike = min(speeds) == max(speeds)
        self._fronts: dict[State, tuple[int, list[Label]]] = {}
        self._options: dict[tuple[Chain, int], Options] = {}
        self._least: dict[tuple[Chain, int], int] = {}
        self._sides: dict[tuple[Chain, int], tuple[Chain, Chain]] = {}

    # --- the whole robot -------------------------------------------------------------------------

    def tighten(self, known: int) -> bool:
        """Look for the best way below ``known`` ticks, raising :attr:`lower`; return if certain."""
        whole = State(WHOLE, 0, len(self._speeds))
        self.lower = max(self.lower, min(known, self._lower(whole)))
        step = 10
        try:
            while self.lower < known:
                limit = known if step <= 1 else self.lower + max(1, (known - self.lower) // step)
                self.solve(limit)
                if self.best is not None and self.best.time.total < limit:
                    self.lower = self.best.time.total
                    return True
                self.lower = limit
                step -= 1
        except OutOfBudget:
            return False
        return True

    def solve(self, limit: int) -> None:
        """Look for a way to do the whole robot in less than ``limit`` ticks; see :attr:`best`.

        Raises:
            OutOfBudget: there may be a better one.
        """
        self._front(State(WHOLE, 0, len(self._speeds)), limit, only_best=True)

    # --- fronts ----------------------------------------------------------------------------------

    def _front(self, state: State, limit: int, *, only_best: bool = False) -> list[Label]:
        """Return the front of a state, complete for totals below ``limit``.

        Args:
            state: the state.
            limit: ticks.
            only_best: whether no more is asked for than a label of the least total.

        Raises:
            OutOfBudget: cannot tell.
        """
        done, front = self._fronts.get(state, (0, []))
        if done >= limit:
            return front
        if state.processes == 1:
            front, limit = [self._alone(state)], FOREVER
        elif self._lower(state) < limit:
            self.budget.spend()
            front = self._searched(state, limit, only_best)
            if self.width is not None and len(front) > _THIN:
                front = sorted(front, key=lambda label: label.time.total)[:_THIN]
                front.sort(key=lambda label: label.time.assembly)
        self._fronts[state] = (limit, front)
        return front

    def _alone(self, state: State) -> Label:
        speed = self._speeds[state.first]
        times = segment_time(self.costs, state.chain, state.beyond, speed)
        return Label(Sweeps(*times, 0), state)

    def _lower(self, state: State) -> int:
        """Return the best bound on the total known without a search."""
        if state.processes == 1:
            speed = self._speeds[state.first]
            return sum(segment_time(self.costs, state.chain, state.beyond, speed))
        least = self._by_area(state.chain, state.processes)
        done, front = self._fronts.get(state, (0, []))
        if front:
            return max(least, min(done, min(label.time.total for label in front)))
        return max(least, done)

    def _by_area(self, chain: Chain, processes: int) -> int:
        """Return the bound on a chain's total by its area."""
        key = (chain, processes)
        least = self._least.get(key)
        if least is None:
            least = self._least[key] = self.bounds.least(chain, processes)
        return least

    def _searched(self, state: State, limit: int, only_best: bool) -> list[Label]:
        chain, count = state.chain, state.processes
        alone = self._alone(state)
        front = [alone] if alone.time.total < limit else []
        if only_best and front:
            self.best, limit = alone, alone.time.total
        for total, assembly, disassembly, position, first in self._followed(chain, count):
            if total >= limit:
                if self.width is None:
                    break
                continue
            # Where nothing is known of the sweeps, the total may be that of a part on its own.
            if assembly and covered(front, total, assembly, disassembly):
                continue
            for label in self.ways(state, position, first, limit):
                add(front, label)
                if only_best and label.time.total < limit:
                    self.best, limit = label, label.time.total
        return front

    def _followed(self, chain: Chain, count: int) -> Iterator[tuple[int, int, int, int, int]]:
        """Return the options that are followed: bounds on total and sweeps, position, division."""
        options = self._options_of(chain, count)
        columns = [
            options.total,
            options.assembly,
            options.disassembly,
            options.position,
            options.first,
        ]
        if self.width is not None:
            even = np.flatnonzero(np.abs(2 * options.first - count) <= self.uneven)
            chosen = even[np.argsort(options.guess[even], kind="stable")[: self.width]]
            columns = [column[chosen] for column in columns]
        return zip(*(column.tolist() for column in columns), strict=True)

    def _options_of(self, chain: Chain, count: int) -> Options:
        key = (chain, count)
        known = self._options.get(key)
        if known is None:
            known = self._options[key] = self.bounds.options(chain, count)
        return known

    def ways(self, state: State, position: int, first: int, limit: int) -> list[Label]:
        """Return the ways to do a state with a cut that take less than ``limit``.

        Args:
            state: the state.
            position: of the joint that is cut.
            first: processes for its root side.
            limit: ticks.

        Raises:
            OutOfBudget: cannot tell.
        """
        if (state.chain, position) not in self._sides:
            self._sides[state.chain, position] = self.costs.chains.split(state.chain, position)
        root, end = self._sides[state.chain, position]
        cut, speed = self.costs.cut(state.chain, position), self._speeds[state.first]
        join = scaled(cut.assembly, speed), scaled(cut.disassembly, speed)
        second = state.processes - first
        return [
            *self._joined(state, position, root, end, (first, second), join, True, limit),
            *self._joined(state, position, end, root, (second, first), join, False, limit),
        ]

    def _joined(
        self,
        state: State,
        position: int,
        here: Chain,
        there: Chain,
        counts: tuple[int, int],
        join: tuple[int, int],
        root_here: bool,
        limit: int,
    ) -> list[Label]:
        """Return the ways with one side on the process that joins it to the other."""
        (up, down), transit = join, self.costs.transit(there)
        away, left = None, [limit - up - down, limit]
        if transit is not None:  # written without calls: most ways end here
            assembly, disassembly, send, latency = transit
            up, down = up + assembly, down + disassembly + send
            away = assembly + send + latency, disassembly + latency
            left[0] = limit - up - down
            left[1] = left[0] - away[0] - away[1]
        next_one = 0 if self._alike else state.first + counts[0]
        remote = State(there, next_one, counts[1])
        low_remote = self._lower(remote)
        if low_remote >= left[1] or (
            counts[0] > 1 and self._by_area(here, counts[0]) >= left[0]
        ):  # before it is known what is joined
            return []
        local = self._local(state, position, here, there, counts[0], root_here)
        states = [local, remote]
        low = [self._lower(local), low_remote]
        if low[0] >= left[0]:
            return []
        fronts: list[list[Label]] = [[], []]
        for k in (0, 1) if low[0] >= low[1] else (1, 0):
            fronts[k] = self._front(states[k], left[k])
            if not fronts[k]:
                return []
        found = []
        for a in fronts[0]:
            for b in fronts[1]:
                time = beside(a.time, b.time, away).after(up, down)
                if time.total < limit:
                    found.append(Label(time, state, position, a, b, root_here))
        return found

    def _local(
        self,
        state: State,
        position: int,
        here: Chain,
        there: Chain,
        count: int,
        root_here: bool,
    ) -> State:
        """Return the state of the side that stays, with all that its process joins."""
        chains = self.costs.chains
        joined = tuple(p for p in state.joined if p in here.cuts)
        top = there.top if root_here else chains.parent[position]
        beyond = state.beyond
        passing = [p for p in state.joined if p in there.cuts]
        if passing:  # joints of the other side on the way to joints that are joined further up
            passed = {q for p in passing for q in chains.above(chains.parent[p])}
            passed -= {*chains.above(state.chain.top), *chains.above(top)}
            beyond += sum(self.costs.passed[q] for q in passed)
        if root_here:
            beyond += self.costs.passed[position]
            joined = tuple(sorted((*joined, position)))
        return State(here, state.first, count, joined, beyond)
