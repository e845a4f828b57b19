"""One process (Section III-D): the least work of a partial chain, and an order that achieves it.

The paper's rule, read literally, is exact for at most one boundary joint. What follows is
exact for any number m of them. To assemble is to contract joints, and contracting links of degrees
d1 and d2 costs q(d1 + d2 - 2) on top of what every order pays. Hence, q not decreasing:

1. leaves without a boundary joint go first, at q(d - 1) each;
2. what is left is the Steiner tree of the boundary. A run of s links of degree 2 costs (s - 1) q(2)
   and then q(d) to join the branch link at its end, the smaller one if there are two;
3. the links of degree 3 and more that remain, at most m - 2, are merged in the best order, found by
   dynamic programming over their connected subsets.
"""

from __future__ import annotations

from itertools import pairwise

from adagen.paper.contraction import MOST_BRANCHES, Merge, TooManyBranches
from adagen.schedule.chains import Chain, Chains
from adagen.union_find import UnionFind


class SingleProcess:
    """The exact f(S, 1) of every partial chain of a robot, with what has been worked out kept."""

    def __init__(self, chains: Chains) -> None:
        self.chains = chains
        self._corrections: dict[tuple[int, ...], int] = {}
        self._merges: dict[tuple[tuple[int, ...], tuple[tuple[int, int], ...]], Merge] = {}

    def work(self, chain: Chain) -> int:
        """Return f(S, 1) in ticks; 0 for a bare link.

        Raises:
            TooManyBranches: see there.
        """
        if not self.chains.ranges(chain):
            return 0
        return self.chains.linear_work(chain) + self.correction(self.chains.handles(chain))

    def correction(self, handles: tuple[int, ...]) -> int:
        """Return what boundary joints at these links add to the linear work (may be negative).

        Args:
            handles: links that boundary joints touch, ascending, with repetition.

        Raises:
            TooManyBranches: see there; its ``least`` is a lower bound on the correction.
        """
        if len(handles) <= 1:
            return 0
        known = self._corrections.get(handles)
        if known is None:
            known = self._corrections[handles] = self._correct(handles)
        return known

    def _correct(self, handles: tuple[int, ...]) -> int:
        q, q_sum = self.chains.q, self.chains.q_sum
        near, inner = self._steiner(handles)
        degree = {v: len(near[v]) for v in near}
        for link in handles:
            degree[link] += 1
        total = -inner * q[1] - sum(q_sum[d] for d in degree.values())
        branches = [v for v in degree if degree[v] >= 3]
        if not branches:
            return total + (inner + len(degree) - 1) * q[2]
        number = {v: i for i, v in enumerate(branches)}
        edges = []
        for u in branches:
            for step in near[u]:
                run, last = _run(near, number, u, step)
                if last is None:
                    total += (run - 1) * q[2] + q[degree[u]]
                elif u < last:
                    edges.append((number[u], number[last]))
                    if run:
                        total += (run - 1) * q[2] + q[min(degree[u], degree[last])]
        try:
            return total + self.merge(tuple(degree[v] for v in branches), tuple(edges)).cost
        except TooManyBranches as error:
            raise TooManyBranches(total + error.least) from None

    def _steiner(self, handles: tuple[int, ...]) -> tuple[dict[int, list[tuple[int, int]]], int]:
        """Return the Steiner tree of links, runs shortened, and the number of links left out.

        The tree maps each key link (a handle, or where paths to handles meet) to its neighbours and
        the number of links in between.
        """
        chains = self.chains
        keys = set(handles)
        keys.update(chains.meet(a, b) for a, b in pairwise(handles))
        near: dict[int, list[tuple[int, int]]] = {v: [] for v in sorted(keys)}
        inner = 0
        path: list[int] = []
        for v in near:
            while path and path[-1] and not path[-1] <= v - 1 < chains.end[path[-1] - 1]:
                path.pop()
            if path:
                u = path[-1]
                between = chains.depth[v] - chains.depth[u] - 1
                near[u].append((v, between))
                near[v].append((u, between))
                inner += between
            path.append(v)
        return near, inner

    def merge(self, degrees: tuple[int, ...], edges: tuple[tuple[int, int], ...]) -> Merge:
        """Return the best way to merge a tree of links, all of degree 3 or more.

        Args:
            degrees: degree of each link, boundary joints counted.
            edges: pairs of link numbers, one less than there are links.

        Raises:
            TooManyBranches: there are more than ``MOST_BRANCHES`` links.
        """
        key = (degrees, edges)
        known = self._merges.get(key)
        if known is None:
            if len(degrees) > MOST_BRANCHES:
                # Merging two of them leaves degree 4 or more, and the last merge leaves all.
                outside = sum(degrees) - 2 * len(edges)
                q = self.chains.q
                raise TooManyBranches((len(degrees) - 2) * q[4] + q[outside])
            known = self._merges[key] = Merge(self.chains.q, degrees, edges)
        return known

    def order(self, chain: Chain) -> list[int]:
        """Return the chain's joints in an order of assembly whose total cost is f(S, 1).

        The joint next to the boundary (for the whole robot: to the ground) comes last, so that it
        is at the top of the schedule tree, as in the paper's Figs. 8 and 9.
        """
        chains = self.chains
        inside, steiner = self._parted(chain)
        parent = chains.parent
        degree: dict[int, int] = {}
        for link in chains.handles(chain) or (chain.top,):
            degree[link] = degree.get(link, 0) + 1
        for p in steiner:
            for link in (parent[p], p + 1):
                degree[link] = degree.get(link, 0) + 1
        order = [p for p, _, _ in reversed(chains.outwards(inside, sorted(degree)))]
        order += self._contract(steiner, degree)
        return [chains.original[p] for p in order]

    def _parted(self, chain: Chain) -> tuple[list[int], list[int]]:
        """Return the positions outside the Steiner tree of the boundary, and those in it."""
        chains = self.chains
        m = chains.boundary(chain)
        begins = [0] * (len(chains.original) + 1)  # boundary joints below, as prefix sums
        for cut in chain.cuts:
            begins[cut + 1] = 1
        for p in range(1, len(begins)):
            begins[p] += begins[p - 1]
        outside: list[int] = []
        steiner: list[int] = []
        for p in chains.positions(chain):
            below = begins[chains.end[p]] - begins[p + 1]
            (steiner if 0 < below < m else outside).append(p)
        return outside, steiner

    def _contract(self, steiner: list[int], degree: dict[int, int]) -> list[int]:
        """Return the positions of a Steiner tree in the best order of contraction."""
        parent = self.chains.parent
        runs = UnionFind[int]()  # of links between branches
        order, edges = [], []
        attached: dict[int, list[tuple[int, int]]] = {}
        for p in reversed(steiner):
            if degree[parent[p]] == degree[p + 1] == 2:
                runs.join(p + 1, parent[p])
                order.append(p)
        for p in steiner:
            big = [v for v in (parent[p], p + 1) if degree[v] > 2]
            if len(big) == 2:
                edges.append((big[0], big[1], p))
            elif big:
                low = p + 1 if big[0] == parent[p] else parent[p]
                attached.setdefault(runs.of(low), []).append((big[0], p))
        for ends in attached.values():
            ends.sort(key=lambda end: degree[end[0]])
            order.append(ends[0][1])
            if len(ends) == 2:
                edges.append((ends[0][0], ends[1][0], ends[1][1]))
        branches = sorted(v for v in degree if degree[v] > 2)
        if branches:
            number = {v: i for i, v in enumerate(branches)}
            pairs = tuple((number[u], number[v]) for u, v, _ in edges)
            merge = self.merge(tuple(degree[v] for v in branches), pairs)
            order += [edges[i][2] for i in merge.order]
        return order


def _run(
    near: dict[int, list[tuple[int, int]]], number: dict[int, int], u: int, step: tuple[int, int]
) -> tuple[int, int | None]:
    """Walk from a branch link; return the links of the run, and the branch link at its end."""
    before, (at, run) = u, step
    while at not in number:
        run += 1
        onward = [s for s in near[at] if s[0] != before]
        if not onward:
            return run, None
        before, at, run = at, onward[0][0], run + onward[0][1]
    return run, at
