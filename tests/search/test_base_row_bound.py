"""First rows of a process, against all orders in which small limbs can be passed."""

from __future__ import annotations

from functools import cache
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from adagen.search.base_row_bound import FirstRows, Levels, together

prices = st.lists(st.integers(0, 12), min_size=1, max_size=4).map(
    lambda own: [sum(own[k:]) / 8 for k in range(1, len(own))] + [0.0]
)
"""What a joint takes above its share of a full row, in a row of 1, 2, ... joints."""

limbs_of = st.lists(
    st.lists(st.integers(-1, 3), min_size=1, max_size=4).map(
        lambda parents: tuple(min(parent, k - 1) for k, parent in enumerate(parents))
    ),
    min_size=1,
    max_size=2,
)
"""Limbs: for each joint the one before it, -1 at the base."""


def levels(parents: tuple[int, ...]) -> Levels:
    depth: list[int] = []
    for parent in parents:
        depth.append(1 + (depth[parent] if parent >= 0 else 0))
    counts = np.bincount(depth, minlength=10)
    return Levels(np.cumsum(counts)[1:], max(depth), 0)


def fastest(limbs: list[tuple[int, ...]], fillings: int, above: list[float]) -> float:
    """The least of all sequences of rows; what fills may be in any row and costs nothing."""
    parents: list[int] = []
    for limb in limbs:
        parents += [parent + len(parents) if parent >= 0 else -1 for parent in limb]

    @cache
    def rest(done: frozenset[int], left: int) -> float:
        if len(done) == len(parents):
            return 0.0
        free = [k for k, p in enumerate(parents) if k not in done and (p < 0 or p in done)]
        return min(
            count * above[count + filling - 1] + rest(done.union(row), left - filling)
            for count in range(1, min(len(free), len(above)) + 1)
            for filling in range(min(left, len(above) - count) + 1)
            for row in combinations(free, count)
        )

    return rest(frozenset(), fillings)


@given(limbs_of, st.integers(0, 3), prices)
def test_no_order_takes_less(
    limbs: list[tuple[int, ...]], fillings: int, above: list[float]
) -> None:
    found = FirstRows(above).least(together([levels(limb) for limb in limbs]), fillings)
    assert 0.0 <= found <= fastest(limbs, fillings, above) + 1e-9


def test_a_chain_has_a_row_for_each_joint() -> None:
    """Four fingers of two joints on an arm of three: the arm's rows hold one joint each."""
    above = [3.0, 1.0, 0.5, 0.0]
    hand = levels((-1, 0, 1, 2, 3, 2, 5, 2, 7, 2, 9))
    assert FirstRows(above).least(hand, 0) == pytest.approx(9.0)
    assert FirstRows(above).least(hand, 3) == pytest.approx(9.0 - 3 * 2.0)
    assert FirstRows(above).least(hand, 9) == pytest.approx(0.0)
    assert FirstRows(above).least(together([hand, hand]), 0) == pytest.approx(6.0)
    assert fastest([(-1, 0, 1, 2, 2, 2, 2)], 0, above) == pytest.approx(9.0)


def test_several_processes_have_first_rows_each() -> None:
    above = [3.0, 1.0, 0.5, 0.0]
    rows, own = np.array([3, 6]), np.array([6, 6])
    assert FirstRows(above).of(rows, own, 0) == pytest.approx([6.0, 18.0])


def test_a_joint_of_a_core_takes_a_row_of_each_process_that_passes_it() -> None:
    """Six rows of three joints: one by one and passed again, or as parts of a full row."""
    above, rows, own = [3.0, 1.0, 0.5, 0.0], np.array([6]), np.array([3])
    assert FirstRows(above, again=4.0).of(rows, own, 0) == pytest.approx([3 * 3.0 + 3 * 4.0])
    assert FirstRows(above, again=2.0).of(rows, own, 0) == pytest.approx([(6 - 3 / 4) * 2.0])
