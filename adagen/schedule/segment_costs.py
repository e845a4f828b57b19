"""Prices of form `segment`: of a partial chain on one process, and of a cut.

Inside a chain of one process no order matters: every joint is articulated once, and along the paths
between the chain's handles mobility is carried outwards. Prices follow the plan (adagen.plan) step
by step, assembly and disassembly apart, so that a schedule played through by the rules of its tree
takes what its plan takes. All times are ticks on a core of speed 1.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from itertools import accumulate
from typing import NamedTuple

from adagen.schedule.chains import Chain, Chains
from adagen.schedule.costs import PRESCRIBED, StepCosts, block_rows
from adagen.schedule.profile import TICKS, CostProfile
from adagen.schedule.topology import Topology


class Price(NamedTuple):
    """Times of the first sweep and of the second one; ticks."""

    assembly: int
    disassembly: int

    @property
    def total(self) -> int:
        """Both together."""
        return self.assembly + self.disassembly

    def plus(self, other: Price) -> Price:
        """Return the price of both."""
        return Price(self.assembly + other.assembly, self.disassembly + other.disassembly)


class SegmentPrice(NamedTuple):
    """Times of a chain on one process; ticks.

    Attributes:
        kinematics: of its joints and of those between it and the ground, once.
        sweeps: of everything else.
        path: positions of the joints along which mobility is carried outwards.
    """

    kinematics: int
    sweeps: Price
    path: tuple[int, ...]


class Transit(NamedTuple):
    """Times of a chain's two messages; ticks.

    Attributes:
        assembly: to put the first one in, and again to take it out.
        disassembly: the same of the second one.
        send: of the sender besides.
        latency: from sent to seen.
    """

    assembly: int
    disassembly: int
    send: int
    latency: int

    @property
    def away(self) -> tuple[int, int]:
        """How long they are under way in either sweep, apart from the time of the joint's process.

        That process takes the times of the receiver in the first and of the sender in the second.
        """
        return self.assembly + self.send + self.latency, self.disassembly + self.latency

    @property
    def handling(self) -> Price:
        """Time of the joint's process for them in either sweep."""
        return Price(self.assembly, self.disassembly + self.send)


