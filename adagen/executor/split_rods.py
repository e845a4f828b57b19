"""Rods split in two halves by a weld (adagen/plan/split_rods.py).

The body of the half on the ball joint is added to the other half's link. Torques of the ball joint
act on that link, and oppositely on the link that the ball joint is on. The rotation of the ball
joint follows at the end. For three hinges with axes z_1, z_2, z_3 it needs their inverse,
(z_2 x z_3, z_3 x z_1, z_1 x z_2) / det, which exists unless the axes are in one plane.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.executor.elimination_checks import LEAST, failure_of
from adagen.executor.frames import Dense, Rotation, Transform, columnwise, constant_turn
from adagen.executor.front import Front
from adagen.executor.kinematics import Motion
from adagen.executor.state import State
from adagen.graph import Expression, cross, dot, matrix_times
from adagen.plan.closure_steps import ClosureSteps
from adagen.plan.robot import PlanLoop
from adagen.plan.split_rods import RodHalf, rod_halves_in
from adagen.plan.steps import CloseLoop, Eliminate

Array = NDArray[Any]


class RodHalfMotion:
    """One rod half on a ball joint; for similar closures, those of all lanes.

    Args:
        state: whose process it is.
        motion: its kinematics.
        half: the link.
        loops: returns the weld that fixes it, in each lane.
    """

    def __init__(
        self,
        state: State,
        motion: Motion,
        half: RodHalf,
        loops: Callable[[CloseLoop], Sequence[PlanLoop]],
    ) -> None:
        self.state, self.motion, self.half = state, motion, half
        self._read_loops = loops
        self.known = False

    @cached_property
    def loops(self) -> Sequence[PlanLoop]:
        """The weld, in each lane."""
        return self._read_loops(self.half.closing)

    def _axes(self, side: int) -> Array:
        """The frames' axes at one side of the welds."""
        each = [self.state.constants(loop.rotations[side]) for loop in self.loops]
        return self.state.rows.packed(each)

    @property
    def carriers(self) -> list[int]:
        """The links of the other halves, by lanes."""
        return [loop.links[1 - self.half.side] for loop in self.loops]

    @cached_property
    def fixed(self) -> Transform:
        """Its pose on the other half."""
        beside = 1 - self.half.side
        turn = matrix_times(self._axes(beside), self._axes(self.half.side).T)
        each = [self.state.constants(loop.translations[beside]) for loop in self.loops]
        place = self.state.rows.packed(each)
        return Transform(Rotation((constant_turn(turn) or Dense(turn),)), place)

    # -- bodies and torques -----------------------------------------------------------------------

    def inertia_at_carrier(self, own: Array) -> Array:
        """Return its inertia at the other half's link, shape (6, 6)."""
        return self.fixed.rigid_inertia(own)

    def push_on(self, number: int) -> Array:
        """Return the effect of its ball's torques on the other half, or on the ball's near link."""
        none = self.state.zeros(3)
        if number == self.half.carrier:
            return np.concatenate([self.fixed.rotation.vector(self._moment), none])
        return np.concatenate([-self._moment, none])

    @cached_property
    def _moment(self) -> Array:
        """Moment of its ball's torques on it, in its axes, shape (3,)."""
        pulls = [self.state.torques(j)[:, 0] for j in self.half.joints]
        if len(pulls) == 1:
            return pulls[0]
        return self._by_hinges(self._hinges[0].T, np.concatenate(pulls))

    @cached_property
    def _hinges(self) -> tuple[Array, Expression]:
        """The inverse of the hinges' axes, shape (3, 3), times their determinant; this."""
        axes, x = [], [self.state.memory["X", j] for j in self.half.joints]
        for k in range(len(x)):
            axis = self.state.constants([0.0, 0.0, 1.0])
            for joint in x[k + 1 :]:
                axis = joint.rotation.transposed().vector(axis)
            axes.append(axis)
        rows = [cross(axes[(k + 1) % 3], axes[(k + 2) % 3]) for k in range(3)]
        return np.array(rows, dtype=object), dot(axes[0], rows[0])

    def _by_hinges(self, rows: Array, values: Array) -> Array:
        """Rows of the inverse, or of its transpose, times values."""
        inverse = self.state.graph.reciprocal(self._hinges[1])
        found: Array = matrix_times(rows, values) * inverse
        return found

    def look_at(self, place: int) -> None:
        """Check that the hinges are not in one plane, nor so near that digits are lost."""
        if len(self.half.joints) > 1:
            determinant, how = self._hinges[1], self.half.eliminate
            least = max(LEAST[self.state.plan.scalar], 1 / how.limit) ** 2
            limit = self.state.graph.constant(least)
            check = Check(determinant * determinant, limit, place, failure_of(how))
            self.state.checks.append(check)

    # -- how it turns -----------------------------------------------------------------------------

    def turning_apart(self) -> Array:
        """Return its angular velocity relative to the other half, in its axes, shape (3,)."""
        own = self.motion.field_of_all(self._links).omega
        return own - self.fixed.rotation.transposed().vector(self._carrier_field.omega)

    @property
    def _links(self) -> list[int]:
        return [loop.links[self.half.side] for loop in self.loops]

    @property
    def _carrier_field(self) -> Any:
        return self.motion.field_of_all(self.carriers)

    def find(self, front: Front) -> bool:
        """Compute accelerations of its ball, once those of the other unknowns are known."""
        near = self.state.rows.near_links(self.half.joints[0])
        if self.known or not all(self._is_known(link) for link in (*near, *self.carriers)):
            return self.known
        back = self.fixed.rotation.transposed()
        turning = columnwise(back.vector, self._turns(self.carriers)) - self._seen()
        if len(self.half.joints) > 1:
            turning = self._by_hinges(self._hinges[0], turning)
        front.found.update(zip(self.half.freedoms, turning, strict=True))
        self.known = True
        return True

    def _turns(self, links: Sequence[int]) -> Array:
        """Angular accelerations of links, one for each lane, shape (3, columns)."""
        moved = self.state.rows.of_links("a", links, self.state.zeros(6, self.state.columns))
        turned: Array = moved[:3] + self.state.column(self.motion.field_of_all(links).alpha)
        return turned

    def _seen(self) -> Array:
        """Its angular acceleration for zero accelerations of its ball, shape (3, columns)."""
        near = self.state.rows.near_links(self.half.joints[0])
        turns, omega = self._turns(near), self.motion.field_of_all(near).omega
        for j in self.half.joints:
            back, own = self.state.memory["X", j].rotation.transposed(), self.state.zeros(6)
            own[list(self.state.kind(j).free)] = self.state.configuration(j)[1]
            omega = back.vector(omega)
            turns = columnwise(back.vector, turns) + self.state.column(cross(omega, own[:3]))
            omega = omega + own[:3]
        return turns

    def _is_known(self, link: int) -> bool:
        """Whether a link's acceleration is known."""
        if link == 0:
            return True
        try:
            self.state.rows.kept("a", link)
        except KeyError:
            return False
        return True


