"""Least number of segments of a partial chain within a given time.

Besides its joints a segment repeats the kinematics towards the ground, and carries mobility from
its root to its handles: what lies far out, or between others, takes longer than its share.
"""

from __future__ import annotations

from collections.abc import Sequence

from adagen.schedule.chains import Chain
from adagen.schedule.segment_costs import SegmentCosts

MANY = 1 << 30
"""More segments than there can be."""


class Room:
    """Counts the segments of one robot's chains.

    Args:
        costs: prices.
    """

    def __init__(self, costs: SegmentCosts) -> None:
        self.costs = costs
        self._alone = [own + alone.total for own, alone in zip(costs.own, costs.alone, strict=True)]
        rows = list(zip(costs.outward, costs.free, strict=True))
        rooted = [0 if free else out.total + costs.spread + costs.load for out, free in rows]
        held = [0 if free else out.total + costs.load for out, free in rows]
        # A floating chain has its root at a handle: what is beside it need not carry anything.
        self._out = {True: rooted, False: [0] * len(rows) if any(costs.free) else held}

    def segments(self, chain: Chain, time: int, most: int = MANY) -> int:
        """Return a lower bound on the number of segments, none of which takes longer than ``time``.

        From the ends inwards, each link knows the least number of segments cut off below it, and
        of those ways the least work of what is still open. Fewer segments are always better, as
        one more could be cut off right above the link; so the heaviest parts are cut off first.

        Args:
            chain: the chain.
            time: ticks on a core of speed 1.
            most: a number beyond which they need not be counted.

        Returns:
            The number, or one beyond ``most``; ``MANY`` if some joint alone takes longer.
        """
        chains, kinematics = self.costs.chains, self.costs.kinematics
        alone, out, parent = self._alone, self._out[chain.top > 0], chains.parent
        room = time - self.costs.start - (self.costs.whole_root.total if chain.top else 0)
        handles = {parent[cut] for cut in chain.cuts}
        parts: dict[int, list[int]] = {}
        count = 1
        for first, last in reversed(chains.ranges(chain)):
            for p in range(last - 1, first - 1, -1):
                link, above = p + 1, parent[p]
                work, cut = _within(parts.pop(link, ()), room - kinematics[link])
                if work < 0:
                    return MANY
                count += cut
                if count > most:
                    return count
                if cut or link in handles:
                    handles.add(above)
                    work += out[p]
                    handles.add(link)
                parts.setdefault(above, []).append(work + alone[p])
        work, cut = _within(parts.get(chain.top, ()), room - kinematics[chain.top])
        return MANY if work < 0 else count + cut


def _within(parts: Sequence[int], room: int) -> tuple[int, int]:
    """Return how much work stays if the fewest parts are cut off, and how many; -1 if too much."""
    work = sum(parts)
    if work <= room:
        return work, 0
    if room < 0:
        return -1, 0
    left = sorted(parts)
    while work > room:
        work -= left.pop()
    return work, len(parts) - len(left)
