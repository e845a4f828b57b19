"""Changes of frame over expressions, with as few operations as their structure allows.

A rotation is a product of rotations about coordinate axes and a permutation of axes; only
quaternions and oblique axes need a dense matrix. A symmetric 2x2 block [[a, b], [b, d]] is rotated
by [[p, q], [-q, p]] with t = p (a - d) + 2 q b as [[d + p t, b - q t], [., a - p t]]: 7 operations
instead of 12. That is accurate to a unit in the last place of the block, not of its entries. Where
an entry may become the inertia that a joint has near gimbal lock, the rotation is ``exact``, and
computes p (p a + q b) + q (p b + q d) and so on.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.graph import Expression, dot, total

Array = NDArray[Any]
ANGULAR, LINEAR = slice(0, 3), slice(3, 6)


@dataclass(frozen=True)
class Turn:
    """An orthogonal matrix of a 2x2 block and a lone entry.

    Attributes:
        rows: the block's two rows, and the lone entry's.
        columns: the block's two columns, and the lone entry's.
        block: (p, q, r, s) with v[rows[0]] = p u[columns[0]] + q u[columns[1]], ...
        proper: whether the block is a rotation, [[p, q], [-q, p]], not [[p, q], [q, -p]].
        lone: the lone entry, 1 or -1.
        exact: whether entries that are small beside others keep their digits.
    """

    rows: tuple[int, int, int]
    columns: tuple[int, int, int]
    block: tuple[Expression, Expression, Expression, Expression]
    proper: bool
    lone: int
    exact: bool = False

    def transposed(self) -> Turn:
        """Return the inverse."""
        p, q, r, s = self.block
        return Turn(self.columns, self.rows, (p, r, q, s), self.proper, self.lone, self.exact)

    def vector(self, u: Array) -> Array:
        """Return the matrix times u, shape (3,)."""
        p, q, r, s = self.block
        (i, k, m), (a, b, c) = self.rows, self.columns
        v = u.copy()
        v[i], v[k], v[m] = p * u[a] + q * u[b], r * u[a] + s * u[b], u[c] * self.lone
        return v

    def magnitudes(self, u: Array) -> Array:
        """Return no less than the entries of the matrix times u, whatever turn and signs.

        Exact where axes only change places.
        """
        (i, k, m), (a, b, c) = self.rows, self.columns
        (p, q, _, _), v = self.block, u.copy()
        v[m] = u[c]
        if q.constant == 0:
            v[i], v[k] = u[a], u[b]
        elif p.constant == 0:
            v[i], v[k] = u[b], u[a]
        else:
            v[i] = v[k] = u[a].graph.larger(u[a], u[b])
        return v

    def congruent(self, matrix: Array, symmetric: bool) -> Array:
        """Return Q M Q^T, shape (3, 3)."""
        (i, k, m), (a, b, c) = self.rows, self.columns
        p, q, r, s = self.block
        result = matrix.copy()
        result[m, m] = matrix[c, c]
        x, y = matrix[a, c] * self.lone, matrix[b, c] * self.lone
        result[i, m], result[k, m] = p * x + q * y, r * x + s * y
        if not symmetric:
            x, y = matrix[c, a] * self.lone, matrix[c, b] * self.lone
        result[m, i], result[m, k] = p * x + q * y, r * x + s * y
        corner = matrix[a, a], matrix[a, b], matrix[b, a], matrix[b, b]
        result[i, i], result[i, k], result[k, i], result[k, k] = self._corner(*corner)
        return result

    def _corner(
        self, a: Expression, b: Expression, g: Expression, d: Expression
    ) -> tuple[Expression, Expression, Expression, Expression]:
        """The block's own congruence of [[a, b], [g, d]]."""
        p, q, r, s = self.block
        if q.constant == 0:
            return a, p * s * b, p * s * g, d
        if p.constant == 0:
            return d, q * r * g, q * r * b, a
        if self.exact:
            first, second = (p * a + q * g, p * b + q * d), (r * a + s * g, r * b + s * d)
            right = r * first[0] + s * first[1]
            left = right if b == g else p * second[0] + q * second[1]
            return p * first[0] + q * first[1], right, left, r * second[0] + s * second[1]
        if _smaller(p, q):
            t = p * (a - d) + ((q + q) * b if b == g else q * (b + g))
            offs = (b - q * t, g - q * t) if self.proper else (q * t - b, q * t - g)
            return d + p * t, *offs, a - p * t
        t = q * (a - d) - ((p + p) * b if b == g else p * (b + g))
        offs = (-(p * t) - g, -(p * t) - b) if self.proper else (p * t + g, p * t + b)
        return a - q * t, *offs, d + q * t


