"""Values that a function computes again, so that they need not be kept in memory for it.

In batches each value that one function hands to another takes a register's width of the first-level
cache, and what does not fit there comes from the next one. A product or sum of what a function has
at hand anyway takes less than to store and to load it. Factors of eliminations, for example, are
rows of a loop divided by a pivot: the residual needs the rows, too, and one reciprocal.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Sequence
from typing import Protocol

from adagen.graph import Graph

_CHEAP = ("add", "sub", "mul", "multiply_add", "neg")
_WORTH = 2
"""Values, at least, for which something else is loaded instead."""


class Function(Protocol):
    """One function; ``values`` are the indices of what it computes, in order."""

    values: list[int]


def compute_again(graph: Graph, functions: Sequence[Function], kept: Collection[int]) -> None:
    """Have functions compute values again that they would load, where that takes one operation.

    What only later functions use is no longer computed before.

    Args:
        graph: what the values belong to.
        functions: in the order in which they are called; their values are changed.
        kept: values that stay where they are, as something else looks at them there.
    """
    home = {index: k for k, function in enumerate(functions) for index in function.values}
    for k, function in enumerate(functions):
        again = _cheaper(graph, function, home, k, kept)
        function.values = _with(graph, function.values, again)
    _leave_out(graph, functions, home, kept)


def _cheaper(
    graph: Graph, function: Function, home: dict[int, int], k: int, kept: Collection[int]
) -> set[int]:
    """The values of earlier functions that a function computes again."""
    nodes = graph.nodes
    loads = {arg for v in function.values for arg in nodes[v].args if home.get(arg, k) != k}
    again: set[int] = set()

    def missing(v: int) -> tuple[int, ...]:
        args = dict.fromkeys(nodes[v].args)
        return tuple(a for a in args if a in home and a not in loads and a not in again)

    while True:
        by_missing: dict[tuple[int, ...], list[int]] = defaultdict(list)
        for v in sorted(loads):
            if nodes[v].op in _CHEAP and v not in kept:
                by_missing[missing(v)].append(v)
        found = by_missing.pop((), [])
        if not found:
            one = {m: values for m, values in by_missing.items() if len(m) == 1}
            if not one:
                return again
            most = max(one, key=lambda m: len(one[m]))
            found = one[most]
            if len(found) < _WORTH:
                return again
            loads.update(most)
        loads.difference_update(found)
        again.update(found)


def _with(graph: Graph, values: Sequence[int], again: set[int]) -> list[int]:
    """Values with those that are computed again, each right before its first use."""
    found: list[int] = []
    placed: set[int] = set()
    for index in values:
        first, asked = set[int](), [index]
        while asked:
            args = graph.nodes[asked.pop()].args
            more = [arg for arg in args if arg in again and arg not in placed]
            placed.update(more)
            first.update(more)
            asked += more
        found += [*sorted(first), index]  # operands have smaller indices
    return found


def _leave_out(
    graph: Graph, functions: Sequence[Function], home: dict[int, int], kept: Collection[int]
) -> None:
    """Leave out what nothing uses any more; values are loaded from where they are first."""
    loaded: set[int] = set()  # by later functions
    for k in reversed(range(len(functions))):
        function = functions[k]
        used: set[int] = set()
        left: list[int] = []
        for v in reversed(function.values):
            if v in used or (home[v] == k and (v in kept or v in loaded)):
                left.append(v)
                used.update(graph.nodes[v].args)
        function.values = left[::-1]
        loaded |= used.difference(left)
