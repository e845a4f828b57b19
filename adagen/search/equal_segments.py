"""First schedules: a robot cut into segments of equal time.

What a search of a few options at a time misses: the outermost segment of a long chain carries no
mobility, so that one process passes several times as many joints there as in between.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

import numpy as np
from numpy.typing import NDArray

from adagen.paper.budget import Budget, OutOfBudget
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.segment_costs import SegmentCosts
from adagen.search.segment_bounds import SegmentBounds
from adagen.search.segment_pareto import Label
from adagen.search.segment_search import SegmentSearch

_FINE = 1 / 500
"""Share of a time to which the least one is sought."""
_WIDTH = 64  # what follows is a guess: no bound rules anything out
_HALVES = 4  # cuts that are tried at each chain
_MANY = 8  # segments up to which all numbers of them are tried


def even_cuts(costs: SegmentCosts, cuttable: NDArray[np.bool_], segments: int) -> list[int]:
    """Return the positions at which a robot falls into so many segments, alike in time.

    Args:
        costs: prices of the robot's chains and cuts.
        cuttable: per position, whether two processes may meet there.
        segments: how many at most.
    """
    low, high = 0, _alone(costs)
    found: list[int] = []
    while high - low > max(1, int(_FINE * high)):
        middle = (low + high) // 2
        cuts = _within(costs, cuttable, middle)
        if cuts is not None and len(cuts) < segments:
            high, found = middle, cuts
        else:
            low = middle
    return found


def _alone(costs: SegmentCosts) -> int:
    """What one process takes for the whole robot, ticks."""
    price = costs.price(WHOLE)
    return costs.start + price.kinematics + price.sweeps.total


def _within(costs: SegmentCosts, cuttable: NDArray[np.bool_], time: int) -> list[int] | None:
    """Where to cut so that segments keep within a time, from the ends inwards; None: nowhere."""
    chains, found = costs.chains, list[int]()
    room = time - costs.start - costs.whole_root.total
    handles: set[int] = set()
    parts: dict[int, list[tuple[int, int]]] = {}
    for link in range(len(chains.parent), -1, -1):
        own = parts.pop(link, [])
        work = sum(part for part, _ in own)
        for part, p in sorted(own, reverse=True):
            if work <= room - costs.kinematics[link]:
                break
            if cuttable[p]:
                found.append(p)
                handles.add(link)
                work -= part
        if work > room - costs.kinematics[link]:
            return None
        if link:
            p = link - 1
            if link in handles and not costs.free[p]:
                handles.add(chains.parent[p])
                work += costs.outward[p].total + costs.spread + costs.load
            parts.setdefault(chains.parent[p], []).append(
                (work + costs.own[p] + costs.alone[p].total, p)
            )
    return found


class _Joining(SegmentSearch):
    """The search among schedules that make some cuts and no others.

    Args:
        cuts: their positions.
    """

    def __init__(
        self,
        costs: SegmentCosts,
        bounds: SegmentBounds,
        speeds: tuple[float, ...],
        budget: Budget,
        cuts: list[int],
    ) -> None:
        super().__init__(costs, bounds, speeds, budget, _WIDTH)
        self._cuts = sorted(cuts)

    def _followed(self, chain: Chain, count: int) -> Iterator[tuple[int, int, int, int, int]]:
        chains = self.costs.chains
        own, ends = [p for p in self._cuts if self._parts(chain, p)], chains.end
        sizes = [(1 + sum(p < q < ends[p] for q in own), p) for p in own]
        # Few joins are above each segment where halves have about as many of them.
        for beyond, p in sorted(sizes, key=lambda each: abs(2 * each[0] - len(own) - 1))[:_HALVES]:
            if beyond < count:
                yield 0, 0, 0, p, count - beyond

    def _parts(self, chain: Chain, position: int) -> bool:
        """Whether a cut leaves joints of a chain on both of its sides."""
        chains = self.costs.chains
        if not any(first <= position < last for first, last in chains.ranges(chain)):
            return False
        return all(chains.ranges(side) for side in chains.split(chain, position))


def evenly_cut(
    costs: SegmentCosts,
    bounds: SegmentBounds,
    cuttable: NDArray[np.bool_],
    speeds: tuple[float, ...],
    budget: Budget,
    best: Label,
) -> Label:
    """Return the best way to do the whole robot by even cuts, or one that is known.

    Args:
        costs: prices of the robot's chains and cuts.
        bounds: on their times.
        cuttable: per position, whether two processes may meet there.
        speeds: of the cores of all processes.
        budget: what may be spent.
        best: the way that is known.
    """
    for segments in _numbers(len(speeds)):
        cuts = even_cuts(costs, cuttable, segments)
        search = _Joining(costs, bounds, speeds, budget, cuts)
        with suppress(OutOfBudget):
            search.solve(best.time.total)
        best = search.best or best
    return best


def _numbers(processes: int) -> Iterator[int]:
    """Numbers of segments that are tried, down from all: a third less each time, then each."""
    count = processes
    while count > 1:
        yield count
        count -= 1 if count <= _MANY else count // 3
