"""Passages over expressions: pose and motion of a run's last link, computed and combined.

A passage is 24 numbers in axes of the link before the run's first joint, as if that link were at
rest: orientation of the last link by rows, its angular velocity and acceleration, and position,
velocity and acceleration of its origin. If that link moves, velocities and accelerations add up as
for a point in a moving frame, Coriolis acceleration included.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.frames import plus_cross
from adagen.executor.kinematics import Field, Motion, gradient_of
from adagen.executor.state import State
from adagen.graph import dot, total
from adagen.plan.steps import Append, Arrive, Passage, Traverse

Array = NDArray[Any]


class Passages:
    """Executes steps about passages on a process's memory."""

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion

    def step(self, step: Traverse | Append | Arrive) -> None:
        """Do one step."""
        match step:
            case Traverse():
                self.state.memory[step.passage] = self._traversed(step.passage)
            case Append():
                near, far = (self.state.memory[part] for part in (step.near, step.far))
                self.state.memory[step.passage] = self._appended(near, far)
            case Arrive():
                self._arrive(step)

    def _traversed(self, passage: Passage) -> Array:
        """The passage of a run, joint by joint."""
        whole: Array | None = None
        for j in range(passage.first, passage.last + 1):
            x, moving = self.motion.placed(j)
            units = self.state.constants(np.eye(3))
            rotation = np.array([x.rotation.vector(unit) for unit in units]).T
            turning, sliding = x.rotation.vector(moving[:3]), x.rotation.vector(moving[3:])
            nothing = self.state.zeros(3)
            own = np.concatenate([rotation.ravel(), turning, nothing, x.origin, sliding, nothing])
            whole = own if whole is None else self._appended(whole, own)
        assert whole is not None  # no run is empty
        return whole

    def _appended(self, near: Array, far: Array) -> Array:
        """The passage of two successive runs."""
        turn = near[:9].reshape(3, 3)
        _, omega, alpha, place, v, a = _parts(near)
        turned, spin, turns, lever, slide, more = (
            _turned(turn, part) if part.ndim == 1 else _product(turn, part) for part in _parts(far)
        )
        ride = plus_cross(slide + slide, omega, lever)  # with Coriolis' share of the velocity
        return np.concatenate(
            [
                turned.ravel(),
                omega + spin,
                plus_cross(alpha + turns, omega, spin),
                place + lever,
                plus_cross(v + slide, omega, lever),
                plus_cross(plus_cross(a + more, alpha, lever), omega, ride),
            ]
        )

    def _arrive(self, step: Arrive) -> None:
        """The field of a passage's last link, from that of the link before the run."""
        above = self.motion.field_of(step.near)
        rotation, spin, turns, lever, slide, more = _parts(self.state.memory[step.passage])
        ride = plus_cross(slide + slide, above.omega, lever)
        back = rotation.T
        omega = _turned(back, above.omega + spin)
        alpha = _turned(back, plus_cross(above.alpha + turns, above.omega, spin))
        a = plus_cross(plus_cross(above.a + more, above.alpha, lever), above.omega, ride)
        field = Field(omega, alpha, _turned(back, a), gradient_of(omega, alpha))
        self.state.memory["field", step.passage.link] = field


def _parts(passage: Array) -> list[Array]:
    """Rotation, shape (3, 3), and vectors of a passage."""
    return [passage[:9].reshape(3, 3), *(passage[k : k + 3] for k in range(9, 24, 3))]


def _turned(matrix: Array, u: Array) -> Array:
    return np.array([total(row * u) for row in matrix], dtype=object)


def _product(a: Array, b: Array) -> Array:
    return np.array([[dot(row, column) for column in b.T] for row in a], dtype=object)
