"""Order of the values of a function.

For many states at once, the order is by step: a value is used soon after it is computed, and
registers and the first-level cache hold all live values; the reference field's terms of a link are
computed as soon as its motion is known. Functions are cut in this order. For a single state the
values of a function are then ordered by the length of the chain that depends on them, so that no
value on the longest chain is computed late. A processor looks some hundred statements ahead, so the
values of one step may stay together within that distance. More values are alive at once then, the
more of them the longer the line is: from some length on, or with 16 registers in every line, the
order of steps may be the faster one, and a profile says so.
"""

from __future__ import annotations

import heapq
from collections import defaultdict, deque
from collections.abc import Callable, Sequence, Set
from dataclasses import dataclass
from itertools import accumulate
from math import inf

from adagen.executor import work_of
from adagen.graph import Graph, Operations
from adagen.plan.steps import Kinematics, LinkBias, StartLink
from adagen.plan.types import Process
from adagen.schedule.costs import StepCosts

_TOGETHER = 100  # values among which those of one step stand together
LIMIT, LIMIT_OF_BATCHES, LIMIT_OF_LONG = 4000, 2000, 1000
"""Values that one function computes, by default: of a single state; of batches, wide ones, which
take the nearest cache longer to hold; and of a long line."""
_LONG = 0.1297
"""Values for each byte of the first instruction cache beyond which the line of a single state is
long (8,500 where it has 64 kB): short functions have short stack frames, within reach of short
displacements, and it fits that cache more often."""
_LEAST = 0.6  # of its limit is what a function computes at least, but for the last one
_MOST = 0.09
"""Values of several functions for each byte of that cache, up to which less waiting gains more than
fewer instructions (5,900 where it has 64 kB)."""
_WORTH = 0.5  # waiting, of their work: what is alive for long costs instructions, which they lack


@dataclass(frozen=True)
class Pace:
    """Speed at which a machine computes the values of a process; microseconds.

    Attributes:
        value: what one takes, on average, where none waits for another.
        cycle: a cycle of the longest chain of values that do.
        cache: size of its first instruction cache, bytes.
        ahead: how many values by step are looked at for the most urgent one; 0 keeps the order of
            steps.
    """

    value: float
    cycle: float
    cache: float
    ahead: float

    @staticmethod
    def of(operations: Operations, values: int, costs: StepCosts) -> Pace:
        """Return the pace of a process with so many values."""
        urgent = values <= costs["unrolled.urgent"]
        return Pace(
            costs.total(work_of(operations, costs["unrolled.held"])) / max(1, values),
            costs["unrolled.cycle"],
            costs["unrolled.cache"],
            costs["unrolled.ahead"] if urgent else 0.0,
        )


def in_functions(
    graph: Graph, process: Process, values: Set[int], longest: int, pace: Pace | None
) -> list[list[int]]:
    """Return values in the order in which they are computed, function by function.

    Args:
        graph: what they belong to.
        process: whose steps the marks of the nodes number.
        values: indices of what is to be computed; the rest of the graph is there before.
        longest: values of one function; a product and a sum that are rounded once are two.
        pace: of a single state; None where many are solved at once, which keeps a processor busy
            whatever waits for what.
    """
    order = by_step(graph, process, values)
    # Functions are parted by step: what one computes long before it is used goes through memory.
    functions = _cut(graph, order, longest)
    if pace is None or not pace.ahead:
        return functions
    if len(functions) > 1 and not _waiting_counts(graph, values, pace):
        return functions
    return [by_waits(graph, function, pace) for function in functions]


def limit_of_functions(values: int, pace: Pace | None, *, short: bool = False) -> int:
    """Return how many values one function computes, by default.

    Args:
        values: how many the process has.
        pace: of a single state; None where many are solved at once.
        short: whether the line is long enough for short functions, though it is shorter than others
            that have these.
    """
    if pace is None:
        return LIMIT_OF_BATCHES
    return LIMIT if values <= _LONG * pace.cache and not short else LIMIT_OF_LONG


def _cut(graph: Graph, order: Sequence[int], longest: int) -> list[list[int]]:
    """Values in functions of limited length; but for long ones, cut where the fewest are alive."""
    sizes = [2 if graph.nodes[k].op == "multiply_add" else 1 for k in order]
    if longest <= LIMIT_OF_BATCHES:
        return _cut_where_few(graph, order, longest, [0, *accumulate(sizes)])
    functions: list[list[int]] = []
    room = 0
    for k, size in zip(order, sizes, strict=True):
        if room <= 0:
            functions.append([])
            room = longest
        functions[-1].append(k)
        room -= size
    return functions


