"""Orthogonal basis of a closure's constraint rows and of their null space (J^T = Q R)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.state import State
from adagen.graph import Expression, reflect, solve_lower, total

Array = NDArray[Any]


class RowBasis:
    """J^T = Q R of rows J, brought to one size.

    Args:
        state: whose numbers they are.
        pushes: J^T, shape (w, rows).
        scales: what rows are to be multiplied by, shape (rows,).
    """

    def __init__(self, state: State, pushes: Array, scales: Array) -> None:
        self.state, self.scales = state, scales[:, None]
        self.count, nothing = len(scales), state.zeros(len(pushes), 0)
        self.r = pushes * scales
        found = [reflect(k, self.r, nothing) for k in range(self.count)]
        self.reflections = [each for each in found if each is not None]

    @property
    def pivots(self) -> list[Expression]:
        """The diagonal of R."""
        return [self.r[k, k] for k in range(self.count)]

    def motions(self, biases: Array) -> tuple[Array, Array]:
        """The motions that satisfy the rows: w = N y + g.

        Args:
            biases: how rows part by themselves, shape (rows, columns).

        Returns:
            N, shape (w, w - rows), columns of Q, and g, shape (w, columns).
        """
        free = len(self.r) - self.count
        basis = self.state.zeros(len(self.r), free + biases.shape[1])
        basis[self.count :, :free] = self.state.constants(np.eye(free))
        basis[: self.count, free:] = solve_lower(self.r.T, -(biases * self.scales))
        for reflection in reversed(self.reflections):
            reflection.apply(basis)
        return basis[:, :free], basis[:, free:]

    def moves(self, parted: Array) -> Array:
        """Squared motions of w along columns of Q, from squared residuals of the rows.

        That is R^-T of these, signs being treated as if they were random.
        """
        found = self.state.zeros(self.count)
        for k, (pivot, scale) in enumerate(zip(self.pivots, self.scales[:, 0], strict=True)):
            over = self.state.graph.reciprocal(pivot)
            before = (x * x * moved for x, moved in zip(self.r[:k, k], found[:k], strict=True))
            found[k] = total([scale * scale * parted[k], *before]) * (over * over)
        return found

    def forces(self, pull: Array) -> Array:
        """Return the forces of rows that balance a generalised force, shape (rows, 1) of (w, 1)."""
        pull, last = pull.copy(), self.count - 1
        for reflection in self.reflections:
            reflection.apply(pull)
        found: Array = solve_lower(self.r[last::-1, ::-1], pull[last::-1])[::-1]
        return found * self.scales
