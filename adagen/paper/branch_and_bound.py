"""The exact search: AND/OR branch and bound over partial chains, remembered by isomorphism class.

f(S, P) = min over cuts of C + max(f(root side, P1), f(end side, P2)), with the sum in place of the
maximum where the sides share the range or one is a bare link, and f(S, 1) in closed form. A state
is a chain and a number of processes, so that independent sides are searched apart, not as a product
as in a search over sequences.
"""

from __future__ import annotations

from adagen.paper.budget import Budget, OutOfBudget, Task, run
from adagen.paper.successors import FOREVER, Option, Space
from adagen.schedule.chains import WHOLE, Chain


class ExactSearch:
    """Optimal times of partial chains, as far as the budget goes.

    Attributes:
        lower: proven lower bound on the time of the whole robot, ticks.
    """

    def __init__(self, space: Space, budget: Budget) -> None:
        self.space = space
        self.budget = budget
        self.lower = 0
        self._memo: dict[tuple[int, int], tuple[int, bool]] = {}

    def fits(self, chain: Chain, processes: int, limit: int) -> bool:
        """Return whether the chain can be done within ``limit`` ticks.

        Raises:
            OutOfBudget: cannot tell.
        """
        if limit < 0:
            return False
        return self.time(chain, processes, limit + 1) <= limit

    def time(self, chain: Chain, processes: int, limit: int = FOREVER) -> int:
        """Return f(S, P) if that is below ``limit``; else a lower bound on it, at least ``limit``.

        Raises:
            OutOfBudget: cannot tell.
        """
        if not (size := self.space.size(chain)):
            return 0
        processes = self.space.rules.useful(processes, size)
        if processes == 1:
            return self.space.single.work(chain)
        return run(self._solve(chain, processes, limit))

    def tighten(self, processes: int, known: int) -> int | None:
        """Look for the optimum of the whole robot, raising :attr:`lower` on the way.

        The limit goes up in steps, from the proven bound to what is known to be possible: what is
        ruled out quickly is remembered, and so is the bound where the budget ends.

        Args:
            processes: P.
            known: time of a schedule that is known, ticks.

        Returns:
            The optimum, or None if the budget ran out.
        """
        self.lower = max(self.lower, self.space.bounds.whole(processes))
        step = 64
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
        self.lower = known
        return known

    def _lower(self, chain: Chain, processes: int, work: int) -> int:
        """Return the best bound known without any search."""
        if work == 0 or processes == 1:
            return work
        bounds = self.space.bounds
        bound = max(bounds.spread(work, processes), bounds.meeting(chain, processes))
        known = self._memo.get((self.space.canon.key(chain), processes))
        return bound if known is None else max(bound, known[0])

    def _solve(self, chain: Chain, processes: int, limit: int) -> Task[int]:
        """Return what :meth:`time` promises, for two processes or more that are of use."""
        key = (self.space.canon.key(chain), processes)
        known, exact = self._memo.get(key, (0, False))
        if exact or known >= limit:
            return known
        known = max(known, self.space.bounds.meeting(chain, processes))
        if known >= limit:
            return known
        self.budget.spend()
        options = self.space.options(chain, processes)
        best = self.space.cutter.cuts(chain).work  # never slower than one process alone
        lowest = FOREVER
        for bound, option in self.space.best_first(
            chain, processes, options, min(best, limit), self._lower
        ):
            goal = min(best, limit)
            if bound >= goal:
                lowest = min(lowest, bound)
                break
            attempt = self._shared if option.shared else self._divided
            value: int = yield attempt(option, goal)
            if value < goal:
                best = value
            else:
                lowest = min(lowest, value)
        exact = best < limit or best <= lowest
        value = best if exact else max(known, min(best, lowest))
        self._memo[key] = (value, exact)
        return value

    def _side(self, chain: Chain, processes: int, work: int, limit: int) -> Task[int]:
        """Return the time of a side, or a bound that reaches ``limit``."""
        if work == 0:
            return 0
        processes = self.space.rules.useful(processes, self.space.size(chain))
        if processes == 1:
            return work
        time: int = yield self._solve(chain, processes, limit)
        return time

    def _divided(self, o: Option, goal: int) -> Task[int]:
        """Return the time of an option whose sides run side by side, or a bound >= ``goal``."""
        sides = [(o.root, o.first, o.root_work), (o.end, o.second, o.end_work)]
        lower = [self._lower(*side) for side in sides]
        if o.cost + max(lower) >= goal:
            return o.cost + max(lower)
        if lower[1] > lower[0]:
            sides.reverse()
            lower.reverse()
        limit = goal - o.cost
        time: int = yield self._side(*sides[0], limit)
        if time >= limit:
            return o.cost + time
        other: int = yield self._side(*sides[1], limit)
        return o.cost + max(time, other)

    def _shared(self, o: Option, goal: int) -> Task[int]:
        """Return the time of an option whose sides run one after the other, or a bound."""
        lower = self._lower(o.end, o.second, o.end_work)
        ahead = self._lower(o.root, o.first, o.root_work)
        if o.cost + ahead + lower >= goal:
            return o.cost + ahead + lower
        time: int = yield self._side(o.root, o.first, o.root_work, goal - o.cost - lower)
        if o.cost + time + lower >= goal:
            return o.cost + time + lower
        other: int = yield self._side(o.end, o.second, o.end_work, goal - o.cost - time)
        return o.cost + time + other
