"""Vectors and small matrices of expressions: numpy arrays of dtype object.

Terms of a sum are added in the order in which they are ready, so that the last one waits for one
addition only.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.graph.expressions import Expression
from adagen.graph.numbers import Number, summed

Array = NDArray[Any]


def total(terms: Iterable[Expression]) -> Expression:
    """Return the sum of at least one term, which may be numbers instead (numbers.py)."""
    found: list[Any] = list(terms)
    if type(found[0]) is Number:
        return summed(found)  # type: ignore[return-value]  # all are there at once
    if len(found) > 1 and type(found[0]) is Expression:
        nodes = found[0].graph.nodes
        found.sort(key=lambda term: nodes[term.index].ready)
    first: Expression = found[0]
    for term in found[1:]:
        first = first + term
    return first


def dot(u: Sequence[Expression] | Array, v: Sequence[Expression] | Array) -> Expression:
    """Return the inner product of two vectors of one length, which is not 0."""
    return total([a * b for a, b in zip(u, v, strict=True)])


def cross(u: Array, v: Array) -> Array:
    """Return u x v; both have shape (3,)."""
    return np.array(
        [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ],
        dtype=object,
    )


def matrix_times(matrix: Array, other: Array) -> Array:
    """Return a product, shapes (n, m) and (m,) or (m, k)."""
    if other.ndim == 1:
        return np.array([dot(row, other) for row in matrix], dtype=object)
    columns = [[dot(row, column) for row in matrix] for column in other.T]
    return np.array(columns, dtype=object).reshape(other.shape[1], len(matrix)).T


@dataclass(frozen=True)
class Factors:
    """M = L D L^T of a symmetric positive definite matrix, shape (n, n).

    Attributes:
        lower: L, whose diagonal (ones) is not looked at.
        inverses: of the entries of D.
        pivots: the entries of D, which have to be positive.
        diagonal: of M: a pivot far below it has lost its digits.
    """

    lower: Array
    inverses: tuple[Expression, ...]
    pivots: tuple[Expression, ...]
    diagonal: tuple[Expression, ...]

    def forward(self, x: Array) -> Array:
        """Return L^-1 x, shape (n, k)."""
        x = x.copy()
        for i in range(len(x)):
            for c in range(x.shape[1]):
                x[i, c] = total([x[i, c], *(-(self.lower[i, j] * x[j, c]) for j in range(i))])
        return x

    def scaled(self, x: Array) -> Array:
        """Return D^-1 x, shape (n, k)."""
        x = x.copy()
        for i, inverse in enumerate(self.inverses):
            for c in range(x.shape[1]):
                x[i, c] = x[i, c] * inverse
        return x

    def backward(self, x: Array) -> Array:
        """Return L^-T x, shape (n, k)."""
        x = x.copy()
        n = len(x)
        for i in reversed(range(n)):
            for c in range(x.shape[1]):
                terms = [-(self.lower[j, i] * x[j, c]) for j in range(i + 1, n)]
                x[i, c] = total([x[i, c], *terms])
        return x

    def solve(self, x: Array) -> Array:
        """Return M^-1 x, shape (n, k)."""
        return self.backward(self.scaled(self.forward(x)))


def factorize(matrix: Array) -> Factors:
    """Return the factors of a symmetric matrix, of which the lower triangle is used."""
    n = len(matrix)
    scaled, lower = matrix.copy(), matrix.copy()  # scaled: L D
    inverses: list[Expression] = []
    pivots: list[Expression] = []
    for j in range(n):
        for i in range(j, n):
            terms = [-(scaled[i, k] * lower[j, k]) for k in range(j)]
            scaled[i, j] = total([matrix[i, j], *terms])
        pivots.append(scaled[j, j])
        inverses.append(scaled[j, j].graph.reciprocal(scaled[j, j]))
        for i in range(j + 1, n):
            lower[i, j] = scaled[i, j] * inverses[j]
    diagonal = tuple(matrix[i, i] for i in range(n))
    return Factors(lower, tuple(inverses), tuple(pivots), diagonal)


@dataclass(frozen=True)
class Reflection:
    """Householder's reflection of some rows: x - u (factor u^T x).

    Attributes:
        rows: which.
        u: shape (len(rows),).
        factor: 2 / u^T u.
    """

    rows: tuple[int, ...]
    u: Array
    factor: Expression

    def apply(self, matrix: Array, first: int = 0) -> None:
        """Reflect columns of a matrix, from the first one on."""
        rows = list(self.rows)
        for c in range(first, matrix.shape[1]):
            part = self.factor * total(self.u * matrix[rows, c])
            matrix[rows, c] = matrix[rows, c] - self.u * part


def reflect(k: int, r: Array, b: Array) -> Reflection | None:
    """Reflect r and b so that column k of r is zero below the diagonal.

    Columns of r before k have nothing there already. Returns the reflection; None where there was
    nothing to do.
    """
    graph = r[0, 0].graph
    rows = [i for i in range(k, len(r)) if i == k or r[i, k].constant != 0]
    if len(rows) == 1:
        return None
    x = r[rows, k]
    reached = graph.sign(x[0]) * graph.sqrt(total(x * x))
    u = x.copy()
    u[0] = x[0] + reached
    reflection = Reflection(tuple(rows), u, 2 * graph.reciprocal(total(u * u)))
    reflection.apply(r, k + 1)
    reflection.apply(b)
    r[rows, k] = graph.constant(0)
    r[k, k] = -reached
    return reflection


def solve_lower(lower: Array, right: Array) -> Array:
    """Return L^-1 x of a lower triangular matrix, shape (n, k)."""
    x = right.copy()
    for i in range(len(x)):
        over = lower[i, i].graph.reciprocal(lower[i, i])
        for c in range(x.shape[1]):
            x[i, c] = total([x[i, c], *(-(lower[i, k] * x[k, c]) for k in range(i))]) * over
    return x


def solve_by_reflections(matrix: Array, right: Array) -> Array:
    """Return M^-1 x of a square matrix of any kind, shape (n, k)."""
    return solved_by_reflections(matrix, right)[0]


def solved_by_reflections(matrix: Array, right: Array) -> tuple[Array, list[Expression]]:
    """Return M^-1 x of a matrix of any kind, shape (m, k), and the diagonal of its R.

    One entry of that is next to nothing where the matrix is next to singular. Of a matrix of shape
    (n, m) with more rows than columns it is what comes closest, by least squares.
    """
    r, x, count = matrix.copy(), right.copy(), matrix.shape[1]
    for k in range(count):
        reflect(k, r, x)
    diagonal = [r[i, i] for i in range(count)]
    for i in reversed(range(count)):
        over = r[i, i].graph.reciprocal(r[i, i])
        for c in range(x.shape[1]):
            terms = [-(r[i, k] * x[k, c]) for k in range(i + 1, count)]
            x[i, c] = total([x[i, c], *terms]) * over
    return x[:count], diagonal
