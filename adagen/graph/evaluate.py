"""Evaluates expressions: in double or float as a processor does, or in ball arithmetic.

Each operation of a graph is one operation of the arithmetic, and constants are rounded once, so
that values are those of emitted code to the last bit where that is compiled without contraction.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from flint import arb

from adagen.graph.expressions import Expression, Graph
from adagen.graph.nodes import Node
from adagen.graph.rounded_once import multiply_add

_TWO_OVER_PI = 0.63661977236758134308


@dataclass(frozen=True)
class Trigonometry:
    """Constants of sines and cosines (templates/include/adagen/trigonometry.hpp).

    Attributes:
        largest: angle beyond which three parts of pi/2 would lose digits.
        shift: number that rounds to a whole number when it is added.
        parts: of pi/2.
        sine: coefficients of its polynomial.
        cosine: likewise.
    """

    largest: float
    shift: float
    parts: tuple[float, ...]
    sine: tuple[float, ...]
    cosine: tuple[float, ...]


TRIGONOMETRY: dict[type[np.floating[Any]], Trigonometry] = {
    np.float64: Trigonometry(
        1e5,
        6755399441055744.0,
        (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624871116645580e-21),
        (
            *(1.58962301576546568060e-10, -2.50507477628578072866e-8, 2.75573136213857245213e-6),
            *(-1.98412698295895385996e-4, 8.33333333332211858878e-3, -1.66666666666666307295e-1),
        ),
        (
            *(-1.13585365213876817300e-11, 2.08757008419747316778e-9, -2.75573141792967388112e-7),
            *(2.48015872888517045348e-5, -1.38888888888730564116e-3, 4.16666666666665929218e-2),
        ),
    ),
    np.float32: Trigonometry(
        8000.0,
        12582912.0,
        (1.5703125, 4.837512969970703125e-4, 7.54978995489188216e-8),
        (-1.9515295891e-4, 8.3321608736e-3, -1.6666654611e-1),
        (2.443315711809948e-5, -1.388731625493765e-3, 4.166664568298827e-2),
    ),
}
"""By number type."""


class Algebra(Protocol):
    """Numbers with +, -, *, / and the other operations of graphs."""

    def number(self, value: Any) -> Any:
        """Return a rational number (fmpq) as one of the algebra."""

    def given(self, value: Any) -> Any:
        """Return an input as one of the algebra."""

    def together(self, values: Sequence[Any]) -> Any:
        """Return values as one array, with the index of the value first."""

    def sines_and_cosines(self, angles: Sequence[Any]) -> list[tuple[Any, Any]]:
        """Return sine and cosine of all angles that a process has."""

    def sqrt(self, a: Any) -> Any:
        """Return the square root."""

    def sign(self, a: Any) -> Any:
        """Return 1 or -1."""

    def tanh(self, a: Any) -> Any:
        """Return the hyperbolic tangent."""

    def larger(self, a: Any, b: Any) -> Any:
        """Return the larger number."""

    def multiply_add(self, a: Any, b: Any, c: Any) -> Any:
        """Return a b + c, rounded once."""


class Floating:
    """Numbers of a processor, or numpy arrays of them for many states at once.

    Args:
        scalar: np.float64 or np.float32.
    """

    def __init__(self, scalar: type[np.floating[Any]] = np.float64) -> None:
        self.scalar = scalar

    def number(self, value: Any) -> Any:
        """Return a rational number, rounded as a literal of emitted code is."""
        p, q = int(value.p), int(value.q)
        try:
            return self.scalar(p / q)
        except OverflowError:
            return self.scalar(math.copysign(math.inf, p))

    def given(self, value: Any) -> Any:
        """Return an input, rounded."""
        return np.asarray(value).astype(self.scalar)[()]

    def together(self, values: Sequence[Any]) -> Any:
        """Return values as one array."""
        return np.array(np.broadcast_arrays(*values))

    def sines_and_cosines(self, angles: Sequence[Any]) -> list[tuple[Any, Any]]:
        """Return what templates/include/adagen/kernels/lanes.hpp computes.

        Angles far from zero are left to the C library.
        """
        stacked = self.given(np.array(np.broadcast_arrays(*angles)))
        return list(zip(*map(self.given, self._sine_and_cosine(stacked)), strict=True))

    def _sine_and_cosine(self, angle: Any) -> tuple[Any, Any]:
        """Sine and cosine, operation by operation those of the runtime; shape of the angle."""
        number, table = self.scalar, TRIGONOMETRY[self.scalar]
        shift = number(table.shift)
        turns = (angle * number(_TWO_OVER_PI) + shift) - shift
        rest = angle
        for part in table.parts:
            rest = rest - turns * number(part)
        square = rest * rest
        s = rest + rest * square * self._polynomial(table.sine, square)
        c = number(1) - square / number(2)
        c = c + square * square * self._polynomial(table.cosine, square)
        quadrant = np.mod(turns, number(4))
        swapped = np.mod(quadrant, number(2)) == 1
        sine, cosine = np.where(swapped, c, s), np.where(swapped, s, c)
        sine = np.where(quadrant >= 2, -sine, sine)
        cosine = np.where((quadrant == 1) | (quadrant == 2), -cosine, cosine)
        far = np.abs(angle) > table.largest
        if np.any(far):
            given = np.asarray(angle, dtype=np.float64)
            sine, cosine = (
                np.where(far, np.vectorize(f, otypes=[np.float64])(given), near)
                for f, near in ((math.sin, sine), (math.cos, cosine))
            )
        return sine, cosine

    def _polynomial(self, coefficients: Sequence[float], x: Any) -> Any:
        result = self.scalar(coefficients[0])
        for coefficient in coefficients[1:]:
            result = result * x + self.scalar(coefficient)
        return result

    def sqrt(self, a: Any) -> Any:
        """Return the square root."""
        return np.sqrt(a)

    def sign(self, a: Any) -> Any:
        """Return 1 or -1."""
        return np.copysign(self.scalar(1), a)

    def tanh(self, a: Any) -> Any:
        """Return what templates/include/adagen/tangents.hpp computes: that of a double, rounded."""
        x = np.asarray(a, dtype=np.float64)
        size = np.minimum(np.abs(x), _LARGE)  # NaN stays
        z = size * size
        above = (-9.64399179425052238628e-1 * z - 9.92877231001918586564e1) * z
        below = ((z + 1.12811678491632931402e2) * z + 2.23548839060100448583e3) * z
        quotient = (above - 1.61468768441708447952e3) / (below + 4.84406305325125486048e3)
        n = np.floor(2 * size * 1.4426950408889634073599 + 0.5)
        power = np.ldexp(_rest_of_power(size, n), np.nan_to_num(n).astype(int))
        large = np.where(size < _LARGE, 1 - 2 / (power + 1), 1.0)
        found = np.where(size < 0.625, size + size * z * quotient, large)
        return self.given(np.where(np.isnan(x), x, np.copysign(found, x)))

    def larger(self, a: Any, b: Any) -> Any:
        """Return the larger number."""
        return np.where(a > b, a, b)[()]

    def multiply_add(self, a: Any, b: Any, c: Any) -> Any:
        """Return a b + c, rounded once."""
        return self._rounded_once(a, b, c)

    @cached_property
    def _rounded_once(self) -> Callable[[Any, Any, Any], Any]:
        return multiply_add(self.scalar)


_LARGE = 20.0  # whose tangent is 1


def _rest_of_power(size: Any, n: Any) -> Any:
    """exp(2 size), less n log 2 in the exponent (Cephes)."""
    r = (2 * size - n * 6.93145751953125e-1) - n * 1.42860682030941723212e-6
    z = r * r
    odd = r * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z + 1)
    even = (3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z
    even = (even + 2.27265548208155028766e-1) * z + 2
    return 1 + 2 * (odd / (even - odd))


class Balls:
    """Balls around midpoints of any length (python-flint's arb, at the context's precision)."""

    @staticmethod
    def number(value: Any) -> Any:
        """Return a ball around a rational number."""
        return arb(value)

    @staticmethod
    def given(value: Any) -> Any:
        """Return an input, which is a double."""
        return arb(float(value))

    @staticmethod
    def together(values: Sequence[Any]) -> Any:
        """Return values as one array."""
        return np.array(values, dtype=object)

    @staticmethod
    def sines_and_cosines(angles: Sequence[Any]) -> list[tuple[Any, Any]]:
        """Return sine and cosine of each angle."""
        return [(angle.sin(), angle.cos()) for angle in angles]

    @staticmethod
    def sqrt(a: Any) -> Any:
        """Return the square root."""
        return a.sqrt()

    @staticmethod
    def sign(a: Any) -> Any:
        """Return 1 or -1; either if the ball contains zero."""
        return arb(-1 if a < 0 else 1)

    @staticmethod
    def tanh(a: Any) -> Any:
        """Return the hyperbolic tangent."""
        return a.tanh()

    @staticmethod
    def larger(a: Any, b: Any) -> Any:
        """Return the larger number."""
        return a.max(b)

    @staticmethod
    def multiply_add(a: Any, b: Any, c: Any) -> Any:
        """Return a ball around a b + c."""
        return a * b + c


DOUBLE, FLOAT, BALLS = Floating(np.float64), Floating(np.float32), Balls()


class Evaluation:
    """The values of a graph's expressions, each computed when it is first needed.

    Args:
        graph: the graph.
        lookup: returns an input by its name; it may ask other evaluations.
        algebra: what is computed with.
    """

    def __init__(
        self, graph: Graph, lookup: Callable[[str], Any], algebra: Algebra = DOUBLE
    ) -> None:
        self.graph, self.lookup, self.algebra = graph, lookup, algebra
        self.values: dict[int, Any] = {}

    def of(self, expressions: Iterable[Expression]) -> list[Any]:
        """Return the values of some expressions, of wide ones tuples."""
        indices = [x.index for x in expressions]
        with np.errstate(all="ignore"):  # who asks looks at what comes out
            for index in self._missing(indices):
                self.values[index] = self._value(index)
        return [self.values[k] for k in indices]

    def _missing(self, indices: Iterable[int]) -> list[int]:
        """The values to compute for some expressions, operands first."""
        nodes, found = self.graph.nodes, set[int]()
        waiting = [k for k in indices if k not in self.values]
        while waiting:
            index = waiting.pop()
            if index not in found:
                found.add(index)
                waiting += [k for k in nodes[index].args if k not in self.values]
        return sorted(found)

    def _value(self, index: int) -> Any:
        node, values = self.graph.nodes[index], self.values
        if node.width > 1:
            return self._wide(node)
        match node.op:
            case "mul":
                return values[node.args[0]] * values[node.args[1]]
            case "add":
                return values[node.args[0]] + values[node.args[1]]
            case "sub":
                return values[node.args[0]] - values[node.args[1]]
            case "neg":
                return -values[node.args[0]]
            case "constant":
                return self.algebra.number(node.value)
            case "input":
                return self.lookup(node.value)
            case "lane":
                return values[node.args[0]][node.value]
            case "across":
                return _across(values[node.args[0]], node.value)
        return self._function(node, [values[k] for k in node.args])

    def _wide(self, node: Node) -> tuple[Any, ...]:
        """The values of all lanes."""
        args = [self.values[k] for k in node.args]
        match node.op:
            case "constant":
                return tuple(map(self.algebra.number, node.value))
            case "input":
                array, first = str(node.value).removesuffix("]").split("[")
                return tuple(self.lookup(f"{array}[{int(first) + k}]") for k in range(node.width))
            case "pack":
                return tuple(args)
        lanes = zip(*(in_lanes(x, node.width) for x in args), strict=True)
        if node.op in _ARITHMETIC:
            return tuple(_ARITHMETIC[node.op](*own) for own in lanes)
        return tuple(self._function(node, list(own)) for own in lanes)

    def _function(self, node: Node, args: list[Any]) -> Any:
        algebra = self.algebra
        match node.op:
            case "multiply_add":
                (a, b, c), (product, addend) = args, node.value
                return algebra.multiply_add(a if product > 0 else -a, b, c if addend > 0 else -c)
            case "reciprocal":
                return 1 / args[0]
            case "sqrt":
                return algebra.sqrt(args[0])
            case "sign":
                return algebra.sign(args[0])
            case "max":
                return algebra.larger(*args)
        raise AssertionError(f"no meaning for {node.op}")


def in_lanes(value: Any, width: int) -> tuple[Any, ...]:
    """Return the values of all lanes: a single number is in each."""
    return value if isinstance(value, tuple) else (value,) * width


_ARITHMETIC: dict[str, Callable[..., Any]] = {
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "neg": lambda x: -x,
    "reciprocal": lambda x: 1 / x,
}


def _across(lanes: tuple[Any, ...], count: int) -> Any:
    """The sum of the first numbers, half by half as the runtime adds them."""
    if len(lanes) == 1:
        return lanes[0]
    half = len(lanes) // 2
    first, second = lanes[:half], lanes[half:]
    if count == len(lanes):
        return _across(tuple(x + y for x, y in zip(first, second, strict=True)), half)
    if count > half:
        return _across(first, half) + _across(second, count - half)
    return _across(first, count)
