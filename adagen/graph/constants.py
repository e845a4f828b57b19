"""Constants of a graph: rational numbers, single or one for each lane."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import fmpq

LONGEST = 2048
"""Bits of a numerator or denominator before a number is rounded."""
KEPT = 256
"""Bits that a number is rounded to."""


def rational(value: Any) -> Any:
    """Return a float or int as a rational number."""
    if isinstance(value, fmpq):
        return value
    return fmpq(*value.as_integer_ratio()) if isinstance(value, float) else fmpq(value)


def lanewise(operation: Callable[[Any, Any], Any], x: Any, y: Any) -> Any:
    """Return an operation's result on constants: a single number stands for all lanes."""
    if not isinstance(x, tuple) and not isinstance(y, tuple):
        return operation(x, y)
    width = max(len(c) for c in (x, y) if isinstance(c, tuple))
    xs, ys = (c if isinstance(c, tuple) else (c,) * width for c in (x, y))
    return tuple(operation(a, b) for a, b in zip(xs, ys, strict=True))


def is_negative(lanes: tuple[Any, ...]) -> bool:
    """Return whether a constant is written as another's negative: its first number but 0 is."""
    return bool(next((x for x in lanes if x != 0), 0) < 0)


def shortened(value: Any, p: int, q: int) -> Any:
    """Return a rational number, rounded to 256 bits if it is excessively long.

    That is far more than any scalar keeps.

    Args:
        value: p / q in lowest terms.
        p: its numerator.
        q: its denominator.
    """
    longest = max(p.bit_length(), q.bit_length())
    if longest <= LONGEST:
        return value
    shift = KEPT - p.bit_length() + q.bit_length()
    scaled = (p << shift) // q if shift >= 0 else p // (q << -shift)
    return fmpq(scaled) / fmpq(2) ** shift
