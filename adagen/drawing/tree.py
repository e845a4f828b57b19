"""A schedule tree as a picture: both sweeps in time by Eq. (11), the tree, and the robot."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from adagen.cost import Exchange, Interval, Timeline
from adagen.drawing.gantt import Caption
from adagen.drawing.outline import schedule_rows
from adagen.drawing.page import NAME, Outline, page, robot_outline
from adagen.drawing.svg import SIZE, shorten
from adagen.schedule import Node, Schedule, Topology, postorder, preorder
from adagen.schedule.profile import TICKS


def schedule_svg(schedule: Schedule, topology: Topology, name: str) -> str:
    """Return a drawing of a schedule: a Gantt chart, the schedule tree, and the robot's tree.

    Args:
        schedule: the schedule.
        topology: the robot.
        name: the robot's name.

    Returns:
        An SVG document that needs no other resource; the same bytes for the same arguments.
    """

    def caption(i: Interval) -> Caption:
        if i.joint is None:
            return Caption(i.what)
        joint = topology.names[i.joint]
        return Caption(f"{joint}: {i.what}", (joint, str(i.joint)))

    count = f"{schedule.processes} process{'es' * (schedule.processes > 1)}"
    said = (
        f"{count}: predicted {schedule.makespan:.2f} µs ({schedule.proven}; "
        f"costs: {schedule.profile}; strategy: {schedule.strategy}; tie-break: {schedule.tie}); "
        "half of a cost in each sweep"
    )
    tree = tree_outline(schedule, topology)
    busiest = max(Counter(tree.process.values()).values())
    right = robot_outline(topology, tree.process, "the same colours")
    return page(name, said, played_tree(schedule), caption, 2 * busiest, tree, right)


def tree_outline(schedule: Schedule, topology: Topology, *, costs: bool = True) -> Outline:
    """Return a schedule's tree: names, joint numbers and k; costs where they make up the time."""
    nodes = {node.joint: node for node in preorder(schedule.root)}
    rows = []
    for row in schedule_rows(schedule, topology):
        node = nodes[row.joint]
        a, b = node.processes
        parts = [f"{row.joint}:  k={node.boundary}"]
        parts += [f"{node.cost:.2f} µs"] if costs else []
        parts += [row.label] if row.label else []
        parts += [f"processes {a}–{b - 1}"] if b - a > 1 else []
        rows.append((row, shorten(topology.names[row.joint], NAME, SIZE), ", ".join(parts)))
    about = "assembled from below, in the circle: process; then joint number, boundary joints k"
    about += ", cost" if costs else ""
    process = {joint: node.processes[0] for joint, node in nodes.items()}
    return Outline("Schedule tree", about, rows, process)


def played_tree(schedule: Schedule) -> Timeline:
    """Return how both sweeps of a schedule tree go.

    Eq. (11) prices assembly and disassembly of a joint together; each sweep is shown with half of
    it where the node does not tell. A node is computed by the first process of its range, once its
    descendants (in the second sweep: its ascendant) and that process's earlier work are done.
    """
    play = _Play(schedule.processes)
    nodes = list(postorder(schedule.root))
    for node in nodes:
        play.sweep(node, "assembly", _sweeps(node)[0], node.children)
    above = {child.joint: node for node in nodes for child in node.children}
    for node in reversed(nodes):
        before = [above[node.joint]] if node.joint in above else []
        play.sweep(node, "disassembly", _sweeps(node)[1], before)
    order = sorted(play.intervals, key=lambda i: (i.process, i.start, i.end))
    return Timeline(tuple(order), tuple(play.exchanges), max(play.free) / TICKS, "predicted")


class _Play:
    """Both sweeps as far as they have gone; ticks."""

    def __init__(self, processes: int) -> None:
        self.free = [0] * processes  # when each process is done with its work so far
        self.ready: dict[int, int] = {}  # when each joint's latest sweep is done
        self.intervals: list[Interval] = []
        self.exchanges: list[Exchange] = []

    def sweep(self, node: Node, what: str, time: int, before: Sequence[Node]) -> None:
        """Let the process of a node do it, once the nodes before it are done."""
        p = node.processes[0]
        start = max([self.free[p], *(self.ready[other.joint] for other in before)])
        if start > self.free[p]:
            self._note(p, "wait", None, self.free[p], start)
        for other in before:
            if other.processes[0] != p:
                sent = self.ready[other.joint] / TICKS
                self.exchanges.append(Exchange(other.processes[0], p, sent, start / TICKS))
        self.free[p] = self.ready[node.joint] = start + time
        self._note(p, what, node.joint, start, start + time)

    def _note(self, p: int, what: str, joint: int | None, start: int, end: int) -> None:
        self.intervals.append(Interval(p, what, joint, None, start / TICKS, end / TICKS))


def _sweeps(node: Node) -> tuple[int, int]:
    """Return how long a node takes in each sweep, ticks."""
    cost, second = round(node.cost * TICKS), round(node.disassembly * TICKS)
    first = cost - second if second else cost // 2
    return first, cost - first
