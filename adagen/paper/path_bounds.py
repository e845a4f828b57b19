"""Lower bound on the time of a partial chain from a link at which many joints meet.

The nodes whose chains contain a link v are on one path of the schedule tree. Each of them cuts off
a *piece*: the side without v, which lies within one branch at v. When the range of processes is
divided the piece goes to other processes, but that can happen only so often until one process is
left. Everything else is done by the processes that work on v, one thing after the other:

* every joint that is in no piece given away is a node of the path, or waits for one;
* with pieces replaced by bare links, the path assembles what is left, which costs no less than the
  least work of that (III-D), counting only boundary joints at one link: those decide nothing then
  but the degree of that link.

So the time is at least the least work of the chain without its largest branches at v. Where a range
may be shared, a piece that stays is worked on by all of the range, and takes a bounded share.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from adagen.schedule.chains import Chain, Chains

Ints = NDArray[np.int64]
Spread = Callable[[Ints, int], Ints]


class PathBounds:
    """The bound of every link of a partial chain at once.

    Args:
        chains: the robot.
        spread: least times for amounts of work on a number of processes; concave in the work.
        shares: whether descendants may share a range.
        halving: whether a range is divided in halves.
    """

    def __init__(self, chains: Chains, spread: Spread, *, shares: bool, halving: bool) -> None:
        self.chains = chains
        self._spread = spread
        self._shares = shares
        self._halving = halving
        self._parent = np.array(chains.parent, dtype=np.int64)
        self._end = np.array(chains.end, dtype=np.int64)
        self._fixed = np.array(chains.fixed, dtype=np.int64)
        self._link = np.array([chains.q_sum[d] for d in chains.degree], dtype=np.int64)
        self._degree = np.array(chains.degree, dtype=np.int64)
        self._known: dict[tuple[Chain, int], int] = {}

    def bound(self, chain: Chain, processes: int) -> int:
        """Return a lower bound on f(S, P) in ticks, for P of two or more and S of some joints."""
        key = (chain, processes)
        known = self._known.get(key)
        if known is None:
            known = self._known[key] = self._bound(chain, processes)
        return known

    def _bound(self, chain: Chain, processes: int) -> int:
        chains = self.chains
        given = processes.bit_length() - 1 if self._halving else processes - 1
        if self._meeting(chain) <= given:
            return 0  # every branch could be given away
        at = np.concatenate([np.arange(a, b) for a, b in chains.ranges(chain)])
        own, outside = self._own(chain)
        # Work below each position, itself and its link included, and in all.
        work = self._fixed[at] + own[at + 1]
        before = np.concatenate([[0], np.cumsum(work)])
        below = before[np.searchsorted(at, self._end[at])] - before[:-1]
        total = int(before[-1] + own[chain.top])
        # The root node has all boundary joints around it; counted are those at one link.
        q = chains.q
        extra = q[chains.boundary(chain)] - q[outside]
        links = np.concatenate([self._parent[at], at + 1])
        branch = np.concatenate([below - self._fixed[at], total - below])
        order = np.lexsort((-branch, links))
        links, branch = links[order], branch[order]
        first = np.flatnonzero(np.concatenate([[True], links[1:] != links[:-1]]))
        counts = np.diff([*first, len(links)])
        rank = np.arange(len(links)) - np.repeat(first, counts)
        away = np.add.reduceat(np.where(rank < given, branch, 0), first)
        if not self._shares:
            return total - int(away.min()) + extra
        rest = np.add.reduceat(branch, first) - away
        return self._shared(total + extra, rest, away, branch[first], processes)

    def _meeting(self, chain: Chain) -> int:
        """Return the largest number of joints at a link of a chain, those outside counted too."""
        most = self.chains.degree[chain.top]
        for a, b in self.chains.ranges(chain):
            most = max(most, int(self._degree[a + 1 : b + 1].max()))
        return most

    def _shared(self, total: int, rest: Ints, away: Ints, size: Ints, processes: int) -> int:
        """Return the best bound where what stays of the branches is shared out.

        Args:
            total: work of the path with all branches.
            rest: for each link, work of the branches that stay.
            away: for each link, work of those given away.
            size: for each link, the largest branch, so the largest piece.
            processes: P.
        """
        share = self._spread(np.maximum(size, 1), processes) / np.maximum(size, 1)
        time = (total - rest - away) + share * rest
        at = int(time.argmax())
        # Exact for the link that looks best: floats decide nothing but which one that is.
        piece, stays = int(size[at]), int(rest[at])
        tower = total - stays - int(away[at])
        if not piece:
            return tower
        spread = int(self._spread(np.array([piece], dtype=np.int64), processes)[0])
        return tower + spread * stays // piece

    def _own(self, chain: Chain) -> tuple[Ints, int]:
        """Return what assembly at each link costs, and the number of boundary joints counted.

        Boundary joints are counted at that one link only, the one where they cost most.
        """
        chains = self.chains
        taken: dict[int, int] = {}
        for link in chains.handles(chain):
            taken[link] = taken.get(link, 0) + 1
        own = self._link.copy()
        best, most, outside = 0, -1, 0
        for link, out in taken.items():
            degree = chains.degree[link]
            own[link] = chains.q_sum[degree - out]
            gain = chains.q_sum[degree] - chains.q_sum[out] - int(own[link])
            if gain > best:
                best, most, outside = gain, link, out
        if most >= 0:
            own[most] += best
        return own, outside
