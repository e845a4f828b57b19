"""Which joints a loop sweeps together, and in which lanes.

A row of joints shares a record with other rows that neither wait for it nor it for them. Records
are found outwards, one after the other, each with the rows that most others hang on (Hu, Parallel
sequencing and assembly line problems, Operations Research 9, 1961). A row has the lanes of the one
that it hangs on where it can: what is handed on then stays in its lane.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from adagen.executor.rows import Rows
from adagen.plan.certificate import IN_LOOPS

Record = list[tuple[int, int]]
"""Rows of joints by their names, each with its first lane."""
_WIDEST = 4
"""Lanes that records have at most where no row has more: with eight, they take 1.6 times as long on
an Intel Xeon (docs/records/certificates.md)."""


def outermost(
    rows: Rows, inwards: Sequence[int], count: int, tops: Iterable[int] = ()
) -> list[int]:
    """Return the outermost rows that a loop can sweep, each behind those beyond it.

    These are rows of hinges and slides that nothing but such hangs on.

    Args:
        rows: of a process.
        inwards: the joints that rows are named by, each behind those beyond it.
        count: how many are asked for; where there are fewer, all.
        tops: links that something else hangs on.
    """
    able, within = list[int](), set(tops)
    for j in inwards:
        in_loop = rows.process.plan.joints[j].kind in IN_LOOPS
        if in_loop and within.isdisjoint(each + 1 for each in rows.own(j)):
            able.append(j)
        else:
            within.update(rows.near_links(j))
    depths = dict[int, int]()
    for j in reversed(able):
        depths[j] = 1 + max((depths.get(each, 0) for each in _nearer(rows, j)), default=0)
    return sorted(able, key=lambda j: -depths[j])[:count]


def records(rows: Rows, looped: Sequence[int]) -> tuple[int, list[Record]]:
    """Return how many lanes records have, and the records inwards.

    Args:
        rows: of a process.
        looped: those that are swept, see ``outermost``.
    """
    within = [near for j in looped for near in _nearer(rows, j)]
    least = max(2, *(len(rows.lanes(j)) for j in (*looped, *within)))
    widths = dict.fromkeys((least, max(least, _WIDEST)))
    offers = [(n, _placed(rows, looped, n, on)) for n in widths for on in (True, False)]
    return min(offers, key=lambda offer: len(offer[1]))


def _nearer(rows: Rows, j: int) -> list[int]:
    """The rows that a row hangs on."""
    return list(dict.fromkeys(rows.name_of(link) - 1 for link in rows.near_links(j) if link))


def _placed(rows: Rows, looped: Sequence[int], lanes: int, on: bool) -> list[Record]:
    """Records with so many lanes.

    Args:
        rows: of a process.
        looped: those that are swept.
        lanes: of a record.
        on: whether rows that hang on those of the record before come first, if none is late.
    """
    beyond = dict.fromkeys(looped, 0)  # how many rows hang on each other there, at most
    for j in looped:
        for near in _nearer(rows, j):
            if near in beyond:
                beyond[near] = max(beyond[near], 1 + beyond[j])
    left = sorted(looped, key=lambda j: (-beyond[j], -len(rows.lanes(j))))
    places, found = dict[int, int](), list[Record]()  # places: first lanes
    while left:
        record, free = Record(), set(range(lanes))
        ready = [j for j in left if not any(near in left for near in _nearer(rows, j))]
        if on and found:
            latest, before = beyond[left[0]], {j for j, _ in found[-1]}
            apart = {j: before.isdisjoint(_nearer(rows, j)) for j in ready}
            ready.sort(key=lambda j: beyond[j] < latest and 1 + apart[j])
        beside = {j: _beside(rows, j, places) for j in _as_many_as_fit(rows, ready, lanes)}
        for j in sorted(beside, key=lambda j: beside[j] is None):
            width = len(rows.lanes(j))
            firsts = [n for n in range(0, lanes, width) if free.issuperset(range(n, n + width))]
            if firsts:
                own = beside[j]
                places[j] = first = own if own in firsts else firsts[0]
                record.append((j, first))
                free.difference_update(range(first, first + width))
        left = [j for j in left if j not in places]
        found.append(record)
    return _one_after_the_other(rows, found[::-1])


def _one_after_the_other(rows: Rows, found: Sequence[Record]) -> list[Record]:
    """Records inwards, right behind one that hands on to them where that can be."""
    own = {j: k for k, record in enumerate(found) for j, _ in record}
    hangs_on = [
        {own[near] for j, _ in record for near in _nearer(rows, j) if near in own}
        for record in found
    ]
    left, order = list(range(len(found))), list[int]()
    while left:
        waiting = set[int]().union(*(hangs_on[k] for k in left))
        ready = [k for k in left if k not in waiting]
        after = hangs_on[order[-1]] if order else set()
        order.append(next((k for k in ready if k in after), ready[0]))
        left.remove(order[-1])
    return [found[k] for k in order]


def _as_many_as_fit(rows: Rows, ready: Sequence[int], lanes: int) -> list[int]:
    """The first rows that have so many lanes together."""
    found = list[int]()
    for j in ready:
        width = len(rows.lanes(j))
        if width <= lanes:
            found.append(j)
            lanes -= width
    return found


def _beside(rows: Rows, j: int, places: Mapping[int, int]) -> int | None:
    """The lane of the link that a row's first joint hangs on."""
    link = rows.near_links(j)[0]
    near = rows.name_of(link) - 1
    if near not in places:
        return None
    row = rows.row_at(link)
    return places[near] + (0 if row is None else row.lanes.index(link - 1))


@dataclass(frozen=True)
class Pass:
    """What a record hands on to one that is swept later, each lane's numbers to one lane at most.

    Attributes:
        near: where the other one's numbers begin.
        sources: by lanes of the other one, the lane whose numbers it takes; None for nothing.
    """

    near: int
    sources: tuple[int | None, ...]

    @property
    def straight(self) -> bool:
        """Whether all numbers stay in their lanes."""
        return all(lane in (None, k) for k, lane in enumerate(self.sources))


def passes(handed: Sequence[tuple[int, int]], lanes: int) -> tuple[Pass, ...]:
    """Return how lanes are handed on, in as few passes as can be.

    Args:
        handed: lanes, and the places in memory that they go to.
        lanes: of a record.
    """
    found = list[Pass]()
    for near in dict.fromkeys(place - place % lanes for _, place in handed):
        left = [(place - near, lane) for lane, place in handed if 0 <= place - near < lanes]
        if len(dict(left)) < len(left):  # several passes: those that stay first
            left.sort(key=lambda pair: pair[0] != pair[1])
        while left:
            own = dict(reversed(left))
            if len(own) < len(left) and any(to == lane for to, lane in left):
                own = {to: lane for to, lane in own.items() if to == lane}
            found.append(Pass(near, tuple(own.get(to) for to in range(lanes))))
            left = [(to, lane) for to, lane in left if own.get(to) != lane]
    return tuple(found)
