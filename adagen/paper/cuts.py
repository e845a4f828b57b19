"""All cuts of a partial chain at once: their costs and the work on either side."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from adagen.paper.contraction import TooManyBranches
from adagen.paper.one_process import SingleProcess
from adagen.schedule.chains import Chain, Chains

Ints = NDArray[np.int64]


class Cuts(NamedTuple):
    """The cuts of a chain of n joints, by ascending position; arrays of length n, times in ticks.

    Attributes:
        position: of the joint that is cut.
        cost: Eq. (11).
        root_work: f(root side, 1).
        end_work: f(end side, 1).
        root_size: joints on the root side.
        end_size: joints on the end side.
        hard: whether a side has too intricate a boundary to be worked out: its work is then only
            a lower bound.
        work: f(chain, 1), a number.
    """

    position: Ints
    cost: Ints
    root_work: Ints
    end_work: Ints
    root_size: Ints
    end_size: Ints
    hard: NDArray[np.bool_]
    work: int

    def take(self, keep: NDArray[np.bool_]) -> Cuts:
        """Return the cuts that are kept."""
        return Cuts(
            self.position[keep],
            self.cost[keep],
            self.root_work[keep],
            self.end_work[keep],
            self.root_size[keep],
            self.end_size[keep],
            self.hard[keep],
            self.work,
        )


class Cutter:
    """Cuts partial chains of one robot and keeps the results."""

    def __init__(self, chains: Chains, single: SingleProcess) -> None:
        self.chains = chains
        self.single = single
        n = len(chains.original)
        self._parent = np.array(chains.parent, dtype=np.int64)
        self._end = np.array(chains.end, dtype=np.int64)
        self._depth = np.array(chains.depth, dtype=np.int64)
        self._fixed = np.array(chains.fixed, dtype=np.int64)
        self._below = np.array(
            [chains.linear_work(Chain(p + 1, ())) for p in range(n)], dtype=np.int64
        )
        self._known: dict[Chain, Cuts] = {}

    def cuts(self, chain: Chain) -> Cuts:
        """Return all cuts of a chain (not of a bare link)."""
        known = self._known.get(chain)
        if known is None:
            known = self._known[chain] = self._cut(chain)
        return known

    def _cut(self, chain: Chain) -> Cuts:
        chains = self.chains
        at = np.concatenate([np.arange(a, b) for a, b in chains.ranges(chain)])
        stop = self._end[at]
        cost = self._fixed[at] + chains.q[chains.boundary(chain)]
        end_work = self._below[at].copy()
        end_size = stop - at - 1
        inside = np.zeros((len(chain.cuts), len(at)), dtype=np.bool_)
        for row, cut in zip(inside, chain.cuts, strict=True):
            row[:] = (at < cut) & (cut < stop)
            lost = chains.linear_work(Chain(cut + 1, ())) + chains.fixed[cut]
            end_work -= lost * row
            end_size -= (chains.end[cut] - cut) * row
        root_work = chains.linear_work(chain) - end_work - self._fixed[at]
        root_size = len(at) - 1 - end_size
        hard = np.zeros(len(at), dtype=np.bool_)
        end_work += self._end_corrections(chain, at, inside, end_size, hard)
        root_work += self._root_corrections(chain, at, inside, root_size, hard)
        return Cuts(
            at,
            cost,
            np.where(root_size > 0, root_work, 0),
            np.where(end_size > 0, end_work, 0),
            root_size,
            end_size,
            hard,
            self.single.work(chain),
        )

    def _path(self, links: Ints) -> Ints:
        """Return the correction for two boundary joints, from the number of links between them."""
        q = self.chains.q
        return (links - 1) * q[2] - links * q[1]

    def _correction(self, links: list[int]) -> tuple[int, bool]:
        """Return a correction, and whether it is only a lower bound."""
        try:
            return self.single.correction(tuple(sorted(links))), False
        except TooManyBranches as error:
            return error.least, True

    def _end_corrections(
        self, chain: Chain, at: Ints, inside: NDArray[np.bool_], size: Ints, hard: NDArray[np.bool_]
    ) -> Ints:
        chains = self.chains
        result = np.zeros(len(at), dtype=np.int64)
        count = inside.sum(axis=0)
        for row, cut in zip(inside, chain.cuts, strict=True):
            one = row & (count == 1)
            result[one] = self._path(
                chains.depth[chains.parent[cut]] - self._depth[at[one] + 1] + 1
            )
        for i in np.flatnonzero((count > 1) & (size > 0)):
            p = int(at[i])
            links = [chains.parent[cut] for cut in chain.cuts if p < cut < chains.end[p]]
            result[i], hard[i] = self._correction([p + 1, *links])
        return result

    def _root_corrections(
        self, chain: Chain, at: Ints, inside: NDArray[np.bool_], size: Ints, hard: NDArray[np.bool_]
    ) -> Ints:
        chains = self.chains
        result = np.zeros(len(at), dtype=np.int64)
        count = len(chain.cuts) - inside.sum(axis=0)
        many = count > 0
        if chain.top:
            one = ~many
            result[one] = self._path(
                self._depth[self._parent[at[one]]] - chains.depth[chain.top] + 1
            )
        for i in np.flatnonzero(many & (size > 0)):
            p = int(at[i])
            links = [chains.parent[cut] for cut in chain.cuts if not p < cut < chains.end[p]]
            links += [chain.top] if chain.top else []
            result[i], hardly = self._correction([*links, chains.parent[p]])
            hard[i] |= hardly
        return result
