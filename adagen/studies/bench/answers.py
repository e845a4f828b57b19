"""How wrong answers are: against the truth where it can be had, and by inverse dynamics."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
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

Array = NDArray[np.float64]
DIRECT = 200
"""Degrees of freedom up to which the truth of a tree is solved for directly, in balls."""
_DIGITS = 20
_PASSES = 20
_SETTLED = 1e-15


@dataclass(frozen=True)
class Errors:
    """The largest errors over some states.

    Attributes:
        forward: of the accelerations, in the energy norm sqrt(e^T H e / t^T H t).
        residual: of inverse dynamics, relative to the torques at work.
    """

    forward: float
    residual: float


class Judge:
    """Knows the true accelerations of a model for some states, to the last digits of a double.

    Args:
        model: the robot.
        states: what is to be solved for.
    """

    def __init__(self, model: Model, states: States) -> None:
        self.model = model
        self.states = states

    @cached_property
    def truth(self) -> Array:
        """Shape (S, nv)."""
        each = zip(self.states.q, self.states.v, self.states.tau, strict=True)
        if self.model.nv > DIRECT and not self.model.closed:
            return np.array([refined(self.model, *state) for state in each])
        found = (exact_forward_dynamics(self.model, *s, digits=_DIGITS) for s in each)
        return np.array([certified.value for certified in found])

    @cached_property
    def _inertias(self) -> list[Array]:
        return [joint_space_inertia(self.model, q) for q in self.states.q]

    def errors(self, found: Array) -> Errors:
        """Return how wrong accelerations are, shape (S, nv), the largest over the states."""
        forward = back = 0.0
        truth, states = self.truth, self.states
        for s in range(states.count):
            error = energy_norm_error(self._inertias[s], found[s] - truth[s], truth[s])
            forward = max(forward, error)
            own = residual(self.model, states.q[s], states.v[s], states.tau[s], found[s])
            back = max(back, own)
        return Errors(forward, back)


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
        needed = exact_inverse_dynamics(model, q, v, found, digits=_DIGITS).raw
        missing = rounded(exact(tau) - needed)
        change = forward_dynamics(weightless, q, still, missing)
        found = found + change
        if np.abs(change).max() <= _SETTLED * np.abs(found).max():
            return np.asarray(found)
    raise EnvironmentFault(f"the true accelerations of {model.name} cannot be found: H is singular")
