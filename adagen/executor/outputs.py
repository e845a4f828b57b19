"""Outputs beside accelerations: of links and joints (adagen.model.Output)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.frames import plus_cross
from adagen.executor.kinematics import Field, Motion
from adagen.executor.state import State
from adagen.graph import matrix_times, total
from adagen.model import LINK_ACCELERATION, REACTION_FORCE
from adagen.plan.robot import PlanOutput

Array = NDArray[Any]


class Outputs:
    """Computes outputs from a process's memory, after its outward sweep."""

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion

    def output(self, k: int) -> Array:
        """Return the numbers of output ``k`` of the plan, shape (size,)."""
        output = self.state.plan.outputs[k]
        if output.what == LINK_ACCELERATION:
            return self._acceleration(output)
        if output.what == REACTION_FORCE:
            return self._reaction(output)
        return self._inverse_inertia(output)

    def _acceleration(self, output: PlanOutput) -> Array:
        """[linear; angular] acceleration of the frame's origin: reference field plus deviation.

        The field is one relative to free fall.
        """
        field: Field = self.motion.field_of(output.link)
        deviation = self._kept("a", output.link)
        turning, sliding = deviation[:3], deviation[3:]
        place = self.state.constants(output.translation)
        assert field.up is not None  # it is asked for
        linear = [
            total([field.a[k], -field.up[k], sliding[k], *(field.gradient[k] * place)])
            for k in range(3)
        ]
        moved = plus_cross(np.array(linear, dtype=object), turning, place)
        angular = field.alpha + turning
        return np.concatenate([self._in_frame(output, moved), self._in_frame(output, angular)])

    def _reaction(self, output: PlanOutput) -> Array:
        """[force; moment] at the link's origin, in the description's axes."""
        wrench = self._kept("reaction", output.link)
        return np.concatenate(
            [self._in_frame(output, wrench[3:]), self._in_frame(output, wrench[:3])]
        )

    def _inverse_inertia(self, output: PlanOutput) -> Array:
        """The link's mobility in the frame: X Phi X^T, linear before angular, row by row."""
        phi = self.state.memory[self.state.plan.mobility_of(output.link)]
        turn = self.state.constants(output.rotation).T
        place = self.state.constants(output.translation)
        change = self.state.zeros(6, 6)  # from [angular; linear] at the link's origin
        zero = self.state.zeros(3)
        for k in range(3):
            unit = self.state.zeros(3)
            unit[k] = self.state.graph.constant(1)
            change[:3, k] = matrix_times(turn, plus_cross(zero, unit, place))
            change[:3, 3 + k] = turn[:, k]
            change[3:, k] = turn[:, k]
        half = matrix_times(change, phi)
        result = self.state.zeros(6, 6)
        for i in range(6):
            for k in range(i, 6):
                result[i, k] = result[k, i] = total(half[i] * change[k])
        return result.ravel()

    def _in_frame(self, output: PlanOutput, vector: Array) -> Array:
        """A vector of the link's axes in those of the frame."""
        return matrix_times(self.state.constants(output.rotation).T, vector)

    def _kept(self, name: str, link: int) -> Array:
        """A stored value of a link, shape (6,), with coupling torques of slaved joints."""
        kept, k = self.state.rows.kept(name, link)
        value = kept if k is None else self.state.rows.lane(kept, k)
        if not self.state.plan.slaved:
            return value[:, 0]
        torques = self.state.memory["torques"]
        return np.array([total([row[0], *(row[1:] * torques)]) for row in value], dtype=object)
