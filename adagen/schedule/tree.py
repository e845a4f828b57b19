"""The schedule tree (Section II-C): nodes, the whole schedule, and its traversals."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

Tie = Literal["work", "lex"]
Strategy = Literal["exact", "astar", "paper", "file"]
Named = Literal["balanced", "sequential", "middle-out"]
Split = Literal["always", "free", "any"]
Verdict = Literal["optimal", "gap"]
Meeting = Literal["join", "gather", "exchange"]

FAR = 0.5
"""Gap beyond which a bound says nothing about a schedule that is worth a number."""


@dataclass(frozen=True, eq=False, repr=False)
class Node:
    """A joint of the schedule tree: it joins the partial chains of its two sides.

    A chain of N joints makes a tree as deep as N, so nothing here recurses: two nodes are equal
    if they are the same object, and :func:`preorder` and :func:`postorder` walk without recursion.

    Attributes:
        joint: index of the joint.
        processes: (first, last + 1), the range of processes that it is assigned to (III-C); the
            first one computes it.
        root_side: what is assembled on the side of the joint's parent link; None: the bare link.
        end_side: the same on the side of its child link.
        cost: Eq. (11), or what the node's steps take; microseconds.
        boundary: k = N_O, the number of joints outside the node's chain that touch it.
        disassembly: how much of the cost falls into the second sweep, where that is known; Eq. (11)
            prices both sweeps as one.
        transit: how long the results of its chain are under way to the process of the node above,
            and the forces on it back; None if there is nothing to tell.
    """

    joint: int
    processes: tuple[int, int]
    root_side: Node | None
    end_side: Node | None
    cost: float
    boundary: int
    disassembly: float = 0.0
    transit: tuple[float, float] | None = (0.0, 0.0)

    @property
    def children(self) -> tuple[Node, ...]:
        """Its descendants, root side first; length 0 to 2."""
        return tuple(side for side in (self.root_side, self.end_side) if side is not None)

    def __repr__(self) -> str:
        below = "".join(f" {side}={child.joint}" for side, child in _sides(self))
        return f"<Node {self.joint} on {self.processes}{below}>"


@dataclass(frozen=True)
class Gathered:
    """A layout of gathering processes: roots and owners (adagen.plan.gather).

    Attributes:
        roots: for each tree of links that move together, in the order of their first joints, the
            link that all inertias are swept to; 0 is the ground.
        owners: the process of each joint; None in the core, which every process sweeps. That of a
            joint that floats on the ground follows from the others.
        told: whether a process is told how the run of joints moves that its own hang on, where
            another process has all of that, instead of passing it (adagen.plan.sent_passages).
    """

    roots: tuple[int, ...]
    owners: tuple[int | None, ...]
    told: bool = False


@dataclass(frozen=True, eq=False)
class Schedule:
    """A schedule tree with its predicted time and bound; times in microseconds.

    Attributes:
        root: the joint assembled last.
        processes: P.
        makespan: predicted time; the active time of a node is charged to every process of its
            range (III-B-2).
        lower_bound: proven: no schedule under the same rules is shorter than this; at most the
            makespan.
        profile: name of the cost profile.
        tie: the preference among equally long schedules.
        tie_proven: whether the preference is known to be met.
        strategy: how the schedule was found, or its name.
        split: whether two descendants always divide the range (III-C), may share it, or may also
            divide it unevenly.
        expanded: partial chains (exact) or search nodes (A*) that were expanded.
        loads: active time of each process; length P.
        meeting: how its processes meet: joined pair by pair as the tree says (the paper); the
            same with both sides joining (adagen.plan.exchange); or all gathering what they have at
            a small core (adagen.plan.gather).
        families: the families of candidates that it was chosen from at the price that is played
            (adagen.search), which makespan, bound and loads are then given in, in the shape that is
            emitted; empty where they are given in that of the tree.
        candidates: how many candidates were priced as loops, where families were searched.
        straight_lines: how many of them were priced as straight lines of statements, too: the bound
            is one on all loops and on these.
        gathered: where processes gather; None where the tree says that.
        shape: the shape of the code that a document asks for; "auto" for that of least price.
        fan: how many groups of processes that exchange put together at once how their parts of a
            serial chain move, a power of two.
        parts: in how many parts each process sweeps a long chain of hinges of its own at once, one
            in each SIMD lane (adagen.plan.parts); 0: none.
    """

    root: Node
    processes: int
    makespan: float
    lower_bound: float
    profile: str
    tie: Tie
    tie_proven: bool
    strategy: Strategy | Named
    split: Split
    expanded: int
    loads: tuple[float, ...]
    meeting: Meeting = "join"
    families: tuple[str, ...] = ()
    candidates: int = 0
    straight_lines: int = 0
    gathered: Gathered | None = None
    shape: str = "auto"
    fan: int = 2
    parts: int = 0

    @property
    def verdict(self) -> Verdict:
        """``optimal`` if no schedule under the same rules is shorter, proven; else ``gap``."""
        return "optimal" if self.lower_bound >= self.makespan else "gap"

    @property
    def among(self) -> str:
        """The programs that the verdict covers, in words: straight lines only as far as priced."""
        lines = self.straight_lines
        priced = f" and {lines} straight line{'s' * (lines > 1)}" if lines else ""
        return f"loops{priced}" if self.families else ""

    @property
    def proven(self) -> str:
        """The proven bound, in words."""
        among = f" among {self.among}" if self.among else ""
        if self.verdict == "optimal":
            return f"optimal{among}"
        if self.gap > FAR:
            least = f"{self.lower_bound:.2g} us at least"
            return f"no useful bound: proven is only that others{among} take {least}"
        return f"at most {self.gap:.1%} above the optimum{among}"

    @property
    def gap(self) -> float:
        """Proven relative distance ``makespan / lower_bound - 1``; 0 when optimal."""
        if self.verdict == "optimal":
            return 0.0
        return self.makespan / self.lower_bound - 1.0 if self.lower_bound > 0.0 else math.inf


def _sides(node: Node) -> Iterator[tuple[str, Node]]:
    if node.root_side is not None:
        yield "root", node.root_side
    if node.end_side is not None:
        yield "end", node.end_side


def preorder(root: Node) -> Iterator[Node]:
    """Yield every node, a node before its descendants, root side first."""
    stack = [root]
    while stack:
        node = stack.pop()
        yield node
        stack.extend(reversed(node.children))


def postorder(root: Node) -> Iterator[Node]:
    """Yield every node after its descendants, root side first: an order of assembly."""
    stack: list[tuple[Node, bool]] = [(root, False)]
    while stack:
        node, seen = stack.pop()
        if seen:
            yield node
        else:
            stack.append((node, True))
            stack.extend((child, False) for child in reversed(node.children))


def levels(root: Node) -> Iterator[Node]:
    """Yield every node level by level, root side first: the slot order of the paper's search."""
    row = [root]
    while row:
        yield from row
        row = [child for node in row for child in node.children]
