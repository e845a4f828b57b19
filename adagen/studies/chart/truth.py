"""True accelerations to a hundred digits, and how far answers are from them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from adagen.model import Model
from adagen.reference import (
    energy_norm_error,
    exact_forward_dynamics,
    joint_space_inertia,
    residual,
)
from adagen.states import States
from adagen.studies.random_states import check_closed, drawn_states

Array = NDArray[np.float64]
DIGITS = 100


@dataclass(frozen=True, eq=False)
class Truth:
    """What is true of some states of a robot.

    Attributes:
        model: the robot.
        states: the states.
        exact: accelerations as balls, object array of shape (S, nv).
        inertias: joint-space inertias, shape (S, nv, nv).
        digits: certified decimal digits of the accelerations.
    """

    model: Model
    states: States
    exact: NDArray[Any]
    inertias: Array
    digits: int

    def errors(self, found: Array) -> tuple[float, float]:
        """Return the largest forward error and the largest torque residual of answers.

        Args:
            found: accelerations, shape (S, nv).

        Returns:
            sqrt(e^T H e / t^T H t), where e is formed before anything is rounded; and what
            ``adagen.reference.residual`` says. Infinity where an answer is not finite.
        """
        if not np.isfinite(found).all():
            return np.inf, np.inf
        back = 0.0
        for s in range(self.states.count):
            q, v, tau = self.states.q[s], self.states.v[s], self.states.tau[s]
            back = max(back, residual(self.model, q, v, tau, found[s]))
        return max(self.error(s, found[s]) for s in range(self.states.count)), back

    def error(self, state: int, found: Array) -> float:
        """Return the forward error of one state's answer, in the energy norm.

        Args:
            state: its number, from 0.
            found: accelerations, shape (nv,).
        """
        error = [float(arb(a) - t) for a, t in zip(found, self.exact[state], strict=True)]
        truth = [float(t) for t in self.exact[state]]
        return energy_norm_error(self.inertias[state], error, truth)


def truth_of(
    model: Model,
    count: int | States,
    seed: int = 1,
    digits: int = DIGITS,
    on_progress: Callable[[str], None] = lambda _: None,
) -> Truth:
    """Return the truth of random states, or of given ones.

    Args:
        model: the robot.
        count: how many states, or these.
        seed: of the states.
        digits: how many are certified.
        on_progress: called with messages about progress.

    Raises:
        InputError: the robot's joint-space inertia is singular, or a loop is open.
    """
    states = drawn_states(model, count, seed) if isinstance(count, int) else count
    check_closed(model, states)
    exact, inertias = [], []
    for s, state in enumerate(zip(states.q, states.v, states.tau, strict=True)):
        on_progress(f"exact accelerations to {digits} digits: state {s + 1} of {states.count}")
        exact.append(exact_forward_dynamics(model, *state, digits=digits).raw)
        inertias.append(joint_space_inertia(model, state[0]))
    return Truth(model, states, np.array(exact), np.array(inertias), digits)
