"""The schedule tree (Section II-C): nodes, the whole schedule, and what makes one right."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, NamedTuple

from adagen.schedule.profile import TICKS
from adagen.schedule.topology import Topology

Tie = Literal["work", "lex"]
Strategy = Literal["exact", "astar", "paper", "file"]
Named = Literal["balanced", "sequential", "middle-out"]
Split = Literal["always", "free", "any"]
Verdict = Literal["optimal", "gap"]
Meeting = Literal["join", "gather"]


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


@dataclass(frozen=True, eq=False)
class Schedule:
    """A schedule tree and what is known about it; times in microseconds.

    Attributes:
        root: the joint assembled last.
        processes: P.
        makespan: predicted time; the active time of a node is charged to every process of its
            range (III-B-2).
        verdict: ``optimal`` if no schedule under the same rules is shorter, proven; else ``gap``.
        gap: proven relative distance ``makespan / lower_bound - 1``; 0 when optimal.
        lower_bound: proven: no schedule under the same rules is shorter than this.
        profile: name of the cost profile.
        tie: the preference among equally long schedules.
        tie_proven: whether the preference is known to be met.
        strategy: how the schedule was found, or its name.
        split: whether two descendants always divide the range (III-C), may share it, or may also
            divide it unevenly.
        expanded: partial chains (exact) or search nodes (A*) that were expanded.
        loads: active time of each process; length P.
        meeting: how its processes meet: joined pair by pair as the tree says (the paper), or all
            gathering what they have at a small core (adagen.plan.gather).
    """

    root: Node
    processes: int
    makespan: float
    verdict: Verdict
    gap: float
    lower_bound: float
    profile: str
    tie: Tie
    tie_proven: bool
    strategy: Strategy | Named
    split: Split
    expanded: int
    loads: tuple[float, ...]
    meeting: Meeting = "join"


class Sweeps(NamedTuple):
    """How long a part of a schedule takes; ticks.

    Attributes:
        assembly: from the start until its process has assembled it.
        disassembly: from when its process knows the forces on it until all its processes are done.
        apart: when processes are done that wait for nobody in the second sweep.
    """

    assembly: int
    disassembly: int
    apart: int

    @property
    def total(self) -> int:
        """Of a whole robot: until all processes are done."""
        return max(self.assembly + self.disassembly, self.apart)

    def after(self, assembly: int, disassembly: int) -> Sweeps:
        """Return the time with more to be done by the same process."""
        return Sweeps(self.assembly + assembly, self.disassembly + disassembly, self.apart)


_NONE = Sweeps(0, 0, 0)


def beside(here: Sweeps, there: Sweeps, transit: tuple[int, int] | None) -> Sweeps:
    """Return the time of two parts side by side, before they are joined where the first one is.

    Args:
        here: the part whose process joins them.
        there: the other one.
        transit: how long its messages are under way in either sweep; None if it sends none.
    """
    if transit is None:
        return Sweeps(here.assembly, here.disassembly, max(here.apart, there.total))
    return Sweeps(
        max(here.assembly, there.assembly + transit[0]),
        max(here.disassembly, there.disassembly + transit[1]),
        max(here.apart, there.apart),
    )


class InvalidSchedule(ValueError):
    """A schedule tree that breaks the rules; says where and how."""


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


def loads_of(root: Node, processes: int) -> tuple[float, ...]:
    """Return the active time of each process, charging each node to all of its range (us)."""
    change = [0] * (processes + 1)
    for node in preorder(root):
        first, last = node.processes
        change[first] += _ticks(node.cost)
        change[last] -= _ticks(node.cost)
    loads, total = [], 0
    for step in change[:processes]:
        total += step
        loads.append(total / TICKS)
    return tuple(loads)


def makespan_of(root: Node) -> float:
    """Return the predicted time in microseconds: both sweeps, played through.

    Descendants that divide the range run side by side, those that share it one after the other.
    Where every pair divides its range and Eq. (11) prices the nodes this equals the largest active
    time of a process.
    """
    finish: dict[int, Sweeps] = {}
    for node in postorder(root):
        times = [finish.pop(child.joint) for child in node.children]
        first, second = _ticks(node.cost - node.disassembly), _ticks(node.disassembly)
        if len(times) == 2 and node.children[0].processes != node.children[1].processes:
            local = node.children[0].processes[0] == node.processes[0]
            here, there = times if local else reversed(times)
            away = node.children[local].transit
            transit = None if away is None else (_ticks(away[0]), _ticks(away[1]))
            below = beside(here, there, transit)
        else:
            below = (
                Sweeps(*(sum(column) for column in zip(*times, strict=True))) if times else _NONE
            )
        finish[node.joint] = below.after(first, second)
    return finish[root.joint].total / TICKS


def total_work(root: Node) -> float:
    """Return the sum of the costs of all nodes in microseconds."""
    return sum(_ticks(node.cost) for node in preorder(root)) / TICKS


def validate(schedule: Schedule, topology: Topology) -> None:
    """Check a schedule against the robot.

    Every joint appears once; the joints below a node are exactly those of its partial chain, each
    on its side; ranges follow III-C (halves, other splits or shared ranges alike) or, where
    processes gather, lie within those above; numbers of boundary joints, loads and, unless
    processes gather, makespan are those of the tree.

    Raises:
        InvalidSchedule: it breaks one of these rules.
    """
    _check_tree(schedule.root, topology)
    _check_ranges(schedule, topology)
    if schedule.loads != loads_of(schedule.root, schedule.processes):
        raise InvalidSchedule("the loads are not those of the tree")
    if schedule.meeting == "join" and schedule.makespan != makespan_of(schedule.root):
        raise InvalidSchedule("the makespan is not that of the tree")


def _check_tree(root: Node, topology: Topology) -> None:
    """Assemble the robot in postorder, and see that each node joins what its sides have made."""
    component = list(range(len(topology) + 1))

    def find(link: int) -> int:
        while component[link] != link:
            component[link] = component[component[link]]
            link = component[link]
        return link

    seen = [False] * len(topology)
    degrees = list(topology.degrees)
    joints = [0] * (len(topology) + 1)
    for node in postorder(root):
        j = node.joint
        if not 0 <= j < len(topology) or seen[j]:
            what = "more than once" if 0 <= j < len(topology) else "but is not of the robot"
            raise InvalidSchedule(f"joint {_name(topology, j)} appears {what}")
        seen[j] = True
        ends = (topology.parents[j], j + 1)
        for link, side, label in zip(
            ends, (node.root_side, node.end_side), ("root", "end"), strict=True
        ):
            made = link if side is None else find(side.joint + 1)
            if find(link) != made or (side is None and joints[made]):
                raise InvalidSchedule(
                    f"the {label} side of joint {_name(topology, j)} is not what it cuts off there"
                )
        first, second = find(ends[0]), find(ends[1])
        component[second] = first
        degrees[first] += degrees[second]
        joints[first] += joints[second] + 1
        if node.boundary != degrees[first] - 2 * joints[first]:
            raise InvalidSchedule(f"wrong number of boundary joints at {_name(topology, j)}")
    if not all(seen):
        raise InvalidSchedule(f"joint {_name(topology, seen.index(False))} is missing")


def _check_ranges(schedule: Schedule, topology: Topology) -> None:
    if schedule.root.processes != (0, schedule.processes) or schedule.processes < 1:
        raise InvalidSchedule(f"the root must have the processes [0, {schedule.processes}]")
    for node in preorder(schedule.root):
        ranges = [child.processes for child in node.children]
        if all(r == node.processes for r in ranges):
            continue
        a, b = node.processes
        if schedule.meeting == "gather" and all(a <= first < last <= b for first, last in ranges):
            continue
        if len(ranges) == 2:  # whichever side has the first process stays where it is joined
            (first, m), (n, last) = sorted(ranges)
            if a == first < m == n < last == b:
                continue
        raise InvalidSchedule(
            f"the descendants of joint {_name(topology, node.joint)} neither share its range of "
            "processes nor divide it"
        )


def _name(topology: Topology, joint: int) -> str:
    return f"'{topology.names[joint]}'" if 0 <= joint < len(topology) else str(joint)


def _ticks(microseconds: float) -> int:
    return round(microseconds * TICKS)
