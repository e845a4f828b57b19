"""Motions that the constraint rows of a closure allow, while dependent parts are eliminated.

Similar arms may have motions that do not affect the other arms, such as the spin of a rod on two
balls. These are solved for first, all arms side by side.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.dependent_parts import SolvedPart, by_lanes
from adagen.executor.front import Freed, Solved, alone
from adagen.executor.rows import Rows
from adagen.graph import dot, factorize, matrix_times
from adagen.plan.arms import WideUnknown

Array = NDArray[Any]


@dataclass(frozen=True)
class SolvedFreeMotions:
    """Independent accelerations of single arms, solved for side by side.

    Attributes:
        solved: how they follow from the others.
        freed: their inertia's factors, and what a certificate needs beside them.
        before: their inertias were nothing to follow from them, shape (n,).
        gives: what they take from the top: of its inertia and bias, shape (6, 6 + columns).
    """

    solved: Solved
    freed: Freed
    before: Array
    gives: Array


class FreeMotions:
    """Independent accelerations y: y^T R y / 2 + y^T (B a + c), a the top's acceleration.

    Args:
        rows: joints and arms that share lanes.
        numbers: of y.
        square: R, shape (n, n).
        across: B, shape (n, 6).
        bias: c, shape (n, columns).

    Attributes:
        alone: inertias of y where nothing follows from them, shape (n,): what follows adds to R or
            takes it away, and digits are lost where little is left of these.
    """

    def __init__(
        self, rows: Rows, numbers: Sequence[int], square: Array, across: Array, bias: Array
    ) -> None:
        self.rows, self.numbers = rows, tuple(numbers)
        self.square, self.across, self.bias = square, across, bias
        self.alone = np.array([square[k, k] for k in range(len(square))], dtype=object)

    def take(self, each: SolvedPart) -> None:
        """Add the contribution of a dependent block, z = A a + G y + g."""
        a, g, offset = each.solved.across, each.solved.more, each.solved.bias
        half = each.between + matrix_times(g.T, each.own)
        for value in (matrix_times(half, g), matrix_times(g.T, each.between.T)):
            self.square = self._with_square(each, value)
        for value in (matrix_times(g.T, each.at_top), matrix_times(half, a)):
            self.across = self._with_rows(each, self.across, value)
        for value in (matrix_times(g.T, each.biases), matrix_times(half, offset)):
            self.bias = self._with_rows(each, self.bias, value)

    def places(self, each: SolvedPart) -> list[WideUnknown]:
        """Return the indices of a block's y among all, by lanes."""
        place = {u: k for k, u in enumerate(self.numbers)}
        every = (
            tuple(place[u] for u in wide_unknown if u in place) for wide_unknown in each.part.others
        )
        return [places for places in every if places]

    def _with_rows(self, each: SolvedPart, rows: Array, added: Array) -> Array:
        if each.part.count == 1:
            return rows + added
        result = rows.copy()
        for places, row in zip(self.places(each), added, strict=True):
            self._add_at(each, result, places, row)
        return result

    def _with_square(self, each: SolvedPart, added: Array) -> Array:
        if each.part.count == 1:
            return self.square + added
        result, every = self.square.copy(), self.places(each)
        for i, k in np.ndindex(added.shape):
            self._add_at(each, result, by_lanes(every[i], every[k]), added[i, k])
        return result

    def _add_at(self, each: SolvedPart, to: Array, places: Sequence[Any], value: Any) -> None:
        """Add the sum over all lanes to one place, or each lane to a place of its own."""
        count, value = each.part.count, np.array(value, object)
        if len(places) == 1:
            to[places[0]] = to[places[0]] + self.rows.sum_of(value, count)[()]
            return
        there = self.rows.together([np.array(to[place], object) for place in places])
        lanes = self.rows.each(np.array(there + value, object), count)
        for place, own in zip(places, lanes, strict=True):
            to[place] = own[()]

    def solve_own(self, each: SolvedPart) -> SolvedFreeMotions | None:
        """Solve for the y that only one lane's block uses; None if there are none."""
        own = [places for places in self.places(each) if len(places) > 1]
        if not own:
            return None
        left = sorted({*range(len(self.numbers))}.difference(*own))
        m, numbers = len(left), self.numbers
        to_others = self._wide(own, [(k,) for k in left])
        rest = [
            np.array([self.rows.together([x[k] for k in places]) for places in own])
            for x in (self.across, self.bias)
        ]
        parts = ([self.alone[k] for k in places] for places in own)
        before = np.array(list(map(self.rows.joined, parts)), dtype=object)
        factors = factorize(self._wide(own, own))
        half = factors.forward(np.concatenate([to_others, *rest], axis=1))
        over = factors.scaled(half)
        found = -factors.backward(over)
        wide_unknown = tuple(tuple(numbers[k] for k in places) for places in own)
        others = alone(numbers[k] for k in left)
        solved = Solved(wide_unknown, found[:, m : m + 6], others, found[:, :m], found[:, m + 6 :])
        gives = self.rows.sum_of(matrix_times(half.T, over), each.part.count)
        square, across, bias = self.square[np.ix_(left, left)], self.across[left], self.bias[left]
        self.square, self.across = square - gives[:m, :m], across - gives[:m, m : m + 6]
        self.bias, self.numbers = bias - gives[:m, m + 6 :], tuple(numbers[k] for k in left)
        self.alone = self.alone[left]
        process = self.rows.process
        weighed = process.plan.certified
        energy = dot(half[:, m + 6], over[:, m + 6]) if weighed else process.graph.constant(0)
        freed = Freed(wide_unknown, factors, energy, others, over[:, :m])
        return SolvedFreeMotions(solved, freed, before, gives[m : m + 6, m:])

    def _wide(self, some: Sequence[WideUnknown], others: Sequence[WideUnknown]) -> Array:
        """Entries of R by index, of similar arms as wide values."""
        result = np.empty((len(some), len(others)), dtype=object)
        for i, k in np.ndindex(result.shape):
            pairs = by_lanes(some[i], others[k])
            result[i, k] = self.rows.joined([self.square[p] for p in pairs])
        return result
