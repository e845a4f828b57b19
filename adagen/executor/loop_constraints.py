"""Constraints of loops in form `ada`, each with a right-hand side, solved at the end.

Every acceleration has a column for the given motion and one for a unit of each constraint force.
The relative accelerations of a loop's two frames follow from these, link by link; the constraint
forces make them zero. Accelerations of links are deviations from the reference field, as
everywhere. Joints that both ends of a loop have in common do not change its rows: both ends are
seen from their last common link, so processes need no data about the joints before it.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.executor.frames import columnwise
from adagen.executor.front import Front, Pushed
from adagen.executor.kinematics import Motion
from adagen.executor.loop_forces import give_forces
from adagen.executor.state import State
from adagen.graph import Expression, matrix_times, solved_by_reflections, total
from adagen.model.paths import common_link
from adagen.plan.digits import EPSILON

Array = NDArray[Any]

FOLLOWS = 1e-3
"""How much a row that is left out may part, beside what rows would without forces."""


class LoopConstraints:
    """The rows of all loops and couplings, after accelerations of all right-hand sides.

    Args:
        state: whose process it is.
        motion: its kinematics.
        front: has the rows; it is the only closure.
    """

    def __init__(self, state: State, motion: Motion, front: Front) -> None:
        self.state, self.motion, self.front = state, motion, front
        self.memory: dict[Any, Any] = state.memory
        self.links: dict[tuple[int, int], Array] = {}
        self.common = {
            unknown: common_link(state.plan.joints, state.plan.loops[loop].links)
            for loop, rows in front.loops.items()
            for wide_unknown, *_ in rows
            for unknown in wide_unknown
        }

    def values(self) -> dict[int, Array]:
        """Return the value of each row in every right-hand side, shape (columns,), by number."""
        found = {unknown: bias.copy() for unknown, bias in self.front.bias.items()}
        for link, columns in self.front.columns.items():
            for unknown, column in columns.items():
                a = self._acceleration(link, self.common[unknown])
                found[unknown] = found[unknown] + matrix_times(column[None, :], a)[0]
        for j, ties in self.front.ties.items():
            for unknown, factor in ties:
                found[unknown] = found[unknown] + self.memory["qdd", j][0] * factor
        return found

    def _acceleration(self, link: int, origin: int) -> Array:
        """A link's acceleration relative to a link inwards of it, shape (6, columns)."""
        if link == origin:
            return self.state.zeros(6, self.state.columns)
        if (link, origin) not in self.links:
            j, parent = link - 1, self.state.plan.joints[link - 1].parent
            a = columnwise(self.memory["X", j].motion, self._acceleration(parent, origin))
            drift = self.motion.drift(j)
            if drift is not None:
                a = a + drift
            a = a.copy()
            for k, row in enumerate(self.state.kind(j).free):
                a[row] = a[row] + self.memory["qdd", j][k]
            self.links[link, origin] = a
        return self.links[link, origin]

    def solve(self, others: list[Array], names: list[int]) -> Array:
        """Return the factors of right-hand sides that make all rows zero, shape (columns - 1,).

        Args:
            others: further rows that have to vanish, shape (columns,) each; they come first.
            names: what is to blame for these.
        """
        values, tied, plan = self.values(), self.state.plan.tied_rows, self.state.plan
        every = [*others, *(values[u] for u in tied), *self._lent()]
        rows = self.state.zeros(len(every), self.state.columns)
        for k, row in enumerate(every):
            rows[k] = row
        forces, diagonal = solved_by_reflections(rows[:, 1:], -rows[:, :1])
        blamed = [*names, *(self.front.places[u] for u in tied), *(j for j, _ in plan.lent)]
        lost = (16 * EPSILON[self.state.plan.scalar]) ** 2
        for k, (place, pivot) in enumerate(zip(blamed, diagonal, strict=True)):
            least = total([x * x for x in rows[:, 1 + k]]) * lost
            self.state.checks.append(Check(pivot * pivot, least, place, "kLoopSingular"))
        self._check_left_out(values, forces[:, 0])
        first = len(others)
        for k, unknown in enumerate(tied):
            self.front.found[unknown] = forces[first + k]
        if plan.loop_forces:
            self._give(values)
        return forces[:, 0]

    def _lent(self) -> list[Array]:
        """Rows that subtract the torques K qdd of artificial inertias."""
        rows = []
        for column, (j, k) in enumerate(self.state.plan.lent, -len(self.state.plan.lent)):
            row = self.memory["qdd", j][k].copy()
            row[column] = row[column] + 1.0 / self.state.plan.joints[j].lent
            rows.append(row)
        return rows

    def _check_left_out(self, values: dict[int, Array], forces: Array) -> None:
        """Check that redundant rows are zero, too."""
        zero: Expression = self.state.graph.constant(0)
        free = total([zero, *(value[0] * value[0] for value in values.values())])
        for unknown, value in values.items():
            if unknown not in self.state.plan.tied_rows:
                rest = total([value[0], *(value[1:] * forces)])
                left = (free + 1.0) * FOLLOWS**2 - rest * rest
                place = self.front.places[unknown]
                self.state.checks.append(Check(left, zero, place, "kLoopSingular"))

    def _give(self, values: dict[int, Array]) -> None:
        """Compute forces; redundant rows share them by the matrix F."""
        tied = self.state.plan.tied_rows
        left_out = tuple(unknown for unknown in values if unknown not in tied)
        by_kept = self.state.zeros(len(left_out), len(tied))
        if left_out:
            first = len(self.state.plan.slaved) + 1
            own = slice(first, first + len(tied))
            kept = np.array([values[u][own] for u in tied], dtype=object)
            others = np.array([values[u][own] for u in left_out], dtype=object)
            by_kept = solved_by_reflections(kept.T.copy(), others.T.copy())[0].T
        self.front.pushed = Pushed(tied, None, left_out, by_kept)
        give_forces(self.state, self.front, None)
