"""Residuals of a tree of hinges, swept inwards by a loop instead of statements.

A certified line of a robot with many joints has more code than a first instruction cache holds, and
then all of it is fetched in each evaluation. A certificate does the same for all joints: the line
leaves in memory what the sweep of each row of joints needs (swept.py), and one function of the
runtime sweeps all rows (templates/include/adagen/swept_rows.hpp). Its sums are those of
certificate.py, to rounding.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.allowance import Allowance
from adagen.executor.frames import Transform
from adagen.executor.rows import Rows
from adagen.executor.segments import Articulated
from adagen.executor.state import State
from adagen.executor.swept import CONSTANTS, FIELDS, FORCE, GATHERED, KEPT, Swept, SweptRow
from adagen.graph import Expression

Array = NDArray[Any]

_ACROSS = [0, 1, 3, 4, 5]  # entries of a wrench that a hinge passes on
_WAIT = 60  # cycles that a row takes, about


class SweptRows:
    """Leaves what a loop sweeps, and takes what it gives.

    Args:
        certificate: whose residuals they are.
        joints: those that rows are named by, inwards.

    Attributes:
        swept: what the line leaves.
    """

    def __init__(self, certificate: Allowance, joints: Sequence[int]) -> None:
        self.certificate, self.state = certificate, certificate.state
        rows = self.state.rows
        self._lanes = max(2, *(len(rows.lanes(j)) for j in joints))
        self._places = {j + 1: k * FIELDS * self._lanes for k, j in enumerate(joints)}
        end = len(joints) * FIELDS * self._lanes
        near = (rows.name_of(link) if link else 0 for j in joints for link in rows.near_links(j))
        #: links that no loop sweeps and that gather from those that it does
        self.gather = [link for link in dict.fromkeys([0, *near]) if link not in self._places]
        for k, link in enumerate(self.gather):
            self._places[link] = end + k * GATHERED * self._lanes
        sums = end + len(self.gather) * GATHERED * self._lanes
        self._left: list[tuple[int, Expression, int]] = []
        table, floats = tuple(self._row(j) for j in joints), bool(certificate.bases)
        self.swept = Swept(self._lanes, table, tuple(self._left), end, sums, sums + 3, floats)

    def _row(self, j: int) -> SweptRow:
        """Leave the numbers of a joint's row."""
        rows, memory = self.state.rows, self.state.memory
        width, count, place = len(rows.lanes(j)), len(rows.own(j)), self._places[j + 1]
        body: Articulated = memory["articulated", j]
        own = self.certificate.motion.link_force(j + 1)
        numbers: dict[int, Expression] = dict(enumerate(own))
        if self.certificate.bases:
            numbers |= dict(enumerate(own[3:], start=FORCE))
        inverse = body.factors.inverses[0]
        if count < width:  # a lane that repeats another adds nothing
            inverse = inverse * self.state.graph.constant((1,) * count + (0,) * (width - count))
        rest = [*memory["a", j + 1][:, 0], *body.scaled[0, _ACROSS]]
        rest += [inverse, body.u[0, 0], *self.state.torques(j)[:, 0]]
        numbers |= dict(enumerate(rest, start=GATHERED))
        self._left += [
            (place + k * self._lanes, x, width)
            for k, x in numbers.items()
            if k < GATHERED or x.constant != 0  # what is gathered is added to it
        ]
        links = rows.near_links(j)
        aligned = _aligned(rows, j)
        near = [self._gathers(link) for link in links[:count]]
        near += [self._places[0]] * (self._lanes - count)
        constants = self._constants(j, width)
        hands_on = count if any(links) else 0
        first = place, self._angle(j), width, hands_on, aligned
        return SweptRow(*first, self._turned(j), tuple(near), constants)

    def _turned(self, j: int) -> tuple[int, int, int]:
        """Which squares of moments turn to be which, as allowances have them (frames.py)."""
        x: Transform = self.state.memory["X", j]
        across, _, along = self.state.constants(np.eye(3))
        found = zip(x.rotation.magnitudes(across), x.rotation.magnitudes(along), strict=True)
        first, second, third = (2 if a == b else int(b.constant == 1) for a, b in found)
        return first, second, third

    def _angle(self, j: int) -> int:
        """The place of a row's first angle."""
        (angle, *_), _ = self.state.configuration(j)
        lanes = [angle.graph.lane(angle, k) for k in range(angle.node.width)]
        place = self.state.place_of_angles(tuple(lanes))
        assert isinstance(place, int)  # named otherwise where lines are only counted
        return place

    def _gathers(self, link: int) -> int:
        """The place of what a link gathers, in its lane."""
        if link == 0:
            return self._places[0]
        row = self.state.rows.row_at(link)
        lane = 0 if row is None else row.lanes.index(link - 1)
        return self._places[self.state.rows.name_of(link)] + lane

    def _constants(self, j: int, width: int) -> Array:
        """The constants of a row, in as many lanes as all have."""
        state, graph = self.state, self.state.graph
        inertia = self.certificate.motion.link_inertia(j + 1)
        x: Transform = state.memory["X", j]
        arms = [[*x.origin[:k], *x.origin[k + 1 :]] for k in range(3)]
        numbers = [
            *(inertia[i, k] for i, k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))),
            *(inertia[2, 4], inertia[0, 5], inertia[1, 3], inertia[3, 3]),
            *state.rows.of_joint(j, lambda joint: joint.rotation).flat,
            *x.origin,
            *map(self.certificate.square, arms),
        ]
        found = state.zeros(CONSTANTS, self._lanes)
        for k, number in enumerate(numbers):
            found[k, :width] = [graph.lane(number, lane) for lane in range(width)]
        return found

    # -- what it gives ----------------------------------------------------------------------------

    def gathered(self, link: int) -> tuple[Array, Array, Array]:
        """Return what a link gathers: wrench (6), squares (4), and the field's force (3)."""
        first, width = self._places[link], len(self.state.rows.lanes(link - 1))
        places = [first + k * self._lanes for k in range(GATHERED)]
        found = np.array([self._given(place, width) for place in places], dtype=object)
        return found[:6], found[6:FORCE], found[FORCE:]

    def summed(self) -> list[Expression]:
        """Return squared residual error, allowance in units, and energy of the answer."""
        return [self._given(self.swept.sums + k) for k in range(3)]

    def _given(self, place: int, width: int = 1) -> Expression:
        last = max(x.node.ready for _, x, _ in self.swept.left)
        found: Expression = self.state.graph.input(
            f"{KEPT}{place}]", last + _WAIT * len(self.swept.rows), width
        )
        return found


def by_depth(state: State, inwards: Sequence[int]) -> list[int]:
    """Return joints inwards so that those that do not wait for each other come together.

    Args:
        state: of a process.
        inwards: the joints that rows are named by, each behind those beyond it.
    """
    depths, rows = dict[int, int](), state.rows
    for j in reversed(inwards):
        near = [rows.name_of(link) - 1 for link in rows.near_links(j) if link]
        depths[j] = 1 + max((depths.get(each, 0) for each in near), default=0)
    return sorted(inwards, key=lambda j: -depths[j])


def _aligned(rows: Rows, j: int) -> bool:
    """Whether the near links of a joint's row are a row in the same lanes."""
    links, count = rows.near_links(j), len(rows.own(j))
    return any(links) and rows.as_kept(links) and len(set(links[:count])) == count
