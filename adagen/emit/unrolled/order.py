"""In which order the values of a stretch are computed.

Either by step, so that a value is used soon and registers and the first-level cache hold what is
alive: what a link takes of the reference field is computed as soon as the link has it. Or by what
still follows, where the evaluation of a single state is predicted to last longer for its longest
chain of values that wait for each other: then nothing on that is to be begun late. A processor
looks some hundred statements ahead, so that what belongs to one step may still stand together as
long as it is near. Over several functions values would go through memory, so that only a stretch
that is one function has this order.
"""

from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Callable, Set
from dataclasses import dataclass

from adagen.executor import at_once, work_of
from adagen.graph import Graph, Operations
from adagen.plan.steps import Kinematics, LinkBias, StartLink
from adagen.plan.types import Process
from adagen.schedule.costs import StepCosts

_TOGETHER = 100  # values among which those of one step stand together


@dataclass(frozen=True)
class Pace:
    """How fast a machine computes the values of a process; microseconds.

    Attributes:
        value: what one takes, on average, where none waits for another.
        cycle: a cycle of the longest chain of values that do.
        margin: the share of a time by which predictions are off.
    """

    value: float
    cycle: float
    margin: float

    @staticmethod
    def of(operations: Operations, values: int, costs: StepCosts) -> Pace:
        """Return the pace of a process with so many values."""
        work = costs.total(work_of(operations, costs["unrolled.held"]))
        return Pace(work / max(1, values), costs["unrolled.cycle"], costs["process.margin"])

    def waits(self, values: int, longest: int) -> bool:
        """Whether so many values are predicted to take longer for a chain of so many cycles."""
        work = self.value * values
        return at_once(work, self.cycle * longest) > (1 + self.margin) * work


def in_order(
    graph: Graph, process: Process, values: Set[int], pace: Pace | None = None
) -> list[int]:
    """Return the values of a stretch in the order in which they are computed.

    Args:
        graph: what they belong to.
        process: whose steps the marks of the nodes number.
        values: indices of what is to be computed; the rest of the graph is there before.
        pace: of a single state in one function; None for the order by step in any case. Many
            states at once keep a processor busy, whatever waits for what.
    """
    if pace is not None:
        waits = _waits(graph, values)
        if pace.waits(len(values), waits.longest):
            turns = {k: turn for turn, k in enumerate(_played(waits, pace))}
            place = {k: (turn // _TOGETHER, graph.nodes[k].mark, turn) for k, turn in turns.items()}
            return _operands_first(graph, values, place.__getitem__)
    moved = {s.joint + 1: k for k, s in enumerate(process.steps) if isinstance(s, Kinematics)}
    ranks = [
        moved.get(step.link, k) if isinstance(step, StartLink | LinkBias) else k
        for k, step in enumerate(process.steps)
    ]
    return _operands_first(graph, values, lambda k: (ranks[graph.nodes[k].mark], k))


def _operands_first(
    graph: Graph, values: Set[int], key: Callable[[int], tuple[int, ...]]
) -> list[int]:
    """The values by a key, but that each comes after what it uses."""
    order: dict[int, None] = {}
    for index in sorted(values, key=key):
        waiting = [index]
        while waiting:
            args = graph.nodes[waiting[-1]].args
            missing = [k for k in args if k in values and k not in order]
            if missing:
                waiting += missing[::-1]
            else:
                order.setdefault(waiting.pop())
    return list(order)


@dataclass(frozen=True)
class _Waits:
    """Who waits for whom, in cycles.

    Attributes:
        operands: of each value, those that are to be computed.
        users: of each value.
        start: when what is there before lets a value begin.
        lasts: how long it takes.
        follows: from its beginning to the end of all that waits for it.
    """

    operands: dict[int, set[int]]
    users: dict[int, list[int]]
    start: dict[int, int]
    lasts: dict[int, int]
    follows: dict[int, int]

    @property
    def longest(self) -> int:
        """Cycles of the longest chain."""
        return max((self.start[k] + self.follows[k] for k in self.start), default=0)


def _waits(graph: Graph, values: Set[int]) -> _Waits:
    nodes = graph.nodes
    waits = _Waits({}, defaultdict(list), {}, {}, {})
    for k in sorted(values):
        args = set(nodes[k].args)
        waits.operands[k] = args & values
        waits.start[k] = max((nodes[a].ready for a in args - values), default=0)
        waits.lasts[k] = nodes[k].ready - max((nodes[a].ready for a in args), default=0)
        for operand in waits.operands[k]:
            waits.users[operand].append(k)
    for k in sorted(values, reverse=True):
        after = max((waits.follows[user] for user in waits.users[k]), default=0)
        waits.follows[k] = waits.lasts[k] + after
    return waits


def _played(waits: _Waits, pace: Pace) -> list[int]:
    """The values as a processor would begin them that always takes what most waits for."""
    start: dict[int, float] = dict(waits.start)
    missing = {k: len(operands) for k, operands in waits.operands.items()}
    later = [(start[k], k) for k, count in missing.items() if count == 0]
    heapq.heapify(later)
    ready: list[tuple[int, int]] = []
    order: list[int] = []
    now = 0.0
    while later or ready:
        now = now if ready else max(now, later[0][0])
        while later and later[0][0] <= now:
            k = heapq.heappop(later)[1]
            heapq.heappush(ready, (-waits.follows[k], k))
        k = heapq.heappop(ready)[1]
        order.append(k)
        for user in waits.users[k]:
            missing[user] -= 1
            start[user] = max(start[user], now + waits.lasts[k])
            if missing[user] == 0:
                heapq.heappush(later, (start[user], user))
        now += pace.value / pace.cycle  # not 0, or no chain would lengthen anything
    return order
