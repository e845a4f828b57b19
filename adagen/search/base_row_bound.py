"""Bound for the rows next to the base, which are narrow: their cost beyond that of full rows.

A process passes rows one after the other, none before what its joints hang on. So its first d rows
hold joints alone that have fewer than d others before them on their own limb. An arm has one joint
there for each row, however many fingers hang at its end. This is Hu's bound on the levels of a
forest (Operations Research 9, 1961, pp. 841-848), with rows that cost less by the joint the wider
they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

_TOLERANCE = 1e-12


@dataclass(frozen=True)
class Levels:
    """How deep the joints of a limb are that are of one kind.

    Attributes:
        within: how many there are on the first d levels of the limb, for d = 1, 2, ... up to the
            robot's depth; without those of ``filling``.
        depth: levels of the limb.
        filling: joints that take hardly less in a full row than in one of their own, as those on
            the ground: they may be in any row, and are on no level.
    """

    within: NDArray[np.int64]
    depth: int
    filling: int


def together(limbs: Sequence[Levels]) -> Levels:
    """Return the levels of some limbs, one at least, that one process has."""
    depth = max(limb.depth for limb in limbs)
    within = limbs[0].within[:depth]
    for limb in limbs[1:]:
        within = within + limb.within[:depth]
    return Levels(within, depth, sum(limb.filling for limb in limbs))


class FirstRows:
    """What the first rows of a process take besides the shares of full rows, for one kind of joint.

    That is a linear program: so many rows, each of so many joints on the first levels and so many
    that fill, none of more than are there. Its dual has few vertices, each of which is a bound.

    Args:
        above: what a joint takes above its share of a full row in a row of 1, 2, ... joints.
        again: what a row takes that holds nothing but a joint which other processes pass, too, as
            in a core; None where no joint is passed twice.
    """

    def __init__(self, above: Sequence[float], again: float | None = None) -> None:
        self.rows = [
            (own, filling, own * above[own + filling - 1])
            for own in range(1, len(above) + 1)
            for filling in range(len(above) - own + 1)
        ]
        self.rows += [] if again is None else [(0, 0, again)]
        found = list(self._vertices())
        self._row, self._own, self._filling = (np.array(each) for each in zip(*found, strict=True))

    def _vertices(self) -> set[tuple[float, float, float]]:
        """The vertices of what a row is worth, a joint on the first levels, and one that fills."""
        sides = [(1.0, -1.0 * own, -1.0 * fill, price) for own, fill, price in self.rows]
        sides += [(0.0, -1.0, 0.0, 0.0), (0.0, 0.0, -1.0, 0.0)]
        rows, limits = np.array([s[:3] for s in sides]), np.array([s[3] for s in sides])
        found = {(0.0, 0.0, 0.0)}
        for three in combinations(range(len(sides)), 3):
            own = rows[list(three)]
            if abs(np.linalg.det(own)) < _TOLERANCE:
                continue
            vertex = np.linalg.solve(own, limits[list(three)])
            if (rows @ vertex <= limits + _TOLERANCE).all():
                row, first, filling = (float(x) for x in vertex)
                found.add((row, first, filling))
        return found

    def least(self, levels: Levels, others: int) -> float:
        """Return the least that the first rows of one process take besides.

        Args:
            levels: of its limbs whose first rows are asked for, together.
            others: joints of other limbs that may be in these rows.
        """
        if not levels.depth:
            return 0.0
        rows = np.arange(1, levels.depth + 1)
        within = levels.within[: levels.depth]
        return float(self.of(rows, within, others + levels.filling).max())

    def of(
        self, rows: NDArray[np.int64], own: NDArray[np.int64], filling: int
    ) -> NDArray[np.float64]:
        """Return what some rows take besides at least; for several numbers of rows at once.

        Args:
            rows: how many.
            own: how many joints of the first levels there are for each.
            filling: how many that fill.
        """
        found = self._row[:, None] * rows - self._own[:, None] * own
        least: NDArray[np.float64] = (found - filling * self._filling[:, None]).max(axis=0)
        return least
