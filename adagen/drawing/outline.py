"""A tree as an outline, one row per joint, so that names never overlap."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from adagen.schedule.topology import Topology
from adagen.schedule.tree import Schedule, preorder


@dataclass(frozen=True)
class Row:
    """A joint in an outline.

    Attributes:
        joint: index of the joint.
        indent: its column.
        above: row number of the joint it hangs from, -1 for none.
        label: which side of that joint it is on, where both sides are indented.
    """

    joint: int
    indent: int
    above: int
    label: str = ""


def outline(
    roots: Sequence[int],
    children: Callable[[int], Sequence[int]],
    spread: Callable[[int], bool],
    sizes: Sequence[int],
) -> list[Row]:
    """Return the rows of a forest.

    The largest branch continues in the column of its joint, below the others, which are indented:
    the outline of n joints is then at most log2 n columns wide. Joints that ``spread`` names have
    all their branches indented, in the order given.

    Args:
        roots: joints that hang from none.
        children: joints that hang from a joint.
        spread: see above.
        sizes: number of joints of each joint's branch, itself included.
    """
    rows: list[Row] = []
    stack: list[tuple[int, int, int, str]] = [(root, 0, -1, "") for root in reversed(roots)]
    while stack:
        joint, indent, above, label = stack.pop()
        here = len(rows)
        rows.append(Row(joint, indent, above, label))
        below = list(children(joint))
        if spread(joint):
            labels = ("root side", "end side")
            stack += [
                (child, indent + 1, here, text)
                for child, text in reversed(list(zip(below, labels, strict=True)))
            ]
        elif below:
            below.sort(key=lambda child: sizes[child])
            stack.append((below[-1], indent, here, ""))
            stack += [(child, indent + 1, here, "") for child in reversed(below[:-1])]
    return rows


def schedule_rows(schedule: Schedule, topology: Topology) -> list[Row]:
    """Return the outline of the schedule tree; nodes that divide their processes are spread."""
    nodes = {node.joint: node for node in preorder(schedule.root)}
    sizes = [1] * len(topology)
    for node in reversed(list(preorder(schedule.root))):
        sizes[node.joint] += sum(sizes[child.joint] for child in node.children)

    def divides(joint: int) -> bool:
        node = nodes[joint]
        below = node.children
        return len(below) == 2 and below[0].processes != below[1].processes

    return outline(
        [schedule.root.joint],
        lambda joint: [child.joint for child in nodes[joint].children],
        divides,
        sizes,
    )


def robot_rows(topology: Topology) -> list[Row]:
    """Return the outline of the robot, joint under joint."""
    below: list[list[int]] = [[] for _ in range(len(topology) + 1)]
    for j, parent in enumerate(topology.parents):
        below[parent].append(j)
    sizes = [stop - start for start, stop in topology.intervals]
    return outline(below[0], lambda joint: below[joint + 1], lambda _: False, sizes)
