"""Elimination of a closure's unknowns at its top (adagen/plan/steps/closed.py).

There are three methods. Dependent accelerations follow from independent ones by the rows,
z = G y + g; or all follow from an orthogonal basis of the null space of the rows, w = N y + g; or
all unknowns are solved for at once, where rows are coupled through eliminated joints. The first two
leave y, whose inertia is positive definite.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.dependent_parts import Part, SolvedPart, as_wide_unknown, by_lanes, followed
from adagen.executor.elimination_checks import EliminationChecks
from adagen.executor.free_motions import FreeMotions, SolvedFreeMotions
from adagen.executor.front import (
    Followed,
    Freed,
    Front,
    Push,
    Pushed,
    Reduced,
    Solved,
    alone,
)
from adagen.executor.row_basis import RowBasis
from adagen.executor.state import State
from adagen.graph import (
    Regular,
    dot,
    factorize,
    matrix_times,
    solved_by_blocks,
    solved_by_reflections,
    total,
)
from adagen.plan.arms import WideUnknown
from adagen.plan.steps import Eliminate

Array = NDArray[Any]
Unknowns = Sequence[int | WideUnknown]
"""Unknowns by number; of alike arms together, one for each lane."""


class Elimination:
    """Eliminates the unknowns of one closure.

    Args:
        state: whose process it is.
        lanes: what follows from what: of closures that go side by side, one for each lane.
        front: the closure.
    """

    def __init__(self, state: State, lanes: Sequence[Eliminate], front: Front) -> None:
        self.state, self.lanes, self.front = state, lanes, front
        self.step = step = lanes[0]
        self.checks = EliminationChecks(state, step, front)
        self.columns = front.columns.pop(step.link, {}) if step.link else {}

    def run(self) -> None:
        """Eliminate by the method that the rows allow and the step asks for."""
        step = self.step
        forces = (*step.rows, *step.followers)
        self._begin_forces()
        if any(self.front.entry(i, k) is not None for i in forces for k in forces):
            self._solve_all()
        elif step.rows and not step.moved:
            self._follow_basis()
        else:
            self._follow()
        if step.link:
            tops = [lane.link for lane in self.lanes]
            closures = tuple(dict.fromkeys(lane.closure for lane in self.lanes))
            for name, value in self.front.passed.items():
                self.state.eliminated[name, closures] = value
                self.state.rows.add(name, tops, len(closures), value)

    # -- the closure's function -------------------------------------------------------------------

    def _block(self, rows: Unknowns, columns: Unknowns) -> Array:
        """Part of E, shape (rows, columns)."""
        block, zero = self.state.zeros(len(rows), len(columns)), self.state.graph.constant(0)
        for i, row in enumerate(rows):
            for k, column in enumerate(columns):
                each = [self.front.entry(*pair) for pair in by_lanes(row, column)]
                if any(entry is not None for entry in each):
                    block[i, k] = self.state.rows.joined([zero if x is None else x for x in each])
        return block

    def _biases(self, unknowns: Unknowns) -> Array:
        """Part of e, shape (n, columns)."""
        result = self.state.zeros(len(unknowns), self.state.columns)
        for k, own in enumerate(unknowns):
            result[k] = self.state.rows.together([self.front.bias[u] for u in as_wide_unknown(own)])
        return result

    def _at_top(self, unknowns: Unknowns) -> Array:
        """Part of C^T at the top, shape (n, 6)."""
        result, nothing = self.state.zeros(len(unknowns), 6), self.state.zeros(6)
        for k, own in enumerate(unknowns):
            if not self.columns.keys().isdisjoint(as_wide_unknown(own)):
                each = [self.columns.get(u, nothing) for u in as_wide_unknown(own)]
                result[k] = self.state.rows.together(each)
        return result

    def _by_others(self, rows: Unknowns, others: Unknowns) -> Array:
        """Effect of the top's acceleration and of other unknowns on rows, shape (n, 6 + m)."""
        grounded = self.step.grounded  # else what both ends do to the top cancels
        at_top = self._at_top(rows) if grounded else self.state.zeros(len(rows), 6)
        return np.concatenate([at_top, self._block(rows, others)], axis=1)

    def _scales(self) -> Array:
        """Factors that bring the kept rows to one size, shape (rows,)."""
        each = [self.state.constants(lane.scales) for lane in self.lanes]
        return self.state.rows.packed(each)

    def _begin_forces(self) -> None:
        """Begin to record what constraint forces follow from, if they are requested."""
        if self.state.plan.loop_forces or self.state.plan.weighed:
            step = self.step
            by_kept = self.state.zeros(len(step.followers), len(step.rows))
            self.front.pushed = Pushed(step.rows, (), step.followers, by_kept)

    def _keep_forces(
        self,
        rows: Sequence[WideUnknown],
        moving: Sequence[WideUnknown],
        others: Sequence[WideUnknown],
        solve: Callable[[Array], Array] | None = None,
    ) -> None:
        """Record what forces of rows follow from: the rows' effect on accelerations.

        Args:
            rows: numbers of the forces.
            moving: accelerations that they push, at least as many.
            others: all accelerations that these feel, themselves among them.
            solve: finds forces from what pushes accelerations; None: they are solved for anew.
        """
        step, kept = self.step, self.front.pushed
        if kept is None or kept.parts is None:
            return
        pushes = self._block(rows, moving)
        part = Push(
            tuple(rows),
            solve or (lambda pull: solved_by_reflections(pushes.T.copy(), pull)[0]),
            tuple(others),
            self._block(moving, others),
            self._at_top(moving),
            self._biases(moving),
        )
        self.front.pushed = replace(kept, parts=(*kept.parts, part))
        if self.state.plan.loop_forces and step.followers and rows:
            left_out = self._block(step.followers, moving)
            found = solved_by_reflections(pushes.T.copy(), left_out.T.copy())[0].T
            for k, wide_unknown in enumerate(rows):
                each = self.state.rows.each(found[:, k], len(wide_unknown))
                for unknown, column in zip(wide_unknown, each, strict=True):
                    kept.by_kept[:, step.rows.index(unknown)] = column

    # -- three ways -------------------------------------------------------------------------------

    def _follow(self) -> None:
        """By a choice: z = A a + G y + g by the rows, then y; a is the top's acceleration."""
        y = self.step.singles
        found = [self._solved_part(part) for part in followed(self.front, self.step)]
        self.checks.size(found)
        self.checks.left_out(*self._left_out(found))
        square, across, bias = self._block(y, y), self._at_top(y), self._biases(y)
        free = FreeMotions(self.state.rows, y, square, across, bias)
        for each in found:
            self.front.solved.append(each.solved)
            part = each.part
            others = (*part.others, *part.moved)
            self._keep_forces(part.rows, part.moved, others, _solves_by(each.by_rows))
            free.take(each)
            self._move_top(each)
        free.square = _symmetric(free.square) if found else free.square
        freed = [self._keep_own(own) for each in found if (own := free.solve_own(each))]
        if numbers := free.numbers:
            left = free.square, free.across, free.bias
            freed.append(self._solve_free(numbers, numbers, free.alone, *left))
        self._keep_reduced([_followed(each) for each in found], freed)

    def _keep_own(self, own: SolvedFreeMotions) -> Freed:
        """Store independent accelerations of single arms; subtract their effect from the top."""
        self.front.solved.append(own.solved)
        blamed = [wide_unknown[0] for wide_unknown in own.solved.unknowns]
        self.checks.inertia(blamed, own.freed.factors, own.before)
        if self.step.link:
            self.front.hand("IA", _symmetric(-own.gives[:, :6]))
            self.front.hand("pA", -own.gives[:, 6:])
        return own.freed

    def _solved_part(self, part: Part) -> SolvedPart:
        """Solve the rows of a block for its dependent accelerations."""
        rows, z, others = part.rows, part.moved, part.others
        scale_of = dict(zip(self.step.rows, self._scales(), strict=True))
        scales = [
            self.state.rows.joined([scale_of[row] for row in wide_unknown]) for wide_unknown in rows
        ]
        right = np.concatenate([self._by_others(rows, others), self._biases(rows)], axis=1)
        count, last = 6 + len(others), len(right.T)
        right = np.concatenate([right, self._parted(np.ones(len(rows)))], axis=1)
        solved, regular = solved_by_blocks(self._block(rows, z), right, np.array(scales, object))
        self.checks.regular(regular, [wide_unknown[0] for wide_unknown in rows])
        gained = -solved[:, :last]
        return SolvedPart(
            part,
            Solved(z, gained[:, :6], others, gained[:, 6:count], gained[:, count:]),
            self._block(others, z),
            self._block(z, z),
            self._at_top(z),
            self._biases(z),
            solved[:, last:],
        )

    def _follow_basis(self) -> None:
        """By an orthogonal basis N of the rows' null space, w = N y + g: J^T = Q R, N in Q."""
        step, w, count = self.step, self.step.singles, len(self.step.rows)
        rows = RowBasis(self.state, self._block(step.rows, w).T, self._scales())
        regular = [Regular(k, x * x, 1.0) for k, x in enumerate(rows.pivots)]
        self.checks.regular(regular, step.rows)
        n, offset = rows.motions(self._biases(step.rows))
        left_out = self._block(step.followers, w)
        self.checks.left_out(matrix_times(left_out, n) if step.followers else left_out, left_out)
        y = tuple(-1 - k for k in range(len(w) - count))
        self.front.solved.append(Solved(alone(w), self.state.zeros(len(w), 6), alone(y), n, offset))
        at_top, half = self._at_top(w), matrix_times(n.T, self._block(w, w))
        bias = matrix_times(n.T, self._biases(w)) + matrix_times(half, offset)
        self._keep_forces(alone(step.rows), alone(w), alone(w), rows.forces)
        self._push_top(at_top, offset)
        own, left = np.diag(self._block(w, w)), _symmetric(matrix_times(half, n))
        sizes = matrix_times((n * n).T, own)
        freed = self._solve_free(y, w[: len(y)], sizes, left, matrix_times(n.T, at_top), bias)
        if self.state.plan.certified:
            self._keep_reduced([self._moved(rows, y, n, own)], [freed] if y else [])

    def _moved(self, rows: RowBasis, y: Sequence[int], n: Array, own: Array) -> Followed:
        """How unknowns follow from a basis, and how residuals of rows move them.

        By these they move along as many directions at right angles, none of which takes more than
        the unknown that takes most: where Q turns them does not matter.
        """
        w, none = alone(self.step.singles), self.state.zeros(len(n), 6)
        most = np.full(rows.count, reduce(self.state.graph.larger, own), dtype=object)
        return Followed(w, alone(y), n, none, alone(self.step.rows), rows.moves, most)

    def _solve_all(self) -> None:
        """All unknowns at once, where rows are coupled through eliminated joints."""
        step = self.step
        every = (*step.singles, *step.moved, *step.rows)
        matrix = self._block(every, every)
        across, bias = self._at_top(every), self._biases(every)
        pushed = self._block(every, step.followers)
        known, sizes = self.checks.known(matrix, len(every) - len(step.rows))
        right = np.concatenate([across, bias, pushed, matrix_times(matrix, known)[:, None]], axis=1)
        whole, diagonal = solved_by_reflections(matrix, right)
        self.checks.inverse(every, matrix, diagonal)
        self.checks.found_again(known, sizes, whole[:, -1])
        count = 6 + self.state.columns
        whole = whole[:, :-1]
        self.checks.pushed(pushed, whole[:, count:])
        if self.state.plan.loop_forces or self.state.plan.weighed:
            by_kept = whole[len(every) - len(step.rows) :, count:].T
            self.front.pushed = Pushed(step.rows, None, step.followers, by_kept)
        self._found(every, across, whole[:, :count])

    # -- parts ------------------------------------------------------------------------------------

    def _left_out(self, found: Sequence[SolvedPart]) -> tuple[Array, Array]:
        """Remainders of the redundant rows after the kept ones, for y, and the rows."""
        step = self.step
        rest, block = self._by_others(step.followers, step.singles), self._block
        whole = np.concatenate([rest, block(step.followers, step.moved)], axis=1)
        for each in found if step.followers else ():
            for lane in range(each.part.count):
                z = [wide_unknown[lane] for wide_unknown in each.part.moved]
                own = self.state.rows.each(each.solved.more, each.part.count)[lane]
                across = self.state.rows.each(each.solved.across, each.part.count)[lane]
                gained = self.state.zeros(len(z), rest.shape[1])
                gained[:, :6] = across
                for c, wide_unknown in enumerate(each.part.others):
                    place = step.singles.index(wide_unknown[lane % len(wide_unknown)])
                    gained[:, 6 + place] = own[:, c]
                rest = rest + matrix_times(block(step.followers, z), gained)
        return rest, whole

    # -- what is left -----------------------------------------------------------------------------

    def _solve_free(
        self,
        y: Sequence[int],
        blamed: Sequence[int],
        sizes: Array,
        reduced: Array,
        across: Array,
        bias: Array,
    ) -> Freed:
        """Solve for the independent accelerations by their inertia: each pivot has to be positive.

        Args:
            y: numbers that it is found by.
            blamed: unknowns that a failure's message names.
            sizes: of what each inertia is made of, shape (n,).
            reduced: its inertia.
            across: what it does to the top, shape (n, 6).
            bias: shape (n, columns).
        """
        factors = factorize(reduced)
        self.checks.inertia(blamed, factors, sizes)
        found = factors.solve(np.concatenate([across, bias], axis=1))
        self._found(y, across, found)
        weighed = self.state.plan.certified
        energy = dot(bias[:, 0], found[:, 6]) if weighed else self.state.graph.constant(0)
        return Freed(alone(y), factors, energy, (), self.state.zeros(len(y), 0))

    # -- what certificates need -------------------------------------------------------------------

    def _parted(self, sizes: Array) -> Array:
        """Unit residuals of each row, times a size, shape (rows, rows); empty if not needed."""
        if not self.state.plan.certified:
            return self.state.zeros(len(sizes), 0)
        zero, parted = self.state.graph.constant(0), self.state.zeros(len(sizes), len(sizes))
        for k, size in enumerate(sizes):
            parted[k, k] = zero + size
        return parted

    def _keep_reduced(self, followed: Sequence[Followed], freed: Sequence[Freed]) -> None:
        """Record how unknowns were eliminated, for certificates."""
        if self.state.plan.certified:
            self.front.reduced = Reduced(tuple(followed), tuple(freed))

    def _found(self, unknowns: Sequence[int], across: Array, found: Array) -> None:
        """Store unknowns as functions of the top's acceleration; take their effect off the top."""
        none = self.state.zeros(len(unknowns), 0)
        self.front.solved.append(Solved(alone(unknowns), -found[:, :6], (), none, -found[:, 6:]))
        if not self.step.link:
            return
        inertia = self.state.zeros(6, 6)
        for i in range(6):
            for k in range(i, 6):
                inertia[i, k] = inertia[k, i] = -dot(across[:, i], found[:, k])
        self.front.hand("IA", inertia)
        self.front.hand("pA", -matrix_times(across.T, found[:, 6:]))

    def _move_top(self, each: SolvedPart) -> None:
        """Effect of accelerations z = A a + g on the top, whose acceleration is a."""
        across, offset, count = each.solved.across, each.solved.bias, each.part.count
        if self.step.link and any(x.constant != 0 for x in across.flat):
            added = matrix_times(across.T, each.at_top + matrix_times(each.own, across))
            added = added + matrix_times(each.at_top.T, across)
            self._hand("IA", _symmetric(added), count)
            pushed = each.biases + matrix_times(each.own, offset)
            self._hand("pA", matrix_times(across.T, pushed), count)
        self._push_top(each.at_top, offset, count)

    def _push_top(self, at_top: Array, offset: Array, count: int = 1) -> None:
        """Effect on the top of accelerations that follow from the rows alone."""
        if self.step.link:
            self._hand("pA", matrix_times(at_top.T, offset), count)

    def _hand(self, name: str, value: Array, count: int) -> None:
        """Add the contribution of a number of arms to the top."""
        self.front.hand(name, self.state.rows.sum_of(value, count))


def _followed(each: SolvedPart) -> Followed:
    """The data that a certificate needs of a block."""
    part, solved, own = each.part, each.solved, np.diag(each.own)

    def moves(parted: Array) -> Array:
        return np.array([total(by * by * parted) for by in each.by_rows], dtype=object)

    return Followed(part.moved, part.others, solved.more, solved.across, part.rows, moves, own)


def _solves_by(inverse: Array) -> Callable[[Array], Array] | None:
    """A solver by the inverse of the rows' matrix, where that is known."""
    return (lambda pull: matrix_times(inverse.T, pull)) if inverse.size else None


def _symmetric(matrix: Array) -> Array:
    """A symmetric matrix from the lower triangle of one that is symmetric up to rounding."""
    result = matrix.copy()
    lower = np.tril_indices(len(matrix), -1)
    result.T[lower] = result[lower]
    return result
