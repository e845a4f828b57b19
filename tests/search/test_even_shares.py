"""Limbs distributed evenly."""

from __future__ import annotations

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from adagen.search.even_shares import evenly

WEIGHTS = st.lists(st.floats(0.01, 10.0), min_size=1, max_size=7)


@given(WEIGHTS, st.integers(1, 4))
def test_every_limb_is_handed_out_once(weights: list[float], processes: int) -> None:
    even = evenly(weights, processes)
    assert sorted(k for own in even.shares for k in own) == list(range(len(weights)))
    assert len(even.shares) <= processes
    loads = [sum(weights[k] for k in own) for own in even.shares]
    assert abs(max(loads) - even.time) < 1e-9


@given(WEIGHTS, st.integers(1, 3))
def test_the_busiest_has_at_most_a_third_more_than_it_must(
    weights: list[float], processes: int
) -> None:
    """Graham's bound for the heaviest first: 4/3 - 1/(3P) of the least."""
    least = min(
        max(
            sum(w for w, p in zip(weights, of, strict=True) if p == own) for own in range(processes)
        )
        for of in product(range(processes), repeat=len(weights))
    )
    assert evenly(weights, processes).time <= (4 / 3) * least + 1e-9


def test_what_differs_by_rounding_only_is_left() -> None:
    """Sums of the same numbers in another order are as good: nothing is exchanged for ever."""
    weights = [0.1, 0.2, 0.3, 0.1, 0.2, 0.3, 0.7, 0.7, 1e-17, 1e-16]
    assert evenly(weights, 3).time == pytest.approx(0.9, abs=0.11)