def _smaller(p: Expression, q: Expression) -> bool:
    """Whether |p| <= |q|, where both are known, in the first lane; true where they are not."""
    if p.constant is None or q.constant is None:
        return True
    first, second = (x.graph.lane(x, 0).constant for x in (p, q))
    return bool(abs(first) <= abs(second))


@dataclass(frozen=True)
class Dense:
    """A rotation matrix without structure, shape (3, 3)."""

    entries: Array

    def transposed(self) -> Dense:
        """Return the inverse."""
        return Dense(self.entries.T)

    def vector(self, u: Array) -> Array:
        """Return the matrix times u, shape (3,)."""
        return np.array([dot(row, u) for row in self.entries], dtype=object)

    def magnitudes(self, u: Array) -> Array:
        """Return no less than the entries of the matrix times u, whatever the turn and signs."""
        larger = u[0].graph.larger
        return np.array([larger(larger(u[0], u[1]), u[2])] * 3, dtype=object)

    def congruent(self, matrix: Array, symmetric: bool) -> Array:
        """Return E M E^T, shape (3, 3)."""
        half = np.array([[dot(row, column) for column in matrix.T] for row in self.entries])
        result = matrix.copy()
        for i in range(3):
            for k in range(3):
                mirrored = symmetric and k < i
                result[i, k] = result[k, i] if mirrored else dot(half[i], self.entries[k])
        return result


@dataclass(frozen=True)
class Rotation:
    """A product of factors, the last one applied first; it maps child to parent axes."""

    factors: tuple[Turn | Dense, ...]

    def transposed(self) -> Rotation:
        """Return the inverse."""
        return Rotation(tuple(factor.transposed() for factor in reversed(self.factors)))

    def vector(self, u: Array) -> Array:
        """Return R u, shape (3,)."""
        for factor in reversed(self.factors):
            u = factor.vector(u)
        return u

    def magnitudes(self, u: Array) -> Array:
        """Return no less than the entries of R u, whatever the turns and signs."""
        for factor in reversed(self.factors):
            u = factor.magnitudes(u)
        return u

    def congruent(self, matrix: Array, symmetric: bool) -> Array:
        """Return R M R^T, shape (3, 3)."""
        for factor in reversed(self.factors):
            matrix = factor.congruent(matrix, symmetric)
        return matrix

    def spatial(self, u: Array) -> Array:
        """Return a spatial vector's two halves turned, shape (6,)."""
        return np.concatenate([self.vector(u[ANGULAR]), self.vector(u[LINEAR])])

    def spatial_congruent(self, matrix: Array) -> Array:
        """Return a symmetric matrix turned, shape (6, 6)."""
        corner = self.congruent(matrix[ANGULAR, LINEAR], symmetric=False)
        upper = self.congruent(matrix[ANGULAR, ANGULAR], symmetric=True)
        lower = self.congruent(matrix[LINEAR, LINEAR], symmetric=True)
        return np.block([[upper, corner], [corner.T, lower]])


