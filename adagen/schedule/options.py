"""What can be done at a node: every cut of a chain with every way to divide its processes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from adagen.schedule.bounds import Bounds, Ints, Rules
from adagen.schedule.canon import Canon
from adagen.schedule.chains import Chain, Chains
from adagen.schedule.cuts import Cuts, Cutter
from adagen.schedule.profile import CostProfile
from adagen.schedule.single import SingleProcess, TooManyBranches
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
        degree = self.chains.degree
        # Joints to a link without any other joint: under free splitting they may go first.
        self._bare = np.array(
            [
                degree[p + 1] == 1 or (above == 0 and degree[0] == 1)
                for p, above in enumerate(self.chains.parent)
            ]
        )

    def cuts(self, chain: Chain) -> Cuts:
        """Return the cuts of a chain that some optimal schedule makes first.

        With free splitting a joint to a bare leaf can go down to just above that leaf's neighbour:
        no node on the way gets dearer, and nothing else waits for it. It is then left out unless
        there is no other joint.
        """
        cuts = self.cutter.cuts(chain)
        if self.rules.split == "always":
            return cuts
        keep = ~self._bare[cuts.position]
        return cuts.take(keep) if keep.any() and not keep.all() else cuts

    def options(self, chain: Chain, processes: int) -> Options:
        """Return all options of a state with two processes or more."""
        cuts = self.cuts(chain)
        n = len(cuts.position)
        two = (cuts.root_size > 0) & (cuts.end_size > 0)
        spread = self.bounds.spread_all
        shared = cuts.cost + spread(cuts.root_work, processes) + spread(cuts.end_work, processes)
        keep = np.ones(n, dtype=np.bool_) if self.rules.split == "free" else ~two
        rows: list[tuple[Ints, NDArray[np.bool_], int, int]] = []
        for first, second in self.rules.splits(processes):
            longer = np.maximum(spread(cuts.root_work, first), spread(cuts.end_work, second))
            rows.append((cuts.cost + longer, two, first, second))
        rows.append((shared, keep, processes, processes))
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

    def size(self, chain: Chain) -> int:
        """Return the number of joints of a chain."""
        return sum(b - a for a, b in self.chains.segments(chain))
