"""Lanes of the straight line's wide values that a process computes side by side."""

from __future__ import annotations

from collections.abc import Collection

from adagen.executor.line import Line, Pair
from adagen.union_find import UnionFind


def shared_lanes(
    line: Line, pairs: set[Pair], missing: Collection[Pair]
) -> tuple[set[Pair], dict[int, list[int]]]:
    """Return the values that are computed with lanes side by side, and their lanes.

    Values that are computed of each other lane by lane have the same lanes: all that any of them
    is needed in. Values that are needed in one lane only are left out.

    Args:
        line: the straight line of one process.
        pairs: what is needed of it.
        missing: what of this comes by message.
    """
    known = set(missing)
    while True:
        together = _together(line, pairs - known)
        wanted: dict[int, set[int]] = {}
        for index, lane in pairs - known:
            if index in together:
                wanted.setdefault(together[index], set()).add(lane)
        spread = [(index, lane) for index, lead in together.items() for lane in wanted[lead]]
        more = line.needs(spread, known) - pairs
        if not more:
            break
        pairs = pairs | more
    lanes = {index: sorted(wanted[lead]) for index, lead in together.items()}
    return pairs, {index: own for index, own in lanes.items() if len(own) > 1}


def _together(line: Line, pairs: set[Pair]) -> dict[int, int]:
    """For each wide value, a representative of all that depend on each other lane by lane."""
    nodes = line.nodes
    wide = {index for index, _ in pairs if nodes[index].width > 1}
    leaders = UnionFind[int]()
    for index in wide:
        for k in nodes[index].args:
            if k in wide:
                leaders.join(k, index)
    return {index: leaders.of(index) for index in wide}
