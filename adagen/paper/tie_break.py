"""From the optimal time to one of the optimal schedules, chosen by the tie-break."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator

import numpy as np

from adagen.paper.branch_and_bound import ExactSearch
from adagen.paper.budget import Budget, Task, run
from adagen.paper.successors import FOREVER, Option, Options, Space
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.tree_draft import Draft

Choice = tuple[Option, tuple[int, int]]
"""How a chain is cut, and the time that is left to its root side and to its end side; ticks."""


class Builder:
    """Puts a tree together from options, from the root down."""

    def __init__(self, space: Space) -> None:
        self.space = space
        self.draft = Draft(len(space.topology))

    def leaf(self, chain: Chain, above: int, is_end: bool, processes: tuple[int, int]) -> None:
        """Add a chain in the order of least work, its ranges as III-C has them."""
        order = self.space.single.order(chain)
        top = self.draft.contract(self.space.topology, order)
        self.draft.hang(above, top, is_end)
        self.draft.assign(top, processes)

    def node(
        self, option: Option, above: int, is_end: bool, first: int, processes: int
    ) -> tuple[int, int]:
        """Add a node; return the first process of its root side and of its end side."""
        joint = self.space.chains.original[option.position]
        self.draft.hang(above, joint, is_end)
        self.draft.ranges[joint] = (first, first + processes)
        return first, first if option.shared else first + option.first

    def fill(
        self, processes: int, time: int, choose: Callable[[Chain, int, int], Choice | None]
    ) -> Draft:
        """Return the schedule of the whole robot, slots filled level by level, root side first.

        Args:
            processes: P.
            time: that is left to it, ticks.
            choose: says how a chain is cut on some processes within a time; None: it is not.
        """
        slots = deque([(WHOLE, processes, time, -1, False, 0)])
        while slots:
            chain, p, limit, above, is_end, first = slots.popleft()
            chosen = choose(chain, p, limit)
            if chosen is None:
                self.leaf(chain, above, is_end, (first, first + p))
                continue
            option, limits = chosen
            starts = self.node(option, above, is_end, first, p)
            joint = self.space.chains.original[option.position]
            if option.root_work:
                slots.append((option.root, option.first, limits[0], joint, False, starts[0]))
            if option.end_work:
                slots.append((option.end, option.second, limits[1], joint, True, starts[1]))
        return self.draft


def walk(
    space: Space, search: ExactSearch, processes: int, time: int, lexicographic: bool
) -> Draft:
    """Return a schedule that takes ``time``.

    Every slot takes the first option that fits into the time left for it: in the order of joints
    (and of processes for the root side) for the paper's tie-break, else the quickest to decide.

    Raises:
        OutOfBudget: the search cannot tell what fits.
    """

    def choose(chain: Chain, p: int, limit: int) -> Choice | None:
        if p == 1 or (not lexicographic and space.single.work(chain) <= limit):
            return None
        return _first_fit(space, search, chain, p, limit, lexicographic)

    return Builder(space).fill(processes, time, choose)


def _first_fit(
    space: Space, search: ExactSearch, chain: Chain, p: int, budget: int, lexicographic: bool
) -> tuple[Option, tuple[int, int]]:
    options = space.options(chain, p, every=lexicographic)
    for i in _in_order(space, chain, options, budget, lexicographic):
        o = space.option(chain, p, options, i)
        left = budget - o.cost
        if o.shared and o.root_work and o.end_work:
            end = search.time(o.end, o.second, left + 1)
            if search.fits(o.root, o.first, left - end):
                return o, (left - end, end)
        elif search.fits(o.root, o.first, left) and search.fits(o.end, o.second, left):
            return o, (left, left)
    raise AssertionError("a time that was found possible must be possible")


def _in_order(
    space: Space, chain: Chain, options: Options, budget: int, lexicographic: bool
) -> Iterator[int]:
    fit = np.flatnonzero(options.bound <= budget)
    if lexicographic:
        original = np.array(space.chains.original)[
            space.cutter.cuts(chain).position[options.cut[fit]]
        ]
        order = np.lexsort((options.first[fit], original))
    else:
        order = np.argsort(options.bound[fit], kind="stable")
    return iter(fit[order].tolist())


class LeastWork:
    """The least total work among the schedules of a chain that keep within a time."""

    def __init__(self, space: Space, search: ExactSearch, budget: Budget) -> None:
        self.space = space
        self.search = search
        self.budget = budget
        self._memo: dict[tuple[Chain, int, int], tuple[int, Option | None, tuple[int, int]]] = {}

    def draft(self, processes: int, time: int) -> Draft:
        """Return the schedule of the whole robot.

        Raises:
            OutOfBudget: not decided.
        """
        run(self._solve(WHOLE, processes, time))

        def choose(chain: Chain, p: int, limit: int) -> Choice | None:
            if p == 1 or self.space.single.work(chain) <= limit:
                return None
            _, option, limits = self._memo[chain, p, limit]
            assert option is not None
            return option, limits

        return Builder(self.space).fill(processes, time, choose)

    def _known(self, chain: Chain, p: int, limit: int) -> int | None:
        """Return the least work within ``limit`` if that needs no search."""
        known = self._memo.get((chain, p, limit))
        if known is not None:
            return known[0]
        work = self.space.single.work(chain) if self.space.size(chain) else 0
        if work <= limit:
            return work
        return FOREVER if p == 1 else None

    def _solve(self, chain: Chain, p: int, limit: int) -> Task[int]:
        """Return the least work within ``limit``, FOREVER if nothing keeps within it."""
        known = self._known(chain, p, limit)
        if known is not None:
            return known
        if not self.search.fits(chain, p, limit):
            self._memo[chain, p, limit] = (FOREVER, None, (0, 0))
            return FOREVER
        self.budget.spend()
        options = self.space.options(chain, p)
        fit = np.flatnonzero(options.bound <= limit)
        best, choice, limits = FOREVER, None, (0, 0)
        for i in fit[np.lexsort((options.bound[fit], options.work[fit]))].tolist():
            if int(options.work[i]) >= best:
                break
            option = self.space.option(chain, p, options, i)
            left = (limit - option.cost, limit - option.cost)
            if option.shared and option.root_work and option.end_work:
                end = self.search.time(option.end, option.second, left[0] + 1)
                left = (left[0] - end, end)
            value = option.cost
            for side in (
                (option.root, option.first, left[0]),
                (option.end, option.second, left[1]),
            ):
                if value < best:
                    least = self._known(*side)
                    value += (yield self._solve(*side)) if least is None else least
            if value < best:
                best, choice, limits = value, option, left
        self._memo[chain, p, limit] = (best, choice, limits)
        return best
