"""Numbers in place of expressions: steps evaluated directly, for one state or for several.

A graph pays where it is printed, counted or evaluated often. With numbers a plan is evaluated in a
tenth of the time; sums are added in another order, so last digits differ. The numbers of several
states are an array, with the same bits: six states take twice the time of one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

Value = float | NDArray[np.float64]
"""Of one state, or of several, shape (S,); constants are of one."""


class Number:
    """A double, or an array of them, and whether it is a constant; calculates as ``Expression``."""

    __slots__ = ("known", "x")
    graph: ClassVar[Numbers]
    ready: ClassVar[int] = 0
    width: ClassVar[int] = 1

    def __init__(self, x: Any, known: bool = False) -> None:
        self.x, self.known = x, known

    @property
    def node(self) -> Number:
        """Itself: it is as ready as any other number."""
        return self

    @property
    def constant(self) -> float | None:
        """Its value if it is a constant, else None."""
        return self.x if self.known else None

    def __add__(self, other: Any) -> Number:
        other = other if type(other) is Number else Number(float(other), known=True)
        if self.known and self.x == 0.0:
            return other  # type: ignore[no-any-return]
        if other.known and other.x == 0.0:
            return self
        return Number(self.x + other.x, self.known and other.known)

    __radd__ = __add__

    def __neg__(self) -> Number:
        return self if self.known and self.x == 0.0 else Number(-self.x, self.known)

    def __sub__(self, other: Any) -> Number:
        other = other if type(other) is Number else Number(float(other), known=True)
        if other.known and other.x == 0.0:
            return self
        return Number(self.x - other.x, self.known and other.known)

    def __rsub__(self, other: Any) -> Number:
        return Number(float(other), known=True) - self

    def __mul__(self, other: Any) -> Number:
        other = other if type(other) is Number else Number(float(other), known=True)
        if self.known:
            if self.x == 0.0 or (other.known and other.x == 1.0):
                return self
            if self.x == 1.0:
                return other  # type: ignore[no-any-return]
        if other.known and other.x in (0.0, 1.0):
            return other if other.x == 0.0 else self
        return Number(self.x * other.x, self.known and other.known)

    __rmul__ = __mul__


def summed(terms: Sequence[Number]) -> Number:
    """Return the sum of at least one number, added from the left."""
    x, known = terms[0].x, terms[0].known
    for term in terms[1:]:
        x = x + term.x
        known = known and term.known
    return Number(x, known)


class Numbers:
    """Makes numbers where ``Graph`` makes expressions.

    Args:
        lookup: returns an input by its name.

    Attributes:
        nodes: empty; nothing is kept.
        mark: of no use here.
    """

    def __init__(self, lookup: Callable[[str], Value]) -> None:
        self.lookup = lookup
        self.nodes: list[Any] = []
        self.mark = 0
        self._inputs: dict[str, Number] = {}

    def input(self, name: str, ready: int = 0, width: int = 1) -> Number:  # noqa: ARG002
        """Return an input."""
        if name not in self._inputs:
            self._inputs[name] = Number(self.lookup(name))
        return self._inputs[name]

    @staticmethod
    def constant(value: Any) -> Number:
        """Return a constant."""
        return Number(float(value), known=True)

    @staticmethod
    def lane(a: Number, k: int) -> Number:  # noqa: ARG004
        """Return the number, which is in all lanes."""
        return a

    @staticmethod
    def reciprocal(a: Number) -> Number:
        """Return 1 / a; infinity of zero."""
        if isinstance(a.x, np.ndarray):
            return Number(np.where(a.x != 0.0, 1.0 / a.x, math.inf))
        return Number(1.0 / a.x if a.x != 0.0 else math.inf, a.known)

    @staticmethod
    def sqrt(a: Number) -> Number:
        """Return the square root; NaN where there is none."""
        if isinstance(a.x, np.ndarray):
            return Number(np.sqrt(a.x))
        return Number(math.sqrt(a.x) if a.x >= 0.0 else math.nan, a.known)

    @staticmethod
    def sign(a: Number) -> Number:
        """Return 1 or -1."""
        if isinstance(a.x, np.ndarray):
            return Number(np.copysign(1.0, a.x))
        return Number(math.copysign(1.0, a.x), a.known)

    @staticmethod
    def larger(a: Number, b: Number) -> Number:
        """Return the larger number."""
        if isinstance(a.x, np.ndarray) or isinstance(b.x, np.ndarray):
            return Number(np.where(a.x > b.x, a.x, b.x))
        return a if a.x > b.x else b


def of_each(function: Callable[[float], float], x: Value) -> Any:
    """Return what a function of the C library makes of the number of each state."""
    if isinstance(x, np.ndarray):
        return np.array([function(one) for one in x.tolist()])
    return function(x)


Number.graph = Numbers(lambda _: math.nan)
