"""What the steps at a segment's root mean: mobilities from inertias, inertias from mobilities."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import SINGULAR, Check
from adagen.executor.state import State
from adagen.graph import Factors, factorize, matrix_times, total
from adagen.plan.digits import EPSILON, LEAST_PIVOT
from adagen.plan.steps import (
    AccelerateRoot,
    HoldMobility,
    InvertRoot,
    LoadRoot,
    SolveMobility,
    SolveRoot,
    Step,
)
from adagen.plan.types import FACTORS

Array = NDArray[Any]
_NOTHING = 1e-30  # kg m^2 or kg: an inertia without which a division is by zero


class Roots:
    """Executes the steps at roots on a process's memory."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.memory: dict[Any, Any] = state.memory

    def step(self, step: Step) -> None:
        """Do one step."""
        match step:
            case InvertRoot():
                factors = self.state.factorize(self.memory["IA", step.link], step.link - 1)
                phi = self._inverse(factors)
                self.memory[step.block] = phi
                self.memory[step.bias] = -matrix_times(phi, self.memory["pA", step.link])
            case SolveRoot():
                factors = self.state.factorize(self.memory["IA", step.link], step.link - 1)
                self.memory["a", step.link] = factors.solve(-self.memory["pA", step.link])
            case SolveMobility():
                self.memory["a", step.link] = self._under_mobility(step)
            case HoldMobility():
                self._hold(step)
            case LoadRoot():
                inertia, p = self.memory["IA", step.link], self.memory["pA", step.link]
                load = matrix_times(inertia, self.memory["a", step.link]) + p
                self.memory["load", step.link] = load if step.held else -load
            case AccelerateRoot():
                phi, b = self.memory[step.block], self.memory[step.bias]
                load = self.memory["load", step.link]
                self.memory["a", step.link] = b + matrix_times(phi, load)
            case _:
                raise AssertionError(f"no meaning for {step}")

    def _inverse(self, factors: Factors) -> Array:
        """The inverse of a symmetric matrix by its factors, shape (6, 6)."""
        half = factors.forward(self.state.constants(np.eye(6)))
        over = factors.scaled(half)
        inverse = self.state.zeros(6, 6)
        for i in range(6):
            for k in range(i, 6):
                inverse[i, k] = inverse[k, i] = total(half[:, i] * over[:, k])
        return inverse

    def _hold(self, step: HoldMobility) -> None:
        """Phi^-1 and -Phi^-1 b, where no pivot of Phi is small beside the largest of its kind."""
        graph = self.state.graph
        phi, b = self.memory[step.block], self.memory[step.bias]
        factors, least = factorize(phi), LEAST_PIVOT[FACTORS[self.state.plan.scalar]]
        for rows in (range(3), range(3, 6)):
            first, second, third = (phi[k, k] for k in rows)
            most = graph.larger(graph.larger(first, second), third) * least
            for k in rows:
                check = Check(factors.pivots[k], most, step.link - 1, SINGULAR)
                self.state.checks.append(check)
        inverse = self._inverse(factors)
        self.memory["IA", step.link] = inverse
        self.memory["pA", step.link] = -matrix_times(inverse, b)

    def _under_mobility(self, step: SolveMobility) -> Array:
        """The a of (1 + Phi I) a = r with r = b - Phi p, shape (6, columns).

        With I = L D L^T and U = L D, I a = U y where (D + U^T Phi U) y = U^T r. That matrix is
        symmetric and positive definite whatever Phi and I do not hold, and a = r - Phi U y. Where
        the link is held much firmer than r tells, that subtracts nearly equal numbers: what is left
        over of the equation is solved for once more.
        """
        inertia, p = self.memory["IA", step.link], self.memory["pA", step.link]
        phi, b = self.memory[step.block], self.memory[step.bias]
        if not any(x.constant != 0 for x in inertia.flat):
            return np.asarray(b - matrix_times(phi, p))
        u, d = self._semidefinite(inertia)
        phi_u = matrix_times(phi, u)
        m = matrix_times(u.T, phi_u)
        for k in range(len(d)):
            m[k, k] = d[k] + m[k, k]
        factors = self.state.factorize(m, step.link - 1)

        def solved(r: Array) -> Array:
            result: Array = r - matrix_times(phi_u, factors.solve(matrix_times(u.T, r)))
            return result

        r = b - matrix_times(phi, p)
        a = solved(r)
        left: Array = r - a - matrix_times(phi, matrix_times(inertia, a))
        return np.asarray(a + solved(left))

    def _semidefinite(self, inertia: Array) -> tuple[Array, list[Any]]:
        """U = L D, shape (6, m), and D of I = L D L^T, where I may be singular.

        A pivot that is lost to rounding counts as what rounding leaves of it; a row that is zero
        is left out.
        """
        graph, lost = self.state.graph, 4 * EPSILON[FACTORS[self.state.plan.scalar]]
        columns: list[Array] = []
        pivots: list[Any] = []
        over: list[Array] = []
        for j in range(6):
            if inertia[j, j].constant == 0:
                continue
            column = self.state.zeros(6)
            for i in range(j, 6):
                terms = [-(u[i] * v[j]) for u, v in zip(columns, over, strict=True)]
                column[i] = total([inertia[i, j], *terms])
            least = inertia[j, j] * lost + _NOTHING
            column[j] = graph.larger(column[j], least) if columns else column[j]
            inverse = graph.reciprocal(column[j])
            columns.append(column)
            pivots.append(column[j])
            over.append(column * inverse)
        return np.array(columns, dtype=object).T, pivots
