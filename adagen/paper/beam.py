"""Beam search for a first schedule."""

from __future__ import annotations

from itertools import product
from time import monotonic

from adagen.paper.budget import Budget, OutOfBudget, Task, run
from adagen.paper.successors import FOREVER, Option, Space
from adagen.paper.tie_break import Builder, Choice
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.tree_draft import Draft


class Beam:
    """Beam search over partial chains; finds a schedule, proves nothing.

    Args:
        space: the search space.
        width: options that divide the processes, followed at each state; of the others, half.
        sharp: whether options are distinguished by the bounds on their sides, which sees where many
            joints meet, or by the work on their sides alone, which sees balance. Neither is always
            the better guide.
        budget: where it ends, chains not reached any more are left to the order of least work.
    """

    def __init__(self, space: Space, width: int, budget: Budget, sharp: bool = False) -> None:
        self.space = space
        self.width = width
        self.sharp = sharp
        self.budget = budget
        self._memo: dict[tuple[int, int], int] = {}

    def time(self, processes: int) -> int:
        """Return the time of the schedule that :meth:`draft` gives, ticks."""
        return run(self._solve(WHOLE, processes))

    def draft(self, processes: int) -> Draft:
        """Return the schedule found for the whole robot."""

        def choose(chain: Chain, p: int, _: int) -> Choice | None:
            option = self._choice(chain, p)
            return None if option is None else (option, (0, 0))

        return self.builder().fill(processes, 0, choose)

    def builder(self) -> Builder:
        """Return what puts a schedule together."""
        return Builder(self.space)

    def key(self, chain: Chain) -> int:
        """Return a number that chains share if and only if they have the same schedules."""
        return self.space.canon.key(chain)

    def _choice(self, chain: Chain, processes: int) -> Option | None:
        """Return the best option followed; None: the order of least work."""
        best, choice = self.space.single.work(chain), None
        if processes == 1:
            return None
        for bound, option in self._promising(chain, processes):
            if bound < best and (time := run(self._try(option))) < best:
                best, choice = time, option
        return choice

    def _promising(self, chain: Chain, processes: int) -> list[tuple[int, Option]]:
        """Return the most promising options and their bounds."""
        options = self.space.options(chain, processes)
        left = [self.width, (self.width + 1) // 2]
        chosen = []
        easy = options.take(~options.hard)
        lower = self._sharp if self.sharp else self._rough
        limit = FOREVER if self.sharp else 0
        for bound, option in self.space.best_first(chain, processes, easy, limit, lower):
            if left[option.shared]:
                left[option.shared] -= 1
                chosen.append((bound, option))
            if not any(left):
                break
        return chosen

    def _rough(self, chain: Chain, processes: int, work: int) -> int:  # noqa: ARG002
        return 0

    def _sharp(self, chain: Chain, processes: int, work: int) -> int:
        if work == 0 or processes == 1:
            return work
        bounds = self.space.bounds
        return max(bounds.spread(work, processes), bounds.meeting(chain, processes))

    def _try(self, o: Option) -> Task[int]:
        root: int = (yield self._solve(o.root, o.first)) if o.root_work else 0
        end: int = (yield self._solve(o.end, o.second)) if o.end_work else 0
        return o.cost + (root + end if o.shared else max(root, end))

    def _solve(self, chain: Chain, processes: int) -> Task[int]:
        work = self.space.single.work(chain)
        processes = self.space.rules.useful(processes, self.space.size(chain))
        if processes == 1:
            return work
        key = (self.key(chain), processes)
        known = self._memo.get(key)
        if known is not None:
            return known
        self._memo[key] = best = work
        try:
            self.budget.spend()
        except OutOfBudget:
            return work
        for bound, option in self._promising(chain, processes):
            if bound < best:
                time: int = yield self._try(option)
                best = min(best, time)
        self._memo[key] = best
        return best


def incumbent(
    space: Space, processes: int, lower: int, expansions: int, deadline: float | None
) -> tuple[int, Draft]:
    """Return the best of several beams of growing width: its time in ticks and the schedule.

    Args:
        space: the search space.
        processes: P.
        lower: a proven bound; a schedule that meets it ends the search.
        expansions: states that may be expanded for either way to tell options apart.
        deadline: on the monotonic clock, after which no beam is begun; None for none.
    """
    best, chosen = FOREVER, None
    # Without branches the bounds tell the same.
    branched = max(space.chains.degree) > 2
    left = {False: expansions, True: expansions if branched else 0}
    for width, sharp in product((1, 2, 4, 8, 16), (False, True)):
        late = chosen is not None and deadline is not None and monotonic() > deadline
        if left[sharp] <= 0 or best <= lower or late:
            continue
        budget = Budget(left[sharp], deadline)
        beam = Beam(space, width, budget, sharp)
        time = beam.time(processes)
        if time < best:
            best, chosen = time, beam
        left[sharp] -= budget.expanded
    assert chosen is not None
    chosen.budget = Budget(1 << 30)
    return best, chosen.draft(processes)
