"""The time of a schedule: both sweeps over its tree, and the active time of each process."""

from __future__ import annotations

from typing import NamedTuple

from adagen.schedule.profile import TICKS
from adagen.schedule.tree import Node, postorder, preorder


class Sweeps(NamedTuple):
    """Times of a part of a schedule; ticks.

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


def _ticks(microseconds: float) -> int:
    return round(microseconds * TICKS)