def _cut_where_few(
    graph: Graph, order: Sequence[int], longest: int, ends: Sequence[int]
) -> list[list[int]]:
    """Values cut where the fewest are alive, since what is alive goes through memory.

    Of all divisions into functions of at least ``_LEAST`` of their limit, but for the last one, it
    is the one with the least sum of what is alive at cuts.
    """
    alive = _alive(graph, order)
    least: list[float] = [0.0]  # by place: sum of what is alive at cuts up to there
    before = [0]  # by place: that of the cut before it
    window: deque[int] = deque()  # places of that cut, by ascending sums
    coming = 0
    for place in range(1, len(order) + 1):
        shortest = _LEAST * longest if place < len(order) else 0
        while coming < place and ends[place] - ends[coming] >= shortest:
            while window and least[window[-1]] >= least[coming]:
                window.pop()
            window.append(coming)
            coming += 1
        while window and ends[place - 1] - ends[window[0]] >= longest:
            window.popleft()
        least.append(least[window[0]] + alive[place] if window else inf)
        before.append(window[0] if window else 0)
    functions: list[list[int]] = []
    end = len(order)
    while end > 0:
        functions.append(list(order[before[end] : end]))
        end = before[end]
    return functions[::-1]


def _alive(graph: Graph, order: Sequence[int]) -> list[int]:
    """How many values a cut before each place of an order, or at its end, parts from a user."""
    turns = {k: turn for turn, k in enumerate(order)}
    last = list(range(len(order)))  # use of each
    for turn, k in enumerate(order):
        for operand in graph.nodes[k].args:
            if operand in turns:
                last[turns[operand]] = turn
    change = [0] * (len(order) + 2)
    for turn, use in enumerate(last):
        change[turn + 1] += 1
        change[use + 1] -= 1
    return list(accumulate(change[:-1]))


def _waiting_counts(graph: Graph, values: Set[int], pace: Pace) -> bool:
    """Whether dependency chains decide the order in several functions, too."""
    waiting = pace.cycle * _waits(graph, values).longest
    return len(values) <= _MOST * pace.cache and waiting >= _WORTH * pace.value * len(values)


def by_step(graph: Graph, process: Process, values: Set[int]) -> list[int]:
    """Return values in the order of their steps.

    Args:
        graph: what they belong to.
        process: whose steps the marks of the nodes number.
        values: indices of what is to be computed; the rest of the graph is there before.
    """
    moved = {s.joint + 1: k for k, s in enumerate(process.steps) if isinstance(s, Kinematics)}
    ranks = [
        moved.get(step.link, k) if isinstance(step, StartLink | LinkBias) else k
        for k, step in enumerate(process.steps)
    ]
    return _operands_first(graph, values, lambda k: (ranks[graph.nodes[k].mark], k))


def by_waits(graph: Graph, order: Sequence[int], pace: Pace) -> list[int]:
    """Return values by the chain that depends on them, those of one step close together.

    Args:
        graph: what they belong to.
        order: indices of what is to be computed, by step; the rest of the graph is there before.
        pace: how fast they are computed.
    """
    waits = _waits(graph, set(order))
    turns = {k: turn for turn, k in enumerate(_played(waits, order, pace))}
    place = {k: (turn // _TOGETHER, graph.nodes[k].mark, turn) for k, turn in turns.items()}
    return _operands_first(graph, turns.keys(), place.__getitem__)


def _operands_first(
    graph: Graph, values: Set[int], key: Callable[[int], tuple[int, ...]]
) -> list[int]:
    """The values sorted by a key, but each after its operands."""
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
    """Dependencies between values, in cycles.

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


def _played(waits: _Waits, by_step: Sequence[int], pace: Pace) -> list[int]:
    """The values in the order of a processor that always begins the most urgent one.

    It looks no further ahead than the pace says: the more is begun early, the more is alive, and
    goes through memory.
    """
    start: dict[int, float] = dict(waits.start)
    missing = {k: len(operands) for k, operands in waits.operands.items()}
    turn = {k: n for n, k in enumerate(by_step)}
    later: list[tuple[float, int]] = []  # by when they can begin
    beyond: list[tuple[int, int]] = []  # by their turn: too far ahead yet
    ready: list[tuple[int, int]] = []
    order: list[int] = []
    begun: set[int] = set()
    first = 0  # turn of the first value that is not begun
    step = pace.value / max(pace.cycle, 1e-9)  # cycles; not 0, or no chain would lengthen anything
    now = 0.0

    def free(k: int) -> None:
        if turn[k] < first + pace.ahead:
            heapq.heappush(later, (start[k], k))
        else:
            heapq.heappush(beyond, (turn[k], k))

    for k, count in missing.items():
        if count == 0:
            free(k)
    while later or ready:
        now = now if ready else max(now, later[0][0])
        while later and later[0][0] <= now:
            k = heapq.heappop(later)[1]
            heapq.heappush(ready, (-waits.follows[k], k))
        k = heapq.heappop(ready)[1]
        order.append(k)
        begun.add(k)
        while first < len(by_step) and by_step[first] in begun:
            first += 1
        while beyond and beyond[0][0] < first + pace.ahead:
            free(heapq.heappop(beyond)[1])
        for user in waits.users[k]:
            missing[user] -= 1
            start[user] = max(start[user], now + waits.lasts[k])
            if missing[user] == 0:
                free(user)
        now += step
    return order
