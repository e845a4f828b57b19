"""Branch and bound over layouts: root, core, and owners of limbs.

Frames (frames.py) are tried by their bounds, the smallest first, until none can be faster than the
best layout found; the limbs of each are distributed by branch and bound as well (handout.py).
Layouts that differ in the numbers of their processes only count as one.
"""

from __future__ import annotations

import heapq
from collections import Counter
from collections.abc import Sequence
from itertools import accumulate, count
from math import inf

from adagen.search.bounds import Bounds
from adagen.search.frames import Frames, in_place
from adagen.search.guess import Guess, evenly, halves
from adagen.search.handout import HandOut
from adagen.search.incumbent import LOOK, Incumbent, Spent
from adagen.search.layouts import Frame, Layout, LayoutPrices

_FRAMES = 12  # frames in which layouts are guessed that bring nothing, before that ends
_MANY = 100  # times as many frames that are looked at for these


class GatheredSearch:
    """The fastest layout.

    Args:
        prices: prices of layouts.
        bounds: lower bounds on them.
        roots: for each link whether processes may meet around it; length N + 1.
        spent: the budget.

    Attributes:
        found: the best layout so far.
        lower: proven: no layout takes less, or it is no faster than the best.
    """

    def __init__(
        self,
        prices: LayoutPrices,
        bounds: Bounds,
        roots: Sequence[bool],
        spent: Spent,
    ) -> None:
        self.bounds, self.spent = bounds, spent
        self.frames = Frames(prices.robot, roots)
        self.found = Incumbent(prices, bounds, spent)
        self.lower = 0.0

    @property
    def left_over(self) -> bool:
        """Whether the budget ended before all was looked at."""
        return self.lower < self.found.best

    def guess(self) -> None:
        """Price some layouts that share out evenly what limbs take by themselves.

        The most promising of those frames that come first are looked at, as long as that helps.
        """
        waited = 0
        for frame, guess in self._evenly(self.bounds.floors.by_itself):
            if waited == _FRAMES or 4 * self.spent.spent > self.spent.limit:
                break
            before = self.found.best
            self.spent.on(self.found.share * len(guess.shares))
            self.found.consider(frame, guess.shares)
            waited = 0 if self.found.best < before else waited + 1

    def even(self, weights: Sequence[float], most: int) -> list[Layout]:
        """Return layouts that share out joints evenly, the most promising first.

        Args:
            weights: what each joint takes; length N.
            most: so many at most, for each number of processes that have work.
        """
        found: list[Layout] = []
        counts: Counter[int] = Counter()
        for frame, guess in self._evenly(weights):
            if counts[len(guess.shares)] == most:
                continue
            idle = [()] * (self.bounds.processes - len(guess.shares))
            layout = Layout(frame, (*guess.shares, *idle))
            prices = self.found.prices
            if in_place(layout, prices.robot) and prices.time(layout) is not None:
                found.append(layout)
                counts[len(guess.shares)] += 1
        return found

    def _evenly(self, weights: Sequence[float]) -> list[tuple[Frame, Guess]]:
        """Limbs of those frames that come first, shared out evenly, by the time of the busiest."""
        floors, sums = self.bounds.floors, [0.0, *accumulate(weights)]
        waiting = self.frames.first()
        found: list[tuple[float, int, Frame, Guess]] = []
        for seen in range(_FRAMES * _MANY):
            if seen == len(waiting) or not self.spent.on(LOOK):
                break
            frame = waiting[seen]
            waiting += self.frames.after(frame)
            if self.frames.meets(frame):
                limbs = [
                    sum(sums[span.stop] - sums[span.start] for span in limb.spans)
                    + (floors.upwards(limb).both if limb.up else 0.0)
                    for limb in frame.limbs
                ]
                core = sum(
                    floors.way(core.root) + sum(weights[j] for j in core.joints)
                    for core in frame.cores
                )
                for processes in reversed(halves(self.bounds.processes)):
                    guess = evenly(limbs, processes)
                    found.append((guess.time + core, seen, frame, guess))
        found.sort(key=lambda each: each[:2])
        return [(frame, guess) for _, _, frame, guess in found]

    def run(self, known: float = inf) -> None:
        """Search as far as the budget goes.

        Args:
            known: a time that is to be beaten, microseconds.
        """
        found = self.found
        found.best = min(known, *(time for time, _, _ in found.nearest[:1]), inf)
        order = count()
        heap: list[tuple[float, int, Frame, HandOut | None]] = []
        waiting = self.frames.first()
        left = found.best
        while True:
            for frame in waiting:
                bound = self.bounds.frame(frame.cores, frame.limbs, found.best)
                if bound < found.best:
                    heapq.heappush(heap, (bound, next(order), frame, None))
            if not heap or heap[0][0] >= found.best or not self.spent.on(LOOK):
                break
            bound, _, frame, own = heapq.heappop(heap)
            if own is not None:
                left, waiting = min(left, own.run()), []
                continue
            waiting = self.frames.after(frame)
            if self.frames.meets(frame):  # its own layouts come when their bound is the least
                own = HandOut(found, frame, bound)
                if own.bound < found.best:
                    heapq.heappush(heap, (own.bound, next(order), frame, own))
        if heap:
            left = min(left, heap[0][0])
        self.lower = min(left, found.best)