class RodHalves:
    """All rod halves of a process.

    Args:
        state: whose process it is.
        motion: its kinematics, which counts their bodies to others from now on.
        closures: that are not treated as others are, whose lanes they are in.
        apart: joints that are not to be treated so.
        loops: returns a loop in each lane.
    """

    def __init__(
        self,
        state: State,
        motion: Motion,
        closures: Iterable[ClosureSteps],
        apart: Collection[int],
        loops: Callable[[CloseLoop], Sequence[PlanLoop]],
    ) -> None:
        found = [half for one in closures for half in rod_halves_in(state.plan, one)]
        self.links = tuple(
            RodHalfMotion(state, motion, half, loops)
            for half in found
            if not {*half.joints, half.carrier - 1}.intersection(apart)
        )
        motion.rod_halves = self.links

    def by(self, step: CloseLoop) -> RodHalfMotion | None:
        """Return the link that a weld fixes; None where it fixes none."""
        return next((each for each in self.links if each.half.closing == step), None)

    def at(self, j: int) -> RodHalfMotion | None:
        """Return the rod half whose ball includes a joint; None if there is none."""
        return next((each for each in self.links if j in each.half.joints), None)

    def without(self, steps: Iterable[Eliminate], closure: int) -> list[Eliminate]:
        """Return the elimination of a closure's unknowns, lane by lane, without those of balls."""
        own = [each.half for each in self.links if each.half.closing.closure == closure]
        moved = {k for half in own for k in half.freedoms}
        rows = {k for half in own for k in half.turns}
        return [
            replace(
                step,
                moved=tuple(k for k in step.moved if k not in moved),
                rows=tuple(row for row in step.rows if row not in rows),
                scales=tuple(
                    scale
                    for row, scale in zip(step.rows, step.scales, strict=True)
                    if row not in rows
                ),
            )
            for step in steps
        ]
