"""The search for schedules of form `segment` under measured costs: where to cut, for whom.

T(S, P) = min of the price of S on one process and, over cuts with joints on both sides and all ways
to divide P, C + max(local, remote + L), L being what messages take and the longer side staying
local. A state is a chain and a number of processes; what is known of it is remembered. The bound of
a state: every joint is articulated or cut, each cut is charged to at least two processes, and each
makes one chain more with a root of its own.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from adagen.schedule.budget import Budget, OutOfBudget, Task, run
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.draft import Draft
from adagen.schedule.segments import SegmentCosts

Ints = NDArray[np.int64]
FOREVER = 1 << 62
_ANY_SPLIT = 4
"""Processes up to which a range may be divided anyhow; beyond, in halves where it is even."""


class Choice(NamedTuple):
    """What is done with a chain: the cut, the processes of either side, which side stays local."""

    position: int
    first: int
    second: int
    root_local: bool


@dataclass(frozen=True)
class _Options:
    """Cuts with ways to divide P, by ascending bound; arrays of equal length, ticks."""

    bound: Ints
    position: Ints
    first: Ints


class SegmentSearch:
    """Best times of chains, as far as the budget goes.

    Args:
        costs: prices of the robot's chains and cuts.
        cuttable: per position, whether two processes may meet at its joint.
        budget: what may be spent.
        width: options followed at each state; None for all that their bounds do not rule out.

    Attributes:
        lower: proven lower bound on the time of the whole robot, ticks.
    """

    def __init__(
        self,
        costs: SegmentCosts,
        cuttable: NDArray[np.bool_],
        budget: Budget,
        width: int | None = None,
    ) -> None:
        self.costs = costs
        self.budget = budget
        self.width = width
        self.lower = 0
        self._cuttable = cuttable
        self._memo: dict[tuple[Chain, int], tuple[int, bool]] = {}
        self._choices: dict[tuple[Chain, int], Choice | None] = {}
        chains = costs.chains
        self._end = np.array(chains.end, dtype=np.int64)
        self._before = np.array(costs.before, dtype=np.int64)
        self._kinematics = np.array(costs.kinematics, dtype=np.int64)
        self._join = np.array(costs.join, dtype=np.int64)
        self._parent = np.array(chains.parent, dtype=np.int64)
        self._least_join = int(self._join.min())
        # A joint is articulated or cut, whichever is cheaper.
        saved = np.maximum(0, np.array(costs.alone, dtype=np.int64) - self._join)
        self._cheap = np.concatenate([[0], np.cumsum(saved)])
        # What joints on a path between handles take more: on one process, and at the least.
        out, least = [0] * (len(chains.parent) + 1), [0] * (len(chains.parent) + 1)
        self._extra = [
            min(costs.join[p], alone + costs.outward[p]) - min(costs.join[p], alone)
            for p, alone in enumerate(costs.alone)
        ]
        for p, above in enumerate(chains.parent):
            out[p + 1] = out[above] + costs.outward[p]
            least[p + 1] = least[above] + self._extra[p]
        self._out = np.array(out, dtype=np.int64)
        self._least_out = np.array(least, dtype=np.int64)
        self._held = not any(costs.free)

    # --- bounds ----------------------------------------------------------------------------------

    def _spread(self, work: Ints, processes: int, grounded: bool) -> Ints:
        """Return the least time of chains whose joints take at least ``work`` on one process.

        Of a chain that holds the ground, every part but one has a root that costs something.
        """
        best = work
        one = self._least_join
        root = self.costs.root if grounded else 0
        for p in range(2, processes + 1):
            more = (p - 2) * one + (p - 1) * root
            best = np.minimum(best, one + np.maximum(0, work - one + more) // p)
        return best

    def _saved(self, first: Ints, last: Ints) -> Ints:
        found: Ints = self._cheap[last] - self._cheap[first]
        return found

    def rough(self, chain: Chain, processes: int) -> int:
        """Return a lower bound that needs no search, ticks."""
        costs = self.costs
        if processes == 1:
            return costs.price(chain).total
        first, last = costs.chains.span(chain)
        work = costs.work(chain) - int(self._cheap[last] - self._cheap[first])
        for cut in chain.cuts:
            work += int(self._cheap[costs.chains.end[cut]] - self._cheap[cut])
        work += sum(self._extra[p] for p in costs.price(chain).path)
        spread = int(self._spread(np.array([max(0, work)]), processes, chain.top == 0)[0])
        root = costs.root if chain.top else 0
        return costs.start + costs.kinematics[chain.top] + root + spread

    def _options(self, chain: Chain, processes: int) -> _Options:
        """Return all cuts of a chain with all ways to divide its processes."""
        costs, chains = self.costs, self.costs.chains
        at = np.concatenate([np.arange(a, b) for a, b in chains.segments(chain)])
        stop = self._end[at]
        end_work = self._before[stop] - self._before[at + 1]
        end_saved = self._saved(at + 1, stop)
        size = stop - at - 1
        inner = np.zeros((2, len(at)), dtype=np.int64)  # paths from the end side's top to cuts
        for cut in chain.cuts:
            inside = (at < cut) & (cut < stop)
            end_work -= (costs.before[chains.end[cut]] - costs.before[cut]) * inside
            end_saved -= int(self._cheap[chains.end[cut]] - self._cheap[cut]) * inside
            size -= (chains.end[cut] - cut) * inside
            for row, way in zip(inner, (self._out, self._least_out), strict=True):
                np.maximum(row, (way[chains.parent[cut]] - way[at + 1]) * inside, out=row)
        own = self._before[at + 1] - self._before[at]
        root_work = costs.work(chain) - end_work - own
        good = self._cuttable[at] & (size > 0) & (len(at) - 1 - size > 0)
        first, last = chains.span(chain)
        whole = int(self._cheap[last] - self._cheap[first])
        whole -= sum(int(self._cheap[chains.end[c]] - self._cheap[c]) for c in chain.cuts)
        root_saved = whole - end_saved - (self._cheap[at + 1] - self._cheap[at])
        at, end_work, root_work = at[good], end_work[good], root_work[good]
        end_saved, root_saved, inner = end_saved[good], root_saved[good], inner[:, good]
        end_base = costs.start + self._kinematics[at + 1] + costs.root
        root_base = costs.start + costs.kinematics[chain.top] + (costs.root if chain.top else 0)
        held = self._held or chain.top > 0
        paths = np.zeros((2, len(at)), dtype=np.int64)  # from the root side's top to the cut
        if held:
            for row, way in zip(paths, (self._out, self._least_out), strict=True):
                row += way[self._parent[at]] - way[chain.top]
        bounds, places, splits = [], [], []
        for p, q in self._splits(processes):
            a, b = root_work + paths[0], end_work + inner[0]
            if p > 1:
                a = self._spread(root_work - root_saved + paths[1], p, chain.top == 0)
            if q > 1:
                b = self._spread(end_work - end_saved + inner[1], q, False)
            bounds.append(self._join[at] + np.maximum(root_base + a, end_base + b))
            places.append(at)
            splits.append(np.full(len(at), p, dtype=np.int64))
        bound = np.concatenate(bounds)
        order = np.argsort(bound, kind="stable")
        return _Options(bound[order], np.concatenate(places)[order], np.concatenate(splits)[order])

    def _splits(self, processes: int) -> list[tuple[int, int]]:
        if processes > _ANY_SPLIT and processes % 2 == 0:
            return [(processes // 2, processes // 2)]
        if processes > _ANY_SPLIT:
            return [(processes // 2, processes - processes // 2)]
        return [(p, processes - p) for p in range(1, processes)]

    # --- search ----------------------------------------------------------------------------------

    def time(self, chain: Chain, processes: int, limit: int = FOREVER) -> int:
        """Return T(S, P) if that is below ``limit``; else a lower bound on it, at least ``limit``.

        Raises:
            OutOfBudget: cannot tell.
        """
        return run(self._solve(chain, processes, limit))

    def tighten(self, processes: int, known: int) -> int | None:
        """Return the optimum of the whole robot, raising :attr:`lower` on the way; None if not.

        Args:
            processes: P.
            known: time of a schedule that is known, ticks.
        """
        self.lower = max(self.lower, min(known, self.rough(WHOLE, processes)))
        step = 8
        try:
            while self.lower < known:
                limit = known if step <= 1 else self.lower + max(1, (known - self.lower) // step)
                found = self.time(WHOLE, processes, limit)
                if found < limit:
                    self.lower = found
                    return found
                self.lower = max(self.lower, min(found, known))
                step //= 2
        except OutOfBudget:
            return None
        return known

    def _solve(self, chain: Chain, processes: int, limit: int) -> Task[int]:
        if processes == 1:
            return self.costs.price(chain).total
        key = (chain, processes)
        known, exact = self._memo.get(key, (0, False))
        if exact or known >= limit:
            return known
        self.budget.spend()
        best, choice, lowest = self.costs.price(chain).total, None, FOREVER
        options = self._options(chain, processes)
        for i in range(len(options.bound))[: self.width]:
            bound = int(options.bound[i])
            if bound >= min(best, limit):
                lowest = min(lowest, bound)
                break
            position, p = int(options.position[i]), int(options.first[i])
            value, local = yield self._try(chain, position, p, processes - p, min(best, limit))
            if value < min(best, limit):
                best, choice = value, Choice(position, p, processes - p, local)
            else:
                lowest = min(lowest, value)
        exact = self.width is not None or best < limit or best <= lowest
        value = best if exact else max(known, min(best, lowest))
        self._memo[key] = (value, exact)
        if exact:
            self._choices[key] = choice
        return value

    def _try(
        self, chain: Chain, position: int, first: int, second: int, goal: int
    ) -> Task[tuple[int, bool]]:
        """Return the time with a cut (or a bound >= goal), and whether the root side is local."""
        costs = self.costs
        root, end = costs.chains.split(chain, position)
        cost = costs.cut(chain, position)
        sides = [(root, first), (end, second)]
        away = [costs.transit(side) for side, _ in sides]
        low = [max(self.rough(*s), self._memo.get(s, (0, False))[0]) for s in sides]
        if cost + _together(low, away)[0] >= goal:
            return cost + _together(low, away)[0], True
        for k in (0, 1) if low[0] >= low[1] else (1, 0):
            low[k] = yield self._solve(*sides[k], goal - cost)
            together, local = _together(low, away)
            if cost + together >= goal:
                return cost + together, local == 0
        return cost + together, local == 0

    # --- the schedule ----------------------------------------------------------------------------

    def draft(self, processes: int) -> Draft:
        """Return the schedule of the whole robot that :meth:`time` has found."""
        chains = self.costs.chains
        draft = Draft(len(chains.original))
        stack: list[tuple[Chain, int, int, int, bool]] = [(WHOLE, processes, 0, -1, False)]
        while stack:
            chain, p, first, above, is_end = stack.pop()
            choice = self._choices.get((chain, p))
            if choice is None:
                joint = self._segment(draft, chain, (first, first + p))
            else:
                joint = chains.original[choice.position]
                draft.ranges[joint] = (first, first + p)
                root, end = chains.split(chain, choice.position)
                starts = (first, first + choice.first)
                if not choice.root_local:
                    starts = (first + choice.second, first)
                stack.append((root, choice.first, starts[0], joint, False))
                stack.append((end, choice.second, starts[1], joint, True))
            if above < 0:
                draft.root = joint
            else:
                (draft.end_child if is_end else draft.root_child)[above] = joint
        return draft

    def _segment(self, draft: Draft, chain: Chain, processes: tuple[int, int]) -> int:
        """Put a chain of one process under its joint nearest to the ground; return that joint."""
        chains = self.costs.chains
        order = [chains.original[p] for p in reversed(chains.positions(chain))]
        for joint in order:
            draft.ranges[joint] = processes
        return draft.contract(chains.topology, order)


def _together(times: list[int], away: list[int]) -> tuple[int, int]:
    """Return the time of two sides, and which one stays where they are joined."""
    stay = [max(times[0], times[1] + away[1]), max(times[1], times[0] + away[0])]
    return (stay[0], 0) if stay[0] <= stay[1] else (stay[1], 1)
