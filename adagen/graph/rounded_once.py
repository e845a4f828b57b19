"""Rational numbers and products with sums, rounded once: to the nearest double or float.

A graph whose constants are rounded operation by operation, as a processor rounds them.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
from flint import fmpq

from adagen.graph.expressions import Expression, Graph

Scalar = type[np.floating[Any]]


def nearest(p: int, q: int, scalar: Scalar) -> float:
    """Return the number of a scalar that is nearest to p / q, as a float; ties go to even.

    Args:
        p: numerator.
        q: denominator, positive.
        scalar: np.float64 or np.float32.

    Raises:
        OverflowError: there is none, it is too large for a double.
    """
    near = p / q
    if scalar is np.float64:
        return near
    # Rounded to double first, what lies next to the middle of two floats may become the middle. Of
    # the two doubles around p / q the one with an odd last digit is none.
    a, b = near.as_integer_ratio()
    above, below = a * q > p * b, a * q < p * b
    if (above or below) and not _is_odd(near):
        near = math.nextafter(near, -math.inf if above else math.inf)
    with np.errstate(over="ignore"):
        return float(scalar(near))


def _is_odd(x: float) -> bool:
    """Whether the last binary digit of a double is 1."""
    return bool(np.float64(x).view(np.uint64) & np.uint64(1))


def multiply_add(scalar: Scalar) -> Callable[[Any, Any, Any], Any]:
    """Return a function for a b + c, rounded once; of numbers or arrays of them.

    It is the C library's, which uses the processor's instruction if there is one. Where there is no
    such library, or it rounds twice, numbers are rational.
    """
    one_by_one = np.frompyfunc(_library(scalar) or _exact(scalar), 3, 1)

    def computed(a: Any, b: Any, c: Any) -> Any:
        return np.asarray(one_by_one(a, b, c)).astype(scalar)[()]

    return computed


def _library(scalar: Scalar) -> Callable[..., float] | None:
    """The C library's function, as far as it is right."""
    name, number = ("fma", ctypes.c_double) if scalar is np.float64 else ("fmaf", ctypes.c_float)
    try:
        found = getattr(ctypes.CDLL(None), name)
    except (AttributeError, OSError, TypeError):
        return None
    found.argtypes, found.restype = [number] * 3, number

    def computed(a: Any, b: Any, c: Any) -> float:
        return float(found(float(a), float(b), float(c)))

    step = float(np.finfo(scalar).eps)  # as solvers test it (reproducible.hpp)
    right = computed((1 + step) * step / 2, 1 - step, 1 + step) == 1 + step
    return computed if right else None


def _exact(scalar: Scalar) -> Callable[..., float]:
    """Rational arithmetic, rounded once."""

    def computed(*given: Any) -> float:
        a, b, c = (float(x) for x in given)
        if not (math.isfinite(a) and math.isfinite(b)):
            return a * b + c
        if not math.isfinite(c):
            return c
        exact = Fraction(a) * Fraction(b) + Fraction(c)
        if exact == 0:
            return a * b + c  # with the sign that a processor gives it
        try:
            return nearest(exact.numerator, exact.denominator, scalar)
        except OverflowError:
            return math.inf if exact > 0 else -math.inf

    return computed


class RoundedGraph(Graph):
    """A graph with the same values to the last bit, whichever of them are constants.

    Each constant is a number of the scalar, so that what is folded is rounded operation by
    operation, as it is where the same operation is done at run time.

    Args:
        scalar: "double" or "float".
    """

    def __init__(self, scalar: str) -> None:
        super().__init__()
        self.number: Scalar = np.float32 if scalar == "float" else np.float64

    def _constant(self, lanes: tuple[Any, ...]) -> Expression:
        return super()._constant(tuple(self._rounded(x) for x in lanes))

    def _rounded(self, value: Any) -> Any:
        """A rational number as one of the scalar; as it is where that has no such number."""
        try:
            rounded = nearest(int(value.p), int(value.q), self.number)
        except OverflowError:
            return value
        return fmpq(*rounded.as_integer_ratio()) if math.isfinite(rounded) else value
