"""Branch and bound over layouts: root, core, and owners of limbs.

Meeting places (meeting_places.py) are tried by their bounds, the smallest first, until none can be
faster than the best layout found; the limbs of each are distributed by branch and bound as well
(assignment.py). Layouts that differ in the numbers of their processes only count as one.
"""

from __future__ import annotations

import heapq
from collections import Counter
from collections.abc import Sequence
from itertools import accumulate, count
from math import inf

from adagen.search.assignment import Assignment
from adagen.search.even_shares import EvenShares, evenly, halves
from adagen.search.incumbent import LOOK, Incumbent, Spent
from adagen.search.layout_bounds import Bounds
from adagen.search.layouts import Layout, LayoutPrices, MeetingPlace
from adagen.search.meeting_places import MeetingPlaces, in_place

_PLACES = 12  # meeting places in which layouts are guessed that bring nothing, before that ends
_MANY = 100  # times as many meeting places that are looked at for these


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
        self.places = MeetingPlaces(prices.robot, roots)
        self.found = Incumbent(prices, bounds, spent)
        self.lower = 0.0

    @property
    def left_over(self) -> bool:
        """Whether the budget ended before all was looked at."""
        return self.lower < self.found.best

    def start(self) -> None:
        """Price some layouts that share out evenly what limbs take by themselves.

        The most promising of the first meeting places are looked at, as long as that helps.
        """
        waited = 0
        for place, even in self._evenly(self.bounds.joint_bounds.by_itself):
            if waited == _PLACES or 4 * self.spent.spent > self.spent.limit:
                break
            before = self.found.best
            self.spent.on(self.found.share * len(even.shares))
            self.found.consider(place, even.shares)
            waited = 0 if self.found.best < before else waited + 1

    def even(self, weights: Sequence[float], most: int) -> list[Layout]:
        """Return layouts that share out joints evenly, the most promising first.

        Args:
            weights: what each joint takes; length N.
            most: so many at most, for each number of processes that have work.
        """
        found: list[Layout] = []
        counts: Counter[int] = Counter()
        for place, even in self._evenly(weights):
            if counts[len(even.shares)] == most:
                continue
            idle = [()] * (self.bounds.processes - len(even.shares))
            layout = Layout(place, (*even.shares, *idle))
            prices = self.found.prices
            if in_place(layout, prices.robot) and prices.time(layout) is not None:
                found.append(layout)
                counts[len(even.shares)] += 1
        return found

    def _evenly(self, weights: Sequence[float]) -> list[tuple[MeetingPlace, EvenShares]]:
        """Limbs of the first meeting places, shared out evenly, by the time of the busiest."""
        joint_bounds, sums = self.bounds.joint_bounds, [0.0, *accumulate(weights)]
        waiting = self.places.first()
        found: list[tuple[float, int, MeetingPlace, EvenShares]] = []
        for seen in range(_PLACES * _MANY):
            if seen == len(waiting) or not self.spent.on(LOOK):
                break
            place = waiting[seen]
            waiting += self.places.after(place)
            if self.places.meets(place):
                limbs = [
                    sum(sums[span.stop] - sums[span.start] for span in limb.spans)
                    + (joint_bounds.upwards(limb).both if limb.up else 0.0)
                    for limb in place.limbs
                ]
                core = sum(
                    joint_bounds.way(core.root) + sum(weights[j] for j in core.joints)
                    for core in place.cores
                )
                for processes in reversed(halves(self.bounds.processes)):
                    even = evenly(limbs, processes)
                    found.append((even.time + core, seen, place, even))
        found.sort(key=lambda each: each[:2])
        return [(place, even) for _, _, place, even in found]

    def run(self, known: float = inf) -> None:
        """Search as far as the budget goes.

        Args:
            known: a time that is to be beaten, microseconds.
        """
        found = self.found
        found.best = min(known, *(time for time, _, _ in found.nearest[:1]), inf)
        order = count()
        heap: list[tuple[float, int, MeetingPlace, Assignment | None]] = []
        waiting = self.places.first()
        left = found.best
        while True:
            for place in waiting:
                bound = self.bounds.place(place.cores, place.limbs)
                if bound < found.best:
                    heapq.heappush(heap, (bound, next(order), place, None))
            if not heap or heap[0][0] >= found.best or not self.spent.on(LOOK):
                break
            bound, _, place, own = heapq.heappop(heap)
            if own is not None:
                left, waiting = min(left, own.run()), []
                continue
            waiting = self.places.after(place)
            if self.places.meets(place):  # its own layouts come when their bound is the least
                own = Assignment(found, place, bound)
                if own.bound < found.best:
                    heapq.heappush(heap, (own.bound, next(order), place, own))
        if heap:
            left = min(left, heap[0][0])
        self.lower = min(left, found.best)
