"""Which variants of a test the quick suite runs; the others are slow tests."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def spread(values: Iterable[Any], quick: int) -> list[Any]:
    """Return the values of parameters: so many of them, evenly spread, are quick.

    Tuples are rows of several parameters, as in ``pytest.mark.parametrize``.
    """
    every = list(values)
    kept = {k * len(every) // quick for k in range(quick)}
    return [value if k in kept else _marked(value) for k, value in enumerate(every)]


def all_but(values: Iterable[Any], *slowly: Any) -> list[Any]:
    """Return the values of a parameter: these are slow ones, and must be among them."""
    every = list(values)
    assert set(slowly) <= set(every)
    return [slow(value) if value in slowly else value for value in every]


def only(values: Iterable[Any], *quickly: Any) -> list[Any]:
    """Return the values of a parameter: all but these, which must be among them, are slow ones."""
    every = list(values)
    assert set(quickly) <= set(every)
    return [value if value in quickly else slow(value) for value in every]


def every_other(values: Iterable[Any]) -> list[Any]:
    """Return rows of a value and a truth: all by turns false and true; the other ones are slow."""
    every = list(enumerate(values))
    quick = [(value, k % 2 == 1) for k, value in every]
    return [*quick, *(slow(value, k % 2 == 0) for k, value in every)]


def slow(*values: Any) -> Any:
    """Return values of parameters that only slow tests take."""
    return pytest.param(*values, marks=pytest.mark.slow)


def _marked(value: Any) -> Any:
    if isinstance(value, type(pytest.param())):
        return value._replace(marks=(*value.marks, pytest.mark.slow))
    return slow(*value) if isinstance(value, tuple) else slow(value)
