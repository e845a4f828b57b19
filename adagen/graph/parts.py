"""Systems that fall into independent parts; small ones are solved by their determinants.

Cramer's rule takes no square roots and fewer products than reflections up to three unknowns, and
what it loses is what the condition of such a system costs anyway (Higham, Accuracy and Stability of
Numerical Algorithms, 2nd ed., 1.10.1: forward stable for two; for three its error is that of the
entries of the adjugate, which are 2x2 determinants, beside those of the whole).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.graph.linear import cross, dot, solved_by_reflections, total
from adagen.graph.nodes import Expression

Array = NDArray[Any]
MOST = 3
"""Unknowns of a part up to which it is solved by determinants."""


@dataclass(frozen=True)
class Regular:
    """What tells that a part is regular: the square of a size has to be well above that of another.

    Attributes:
        row: a row of the part.
        square: of a row, of a pivot, or of the determinant; rows are brought to one size.
        beside: what it is beside: 1, or the squares of all rows, multiplied.
    """

    row: int
    square: Expression
    beside: Expression | float


def solved_by_parts(matrix: Array, right: Array, scales: Array) -> tuple[Array, list[Regular]]:
    """Return M^-1 x, shape (n, k), and what has to be large for that to have digits.

    Args:
        matrix: M, shape (n, n); its structure is not singular.
        right: x, shape (n, k).
        scales: powers of two that bring the rows to one size, shape (n,).
    """
    result, found = right.copy(), []
    for rows, columns in _parts(matrix):
        if len(rows) <= MOST and len(rows) == len(columns):
            part = matrix[np.ix_(rows, columns)]
            result[columns] = _by_determinant(part, right[rows])
            found += _regular(part, rows, scales[rows])
        else:
            scale = scales[rows][:, None]
            part = matrix[np.ix_(rows, columns)] * scale
            result[columns], diagonal = solved_by_reflections(part, right[rows] * scale)
            pairs = zip(rows, diagonal, strict=True)
            found += [Regular(row, pivot * pivot, 1.0) for row, pivot in pairs]
    return result, sorted(found, key=lambda each: each.row)


def _parts(matrix: Array) -> list[tuple[list[int], list[int]]]:
    """Rows and columns that have entries in common, part by part."""
    parts: list[tuple[list[int], set[int]]] = []
    for k, row in enumerate(matrix):
        rows, columns = [k], {c for c, x in enumerate(row) if x.constant != 0}
        for other in [part for part in parts if part[1] & columns]:
            parts.remove(other)
            rows, columns = sorted([*rows, *other[0]]), columns | other[1]
        parts.append((rows, columns))
    return [(rows, sorted(columns)) for rows, columns in parts]


def _by_determinant(part: Array, right: Array) -> Array:
    """Return the solution by the adjugate; the reciprocal goes where it takes least."""
    adjugate, determinant = _adjugate(part)
    over = determinant.graph.reciprocal(determinant)
    if right.shape[1] > len(part):
        adjugate, over = adjugate * over, over.graph.constant(1)
    solved = [[dot(row, column) * over for column in right.T] for row in adjugate]
    return np.array(solved, dtype=object).reshape(right.shape)


def _adjugate(part: Array) -> tuple[Array, Expression]:
    """The adjugate and the determinant of a matrix of up to three rows."""
    graph = part[0, 0].graph
    if len(part) == 1:
        return np.array([[graph.constant(1)]], dtype=object), part[0, 0]
    if len(part) == 2:
        (a, b), (c, d) = part
        return np.array([[d, -b], [-c, a]], dtype=object), a * d - b * c
    a, b, c = part.T
    adjugate = np.array([cross(b, c), cross(c, a), cross(a, b)], dtype=object)
    return adjugate, dot(adjugate[0], a)


def _regular(part: Array, rows: Sequence[int], scales: Array) -> list[Regular]:
    """No row may be next to nothing, nor the determinant beside all rows (Hadamard)."""
    squares = [total([x * x for x in row if x.constant != 0]) for row in part]
    found = [
        Regular(row, square * (scale * scale), 1.0)
        for row, square, scale in zip(rows, squares, scales, strict=True)
    ]
    if len(part) > 1:
        _, determinant = _adjugate(part)
        whole = squares[0]
        for square in squares[1:]:
            whole = whole * square
        found.append(Regular(rows[0], determinant * determinant, whole))
    return found
