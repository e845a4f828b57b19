"""Run-time checks of the elimination of a closure's unknowns (elimination.py).

Each check is one comparison at run time. If it fails, another method of elimination is used, or the
pose is refused.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import SINGULAR, Check
from adagen.executor.dependent_parts import SolvedPart
from adagen.executor.front import Front
from adagen.executor.state import State
from adagen.graph import Expression, Factors, Regular, dot, total
from adagen.plan.digits import EPSILON
from adagen.plan.steps import Eliminate

Array = NDArray[Any]

FOLLOWS = 1e-3
"""How far a row that is left out may be from following, relative to its size: where loops are open
within their tolerance, it is so far."""

LEAST = {"double": 1e-7, "float": 1e-3}
"""Pivots of rows, brought to one size, below which a pose counts as singular."""

LEFT = {"double": 1e-8, "float": 1e-4}
"""How much of an inertia has to be left when others are eliminated; how closely made-up unknowns
have to be found again."""

MOST_LOST = 0.1
"""Digits that the size of G may cost, as a part of half of all."""


def failure_of(step: Eliminate) -> str:
    """Return the failure status of an evaluation in a poor pose."""
    return SINGULAR if step.recovers else "kLoopSingular"


class EliminationChecks:
    """Checks of one closure's elimination.

    Args:
        state: whose process it is.
        step: what follows from what.
        front: the closure.
    """

    def __init__(self, state: State, step: Eliminate, front: Front) -> None:
        self.state, self.step, self.front = state, step, front
        self.epsilon = EPSILON[state.plan.scalar]
        self.fails = failure_of(step)

    def _check(self, value: Expression, least: Expression | float, unknown: int, how: str) -> None:
        """Check that a value exceeds another; the failure names the owner of an unknown."""
        limit = self.state.graph.constant(least) if isinstance(least, float) else least
        self.state.checks.append(Check(value, limit, self.front.places[unknown], how))

    def regular(self, regular: Sequence[Regular], rows: Sequence[int]) -> None:
        """Check that the rows, brought to one size, are not singular."""
        least = LEAST[self.state.plan.scalar] ** 2
        for each in regular:
            self._check(each.square, each.beside * least, rows[each.row], self.fails)

    def size(self, found: Sequence[SolvedPart]) -> None:
        """Check A and G: where they are large, this choice of dependent accelerations is poor."""
        squares = []
        for each in found:
            own = _squares(np.concatenate([each.solved.across, each.solved.more], axis=1).flat)
            if each.part.count > 1 and own:
                own = list(self.state.rows.sum_of(np.array([total(own)]), each.part.count))
            squares += own
        if squares:
            limit = min(self.step.limit, MOST_LOST / self.epsilon**0.5)
            self._check(limit**2 - total(squares), 0.0, self.step.rows[0], self.fails)

    def left_out(self, rest: Array, whole: Array) -> None:
        """Check that the redundant rows follow from the kept ones in this pose, too.

        Args:
            rest: what of each row the kept ones leave, for what they leave free.
            whole: the rows.
        """
        for k, unknown in enumerate(self.step.followers):
            squares = _squares(rest[k])
            if squares:
                left = total(_squares(whole[k])) * FOLLOWS**2 - total(squares)
                self._check(left, 0.0, unknown, self.fails)

    def pushed(self, pushed: Array, found: Array) -> None:
        """Check that redundant rows act only on accelerations on which the kept ones act."""
        for k, unknown in enumerate(self.step.followers):
            own = self.front.entry(unknown, unknown)
            if own is not None:
                rest = own - dot(pushed[:, k], found[:, k])
                left = own * own * FOLLOWS**4 - rest * rest
                self._check(left, 0.0, unknown, self.fails)

    def inverse(self, every: Sequence[int], matrix: Array, diagonal: Sequence[Expression]) -> None:
        """Check that no pivot of the system of all unknowns has lost its digits."""
        lost = (16 * self.epsilon) ** 2
        for k, (unknown, pivot) in enumerate(zip(every, diagonal, strict=True)):
            least = total(_squares(matrix[:, k])) * lost
            self._check(pivot * pivot, least, unknown, self.fails)

    def known(self, matrix: Array, moving: int) -> tuple[Array, Array]:
        """Return known test values of the unknowns, and factors that scale their squares to one.

        Accelerations are 1, and forces such as make these.

        Args:
            matrix: of all unknowns.
            moving: how many of them are accelerations; they come first.
        """
        graph, known = self.state.graph, self.state.constants(np.ones(len(matrix)))
        sizes = known.copy()
        inertias = _squares(matrix[:moving, :moving].flat)
        pushes = _squares(matrix[:moving, moving:].flat)
        if inertias and pushes:
            made, pushed = total(inertias), total(pushes)
            known[moving:] = graph.sqrt(made * graph.reciprocal(pushed))
            sizes[moving:] = pushed * graph.reciprocal(made)
        return known, sizes

    def found_again(self, known: Array, sizes: Array, found: Array) -> None:
        """Check that the known test values are found again by solving the system.

        A pivot need not be next to nothing where digits are lost: joints of light links that come
        near one plane, a motion without inertia among many with. What is lost is seen in numbers
        that are known.
        """
        parts = zip(known, sizes, found, strict=True)
        off = total([(x - y) * (x - y) * size for x, size, y in parts])
        least = LEFT[self.state.plan.scalar] ** 2
        self._check(least - off, 0.0, self.step.rows[0], self.fails)

    def inertia(self, blamed: Sequence[int], factors: Factors, sizes: Array) -> None:
        """Check that no pivot of the inertia has lost its digits, nor an entry as a sum.

        Where some are lost and not all, as of light links near gimbal lock, another way may keep
        them.
        """
        lost, most = 16 * self.epsilon, LEFT[self.state.plan.scalar]
        found = zip(blamed, factors.pivots, factors.diagonal, sizes, strict=True)
        for unknown, pivot, entry, size in found:
            parts = [*([] if pivot == entry else [entry]), *([] if entry == size else [size])]
            whole = total(parts) if parts else self.state.graph.constant(0)
            if not self.step.recovers:
                self._check(pivot, whole * lost, unknown, "kLoopFree")
            if parts or self.step.recovers:
                self._check(pivot, whole * most, unknown, self.fails)


def _squares(values: Iterable[Expression]) -> list[Expression]:
    """The squares of those values that are not known to be zero."""
    return [x * x for x in values if x.constant != 0]
