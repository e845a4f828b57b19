"""The cheapest contraction of a few links of degree 3 or more: step 3 for one process."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from adagen.paper.budget import OutOfBudget

MOST_BRANCHES = 12
"""Branch links up to which the merge of step 3 (adagen.paper.one_process) is solved."""


class TooManyBranches(OutOfBudget):
    """The Steiner tree of a boundary has more branch links than the exact merge is meant for."""

    def __init__(self, least: int) -> None:
        super().__init__()
        self.least = least


class SupportsJoin(Protocol):
    """Anything that prices a boundary, such as the costs ``q`` of :class:`Chains`."""

    def __getitem__(self, k: int, /) -> int: ...


class Merge:
    """The cheapest contraction of a small tree of links.

    Attributes:
        cost: sum of q(d1 + d2 - 2) over the contractions.
        order: indices of the edges in order of contraction.
    """

    def __init__(
        self, q: SupportsJoin, degrees: Sequence[int], edges: Sequence[tuple[int, int]]
    ) -> None:
        self._q, self._degrees, self._edges = q, degrees, edges
        self._best: dict[int, tuple[int, tuple[int, ...]]] = {}
        self.cost, self.order = self._solve((1 << len(degrees)) - 1)

    def _solve(self, links: int) -> tuple[int, tuple[int, ...]]:
        """Return cost and order for a connected subset of links (bit mask)."""
        if links & (links - 1) == 0:
            return 0, ()
        known = self._best.get(links)
        if known is not None:
            return known
        inner = [i for i, (u, v) in enumerate(self._edges) if links >> u & 1 and links >> v & 1]
        best: tuple[int, tuple[int, ...]] | None = None
        for last in inner:
            side = self._side(inner, last)
            a, b = self._solve(side), self._solve(links & ~side)
            if best is None or a[0] + b[0] < best[0]:
                best = (a[0] + b[0], (*a[1], *b[1], last))
        assert best is not None
        k = sum(d for i, d in enumerate(self._degrees) if links >> i & 1) - 2 * len(inner)
        result = self._best[links] = (best[0] + self._q[k], best[1])
        return result

    def _side(self, inner: Sequence[int], cut: int) -> int:
        side = 1 << self._edges[cut][0]
        grown = True
        while grown:
            grown = False
            for i in inner:
                pair = 1 << self._edges[i][0] | 1 << self._edges[i][1]
                if i != cut and side & pair and side & pair != pair:
                    side |= pair
                    grown = True
        return side
