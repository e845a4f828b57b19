"""How solvers of closed loops fare at linkages that are hard for them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from adagen.errors import AdagenError
from adagen.executor import interpret
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.reference import (
    bias,
    energy_norm_error,
    exact_forward_dynamics,
    joint_space_inertia,
)
from adagen.reference.certified import independent_rows
from adagen.reference.closed import closed_forward_dynamics
from adagen.reference.loop_rows import loop_rows
from adagen.reference.numbers import DOUBLE
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States

Array = NDArray[np.float64]
State = tuple[Array, Array, Array]


@dataclass(frozen=True)
class Tally:
    """What a method made of some states.

    Attributes:
        error: the largest of its answers in the energy norm, infinite where one is no number;
            0 where it gave none.
        refused: states that it refused, or failed at.
        states: how many there were.
        reason: of the last refusal.
    """

    error: float
    refused: int
    states: int
    reason: str

    @property
    def result(self) -> str:
        """For people."""
        if self.refused == self.states:
            return self.reason or "fails"
        text = f"{self.error:.1e}"
        return f"{text}; refuses {self.refused} of {self.states}" if self.refused else text


@dataclass(frozen=True)
class ClosedTrial:
    """A mechanism in some states, with the truth."""

    model: Model
    states: States

    @cached_property
    def _rows(self) -> list[State]:
        return list(self.states.each)

    @cached_property
    def truths(self) -> list[Array]:
        """True accelerations, rounded to double."""
        return [exact_forward_dynamics(self.model, *row, digits=20).value for row in self._rows]

    @cached_property
    def plan(self) -> Plan:
        """The plan of form segment on one process."""
        return make_plan(self.model, best_schedule(self.model, 1, load_profile("default")))

    def tally(self, method: Callable[[ClosedTrial, State], Array]) -> Tally:
        """Return what a method makes of the states."""
        worst, refused, reason = 0.0, 0, ""
        for row, truth in zip(self._rows, self.truths, strict=True):
            try:
                with np.errstate(all="ignore"):
                    found = method(self, row)
            except (AdagenError, FloatingPointError, np.linalg.LinAlgError) as failure:
                refused, reason = refused + 1, str(failure).removeprefix("error: ")
                continue
            inertia = joint_space_inertia(self.model, row[0])
            worst = max(worst, energy_norm_error(inertia, found - truth, truth))
        return Tally(worst, refused, len(self._rows), reason)


def shipped(trial: ClosedTrial, state: State) -> Array:
    """Form segment, carried out as straight lines are."""
    return interpret(trial.plan, *state, once=True)


def dense(trial: ClosedTrial, state: State) -> Array:
    """The KKT system with all rows, by LU with partial pivoting."""
    return _kkt(trial, state, None)


def dense_independent(trial: ClosedTrial, state: State) -> Array:
    """The same with independent rows alone."""
    return _kkt(trial, state, independent_rows(trial.model, state[0], 1e-12))


def null_space(trial: ClosedTrial, state: State) -> Array:
    """An orthonormal basis of the null space of J, by singular values."""
    return closed_forward_dynamics(trial.model, *state)


def _kkt(trial: ClosedTrial, state: State, kept: Sequence[int] | None) -> Array:
    model, (q, v, tau) = trial.model, state
    rows, drift = loop_rows(DOUBLE, model, q, v)
    if kept is not None:
        rows, drift = rows[kept], drift[kept]
    none = np.zeros((len(rows), len(rows)))
    matrix = np.block([[joint_space_inertia(model, q), rows.T], [rows, none]])
    right = np.concatenate([tau[: model.nv] - bias(model, q, v), -drift])
    result: Array = np.linalg.solve(matrix, right)[: model.nv]
    return result
