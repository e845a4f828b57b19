"""True accelerations to a hundred digits, or as many as a double has, and errors of answers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from flint import arb
from numpy.typing import NDArray

from adagen.errors import EnvironmentFault
from adagen.exact import exact, rounded
from adagen.model import Model
from adagen.reference import (
    energy_norm_error,
    exact_forward_dynamics,
    exact_inverse_dynamics,
    forward_dynamics,
    joint_space_inertia,
    residual,
)
from adagen.states import States
from adagen.studies.random_states import check_closed, drawn_states

Array = NDArray[np.float64]
DIGITS = 100
DOUBLE = 20
"""Digits of a truth that is compared with answers in double alone."""
DIRECT = 200
"""Degrees of freedom up to which so many digits of a tree are solved for directly, in balls."""
_PASSES = 20
_SETTLED = 1e-15


class Errors(NamedTuple):
    """The largest errors over some states.

    Attributes:
        forward: of the accelerations, in the energy norm sqrt(e^T H e / t^T H t).
        residual: of inverse dynamics, relative to the torques at work.
    """

    forward: float
    residual: float


@dataclass(frozen=True, eq=False)
class Truth:
    """What is true of some states of a robot.

    Attributes:
        model: the robot.
        states: the states.
        exact: accelerations as balls, object array of shape (S, nv); of large trees as doubles.
        inertias: joint-space inertias, shape (S, nv, nv).
        digits: certified decimal digits of the accelerations.
    """

    model: Model
    states: States
    exact: NDArray[Any]
    inertias: Array
    digits: int

    def errors(self, found: Array) -> Errors:
        """Return the largest forward error and the largest torque residual of answers.

        Args:
            found: accelerations, shape (S, nv).

        Returns:
            The errors, differences formed before anything is rounded; infinity where an answer is
            not finite.
        """
        if not np.isfinite(found).all():
            return Errors(np.inf, np.inf)
        back = 0.0
        for s in range(self.states.count):
            q, v, tau = self.states.q[s], self.states.v[s], self.states.tau[s]
            back = max(back, residual(self.model, q, v, tau, found[s]))
        forward = max(self.error(s, found[s]) for s in range(self.states.count))
        return Errors(forward, back)

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
        digits: how many are certified; at most DOUBLE of them of trees that are too large to be
            solved directly come from refinement.
        on_progress: called with messages about progress.

    Raises:
        InputError: the robot's joint-space inertia is singular, or a loop is open.
    """
    states = drawn_states(model, count, seed) if isinstance(count, int) else count
    check_closed(model, states)
    found, inertias = [], []
    large = model.nv > DIRECT and not model.closed and digits <= DOUBLE
    for s, state in enumerate(states.each):
        on_progress(f"exact accelerations to {digits} digits: state {s + 1} of {states.count}")
        if large:
            found.append(refined(model, *state))
        else:
            found.append(exact_forward_dynamics(model, *state, digits=digits).raw)
        inertias.append(joint_space_inertia(model, state[0]))
    return Truth(model, states, np.array(found), np.array(inertias), digits)


def refined(model: Model, q: Array, v: Array, tau: Array) -> Array:
    """Return the true accelerations of a large model, shape (nv,), by iterative refinement.

    The residual is that of inverse dynamics in ball arithmetic, which costs little; corrections
    are solved for in double, by composite bodies. What is left is the rounding of the result.

    Args:
        model: the robot.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        tau: torques, shape (nv,).

    Raises:
        InputError: the joint-space inertia is singular in double precision.
        EnvironmentFault: the corrections do not die down, as with an inertia nearly singular.
    """
    still, weightless = np.zeros(model.nv), model.with_gravity(np.zeros(3))
    found = forward_dynamics(model, q, v, tau)
    for _ in range(_PASSES):
        needed = exact_inverse_dynamics(model, q, v, found, digits=DOUBLE).raw
        missing = rounded(exact(tau) - needed)
        change = forward_dynamics(weightless, q, still, missing)
        found = found + change
        if np.abs(change).max() <= _SETTLED * np.abs(found).max():
            return np.asarray(found)
    raise EnvironmentFault(f"the true accelerations of {model.name} cannot be found: H is singular")
