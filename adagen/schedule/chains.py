"""Partial chains: connected sets of joints, their boundary, their cuts and their work."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from adagen.errors import InputError
from adagen.schedule.profile import CostProfile
from adagen.schedule.topology import Topology


class Chain(NamedTuple):
    """A partial chain, defined by what bounds it; positions and links are those of :class:`Chains`.

    Attributes:
        top: its link nearest to the ground. Unless that is the ground, the joint above it is a
            boundary joint.
        cuts: positions of the boundary joints below, ascending.
    """

    top: int
    cuts: tuple[int, ...]


WHOLE = Chain(0, ())
"""The whole robot: no boundary."""

Outwards = tuple[int, int, int]
"""A position, its link nearer to a root, and the other one."""


class Chains:
    """A robot with costs, its joints renumbered so that every subtree is a range of *positions*.

    Position p joins link ``parent[p]`` to link p + 1; the joints below it are the positions
    p + 1 .. end[p] - 1. All times are ticks.

    Attributes:
        topology: the robot.
        profile: what a join costs.
        original: index of the joint at each position; length N.
        parent: parent link of each position; length N.
        end: one past the last position below each position; length N.
        degree: number of joints at each link; length N + 1.
        depth: number of joints between each link and the ground; length N + 1.
        fixed: gamma n + delta of each position; length N.
        least_fixed: the smallest of these.
        q: q(k) = alpha k^2 + beta k for k = 0..N + 1.
        q_sum: q(1) + ... + q(d - 1) for d = 0..N + 1.
    """

    def __init__(self, topology: Topology, profile: CostProfile) -> None:
        self.topology = topology
        self.profile = profile
        n = len(topology)
        if n == 0:
            raise InputError("the robot has no movable joint: there is nothing to schedule")
        if n * profile.join(n, 6) + n * abs(profile.fixed(6)) >= 2**61:
            raise InputError("the costs of the profile are too large for a robot of this size")
        self._number(topology)
        self.fixed = [profile.fixed(topology.dofs[j]) for j in self.original]
        self.least_fixed = min(self.fixed)
        self.q = [profile.boundary(k) for k in range(n + 2)]
        self.q_sum = [0, 0]
        for k in range(1, n + 1):
            self.q_sum.append(self.q_sum[-1] + self.q[k])
        # Work of everything up to a position where no chain has more than one boundary joint.
        self._before = [0]
        for p in range(n):
            self._before.append(self._before[-1] + self.q_sum[self.degree[p + 1]] + self.fixed[p])

    def _number(self, topology: Topology) -> None:
        n = len(topology)
        intervals = topology.intervals
        self.original = sorted(range(n), key=lambda j: intervals[j][0])
        self.end = [intervals[j][1] for j in self.original]
        self.parent = [
            intervals[parent - 1][0] + 1 if (parent := topology.parents[j]) else 0
            for j in self.original
        ]
        self.degree = [0] * (n + 1)
        self.depth = [0] * (n + 1)
        for p, above in enumerate(self.parent):
            self.degree[above] += 1
            self.degree[p + 1] += 1
            self.depth[p + 1] = self.depth[above] + 1

    def span(self, chain: Chain) -> tuple[int, int]:
        """Return the range of positions below the chain's top link."""
        return (0, len(self.original)) if chain.top == 0 else (chain.top, self.end[chain.top - 1])

    def ranges(self, chain: Chain) -> list[tuple[int, int]]:
        """Return the chain's positions as ascending ranges (first, last + 1)."""
        start, stop = self.span(chain)
        result = []
        for cut in chain.cuts:
            if start < cut:
                result.append((start, cut))
            start = self.end[cut]
        if start < stop:
            result.append((start, stop))
        return result

    def positions(self, chain: Chain) -> list[int]:
        """Return the positions of the chain's joints, ascending."""
        return [p for first, last in self.ranges(chain) for p in range(first, last)]

    def boundary(self, chain: Chain) -> int:
        """Return k = N_O, the number of boundary joints."""
        return len(chain.cuts) + (chain.top > 0)

    def handles(self, chain: Chain) -> tuple[int, ...]:
        """Return the links of the chain that boundary joints touch, ascending, with repetition."""
        links = [self.parent[cut] for cut in chain.cuts]
        if chain.top:
            links.append(chain.top)
        return tuple(sorted(links))

    def split(self, chain: Chain, position: int) -> tuple[Chain, Chain]:
        """Return the root side and the end side of a cut; a side may be a bare link."""
        stop = self.end[position]
        inside = tuple(cut for cut in chain.cuts if position < cut < stop)
        outside = [cut for cut in chain.cuts if not position < cut < stop]
        return Chain(chain.top, tuple(sorted([*outside, position]))), Chain(position + 1, inside)

    def linear_work(self, chain: Chain) -> int:
        """Return the work on one process as if the boundary joints did not matter (III-D, m <= 1).

        That is the sum of gamma n + delta, and q(1) + ... + q(d - 1) for each link of degree d:
        with at most one boundary joint, links contract leaf by leaf.
        """
        start, stop = self.span(chain)
        work = self.q_sum[self.degree[chain.top]] + self._before[stop] - self._before[start]
        for cut in chain.cuts:
            work -= self._before[self.end[cut]] - self._before[cut]
        return work

    def above(self, link: int, top: int = 0) -> list[int]:
        """Return the positions between a link and one above it, upwards."""
        found = []
        while link != top:
            found.append(link - 1)
            link = self.parent[link - 1]
        return found

    def outwards(self, positions: Iterable[int], roots: Iterable[int]) -> list[Outwards]:
        """Return joints depth first from links, at each one in the order given.

        Args:
            positions: of the joints that are walked through.
            roots: links, from each of which all that it leads to is walked.
        """
        at: dict[int, list[int]] = {}
        for p in positions:
            at.setdefault(self.parent[p], []).append(p)
            at.setdefault(p + 1, []).append(p)
        found: list[Outwards] = []
        for root in roots:
            waiting = [(p, root) for p in reversed(at.get(root, []))]
            while waiting:
                p, near = waiting.pop()
                far = p + 1 if self.parent[p] == near else self.parent[p]
                found.append((p, near, far))
                waiting += [(other, far) for other in reversed(at[far]) if other != p]
        return found

    def meet(self, a: int, b: int) -> int:
        """Return the lowest link that is at or above both links."""
        while a != b:
            if self.depth[a] >= self.depth[b]:
                a = self.parent[a - 1]
            else:
                b = self.parent[b - 1]
        return a
