"""Which joints a loop sweeps together, and in which lanes.

A row of joints shares a record with other rows that are as far from the ground, because neither
waits for the other. It has the lanes of the row that it hangs on where it can: what a record hands
on is then added to the next one as a whole.
"""

from __future__ import annotations

from collections.abc import Sequence

from adagen.executor.rows import Rows

Record = list[tuple[int, int]]
"""Rows of joints by their names, each with its first lane."""
_WIDEST = 4
"""Lanes that records have at most where no row has more: with eight, they take 1.6 times as long on
an Intel Xeon (docs/records/certificates.md)."""


def levels(rows: Rows, inwards: Sequence[int], count: int) -> list[list[int]]:
    """Return the outermost rows, as many as are asked for, by their distance from the ground.

    Args:
        rows: of a process.
        inwards: the joints that rows are named by, each behind those beyond it.
        count: how many; where there are fewer, all.

    Returns:
        Levels of rows, the outermost one first.
    """
    depths = dict[int, int]()
    for j in reversed(inwards):
        near = [rows.name_of(link) - 1 for link in rows.near_links(j) if link]
        depths[j] = 1 + max((depths.get(each, 0) for each in near), default=0)
    found = dict[int, list[int]]()
    for j in sorted(inwards, key=lambda j: -depths[j])[:count]:
        found.setdefault(depths[j], []).append(j)
    return list(found.values())


def records(rows: Rows, by_level: Sequence[Sequence[int]]) -> tuple[int, list[Record]]:
    """Return how many lanes records have, and the records inwards.

    Args:
        rows: of a process.
        by_level: see ``levels``.
    """
    own = [j for level in by_level for j in level]
    within = [rows.name_of(link) - 1 for j in own for link in rows.near_links(j) if link]
    least = max(2, *(len(rows.lanes(j)) for j in (*own, *within)))
    offers = [(lanes, _placed(rows, by_level, lanes)) for lanes in (least, max(least, _WIDEST))]
    return min(offers, key=lambda offer: len(offer[1]))


def _placed(rows: Rows, by_level: Sequence[Sequence[int]], lanes: int) -> list[Record]:
    """Records with so many lanes."""
    places = dict[int, tuple[int, int]]()  # by row: number of its record in its level, first lane
    found = list[list[Record]]()
    for level in reversed(by_level):
        own, taken = list[Record](), list[set[int]]()
        later = list[int]()
        for j in level:
            place = _beyond(rows, j, places)
            if place is None or not _free(taken, place, len(rows.lanes(j))):
                later.append(j)
            else:
                _put(j, place, len(rows.lanes(j)), own, taken)
                places[j] = place
        for j in sorted(later, key=lambda j: -len(rows.lanes(j))):
            width = len(rows.lanes(j))
            numbers, firsts = range(len(own) + 1), range(0, lanes, width)
            place = next((k, n) for k in numbers for n in firsts if _free(taken, (k, n), width))
            _put(j, place, width, own, taken)
            places[j] = place
        found.append([record for record in own if record])
    return [record for level in reversed(found) for record in level]


def _beyond(rows: Rows, j: int, places: dict[int, tuple[int, int]]) -> tuple[int, int] | None:
    """The place of the row that a row hangs on lane by lane."""
    links = rows.near_links(j)
    if not any(links) or not rows.as_kept(links):
        return None
    return places.get(rows.name_of(links[0]) - 1)


def _free(taken: Sequence[set[int]], place: tuple[int, int], width: int) -> bool:
    number, first = place
    return number >= len(taken) or taken[number].isdisjoint(range(first, first + width))


def _put(
    j: int, place: tuple[int, int], width: int, own: list[Record], taken: list[set[int]]
) -> None:
    number, first = place
    while len(own) <= number:
        own.append([])
        taken.append(set())
    own[number].append((j, first))
    taken[number].update(range(first, first + width))
