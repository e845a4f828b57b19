"""Blocks of dependent accelerations of a closure: similar arms together, then the rest."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import chain
from typing import Any

from numpy.typing import NDArray

from adagen.executor.front import Front, Solved, alone
from adagen.plan.arms import Arms, WideUnknown
from adagen.plan.steps import Eliminate

Array = NDArray[Any]


@dataclass(frozen=True)
class Part:
    """A block of dependent accelerations that follow from the others by rows of their own.

    Attributes:
        rows: numbers of the rows' forces; of alike arms, one for each lane.
        moved: of the accelerations likewise.
        others: of those that they follow from: of arms their own ones in lanes, then single ones.
    """

    rows: tuple[WideUnknown, ...]
    moved: tuple[WideUnknown, ...]
    others: tuple[WideUnknown, ...]

    @property
    def count(self) -> int:
        """Number of arms in the part."""
        return len(self.rows[0])


@dataclass(frozen=True)
class SolvedPart:
    """A solved block, z = A a + G y + g, and its contributions to the rest.

    Attributes:
        part: which.
        solved: A, G and g.
        between: E of y and z, shape (m, n).
        own: E of z, shape (n, n).
        at_top: C^T of z at the top, shape (n, 6).
        biases: e of z, shape (n, columns).
        by_rows: how z follow from what rows part by, shape (n, n); nothing where nobody asks.
    """

    part: Part
    solved: Solved
    between: Array
    own: Array
    at_top: Array
    biases: Array
    by_rows: Array


def followed(front: Front, step: Eliminate) -> list[Part]:
    """Return the blocks of dependent accelerations, each solved by itself."""
    parts = []
    rows, moved = set(step.rows), set(step.moved)
    for arms in front.arms:
        own = Part(
            tuple(wide_unknown for wide_unknown in arms.forces if wide_unknown[0] in rows),
            tuple(wide_unknown for wide_unknown in arms.freedoms if wide_unknown[0] in moved),
            _others(arms, step, moved),
        )
        if own.moved and len(own.moved) == len(own.rows) and _by_itself(front, step, own):
            parts.append(own)
            rows -= set(chain(*own.rows))
            moved -= set(chain(*own.moved))
    left = [u for u in step.moved if u in moved]
    if left:
        kept = [u for u in step.rows if u in rows]
        parts.append(Part(alone(kept), alone(left), alone(step.singles)))
    return parts


def _others(arms: Arms, step: Eliminate, moved: set[int]) -> tuple[WideUnknown, ...]:
    own = [wide_unknown for wide_unknown in arms.freedoms if wide_unknown[0] not in moved]
    taken = set(chain(*own))
    return (*own, *alone(u for u in step.singles if u not in taken))


def _by_itself(front: Front, step: Eliminate, part: Part) -> bool:
    """Whether each lane's rows and accelerations are independent of all other dependent ones."""
    for lane in range(part.count):
        rows, moved = (
            {wide_unknown[lane] for wide_unknown in some} for some in (part.rows, part.moved)
        )
        others = set(step.moved) - moved
        apart = [(i, k) for i in rows | moved for k in others]
        apart += [(i, k) for i in set(step.rows) - rows for k in moved]
        if any(front.entry(i, k) is not None for i, k in apart):
            return False
    return True


def as_wide_unknown(unknown: int | WideUnknown) -> WideUnknown:
    """Return an unknown's numbers, by lanes."""
    return unknown if isinstance(unknown, tuple) else (unknown,)


def by_lanes(one: int | WideUnknown, other: int | WideUnknown) -> list[tuple[int, int]]:
    """Return pairs of unknowns lane by lane; a single one is the same in all lanes."""
    a, b = as_wide_unknown(one), as_wide_unknown(other)
    return [(a[k % len(a)], b[k % len(b)]) for k in range(max(len(a), len(b)))]
