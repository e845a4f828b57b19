"""How wrong answers are: against the truth where it can be had, and by inverse dynamics."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from adagen.model import Model
from adagen.reference import (
    energy_norm_error,
    exact_forward_dynamics,
    joint_space_inertia,
    residual,
)
from adagen.states import States

Array = NDArray[np.float64]


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
    """Knows the true accelerations of a model for some states, to certified digits.

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
        return np.array([exact_forward_dynamics(self.model, *s, digits=20).value for s in each])

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
