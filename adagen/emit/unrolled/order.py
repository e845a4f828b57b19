"""In which order the values of a stretch are computed.

Either by step, so that a value is used soon and registers and the first-level cache hold what is
alive: what a link takes of the reference field is computed as soon as the link has it. Or by what
still follows: the evaluation of a single state by a short line lasts as long as its longest chain
of values that wait for each other, if nothing on that is begun late. A processor looks some hundred
statements ahead, so that what belongs to one step may still stand together as long as it is near.
"""

from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Callable, Set
from dataclasses import dataclass

from adagen.graph import Graph
from adagen.plan.steps import Kinematics, LinkBias, StartLink
from adagen.plan.types import Process

_EACH_CYCLE = 2.5  # values that a processor of today computes in a cycle, other work beside
_WAITING = 0.8  # share of the time that the longest chain has to take to be what limits
_SHORT = 2500  # values that are alive all over a longer line fill the first-level cache
_TOGETHER = 100  # values among which those of one step stand together


def in_order(graph: Graph, process: Process, values: Set[int], *, batch: bool) -> list[int]:
    """Return the values of a stretch in the order in which they are computed.

    Args:
        graph: what they belong to.
        process: whose steps the marks of the nodes number.
        values: indices of what is to be computed; the rest of the graph is there before.
        batch: whether many states are solved at once, which keeps a processor busy in any case.
    """
    if not batch and len(values) <= _SHORT:
        waits = _waits(graph, values)
        if waits.longest >= _WAITING * len(values) / _EACH_CYCLE:
            turns = {k: turn for turn, k in enumerate(_played(waits))}
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


def _played(waits: _Waits) -> list[int]:
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
        now += 1 / _EACH_CYCLE
    return order
