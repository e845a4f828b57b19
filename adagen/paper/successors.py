"""Successors of a search state: every cut of a chain, with every division of its processes."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from adagen.paper.bounds import Bounds, Ints, Rules
from adagen.paper.canonical_names import Canon
from adagen.paper.contraction import TooManyBranches
from adagen.paper.cuts import Cuts, Cutter
from adagen.paper.one_process import SingleProcess
from adagen.schedule.chains import Chain, Chains
from adagen.schedule.profile import CostProfile
from adagen.schedule.topology import Topology

FOREVER = 1 << 62


class Options(NamedTuple):
    """The options at one state (chain, P); arrays of equal length, times in ticks.

    Attributes:
        bound: least time of the chain with this option.
        work: least total work with this option.
        cut: which of the chain's cuts.
        first: processes for the root side.
        second: processes for the end side; ``first == second == P`` where they share the range or
            a side is a bare link.
        hard: whether nothing but the bound is known (see :class:`Cuts`).
    """

    bound: Ints
    work: Ints
    cut: Ints
    first: Ints
    second: Ints
    hard: NDArray[np.bool_]

    def take(self, keep: NDArray[np.bool_]) -> Options:
        """Return the options that are kept."""
        return Options(
            self.bound[keep],
            self.work[keep],
            self.cut[keep],
            self.first[keep],
            self.second[keep],
            self.hard[keep],
        )


Lower = Callable[[Chain, int, int], int]


class Option(NamedTuple):
    """One option, worked out; a work of 0 means a bare link."""

    position: int
    cost: int
    root: Chain
    end: Chain
    first: int
    second: int
    root_work: int
    end_work: int
    shared: bool


class Space:
    """The search space of one robot under given rules: states, their options and their bounds."""

    def __init__(self, topology: Topology, profile: CostProfile, rules: Rules) -> None:
        self.topology = topology
        self.profile = profile
        self.rules = rules
        self.chains = Chains(topology, profile)
        self.single = SingleProcess(self.chains)
        self.cutter = Cutter(self.chains, self.single)
        self.bounds = Bounds(self.chains, self.single, rules)
        self.canon = Canon(self.chains)
        degree = np.array(self.chains.degree, dtype=np.int64)
        above = np.array(self.chains.parent, dtype=np.int64)
        below = np.arange(1, len(above) + 1)
        # Joints to a link without any other joint, and the link on their other side.
        ground = (above == 0) & (degree[0] == 1)
        self._bare = (degree[below] == 1) | ground
        self._neighbour = np.where(ground & (degree[below] > 1), below, above)
        self._degree = degree

    def cuts(self, chain: Chain) -> Cuts:
        """Return the cuts of a chain that there are in this space."""
        return self.cutter.cuts(chain)

    def _worthwhile(self, chain: Chain, cuts: Cuts) -> NDArray[np.bool_]:
        """Return which cuts of a chain some optimal schedule of least work makes first.

        A joint p to a bare leaf can go down below the next cut i around its neighbour: i and p
        together cost no more then, and the other side of i no longer waits for p. Where every range
        of two chains is divided, that must not make two chains of one, so that p stops above the
        last other joint of its neighbour.
        """
        bare = self._bare[cuts.position]
        if self.rules.split == "free":
            keep: NDArray[np.bool_] = ~bare
        else:
            inner = self._degree[self._neighbour[cuts.position]]
            for link in self.chains.handles(chain):
                inner = inner - (self._neighbour[cuts.position] == link)
            keep = ~bare | (inner <= 2)
        return keep if bool(keep.any()) else np.ones_like(bare)

    def options(self, chain: Chain, processes: int, *, every: bool = False) -> Options:
        """Return the options of a state with two processes or more.

        Args:
            chain: the chain.
            processes: P.
            every: all of them, not only those that some optimal schedule of least work takes.
        """
        cuts = self.cuts(chain)
        n = len(cuts.position)
        keep = np.ones(n, dtype=np.bool_) if every else self._worthwhile(chain, cuts)
        two = (cuts.root_size > 0) & (cuts.end_size > 0)
        spread = self.bounds.spread_all
        shared = cuts.cost + spread(cuts.root_work, processes) + spread(cuts.end_work, processes)
        rows: list[tuple[Ints, NDArray[np.bool_], int, int]] = []
        for first, second in self.rules.splits(processes):
            longer = np.maximum(spread(cuts.root_work, first), spread(cuts.end_work, second))
            rows.append((cuts.cost + longer, two & keep, first, second))
        alone = keep if self.rules.split == "free" else ~two & keep
        rows.append((shared, alone, processes, processes))
        at = np.arange(n)
        cut = np.concatenate([at[kept] for _, kept, _, _ in rows])
        sizes = [int(kept.sum()) for _, kept, _, _ in rows]
        total = cuts.cost + cuts.root_work + cuts.end_work
        return Options(
            np.concatenate([bound[kept] for bound, kept, _, _ in rows]),
            total[cut],
            cut,
            np.repeat([first for _, _, first, _ in rows], sizes),
            np.repeat([second for _, _, _, second in rows], sizes),
            cuts.hard[cut],
        )

    def option(self, chain: Chain, processes: int, options: Options, i: int) -> Option:
        """Return option number ``i`` of a state.

        Raises:
            TooManyBranches: it is a hard one.
        """
        if options.hard[i]:
            raise TooManyBranches(int(options.bound[i]))
        cuts = self.cuts(chain)
        at = int(options.cut[i])
        position = int(cuts.position[at])
        first, second = int(options.first[i]), int(options.second[i])
        root, end = self.chains.split(chain, position)
        return Option(
            position,
            int(cuts.cost[at]),
            root,
            end,
            first,
            second,
            int(cuts.root_work[at]),
            int(cuts.end_work[at]),
            first == processes,
        )

    def best_first(
        self, chain: Chain, processes: int, options: Options, limit: int, lower: Lower
    ) -> Iterator[tuple[int, Option]]:
        """Yield the options of a state by ascending bound, the bound sharpened on the way.

        Only what has the least bound so far is looked at closely, so that options which nobody
        asks for cost next to nothing.

        Args:
            chain: the chain.
            processes: P.
            options: its options.
            limit: bounds from here on need not be sharp.
            lower: lower bound on the time of a side, from its chain, processes and work.

        Raises:
            TooManyBranches: a hard option comes next.
        """
        order = np.argsort(options.bound, kind="stable").tolist()
        rough = [(int(options.bound[i]), i) for i in order]
        sharp: list[tuple[int, int, Option]] = []
        at = 0
        while at < len(rough) or sharp:
            if at < len(rough) and (not sharp or rough[at][0] <= sharp[0][0]):
                bound, i = rough[at]
                at += 1
                option = self.option(chain, processes, options, i)
                if bound >= limit:
                    heapq.heappush(sharp, (bound, i, option))
                    continue
                root = lower(option.root, option.first, option.root_work)
                end = lower(option.end, option.second, option.end_work)
                together = root + end if option.shared else max(root, end)
                heapq.heappush(sharp, (max(bound, option.cost + together), i, option))
            else:
                bound, _, option = heapq.heappop(sharp)
                yield bound, option

    def size(self, chain: Chain) -> int:
        """Return the number of joints of a chain."""
        return sum(b - a for a, b in self.chains.ranges(chain))
