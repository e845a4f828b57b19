"""Steps at a segment's root: mobilities from inertias, inertias from mobilities."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import SINGULAR, Check
from adagen.executor.state import State
from adagen.graph import Expression, Factors, factorize, matrix_times, solve_by_reflections, total
from adagen.plan.digits import LEAST_PIVOT
from adagen.plan.steps import (
    AccelerateRoot,
    HoldMobility,
    InvertRoot,
    LoadRoot,
    SolveMobility,
    SolveRoot,
    Step,
)

Array = NDArray[Any]
_HALVES = (range(3), range(3, 6))  # angular and linear


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
        """Phi^-1 and -Phi^-1 b, if no pivot of Phi is small beside the largest of its kind."""
        phi, b = self.memory[step.block], self.memory[step.bias]
        factors, least = factorize(phi), LEAST_PIVOT[self.state.plan.scalar]
        for rows in _HALVES:
            most = self._largest(phi, rows) * least
            for k in rows:
                check = Check(factors.pivots[k], most, step.link - 1, SINGULAR)
                self.state.checks.append(check)
        inverse = self._inverse(factors)
        self.memory["IA", step.link] = inverse
        self.memory["pA", step.link] = -matrix_times(inverse, b)

    def _largest(self, matrix: Array, rows: Sequence[int]) -> Expression:
        """The largest of three entries of the diagonal."""
        first, second, third = (matrix[k, k] for k in rows)
        return self.state.graph.larger(self.state.graph.larger(first, second), third)  # type: ignore[no-any-return]

    def _under_mobility(self, step: SolveMobility) -> Array:
        """The a of (1 + Phi I) a = b - Phi p, shape (6, columns).

        Phi and I may both be singular, and rows would have to be exchanged by size: reflections
        are as stable and need not look.
        """
        inertia, p = self.memory["IA", step.link], self.memory["pA", step.link]
        phi, b = self.memory[step.block], self.memory[step.bias]
        held = matrix_times(phi, inertia)
        for k in range(6):
            held[k, k] = held[k, k] + 1
        return solve_by_reflections(held, b - matrix_times(phi, p))
