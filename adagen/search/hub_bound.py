"""Bound on joined schedules of robots with links that bear many limbs, such as palms of hands.

Such a link, a hub, is in the segment of one process. Each cut around that segment is a join that
waits for it, in both sweeps, and rids it of one limb at most, or of what is on the ground's side.
Two hubs are either in one segment, which then has all between them too; or one of them is in a part
that is told to the process which joins both. So there are few cases, whatever the number of
processes, where the bound by work (segment_bounds.py) gets smaller with each of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate, combinations
from math import floor, inf

from adagen.schedule.profile import TICKS
from adagen.schedule.segment_costs import SegmentCosts
from adagen.search.whole_limb_bounds import WholeLimbBounds

_LIMBS = 3
"""Limbs from which on a link is a hub."""


@dataclass(frozen=True)
class _Hub:
    """A link that bears many limbs.

    Attributes:
        link: its number, by position as all else.
        limbs: their first positions, those with the longest chains first.
        above: positions on the way to the ground.
    """

    link: int
    limbs: tuple[int, ...]
    above: tuple[int, ...]


class Hubs:
    """Bounds by the hubs of a robot.

    Args:
        costs: least prices of segments and joins.
        whole_limbs: what joints take at least which hang together.
        fastest: speed of the fastest core.
    """

    def __init__(self, costs: SegmentCosts, whole_limbs: WholeLimbBounds, fastest: float) -> None:
        self._costs, self._whole_limbs, self._fastest = costs, whole_limbs, fastest
        self._chains = chains = costs.chains
        self._plain = [whole_limbs.plain[j] for j in chains.original]
        self._reach = [0] * len(chains.parent)  # plain joints on the longest way from each on
        below: list[list[int]] = [[] for _ in range(len(chains.parent) + 1)]
        for p in reversed(range(len(chains.parent))):
            longest = max((self._reach[k] for k in below[p + 1]), default=0)
            self._reach[p] = self._plain[p] + longest
            below[chains.parent[p]].append(p)
        self._hubs = [
            _Hub(
                link,
                tuple(sorted(limbs, key=lambda p: -self._reach[p])),
                tuple(chains.above(link)),
            )
            for link, limbs in enumerate(below)
            if link > 0 and len(limbs) >= _LIMBS
        ]
        message = costs.message([1])
        self._away = sum(message.away)
        self._handling = message.handling.total

    def least(self, processes: int) -> int:
        """Return a lower bound on the time of schedules that cut the robot, ticks.

        Args:
            processes: how many there may be.
        """
        single = [self._single(hub, processes - 1) for hub in self._hubs]
        least = max(single, default=0.0)
        for (a, one), (b, other) in combinations(zip(self._hubs, single, strict=True), 2):
            between = set(a.above) ^ set(b.above)
            if any(self._chains.parent[p] == 0 for p in between) or a.above == b.above:
                continue  # they may have nothing to tell each other
            apart = min(one, other) + self._away
            least = max(least, min(apart, self._together(a, b, between, processes - 1)))
        return floor(least)

    def _join(self, positions: Sequence[int]) -> float:
        """The least that the join of a cut takes at one of some joints."""
        found = inf
        for p in positions:
            told = self._handling if self._chains.parent[p] else 0
            found = min(found, self._costs.join[p].total / self._fastest + told)
        return found

    def _limb_joins(self, hub: _Hub, most: int) -> Iterator[tuple[int, float]]:
        """How many limbs are cut, and what these joins take at least."""
        ends = self._chains.end
        inside = [p for limb in hub.limbs for p in range(limb, ends[limb])]
        join = self._join(inside)
        for count in range(min(most, len(hub.limbs)) + 1):
            yield count, count * join if count else 0.0

    def _single(self, hub: _Hub, cuts: int) -> float:
        """The least where so many cuts may be around the segment of a hub."""
        costs, plain = self._costs, self._plain
        least, way, rubbed = inf, 0, 0.0
        rub = sorted(sum(costs.tangents[p : self._chains.end[p]]) for p in hub.limbs)
        # By the cut towards the ground: at each joint on the way there, and at last none.
        for above in (*hub.above, None):
            once, most = costs.start, cuts
            if above is not None:
                once += costs.kinematics[above + 1] + costs.whole_root.total
                most -= 1
            if most < 0:
                continue
            for count, joins in self._limb_joins(hub, most):
                chains = [self._reach[p] for p in hub.limbs[count:]]
                # Whichever limbs are cut, so many are left, and the friction of those with least.
                work = once + rubbed + sum(rub[: len(chains)])
                work += self._whole_limbs.beside(chains, way) * TICKS
                time = work / self._fastest + joins
                if above is not None:
                    time += self._join([above])
                least = min(least, time)
            if above is not None:
                way += plain[above]
                rubbed += costs.tangents[above]
        return least

    def _together(self, a: _Hub, b: _Hub, between: set[int], cuts: int) -> float:
        """The least where two hubs are in one segment: the work of both and of all between them."""
        limbs = {p for hub in (a, b) for p in hub.limbs if p not in between}
        # Of three chains side by side one at least has joints of limbs alone.
        depth = self._chains.depth
        longest = max(
            depth[p + 1] - depth[self._chains.parent[limb]]
            for limb in limbs
            for p in range(limb, self._chains.end[limb])
        )
        share = self._whole_limbs.share(longest) * TICKS
        works = sorted(
            (self._work(range(p, self._chains.end[p]), share) for p in limbs), reverse=True
        )
        sums = [0.0, *accumulate(works)]
        inside = [p for limb in limbs for p in range(limb, self._chains.end[limb])]
        join = self._join(inside)
        whole = self._costs.start + sums[-1] + self._work(between, share)
        return min(
            (whole - sums[count]) / self._fastest + (count * join if count else 0.0)
            for count in range(min(cuts, len(works)) + 1)
        )

    def _work(self, positions: Iterable[int], share: float) -> float:
        """The least that joints add to the work of a segment, ticks.

        Args:
            positions: the joints.
            share: what each plain one takes at least, without its friction.
        """
        costs = self._costs
        own = ((p, costs.own[p] + costs.alone[p].total) for p in positions)
        return sum(
            max(share + costs.tangents[p], least) if self._plain[p] else least for p, least in own
        )