def constant_turn(rotation: Array) -> Turn | None:
    """Return a constant rotation as a turn, if it has an entry that is 1 or -1 to the bit."""
    for m in range(3):
        for c in range(3):
            alone = [rotation[m, k].constant for k in range(3) if k != c]
            alone += [rotation[k, c].constant for k in range(3) if k != m]
            if rotation[m, c].constant in (1, -1) and not any(x != 0 for x in alone):
                i, k = ((m + 1) % 3, (m + 2) % 3)
                a, b = ((c + 1) % 3, (c + 2) % 3)
                block = rotation[i, a], rotation[i, b], rotation[k, a], rotation[k, b]
                lone = 1 if rotation[m, c].constant > 0 else -1
                return Turn((i, k, m), (a, b, c), block, lone > 0, lone)
    return None


def about_z(cosine: Expression, sine: Expression, *, exact: bool = False) -> Turn:
    """Return the turn by an angle about z."""
    return Turn((0, 1, 2), (0, 1, 2), (cosine, -sine, sine, cosine), True, 1, exact)


def placed(base: Array, turn: Turn | Dense | None, *, across: bool = False) -> Rotation:
    """Return the constant rotation ``base`` times ``turn``, factors merged where possible.

    A sum of angles loses as many digits of a small one as that is smaller than a unit; a product
    that is exact to its largest entry only would lose twice as many.

    Args:
        base: it, shape (3, 3).
        turn: about z or by a quaternion; None for none.
        across: whether a base without structure is R_x R_z if it has a zero that shows that.
    """
    fixed = constant_turn(base)
    if across and fixed is None and isinstance(turn, Turn) and base[0, 2].constant == 0:
        (p, q), (c, s) = base[1:, 2], (turn.block[0], turn.block[2])
        about_x = Turn((1, 2, 0), (1, 2, 0), (q, p, -p, q), True, 1)
        x, y = base[0, 0], -base[0, 1]
        turned = about_z(x * c - y * s, y * c + x * s, exact=turn.exact)
        return Rotation((about_x, turned))
    if turn is None:
        return Rotation((fixed or Dense(base),))
    if isinstance(turn, Dense):
        if fixed is None:
            product = [[dot(row, column) for column in turn.entries.T] for row in base]
            return Rotation((Dense(np.array(product, dtype=object)),))
        columns = [fixed.vector(column) for column in turn.entries.T]
        return Rotation((Dense(np.array(columns, dtype=object).T),))
    if fixed is None:
        c, s = turn.block[0], turn.block[2]
        rows = [[x * c + y * s, y * c - x * s, z] for x, y, z in base]
        return Rotation((Dense(np.array(rows, dtype=object)),))
    if fixed.columns[2] != 2:
        return Rotation((fixed, turn))
    (p, q, r, s), (c, minus, sine, _) = fixed.block, turn.block
    block = p * c + q * sine, p * minus + q * c, r * c + s * sine, r * minus + s * c
    return Rotation((Turn(fixed.rows, fixed.columns, block, fixed.proper, fixed.lone, turn.exact),))


