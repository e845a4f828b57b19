"""Form `segment` priced: what one process takes for a partial chain, and what a cut costs.

Inside a chain of one process no order matters: every joint is articulated once, and along the paths
between the chain's handles mobility is carried outwards. All times are ticks. They bound from below
what the plan takes, played through step by step (adagen.predict): a process also repeats the
kinematics towards joints that it joins, and sends take its time.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate

from adagen.model.kinds import KINDS
from adagen.schedule.chains import Chain, Chains
from adagen.schedule.costs import StepCosts
from adagen.schedule.profile import TICKS, CostProfile
from adagen.schedule.topology import Topology


@dataclass(frozen=True)
class SegmentPrice:
    """What a chain takes on one process; ticks.

    Attributes:
        total: everything.
        path: positions of the joints along which mobility is carried outwards, ascending.
    """

    total: int
    path: tuple[int, ...]


class SegmentCosts:
    """Prices of one robot's chains and cuts under a profile with step costs.

    Attributes:
        chains: the robot, renumbered by position.
        alone: per position, what its joint takes inside a chain, its child link included.
        outward: per position, what it takes to carry mobility across it and loads back.
        kinematics: per link, of all joints between it and the ground.
        join: per position, the least that joining and taking apart its joint costs.
        start: what every chain takes apart from its joints.
        root: what a chain takes besides if its top link is not the ground.
    """

    def __init__(self, topology: Topology, profile: CostProfile) -> None:
        assert profile.steps is not None  # whoever asks for segments has looked
        self.chains = Chains(topology, profile)
        self.costs: StepCosts = profile.steps
        self.kinds = [topology.kind(j) for j in self.chains.original]
        parent = self.chains.parent
        grounded = [above == 0 for above in parent]
        self.free = [g and kind == "floating" for g, kind in zip(grounded, self.kinds, strict=True)]
        rows = list(zip(self.kinds, grounded, self.free, strict=True))
        self.alone = [self._alone(*row) for row in rows]
        self.outward = [self._outward(*row) for row in rows]
        self.join = [
            self._ticks(f"join.{'ground' if g and not f else kind}", f"disassemble.{kind}")
            for kind, g, f in rows
        ]
        self.kinematics = [0] * (len(parent) + 1)
        for p, above in enumerate(parent):
            own = self._ticks(f"kinematics.{self.kinds[p]}")
            self.kinematics[p + 1] = self.kinematics[above] + own
        self.before = [0, *accumulate(self.alone)]
        self.start = self._ticks("process.evaluation")
        self.root = self._ticks("link.start", "root.invert", "root.accelerate", "deliver.load")
        self._prices: dict[Chain, SegmentPrice] = {}

    def _ticks(self, *names: str) -> int:
        return sum(round(self.costs[name] * TICKS) for name in names)

    def _alone(self, kind: str, grounded: bool, free: bool) -> int:
        if free:
            return self._ticks("link.start", f"kinematics.{kind}", "free.base", "free.acceleration")
        articulate = "articulate.ground" if grounded else f"articulate.{kind}"
        return self._ticks("link.start", f"kinematics.{kind}", articulate, f"accelerate.{kind}")

    def _outward(self, kind: str, grounded: bool, free: bool) -> int:
        if free:
            return 0
        propagate = "propagate.ground" if grounded else f"propagate.{kind}"
        return self._ticks(propagate, f"deliver.{kind}", "deliver.load")

    def handles(self, chain: Chain) -> list[int]:
        """Return the links of a chain that boundary joints touch, ascending, each once.

        The ground is none: what meets there alone does not feel each other.
        """
        return sorted(set(self.chains.handles(chain)) - {0})

    def work(self, chain: Chain) -> int:
        """Return what the joints of a chain take, without paths, root and start."""
        first, last = self.chains.span(chain)
        work = self.before[last] - self.before[first]
        for cut in chain.cuts:
            work -= self.before[self.chains.end[cut]] - self.before[cut]
        return work

    def price(self, chain: Chain) -> SegmentPrice:
        """Return what a chain takes on one process."""
        known = self._prices.get(chain)
        if known is None:
            known = self._prices[chain] = self._price(chain)
        return known

    def _price(self, chain: Chain) -> SegmentPrice:
        handles = self.handles(chain)
        total = self.start + self.work(chain) + self.kinematics[chain.top]
        if chain.top:
            path = self._paths(handles, chain.top)
            total += self.root + len(path) * self._ticks("propagate.spread")
        else:
            path, roots = self._grounded_paths(handles)
            total += roots
        total += sum(self.outward[p] for p in path)
        return SegmentPrice(total, tuple(sorted(path)))

    def _paths(self, handles: list[int], top: int) -> set[int]:
        """Return the positions between handles and a link above them."""
        path: set[int] = set()
        for link in handles:
            while link != top and link - 1 not in path:
                path.add(link - 1)
                link = self.chains.parent[link - 1]
        return path

    def _grounded_paths(self, handles: list[int]) -> tuple[set[int], int]:
        """Return the paths of a chain that holds the ground, and what the roots of its parts cost.

        What hangs on a free joint is not held by the ground: its root is its first handle.
        """
        path: set[int] = set()
        roots = 0
        for p, (above, free) in enumerate(zip(self.chains.parent, self.free, strict=True)):
            if above:
                continue
            mine = [link for link in handles if p < link <= self.chains.end[p]]
            if not free:
                path |= self._paths(mine, 0)
            elif mine:
                top = mine[0]
                for link in mine[1:]:
                    top = self.chains.meet(top, link)
                path |= self._paths(mine, top)
                roots += self._ticks("root.invert", "root.accelerate", "deliver.load")
            else:
                roots += self._ticks("root.solve")
        return path, roots

    def cut(self, chain: Chain, position: int) -> int:
        """Return what joining the two sides of a cut costs, in both sweeps."""
        end = self.chains.end[position]
        handles = self.handles(chain)
        b = sum(position < link <= end for link in handles)
        a = len(handles) - b
        kind = self.kinds[position]
        rows = (1 + len(KINDS[kind].constrained)) / 6
        same = rows * (a * (a + 1) + b * (b + 1)) / 2
        extra = (
            a * self.costs["join.coupling_a"]
            + b * self.costs["join.coupling_b"]
            + same * self.costs["join.block"]
            + rows * a * b * self.costs["join.across"]
            + (a + b) * self.costs["disassemble.coupling"]
        )
        return self.join[position] + round(extra * TICKS)

    def bare(self) -> int:
        """Return what a side costs that is a bare link."""
        return self._ticks("link.bias")

    def transit(self, chain: Chain) -> int:
        """Return how long a chain's results and the forces on it are under way, together."""
        m = len(self.handles(chain))
        if not m:  # nothing to tell
            return 0
        numbers = 36 * m * (m + 1) / 2 + 6 * m + 6 * m
        channel = self.costs.window
        return round((2 * (channel.send + channel.latency) + numbers * channel.number) * TICKS)