class SegmentCosts:
    """Prices of one robot's chains and cuts under a profile with step costs.

    Attributes:
        chains: the robot, renumbered by position.
        priced_as: per position, the kind of its joint, or that it is prescribed.
        own: per position, the kinematics of its joint in the chain that it belongs to.
        passed: per position, the kinematics of its joint for a process that only passes it on the
            way to others.
        alone: per position, what its joint takes inside a chain besides, its child link and the
            tangents of its friction included. Those of joined joints are left out: they are taken
            before their process waits for the other.
        tangents: per position, these alone.
        outward: per position, what it takes to carry mobility across it and loads back, without
            the loads themselves.
        kinematics: per link, of all joints between it and the ground, where they are only passed.
        join: per position, the least that joining and taking apart its joint costs.
        start: what every process takes apart from its steps.
        whole_root: what a chain without the ground takes besides its joints: its root.
        branch: per link, the joint on the ground above it; -1 for the ground.
    """

    def __init__(
        self,
        topology: Topology,
        profile: CostProfile,
        *,
        passing: Mapping[str, float] | None = None,
    ) -> None:
        """Price a robot.

        Args:
            topology: the robot.
            profile: a profile with the costs of steps.
            passing: by kind, the kinematics of a joint that is only passed, microseconds; by
                default what the profile says of any joint by itself.
        """
        self.chains = Chains(topology, profile)
        self.costs: StepCosts = profile.measured
        kinds = [topology.kind(j) for j in self.chains.original]
        self.priced_as = [topology.priced_as(j) for j in self.chains.original]
        parent = self.chains.parent
        grounded = [above == 0 for above in parent]
        floats = [kind == "floating" for kind in self.priced_as]
        self.free = [g and f for g, f in zip(grounded, floats, strict=True)]
        rows = list(zip(self.priced_as, grounded, self.free, strict=True))
        self.own = [self._ticks(f"kinematics.{kind}", "kinematics.step") for kind in kinds]
        self.passed = (
            self.own if passing is None else [round(passing[kind] * TICKS) for kind in kinds]
        )
        tangent = self._ticks("process.tangent")
        self.tangents = [tangent * topology.tangents_of(j) for j in self.chains.original]
        self.alone = [
            self._alone(*row).plus(Price(own, 0))
            for row, own in zip(rows, self.tangents, strict=True)
        ]
        self.outward = [self._outward(*row) for row in rows]
        self.join = [
            Price(
                self._ticks(f"join.{'ground' if g and not f else kind}"),
                self._ticks(f"disassemble.{'ground' if g and not f else kind}"),
            )
            for kind, g, f in rows
        ]
        self.kinematics = [0] * (len(parent) + 1)
        self.branch = [-1] * (len(parent) + 1)
        for p, above in enumerate(parent):
            self.kinematics[p + 1] = self.kinematics[above] + self.passed[p]
            self.branch[p + 1] = self.branch[above] if above else p
        self.before = tuple(
            [0, *accumulate(column)] for column in (self.own, *zip(*self.alone, strict=True))
        )
        self.start = self._ticks("process.evaluation")
        self.load = self._ticks("deliver.load")
        self.spread = self._ticks("propagate.spread")
        self.root = Price(self._ticks("root.invert"), self._ticks("root.accelerate"))
        first = self._ticks("link.start", "root.invert")
        self.whole_root = Price(first, self.root.disassembly + self.load)
        self._prices: dict[Chain, SegmentPrice] = {}
        self._cuts: dict[tuple[Chain, int], Price] = {}
        self._transits: dict[Chain, Transit | None] = {}
        self._handles: dict[Chain, list[int]] = {}

    def _ticks(self, *names: str) -> int:
        return sum(round(self.costs[name] * TICKS) for name in names)

    def _alone(self, kind: str, grounded: bool, free: bool) -> Price:
        if free:
            return Price(self._ticks("link.start", "free.base"), self._ticks("free.acceleration"))
        sweep = [f"articulate.{'ground' if grounded else kind}"]
        if grounded and kind == PRESCRIBED:
            sweep = []  # nothing is passed to the ground, and nothing gives way
        return Price(self._ticks("link.start", *sweep), self._ticks(f"accelerate.{kind}"))

    def _outward(self, kind: str, grounded: bool, free: bool) -> Price:
        if free:
            return Price(0, 0)
        propagate = "propagate.ground" if grounded else f"propagate.{kind}"
        return Price(self._ticks(propagate), self._ticks(f"deliver.{kind}"))

    def handles(self, chain: Chain) -> list[int]:
        """Return the links of a chain that boundary joints touch, ascending, each once.

        The ground is none: what meets there alone does not feel each other.
        """
        known = self._handles.get(chain)
        if known is None:
            known = self._handles[chain] = sorted(set(self.chains.handles(chain)) - {0})
        return known

    def work(self, chain: Chain) -> tuple[int, int, int]:
        """Return the time of a chain's joints alone: kinematics, assembly, disassembly."""
        first, last = self.chains.span(chain)
        end = self.chains.end
        found = []
        for before in self.before:
            work = before[last] - before[first]
            for cut in chain.cuts:
                work -= before[end[cut]] - before[cut]
            found.append(work)
        return found[0], found[1], found[2]

    def price(self, chain: Chain) -> SegmentPrice:
        """Return the price of a chain on one process."""
        known = self._prices.get(chain)
        if known is None:
            known = self._prices[chain] = self._price(chain)
        return known

    def _price(self, chain: Chain) -> SegmentPrice:
        own, assembly, disassembly = self.work(chain)
        path: tuple[int, ...] = ()
        if chain.top:
            ways = [way_between(self.chains, chain.top, self.handles(chain))]
            assembly += self._ticks("link.start")
        else:
            ways = self._grounded(chain)
            free = sum(self.free[p] for p in self._on_ground(chain))
            assembly += (free - sum(way.root > 0 for way in ways)) * self._ticks("root.solve")
        for way in ways:
            rooted = way.root > 0
            assembly += rooted * self.root.assembly + way.spreads * self.spread
            disassembly += rooted * self.root.disassembly + way.loads * self.load
            assembly += sum(self.outward[p].assembly for p in way.path)
            disassembly += sum(self.outward[p].disassembly for p in way.path)
            turned = len(way.turned), len(set(way.path).intersection(way.turned))
            extra = self._reversed(*turned)
            assembly, disassembly = assembly + extra.assembly, disassembly + extra.disassembly
            path += way.path
        return SegmentPrice(own + self.kinematics[chain.top], Price(assembly, disassembly), path)

    def _reversed(self, swept: int, outwards: int) -> Price:
        """Return the extra cost of joints whose segment has its root below them."""
        return Price(
            swept * self._ticks("articulate.reversed")
            + outwards * self._ticks("propagate.reversed"),
            swept * self._ticks("accelerate.reversed") + outwards * self._ticks("deliver.reversed"),
        )

    def _on_ground(self, chain: Chain) -> list[int]:
        """Return the positions of a chain's joints on the ground."""
        return [p for p, link in enumerate(self.chains.parent) if not link and p not in chain.cuts]

    def _grounded(self, chain: Chain) -> list[Way]:
        """Return the paths to the handles of a chain with the ground, from each root.

        What hangs on a free joint is not held by the ground: its root is its first handle.
        """
        held: list[int] = []
        ways = []
        for p in self._on_ground(chain):
            mine = [link for link in self.handles(chain) if p < link <= self.chains.end[p]]
            if not self.free[p]:
                held += mine
            elif mine:
                root = min(mine, key=lambda link: self.chains.original[link - 1])
                ways.append(way_between(self.chains, root, mine, above=p + 1))
        return [way_between(self.chains, 0, held), *ways] if held else ways

    def beyond(self, chain: Chain, joined: Collection[int]) -> int:
        """Return the kinematics that a process needs to join joints besides those of its segment.

        Args:
            chain: the segment; what it needs itself reaches from its joints to the ground.
            joined: positions of the joints.
        """
        chains = self.chains
        inside = set(chains.positions(chain)) if joined else set()
        seen = set(chains.above(chain.top)) if joined else set()
        extra = 0
        for p in joined:
            for q in (p, *chains.above(chains.parent[p])):
                if q not in seen and q not in inside:
                    seen.add(q)
                    extra += self.passed[q]
        return extra

    def cut(self, chain: Chain, position: int) -> Price:
        """Return the cost of joining the two sides of a cut, and of their disassembly."""
        key = (chain, position)
        known = self._cuts.get(key)
        if known is None:
            a, b = self.around(chain, position)
            known = self._cuts[key] = self.join[position].plus(self.coupled(position, a, b))
        return known

    def around(self, chain: Chain, position: int) -> tuple[int, int]:
        """Return how many of a chain's handles feel a joint, on its root and on its end side."""
        end, handles = self.chains.end[position], self.handles(chain)
        b = sum(position < link <= end for link in handles)
        if not self.chains.parent[position]:
            return 0, b
        if not chain.top:  # joints on the ground part the handles
            branch = self.branch[position + 1]
            handles = [link for link in handles if self.branch[link] == branch]
        return len(handles) - b, b

    def coupled(self, position: int, a: int, b: int) -> Price:
        """Return the extra cost of a join with so many handles on its two sides."""
        rows = block_rows(self.priced_as[position])
        same = rows * (a * (a + 1) + b * (b + 1)) / 2
        extra = (
            a * self.costs["join.coupling_a"]
            + b * self.costs["join.coupling_b"]
            + same * self.costs["join.block"]
            + rows * a * b * self.costs["join.across"]
        )
        apart = (a + b) * self.costs["disassemble.coupling"]
        return Price(round(extra * TICKS), round(apart * TICKS))

    def bare(self) -> int:
        """Return the cost of a side that is a bare link."""
        return self._ticks("link.bias")

    def transit(self, chain: Chain) -> Transit | None:
        """Return the times of a chain's messages; None if it sends nothing."""
        if chain not in self._transits:
            self._transits[chain] = self._transit(self.handles(chain))
        return self._transits[chain]

    def _transit(self, handles: Sequence[int]) -> Transit | None:
        if not handles:
            return None
        groups: dict[int, int] = {}  # handles on two branches of the ground do not feel each other
        for link in handles:
            groups[self.branch[link]] = groups.get(self.branch[link], 0) + 1
        return self.message(groups.values())

    def message(self, groups: Collection[int]) -> Transit:
        """Return the time of messages about groups of handles, each group coupled in itself."""
        count = sum(groups)
        pairs = sum(m * (m + 1) // 2 for m in groups)
        channel = self.costs.window
        half = channel.number / 2 * TICKS
        return Transit(
            round((36 * (pairs - count) + 27 * count) * half),
            round(6 * count * half),
            round(channel.send * TICKS),
            round(channel.latency * TICKS),
        )


class Way(NamedTuple):
    """From the root of a part of a segment to its handles; positions.

    Attributes:
        root: the link that inertias are swept to; 0 is the ground.
        path: joints between the root and a handle, outwards.
        turned: joints that have the root below them, whether on the path or not.
        spreads: how often a coupling between two links is carried across a joint.
        loads: links at which loads are collected on the way back.
    """

    root: int
    path: tuple[int, ...]
    turned: tuple[int, ...]
    spreads: int
    loads: int


def way_between(chains: Chains, root: int, handles: Sequence[int], above: int = -1) -> Way:
    """Return the way from a root to handles.

    Args:
        chains: the robot.
        root: a link that is above all handles, or one of them.
        handles: links, the root perhaps among them.
        above: the uppermost link of the part if the root may lie below it; -1 if not.
    """
    turned = tuple(chains.above(root, above)) if above >= 0 else ()
    if len(handles) <= 2 and above < 0 and root in handles:  # one path, every coupling carried once
        last = next((link for link in handles if link != root), root)
        path = tuple(chains.above(last, root))
        return Way(root, path[::-1], (), len(path), len(path) + 1)
    top = root
    for link in handles if above >= 0 else ():
        top = chains.meet(top, link)
    joints = {p for link in (*handles, root) for p in chains.above(link, top)}
    edges = chains.outwards(sorted(joints, key=lambda p: chains.original[p]), [root])
    loaded = {near for _, near, _ in edges} | set(handles)
    ends = [(near, far) for _, near, far in edges]
    spreads = sum(map(len, carried_couplings(ends, root, set(handles))))
    return Way(root, tuple(p for p, _, _ in edges), turned, spreads, len(loaded - {0}))


def carried_couplings(
    ends: Sequence[tuple[int, int]], root: int, handles: Collection[int]
) -> list[list[int]]:
    """Return for each joint the links whose coupling is carried outwards across it.

    Kept are couplings with handles, and with links where the path parts until its last branch.

    Args:
        ends: near and far link of the joints between a root and handles, outwards.
        root: the link that they start from; 0 is the ground, which is coupled with none.
        handles: these links.
    """
    last: dict[int, int] = {}
    count: dict[int, int] = {}
    for place, (near, _) in enumerate(ends):
        last[near] = place
        count[near] = count.get(near, 0) + 1
    anchors = {link: place for link, place in last.items() if link and count[link] > 1}
    reached = [root] if root else []
    coupled = {(g, g) for g in reached}
    found: list[list[int]] = []
    for place, (near, far) in enumerate(ends):
        kept = (g for g in reached if g in handles or place < anchors.get(g, -1))
        found.append([g for g in kept if g == near or (g, near) in coupled])
        for g in found[-1]:
            coupled |= {(g, far), (far, g)}
        if far in handles or far in anchors:
            reached.append(far)
    return found
