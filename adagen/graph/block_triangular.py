"""Block-triangular systems, solved block by block; small blocks by their determinants.

Rows and columns are ordered so that each block has entries in its own columns and in those of
earlier blocks (block triangular form: Duff, Erisman, Reid, Direct Methods for Sparse Matrices,
2nd ed., chapter 6).
Cramer's rule takes no square roots and fewer products than reflections up to three unknowns. It
loses no more than the condition of such a system costs anyway (Higham, Accuracy and Stability of
Numerical Algorithms, 2nd ed., 1.10.1: forward stable for two; for three its error is that of the
entries of the adjugate, which are 2x2 determinants, beside those of the whole).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.graph.expressions import Expression
from adagen.graph.linear import cross, dot, solved_by_reflections, total

Array = NDArray[Any]
MOST = 3
"""Unknowns of a part up to which it is solved by determinants."""


@dataclass(frozen=True)
class Regular:
    """A test that a block is regular: the square of one size has to be well above another's.

    Attributes:
        row: a row of the part.
        square: of a row, of a pivot, or of the determinant; rows are brought to one size.
        beside: what it is beside: 1, or the squares of all rows, multiplied.
    """

    row: int
    square: Expression
    beside: Expression | float


def solved_by_blocks(matrix: Array, right: Array, scales: Array) -> tuple[Array, list[Regular]]:
    """Return M^-1 x, shape (n, k), and the tests that it has digits.

    Args:
        matrix: M, shape (n, n); its structure is not singular.
        right: x, shape (n, k).
        scales: powers of two that bring the rows to one size, shape (n,).
    """
    result, found = right.copy(), []
    solved: list[int] = []
    for rows, columns in _parts(matrix):
        part, own = matrix[np.ix_(rows, columns)], right[rows]
        for i, row in enumerate(rows):
            before = [c for c in solved if matrix[row, c].constant != 0]
            for k in range(right.shape[1]) if before else ():
                own[i, k] = total([own[i, k], *(-(matrix[row, c] * result[c, k]) for c in before)])
        if len(rows) <= MOST:
            result[columns] = _by_determinant(part, own)
            found += _regular(part, rows, scales[rows])
        else:
            scale = scales[rows][:, None]
            result[columns], diagonal = solved_by_reflections(part * scale, own * scale)
            pairs = zip(rows, diagonal, strict=True)
            found += [Regular(row, pivot * pivot, 1.0) for row, pivot in pairs]
        solved += columns
    return result, sorted(found, key=lambda each: each.row)


def _parts(matrix: Array) -> list[tuple[list[int], list[int]]]:
    """Rows and columns of each block, after those that it needs; one block if singular.

    Rows need each other where they have entries in each other's columns, once each has a column of
    its own; those that need each other both ways are one part.
    """
    entries = [{c for c, x in enumerate(row) if x.constant != 0} for row in matrix]
    own = _matched(entries)
    if len(own) < len(matrix):
        every = list(range(len(matrix)))
        return [(every, every)]
    row_of = {column: row for row, column in own.items()}
    reached = [_reached(row, entries, row_of) for row in range(len(matrix))]
    parts = {
        tuple(r for r in sorted(all_of) if row in reached[r]) for row, all_of in enumerate(reached)
    }
    ordered = sorted(parts, key=lambda rows: (len(reached[rows[0]]), rows))
    return [(list(rows), sorted(own[row] for row in rows)) for rows in ordered]


def _matched(entries: Sequence[set[int]]) -> dict[int, int]:
    """Return a column for each row, no two the same; fewer where there are not enough."""
    row_of: dict[int, int] = {}

    def give(row: int, tried: set[int]) -> bool:
        for column in sorted(entries[row] - tried):
            tried.add(column)
            if column not in row_of or give(row_of[column], tried):
                row_of[column] = row
                return True
        return False

    for row in range(len(entries)):
        give(row, set())
    return {row: column for column, row in row_of.items()}


def _reached(row: int, entries: Sequence[set[int]], row_of: Mapping[int, int]) -> set[int]:
    """Return the rows that a row depends on, itself among them."""
    found, left = {row}, [row]
    while left:
        more = {row_of[column] for column in entries[left.pop()]} - found
        found |= more
        left += more
    return found


def _by_determinant(part: Array, right: Array) -> Array:
    """Return the solution by the adjugate; the reciprocal is multiplied where that is cheapest."""
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
    """Test that no row is nearly zero, nor the determinant beside all rows (Hadamard)."""
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