@dataclass(frozen=True)
class Transform:
    """Change of frame from a joint's child link to its parent link, and back.

    Attributes:
        rotation: child axes to parent axes.
        origin: of the child frame, in parent axes, shape (3,).
    """

    rotation: Rotation
    origin: Array

    def motion(self, a: Array) -> Array:
        """Return a motion of the parent's frame in the child's: X a."""
        linear = plus_cross(a[LINEAR], -self.origin, a[ANGULAR])
        return self.rotation.transposed().spatial(np.concatenate([a[ANGULAR], linear]))

    def motion_back(self, a: Array) -> Array:
        """Return a motion of the child's frame in the parent's: X^-1 a."""
        a = self.rotation.spatial(a)
        linear = plus_cross(a[LINEAR], self.origin, a[ANGULAR])
        return np.concatenate([a[ANGULAR], linear])

    def force(self, f: Array) -> Array:
        """Return a wrench on the child as one on the parent: X^T f."""
        f = self.rotation.spatial(f)
        return np.concatenate([plus_cross(f[ANGULAR], self.origin, f[LINEAR]), f[LINEAR]])

    def force_back(self, f: Array) -> Array:
        """Return a wrench on the parent as one on the child: X^-T f."""
        moment = plus_cross(f[ANGULAR], -self.origin, f[LINEAR])
        return self.rotation.transposed().spatial(np.concatenate([moment, f[LINEAR]]))

    def inertia(self, matrix: Array) -> Array:
        """Return an inertia of the child at the parent: X^T I X."""
        return shifted(self.rotation.spatial_congruent(matrix), self.origin, ANGULAR, LINEAR)

    def rigid_inertia(self, matrix: Array) -> Array:
        """Return X^T I X of a rigid body, [[A, cx], [-cx, m 1]] with c its mass times its centre.

        With c' = c + m r: A + (r . (c + c')) 1 - c r^T - r c'^T takes the place of A.
        """
        r, mass = self.origin, matrix[3, 3]
        c = self.rotation.vector(np.array([matrix[2, 4], matrix[0, 5], matrix[1, 3]]))
        a = self.rotation.congruent(matrix[ANGULAR, ANGULAR], symmetric=True)
        moved = np.array([x + y * mass for x, y in zip(c, r, strict=True)], dtype=object)
        along = [y * (x + z) for x, y, z in zip(c, r, moved, strict=True)]
        result = matrix.copy()  # the mass stays what it is
        for i in range(3):
            k, m = (i + 1) % 3, (i + 2) % 3
            result[i, i] = total([a[i, i], along[k], along[m]])
            result[i, k] = result[k, i] = total([a[i, k], -(c[i] * r[k]), -(r[i] * moved[k])])
            result[i, 3 + k], result[i, 3 + m] = -moved[m], moved[k]
            result[3 + k, i], result[3 + m, i] = -moved[m], moved[k]
        return result

    def inertia_back(self, matrix: Array) -> Array:
        """Return an inertia of the parent at the child: X^-T I X^-1."""
        moved = shifted(matrix, -self.origin, ANGULAR, LINEAR)
        return self.rotation.transposed().spatial_congruent(moved)

    def mobility(self, matrix: Array) -> Array:
        """Return a mobility of the parent in the child's frame: X Phi X^T."""
        moved = shifted(matrix, -self.origin, LINEAR, ANGULAR)
        return self.rotation.transposed().spatial_congruent(moved)

    def mobility_back(self, matrix: Array) -> Array:
        """Return a mobility of the child in the parent's frame: X^-1 Phi X^-T."""
        return shifted(self.rotation.spatial_congruent(matrix), self.origin, LINEAR, ANGULAR)


def shifted(matrix: Array, r: Array, first: slice, second: slice) -> Array:
    """Return T M T^T of a symmetric 6x6 matrix, T adding r x the second half to the first.

    With B and C the blocks (first, second) and (second, second): S = B + rx C takes the place of
    B, and A + rx B^T - S rx that of A.
    """
    result = matrix.copy()
    b, c = matrix[first, second], matrix[second, second]
    s = np.array([plus_cross(b[:, k], r, c[:, k]) for k in range(3)], dtype=object).T
    a = matrix[first, first].copy()
    for i in range(3):
        for k in range(i, 3):
            terms = [*_cross_terms(r, b[k], i), *_cross_terms(r, s[i], k)]
            a[i, k] = a[k, i] = total([a[i, k], *terms])
    result[first, second], result[second, first], result[first, first] = s, s.T, a
    return result


def _cross_terms(u: Array, v: Array, i: int) -> tuple[Expression, Expression]:
    """The two terms of entry i of u x v."""
    k, m = (i + 1) % 3, (i + 2) % 3
    return u[k] * v[m], -(u[m] * v[k])


def plus_cross(base: Array, u: Array, v: Array) -> Array:
    """Return base + u x v, in multiply-adds; all have shape (3,)."""
    entries = [total([base[i], *_cross_terms(u, v, i)]) for i in range(3)]
    return np.array(entries, dtype=object)


def columnwise(change: Callable[[Array], Array], matrix: Array) -> Array:
    """Return a change of spatial vectors applied to each column, shape (6, k)."""
    return np.array([change(column) for column in matrix.T], dtype=object).T
