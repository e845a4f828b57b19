"""State of a closure during the inward sweep: its front, as in multifrontal elimination."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import combinations_with_replacement
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.graph import Expression, Factors
from adagen.plan.arms import Arms, WideUnknown
from adagen.plan.steps import AccelerateHeld

Array = NDArray[Any]


def alone(unknowns: Iterable[int]) -> tuple[WideUnknown, ...]:
    """Return unknowns as wide unknowns of one lane."""
    return tuple((unknown,) for unknown in unknowns)


@dataclass(frozen=True)
class Solved:
    """Eliminated unknowns as functions of the top and others: w = across a + more w' + bias.

    Attributes:
        unknowns: their numbers, those of alike arms together, lane by lane.
        across: shape (n, 6).
        others: numbers of the others likewise; single ones are the same in all lanes.
        more: shape (n, m).
        bias: shape (n, columns).
    """

    unknowns: tuple[WideUnknown, ...]
    across: Array
    others: tuple[WideUnknown, ...]
    more: Array
    bias: Array


@dataclass(frozen=True)
class Push:
    """Equations for the forces of some kept rows: rows^T w = -(inertia w' + across a + bias).

    Attributes:
        kept: numbers of their forces, those of alike arms together, lane by lane.
        solve: finds rows^-T of what they push, shape (m, 1), of as many accelerations or more.
        others: numbers w' of all accelerations likewise; single ones are the same in all lanes.
        inertia: shape (n, m).
        across: shape (n, 6).
        bias: shape (n, columns).
    """

    kept: tuple[WideUnknown, ...]
    solve: Callable[[Array], Array]
    others: tuple[WideUnknown, ...]
    inertia: Array
    across: Array
    bias: Array


@dataclass(frozen=True)
class Pushed:
    """Equations for the forces of kept rows, block by block.

    Attributes:
        kept: numbers of their forces.
        parts: what they follow from; None where they are found with the accelerations.
        left_out: numbers of the forces of rows that follow from these.
        by_kept: the rows that were left out by those kept, shape (left_out, kept).
    """

    kept: tuple[int, ...]
    parts: tuple[Push, ...] | None
    left_out: tuple[int, ...]
    by_kept: Array


@dataclass(frozen=True)
class Opening:
    """A loop whose opening rate is checked once its rows have passed all joints.

    Attributes:
        place: what is blamed.
        fastest: the square of how fast it may open.
        rows: numbers of its rows' forces, those of alike arms together.
        turning: how fast its links turn against each other, of one that hangs on a ball.
    """

    place: int
    fastest: Expression
    rows: tuple[WideUnknown, ...]
    turning: tuple[Expression, ...] = ()


@dataclass(frozen=True)
class End:
    """One end of a loop, at a link.

    Attributes:
        links: one for each lane.
        count: how many of these lanes count; idle ones repeat the last.
        columns: what a unit of each row's force does to it, shape (6,), by the force's number; by
            those of alike arms together.
        arm: where the loop is in the link's frame, shape (3,).
    """

    links: tuple[int, ...]
    count: int
    columns: dict[WideUnknown, Array]
    arm: Array


@dataclass(frozen=True)
class Followed:
    """Data of dependent unknowns for a certificate.

    Attributes:
        unknowns: their numbers, those of alike arms together, lane by lane.
        others: numbers of those that they follow from, unknowns or of a basis.
        gained: how they follow from these, shape (n, m).
        across: how they follow from the top's acceleration, shape (n, 6).
        rows: numbers of the rows' forces.
        moves: finds from squares of what these part by, shape (rows,), squares of how far they
            move, or as many directions at right angles as there are rows, shape (m,).
        inertia: of each of these alone, or at most, shape (m,).
    """

    unknowns: tuple[WideUnknown, ...]
    others: tuple[WideUnknown, ...]
    gained: Array
    across: Array
    rows: tuple[WideUnknown, ...]
    moves: Callable[[Array], Array]
    inertia: Array


@dataclass(frozen=True)
class Freed:
    """Data of independent unknowns for a certificate.

    Attributes:
        unknowns: their numbers, those of alike arms together, lane by lane; or of a basis.
        factors: of their inertia.
        energy: what they take of the square of the energy norm, were all others at rest.
        others: numbers of those that are solved for after them.
        gained: how they follow from these, shape (n, m).
    """

    unknowns: tuple[WideUnknown, ...]
    factors: Factors
    energy: Expression
    others: tuple[WideUnknown, ...]
    gained: Array


@dataclass(frozen=True)
class Reduced:
    """Data of a closure's eliminated unknowns for a certificate, in order."""

    followed: tuple[Followed, ...]
    freed: tuple[Freed, ...]


@dataclass
class Front:
    """State of a closure during the inward sweep.

    Attributes:
        columns: C by link and unknown, shape (6,) each.
        points: where forces at links act by which columns of C are made, shape (3,), likewise.
        square: E by pairs of unknowns, the smaller one first; those that are not there are zero.
        bias: e by unknown, shape (columns,).
        waiting: what loops by themselves add to it, where that waits for what others tell.
        solved: what has been eliminated, in the order in which it is found outwards.
        carried: joints that were articulated, with their rows of C, by unknown, shape (n,) each.
        found: w by unknown, shape (columns,), on the way outwards.
        ties: unknowns of couplings with factors, by joint.
        places: what each unknown is blamed on: its joint; a loop, coupling, counted behind joints.
        first: number of the first unknown of each joint that was held back.
        pushed: what forces of rows follow from, where they are asked for.
        loops: rows of loops, where forces are asked for: by loop the force's number, as in
            `End.columns`, whether it is a force and no moment, and its direction in frame 2, shape
            (3,).
        couplings: by coupling the number of its force, None for none.
        opening: loops of which is looked at how fast they open, once all is held back.
        speeds: of freedoms that are held back, by unknown.
        lanes: loops and couplings that share lanes, by the place of the first.
        passed: what joints next to the top hand on to it, "IA" and "pA", until its unknowns are
            eliminated.
        ends: of its loops, on links that move.
        forces: of kept rows, by number, where answers are corrected or certified.
        reduced: how its unknowns were eliminated, where answers are certified.
        gaps: how rows part by the answer, where that is weighed by itself, as in `End.columns`.
        arms: of the closure, that share lanes.
        outwards: joints whose accelerations wait for what they join.
    """

    columns: dict[int, dict[int, Array]] = field(default_factory=dict)
    points: dict[int, dict[int, Array]] = field(default_factory=dict)
    square: dict[tuple[int, int], Expression] = field(default_factory=dict)
    bias: dict[int, Array] = field(default_factory=dict)
    waiting: dict[int, Array] = field(default_factory=dict)
    solved: list[Solved] = field(default_factory=list)
    carried: dict[int, dict[int, Array]] = field(default_factory=dict)
    found: dict[int, Array] = field(default_factory=dict)
    ties: dict[int, list[tuple[int, Expression]]] = field(default_factory=dict)
    places: dict[int, int] = field(default_factory=dict)
    first: dict[int, int] = field(default_factory=dict)
    pushed: Pushed | None = None
    loops: dict[int, list[tuple[WideUnknown, bool, Array]]] = field(default_factory=dict)
    couplings: dict[int, int | None] = field(default_factory=dict)
    opening: list[Opening] = field(default_factory=list)
    speeds: dict[int, Expression] = field(default_factory=dict)
    lanes: dict[int, tuple[int, ...]] = field(default_factory=dict)
    passed: dict[str, Array] = field(default_factory=dict)
    ends: list[End] = field(default_factory=list)
    forces: dict[int, Expression] = field(default_factory=dict)
    reduced: Reduced | None = None
    gaps: dict[WideUnknown, Expression] = field(default_factory=dict)
    arms: Sequence[Arms] = ()
    outwards: list[AccelerateHeld] = field(default_factory=list)

    def hand(self, name: str, value: Array) -> None:
        """Add to the inertia or bias force that is passed to the top."""
        self.passed[name] = self.passed[name] + value if name in self.passed else value

    def add_column(
        self, link: int, unknown: int, column: Array, point: Array | None = None
    ) -> None:
        """Add to the column of C that couples an unknown and a link's acceleration.

        Args:
            link: number of the link.
            unknown: of the unknown.
            column: shape (6,).
            point: of a force, where it acts.
        """
        own, points = self.columns.setdefault(link, {}), self.points.setdefault(link, {})
        if unknown in own:
            column, point = own[unknown] + column, None
        own[unknown] = column
        points.pop(unknown, None)
        if point is not None:
            points[unknown] = point

    def add(self, i: int, k: int, value: Expression) -> None:
        """Add to an entry of E."""
        if value.constant == 0:
            return
        key = (min(i, k), max(i, k))
        self.square[key] = self.square[key] + value if key in self.square else value

    def entry(self, i: int, k: int) -> Expression | None:
        """Return an entry of E; None for zero."""
        return self.square.get((min(i, k), max(i, k)))

    def add_bias(self, unknown: int, value: Array) -> None:
        """Add to e, shape (columns,)."""
        self.bias[unknown] = self.bias[unknown] + value if unknown in self.bias else value

    def end_waiting(self) -> None:
        """Add the loops' own biases to e."""
        for unknown, value in self.waiting.items():
            self.add_bias(unknown, value)

    def shown(self, rows: int, zero: Expression) -> tuple[Array, Array]:
        """Return E of the rows, row by row from the diagonal on, and e, shape (rows, columns).

        Nothing else is unknown, so that rows are numbered from 0.
        """
        pairs = combinations_with_replacement(range(rows), 2)
        square = [zero if (entry := self.entry(*pair)) is None else entry for pair in pairs]
        return np.array(square, dtype=object), np.array([self.bias[k] for k in range(rows)])

    def take(self, square: Array, bias: Array) -> None:
        """Add another process's contribution to E and e."""
        pairs = combinations_with_replacement(range(len(bias)), 2)
        for pair, value in zip(pairs, square, strict=True):
            self.add(*pair, value)
        for unknown, value in enumerate(bias):
            self.add_bias(unknown, value)
