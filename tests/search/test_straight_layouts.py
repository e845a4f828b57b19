"""Layouts of straight lines: which are played, and in which order."""

from __future__ import annotations

from adagen.schedule.tree import Gathered
from adagen.search.straight_layouts import _promising

LAYOUTS = [
    Gathered((0,), (0, 0, 0, 1)),  # of joints that weigh 1, 2, 3, 4: 6 and 4
    Gathered((0,), (None, 0, 1, 1)),  # 1 for both, and 2 and 7
    Gathered((0,), (0, 1, 1, 0)),  # 5 and 5
    Gathered((0,), (0, 0, 0, 1)),
    Gathered((0,), (0, 0, 1, 1)),  # 3 and 7
]


def test_layouts_come_by_their_busiest_process_and_once() -> None:
    first, second, third, last = _promising(LAYOUTS, (1.0, 2.0, 3.0, 4.0))
    assert first == LAYOUTS[2] and second == LAYOUTS[0]
    assert third == LAYOUTS[4] and last == LAYOUTS[1]


def test_of_long_straight_lines_some_layouts_are_played_and_of_short_ones_all() -> None:
    many = [Gathered((k,), (0, 0, 1, 1)) for k in range(100)]
    for weight, played in ((1.0, 100), (5_000.0, 12), (500_000.0, 8)):
        assert _promising(many, (weight,) * 4) == many[:played]
