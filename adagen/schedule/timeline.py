"""Who does what when: the two sweeps of a schedule as the cost profile predicts them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from adagen.schedule.profile import TICKS
from adagen.schedule.tree import Node, Schedule, postorder

Sweep = Literal["assembly", "disassembly"]


@dataclass(frozen=True)
class Bar:
    """A stretch of work of one process on one joint; microseconds from the start."""

    joint: int
    process: int
    start: float
    end: float
    sweep: Sweep


@dataclass(frozen=True)
class Message:
    """What one process hands to another; microseconds from the start."""

    sender: int
    receiver: int
    sent: float
    used: float
    sweep: Sweep


@dataclass(frozen=True)
class Timeline:
    """Bars in order of assembly, then of disassembly, and the messages between processes."""

    bars: tuple[Bar, ...]
    messages: tuple[Message, ...]
    end: float


def predict(schedule: Schedule) -> Timeline:
    """Return the predicted timeline of both sweeps.

    Eq. (11) prices assembly and disassembly of a joint together; each sweep is shown with half of
    it where the node does not tell. A node is computed by the first process of its range, once its
    descendants (in the second sweep: its ascendant) and that process's earlier work are done.
    """
    nodes = list(postorder(schedule.root))
    free = [0] * schedule.processes
    ready: dict[int, int] = {}
    bars: list[Bar] = []
    messages: list[Message] = []
    for node in nodes:
        p = node.processes[0]
        start = max([free[p], *(ready[child.joint] for child in node.children)])
        for child in node.children:
            if (q := child.processes[0]) != p:
                messages.append(_message(q, p, ready[child.joint], start, "assembly"))
        free[p] = ready[node.joint] = start + _sweeps(node)[0]
        bars.append(_bar(node.joint, p, start, free[p], "assembly"))
    begin: dict[int, int] = {schedule.root.joint: 0}
    sender: dict[int, int] = {}
    for node in reversed(nodes):
        p = node.processes[0]
        start = max(free[p], begin[node.joint])
        if node.joint in sender:
            sent = begin[node.joint]
            messages.append(_message(sender[node.joint], p, sent, start, "disassembly"))
        free[p] = start + _sweeps(node)[1]
        bars.append(_bar(node.joint, p, start, free[p], "disassembly"))
        for child in node.children:
            begin[child.joint] = free[p]
            if child.processes[0] != p:
                sender[child.joint] = p
    return Timeline(tuple(bars), tuple(messages), max(free) / TICKS)


def _sweeps(node: Node) -> tuple[int, int]:
    """Return how long a node takes in each sweep, ticks."""
    cost, second = round(node.cost * TICKS), round(node.disassembly * TICKS)
    first = cost - second if second else cost // 2
    return first, cost - first


def _bar(joint: int, process: int, start: int, end: int, sweep: Sweep) -> Bar:
    return Bar(joint, process, start / TICKS, end / TICKS, sweep)


def _message(sender: int, receiver: int, sent: int, used: int, sweep: Sweep) -> Message:
    return Message(sender, receiver, sent / TICKS, used / TICKS, sweep)
