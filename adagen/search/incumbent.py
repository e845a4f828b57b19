"""The best layout so far, the expansions spent, and the next best layouts."""

from __future__ import annotations

from bisect import insort
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import count, permutations
from math import inf

from adagen.search.layout_bounds import Bounds
from adagen.search.layouts import Layout, LayoutPrices, MeetingPlace
from adagen.search.meeting_places import in_place

LOOK = 1
"""What a look at a meeting place or a layout costs."""
NEAREST = 3
"""Layouts that are kept, the best one among them, no two of which take as long."""
_SAME = 1e-9
_ALL_NUMBERS = 3
"""Processes up to which all ways to number them are tried."""


@dataclass
class Spent:
    """What a search may spend, and what it has spent.

    A meeting place, a layout or the share of a process is expanded once; the latter costs as much
    as the robot has joints, the others as much as a joint or two.

    Attributes:
        limit: what may be spent.
        spent: so much of it is.
        expanded: on so many.
    """

    limit: int
    spent: int = 0
    expanded: int = 0

    def on(self, cost: int) -> bool:
        """Spend something; return whether it was there."""
        if self.spent >= self.limit:
            return False
        self.spent += cost
        self.expanded += 1
        return True


class Incumbent:
    """The fastest layout that was priced.

    Args:
        prices: prices of layouts.
        bounds: lower bounds on them.
        spent: the budget.

    Attributes:
        best: a time that is to be beaten: the least that was found, or less; microseconds.
        layout: the fastest layout that beat it; None where none did.
        nearest: the fastest layouts, by their times.
        candidates: layouts that were priced.
        share: what pricing the share of a process costs.
    """

    def __init__(self, prices: LayoutPrices, bounds: Bounds, spent: Spent) -> None:
        self.prices, self.bounds, self.spent = prices, bounds, spent
        self.best = inf
        self.layout: Layout | None = None
        self.nearest: list[tuple[float, int, Layout]] = []
        self.candidates = 0
        joints = len(prices.robot.joints)
        self.share = round(joints * (1 + min(1.0, joints / 1000)))
        self._speeds = prices.pricing.costs.speeds(bounds.processes)
        self._number = count()

    def consider(self, place: MeetingPlace, shares: Sequence[tuple[int, ...]]) -> None:
        """Price a layout in several ways to number its processes, and keep the fastest of them."""
        least: tuple[float, Layout] | None = None
        for numbered in self._numbered(place, shares):
            layout = Layout(place, numbered)
            if not in_place(layout, self.prices.robot):
                return
            time = self.prices.time(layout)
            if time is None:
                return
            if least is None or time < least[0]:
                least = time, layout
        self.candidates += 1
        if least is not None:
            self._keep(*least)

    def _keep(self, time: float, layout: Layout) -> None:
        # What differs in limbs that are alike only takes as long.
        if all(abs(time - known) > _SAME for known, _, _ in self.nearest):
            insort(self.nearest, (time, next(self._number), layout))
            del self.nearest[NEAREST:]
        if time < self.best:
            self.best, self.layout = time, layout

    def _numbered(
        self, place: MeetingPlace, shares: Sequence[tuple[int, ...]]
    ) -> Iterator[tuple[tuple[int, ...], ...]]:
        """Ways to number processes, those with nothing to do last where all are alike."""
        processes, speeds = len(self._speeds), self._speeds
        idle = [()] * (processes - len(shares))
        alike = min(speeds) == max(speeds)
        if processes <= _ALL_NUMBERS or (len(shares) <= _ALL_NUMBERS and alike):
            given = shares if alike else [*shares, *idle]
            for order in dict.fromkeys(permutations(given)):
                yield (*order, *idle) if alike else order
            return

        def weight(own: tuple[int, ...]) -> float:
            return sum(self.bounds.joint_bounds.work(place.limbs[k]).both for k in own)

        light_first = sorted(shares, key=weight)
        if alike:
            yield (*light_first, *idle)
            yield (*reversed(light_first), *idle)
            return
        ranked = sorted(range(processes), key=lambda p: -speeds[p])
        found: list[tuple[int, ...]] = [()] * processes
        for p, own in zip(ranked, reversed(light_first), strict=False):
            found[p] = own
        yield tuple(found)
