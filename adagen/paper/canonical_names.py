"""Canonical names of partial chains: equal for isomorphic chains."""

from __future__ import annotations

from adagen.schedule.chains import Chain, Chains

_CUT = (0, -1)


class Canon:
    """Numbers the isomorphism classes of partial chains (Aho, Hopcroft and Ullman).

    Two chains get the same number if their trees of links, rooted at the top, are the same with
    degrees of freedom and boundary joints marked. Then their optimal times are the same.
    """

    def __init__(self, chains: Chains) -> None:
        self.chains = chains
        self._classes: dict[tuple[tuple[int, int], ...], int] = {}
        self._known: dict[Chain, int] = {}
        self._once: dict[int, list[int]] = {}
        self._reached: dict[int, int] = {}  # the joint above the last link of these
        self._below: list[list[int]] = [[] for _ in chains.degree]
        for p, link in enumerate(chains.parent):
            self._below[link].append(p)
        self._dofs = [chains.topology.dofs[j] for j in chains.original]
        self._full = [0] * len(chains.degree)
        for link in reversed(range(len(self._full))):
            self._full[link] = self._number(
                sorted((self._dofs[p], self._full[p + 1]) for p in self._below[link])
            )

    def _number(self, below: list[tuple[int, int]]) -> int:
        return self._classes.setdefault(tuple(below), len(self._classes))

    def key(self, chain: Chain) -> int:
        """Return the number of the chain's class."""
        known = self._known.get(chain)
        if known is None:
            known = self._known[chain] = 2 * self._find(chain) + (chain.top > 0)
        return known

    def _find(self, chain: Chain) -> int:
        if not chain.cuts:
            return self._full[chain.top]
        if len(chain.cuts) == 1:
            return self._cut_once(chain.top, chain.cuts[0])
        chains = self.chains
        touched = {chain.top}
        for cut in chain.cuts:
            link = chains.parent[cut]
            while link not in touched:
                touched.add(link)
                link = chains.parent[link - 1]
        cuts = set(chain.cuts)
        made: dict[int, int] = {}
        for link in sorted(touched, reverse=True):
            below = [
                _CUT if p in cuts else (self._dofs[p], made.get(p + 1, self._full[p + 1]))
                for p in self._below[link]
            ]
            below.sort()
            made[link] = self._number(below)
        return made[chain.top]

    def _cut_once(self, top: int, cut: int) -> int:
        """Return the class of all below a link but for one joint and what is below that."""
        chains = self.chains
        known = self._once.setdefault(cut, [])  # classes of the links above the cut, upwards
        steps = chains.depth[chains.parent[cut]] - chains.depth[top]
        came = self._reached.get(cut, cut)
        while len(known) <= steps:
            mark = (self._dofs[came], known[-1]) if known else _CUT
            link = chains.parent[came]
            below = [
                mark if p == came else (self._dofs[p], self._full[p + 1]) for p in self._below[link]
            ]
            below.sort()
            known.append(self._number(below))
            came = link - 1
        self._reached[cut] = came
        return known[steps]
