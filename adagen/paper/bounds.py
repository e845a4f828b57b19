"""Rules for dividing processes, and lower bounds on the time of a partial chain under them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from adagen.paper.one_process import SingleProcess
from adagen.paper.path_bounds import PathBounds
from adagen.schedule.chains import WHOLE, Chain, Chains
from adagen.schedule.tree import Split

Ints = NDArray[np.int64]


@dataclass(frozen=True)
class Rules:
    """How the range of a node is divided among its two descendants.

    Attributes:
        halving: always in halves, as III-C has it for P a power of two; else anyhow.
        split: ``always``: two descendants divide the range if it has two processes or more;
            ``free``: they may also share it, one after the other. Where ranges may be divided
            anyhow, ``any`` comes to the same as ``free``.
    """

    halving: bool
    split: Split

    @staticmethod
    def of(processes: int, split: Split) -> Rules:
        """Return the rules for P processes."""
        if split == "any":
            return Rules(halving=False, split="free")
        return Rules(processes & (processes - 1) == 0, split)

    def splits(self, processes: int) -> list[tuple[int, int]]:
        """Return the ways to divide P >= 2 processes, root side first."""
        if self.halving:
            return [(processes // 2, processes // 2)]
        return [(first, processes - first) for first in range(1, processes)]

    def useful(self, processes: int, joints: int) -> int:
        """Return the fewest processes on which a chain is as fast as on P of them.

        A tree of n joints has at most (n + 1)/2 leaves, and at most (n - 1)/2 divisions on a path.
        """
        if not self.halving:
            return min(processes, (joints + 1) // 2)
        return min(processes, 1 << min(64, (joints - 1) // 2))


class Bounds:
    """Proven lower bounds on f(S, P) for the partial chains of one robot, in ticks."""

    def __init__(self, chains: Chains, single: SingleProcess, rules: Rules) -> None:
        self.chains = chains
        self.single = single
        self.rules = rules
        self._least = chains.q[1] + chains.least_fixed
        self._paths = PathBounds(
            chains, self.spread_all, shares=rules.split == "free", halving=rules.halving
        )

    def spread(self, work: int, processes: int) -> int:
        """Return the least time for a chain with a boundary whose work on one process is ``work``.

        The joint assembled last is charged to all P processes, the rest is at best divided evenly.
        """
        return int(self.spread_all(np.array([work], dtype=np.int64), processes)[0])

    def spread_all(self, work: Ints, processes: int) -> Ints:
        """Return :meth:`spread` of each amount of work; 0 for none."""
        if processes == 1:
            return work
        least = self._least
        left = np.maximum(work - least, 0)
        if self.rules.halving:
            rest = self.spread_all((left + 1) // 2, processes // 2)
        else:
            rest = (left + processes - 1) // processes
        return np.minimum(work, least + rest)

    def whole(self, processes: int) -> int:
        """Return a lower bound on f of the whole robot, without any search."""
        work = self.single.work(WHOLE)
        if processes == 1:
            return work
        left = work - self.chains.least_fixed
        share = self.spread((left + 1) // 2, processes // 2) if self.rules.halving else 0
        spread = self.chains.least_fixed + max(share, -(-left // processes))
        return max(spread, self.meeting(WHOLE, processes))

    def meeting(self, chain: Chain, processes: int) -> int:
        """Return a lower bound for two processes or more from the joints that meet at a link."""
        return self._paths.bound(chain, processes)
