"""Validity of a schedule: every joint once, each on its side, ranges as in III-C."""

from __future__ import annotations

from adagen.schedule.sweeps import loads_of, makespan_of
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Node, Schedule, postorder, preorder
from adagen.union_find import UnionFind


class InvalidSchedule(ValueError):
    """A schedule tree that breaks the rules; says where and how."""


def validate(schedule: Schedule, topology: Topology) -> None:
    """Check a schedule against the robot.

    Every joint appears once; the joints below a node are exactly those of its partial chain, each
    on its side; ranges follow III-C (halves, other splits or shared ranges alike) or, where
    processes gather, lie within those above, and processes that exchange or gather may leave others
    idle; numbers of boundary joints and, unless they are those
    of the program that is emitted, loads and makespan are those of the tree.

    Raises:
        InvalidSchedule: it breaks one of these rules.
    """
    _check_tree(schedule.root, topology)
    _check_ranges(schedule, topology)
    if schedule.families:
        return
    if schedule.loads != loads_of(schedule.root, schedule.processes):
        raise InvalidSchedule("the loads are not those of the tree")
    if schedule.meeting == "join" and schedule.makespan != makespan_of(schedule.root):
        raise InvalidSchedule("the makespan is not that of the tree")


def _check_tree(root: Node, topology: Topology) -> None:
    """Assemble the robot in postorder, and check that each node joins what its sides have made."""
    leaders = UnionFind[int]()  # of links that are assembled
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
            made = link if side is None else leaders.of(side.joint + 1)
            if leaders.of(link) != made or (side is None and joints[made]):
                raise InvalidSchedule(
                    f"the {label} side of joint {_name(topology, j)} is not what it cuts off there"
                )
        first, second = leaders.of(ends[0]), leaders.of(ends[1])
        leaders.join(second, first)
        degrees[first] += degrees[second]
        joints[first] += joints[second] + 1
        if node.boundary != degrees[first] - 2 * joints[first]:
            raise InvalidSchedule(f"wrong number of boundary joints at {_name(topology, j)}")
    if not all(seen):
        raise InvalidSchedule(f"joint {_name(topology, seen.index(False))} is missing")


def _check_ranges(schedule: Schedule, topology: Topology) -> None:
    first, last = schedule.root.processes
    some = schedule.meeting != "join" and 1 <= last <= schedule.processes  # others are idle
    if first != 0 or not (some or last == schedule.processes >= 1):
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
