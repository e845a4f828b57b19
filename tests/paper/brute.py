"""Answers by enumeration, sharing nothing with adagen.schedule but Topology and CostProfile."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from adagen.schedule import CostProfile, Topology

Set = frozenset[int]


class Tree(NamedTuple):
    """A schedule tree: joint, its chain, the trees of its root side and its end side."""

    joint: int
    chain: Set
    root: Tree | None
    end: Tree | None


class Brute:
    """One robot, one profile; times are exact fractions of microseconds."""

    def __init__(self, topology: Topology, profile: CostProfile) -> None:
        self.topology = topology
        self.profile = profile
        self.whole = frozenset(range(len(topology)))
        self.one = cache(self._one)
        self.trees = cache(lambda chain: list(self._trees(chain)))
        self.best = cache(self._best)

    def links(self, joint: int) -> set[int]:
        return {self.topology.parents[joint], joint + 1}

    def boundary(self, chain: Set) -> Set:
        touched = set().union(*(self.links(j) for j in chain)) if chain else set()
        return frozenset(j for j in self.whole - chain if self.links(j) & touched)

    def cost(self, chain: Set, joint: int) -> Fraction:
        """Eq. (11)."""
        k, n, p = len(self.boundary(chain)), self.topology.dofs[joint], self.profile
        alpha, beta, gamma, delta = (Fraction(str(x)) for x in (p.alpha, p.beta, p.gamma, p.delta))
        return alpha * k * k + beta * k + gamma * n + delta

    def sides(self, chain: Set, joint: int) -> tuple[Set, Set]:
        """Flood from both links of the joint."""
        sides = []
        for start in (self.topology.parents[joint], joint + 1):
            links: set[int] = {start}
            joints: set[int] = set()
            while more := [j for j in chain - joints - {joint} if self.links(j) & links]:
                joints.update(more)
                links.update(*(self.links(j) for j in more))
            sides.append(frozenset(joints))
        return sides[0], sides[1]

    def _one(self, chain: Set) -> Fraction:
        """Subset dynamic program for one process."""
        if not chain:
            return Fraction(0)
        return min(self.cost(chain, j) + sum(map(self.one, self.sides(chain, j))) for j in chain)

    def _best(self, chain: Set, p: int, halving: bool, free: bool) -> Fraction:
        """Subset dynamic program for P processes."""
        if not chain:
            return Fraction(0)
        times = []
        for j in chain:
            a, b = self.sides(chain, j)
            c = self.cost(chain, j)
            if not a or not b or p == 1 or free:
                times.append(c + self.best(a, p, halving, free) + self.best(b, p, halving, free))
            if a and b and p > 1:
                for first in [p // 2] if halving else range(1, p):
                    x = self.best(a, first, halving, free)
                    y = self.best(b, p - first, halving, free)
                    times.append(c + max(x, y))
        return min(times)

    def _trees(self, chain: Set) -> Iterator[Tree | None]:
        """Every schedule tree of a chain."""
        if not chain:
            yield None
        for j in sorted(chain):
            a, b = self.sides(chain, j)
            for root in self.trees(a):
                for end in self.trees(b):
                    yield Tree(j, chain, root, end)

    def assign(self, tree: Tree, p: int) -> list[tuple[int, int, int, Fraction]]:
        """III-C read literally: (joint, first, last + 1, cost), level by level."""
        row = [(tree, 0, p)]
        result = []
        while row:
            following = []
            for node, a, b in row:
                result.append((node.joint, a, b, self.cost(node.chain, node.joint)))
                if node.root and node.end and b - a > 1:
                    m = a + (b - a) // 2
                    following += [(node.root, a, m), (node.end, m, b)]
                else:
                    following += [(side, a, b) for side in (node.root, node.end) if side]
            row = following
        return result

    def enumerate(self, p: int) -> list[tuple[Fraction, Fraction, tuple[int, ...]]]:
        """For each tree: largest active time, total work, joints on several processes."""
        result = []
        for tree in self.trees(self.whole):
            assert tree is not None
            nodes = self.assign(tree, p)
            zero = Fraction(0)
            active = [sum((c for _, a, b, c in nodes if a <= i < b), zero) for i in range(p)]
            sequence = tuple(j for j, a, b, _ in nodes if b - a > 1)
            result.append((max(active), sum((c for *_, c in nodes), zero), sequence))
        return result
