"""Residuals of hinges and slides, swept inwards by a loop instead of statements.

A certified line of a robot with many joints has more code than a first instruction cache holds, and
then all of it is fetched in each evaluation. A certificate does the same for all joints: the line
leaves in memory what the sweep of each joint needs (swept.py), and one function of the runtime
sweeps them all, several in the lanes of a record (templates/include/adagen/swept_rows.hpp). Its
sums are those of certificate.py and closed_certificate.py, to rounding.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from adagen.executor.allowance import Sums
from adagen.executor.frames import Transform
from adagen.executor.kinematics import Motion
from adagen.executor.segments import Articulated
from adagen.executor.state import State
from adagen.executor.swept import (
    ACCELERATION,
    ACROSS,
    CONSTANTS,
    FIELDS,
    FORCE,
    GATHERED,
    INVERSE,
    KEPT,
    MOMENT,
    SHIFT,
    SQUARE,
    SQUARES,
    TORQUE,
    Swept,
    SweptRow,
)
from adagen.executor.swept_records import Pass, Record, passes, records
from adagen.graph import Expression, matrix_times, total

Array = NDArray[Any]

_HINGE, _SLIDE = 2, 5  # entries of a wrench along them
_ACROSS = {_HINGE: [0, 1, 3, 4, 5], _SLIDE: [0, 1, 3, 4, 2]}  # those that they pass on
_WAIT = 60  # cycles that a record takes, about


class Certificate(Protocol):
    """A certificate (allowance.py), and what residuals of links and joints begin with in it."""

    state: State
    motion: Motion
    bases: list[int]
    closed: bool
    rounded: Sums

    def run(self, j: int) -> Hashable:
        """Return what a joint's sums belong to."""

    def count(self, j: int) -> int:
        """Return how many lanes of them count."""

    def handed_noise(
        self, j: int, free: list[int], given: Array, spent: Array, noise: Array
    ) -> Array:
        """Return the squares that a joint passes on, shape (4,)."""

    def square(self, numbers: Iterable[Expression]) -> Expression:
        """Return the sum of squares."""

    def wrench_at(self, link: int) -> Array:
        """Return the wrench of a link but for what its acceleration takes, shape (6,)."""

    def squares_at(self, link: int) -> Array:
        """Return squares of moments and forces that act there by themselves, shape (4,)."""

    def torque_at(self, j: int) -> Expression:
        """Return the torque of a joint that is left for the residual, less what a rotor takes."""


class SweptRows:
    """Leaves what a loop sweeps, and takes what it gives.

    Args:
        certificate: whose residuals they are.
        looped: rows that are swept, see ``outermost``.

    Attributes:
        swept: what the line leaves.
    """

    def __init__(self, certificate: Certificate, looped: Sequence[int]) -> None:
        self.certificate, self.state = certificate, certificate.state
        self.looped, rows = looped, self.state.rows
        self._lanes, found = records(rows, looped)
        self._slides = any(self.along(j) == _SLIDE for j in looped)
        self._rotors = any(self.state.rotor(j) is not None for j in looped)
        size = (FIELDS + self._slides) * self._lanes
        self._places = {
            j + 1: k * size + lane for k, record in enumerate(found) for j, lane in record
        }
        near = (rows.name_of(link) for j in looped for link in self._near(j) if link)
        #: links that no loop sweeps and that gather from those that it does
        self.gather = [link for link in dict.fromkeys(near) if link not in self._places]
        self._weigh_spent()
        end = len(found) * size
        for k, link in enumerate(self.gather):
            self._places[link] = end + k * GATHERED * self._lanes
        sums = end + len(self.gather) * GATHERED * self._lanes
        self._left: list[tuple[int, Expression, int]] = []
        self._added = set[int]()  # places of records that others add to, or the line's squares
        table = tuple(map(self._record, found, [*found[1:], []]))
        floats = bool(certificate.bases)
        left, closed = tuple(self._left), certificate.closed
        self.swept = Swept(
            *(self._lanes, table, len(looped), left, end, sums, sums + 3, floats, closed),
            slides=self._slides,
            rotors=self._rotors,
        )

    def along(self, j: int) -> int:
        """Return the entry of a wrench that is along a joint."""
        return self.state.kind(j).free[0]

    def _near(self, j: int) -> list[int]:
        """The near links of a row, those of idle lanes left out."""
        rows = self.state.rows
        return rows.near_links(j)[: len(rows.own(j))]

    def _record(self, record: Record, following: Record) -> SweptRow:
        """Leave the numbers of a record, which comes before another or none."""
        rows, lanes, place = self.state.rows, self._lanes, self._place(record)
        joints, angles = list[int | None]([None] * lanes), list[int | None]([None] * lanes)
        each, handed = list[Array](), list[tuple[int, int]]()
        for j, lane in record:
            width = len(rows.lanes(j))
            self._leave(j)
            joints[lane : lane + width] = rows.lanes(j)
            angles[lane : lane + width] = self._angles(j)
            each.append(self._constants(j))
            near = enumerate(self._near(j), start=lane)
            handed += [(lane, self._gathers(link)) for lane, link in near if link]
        own = passes(handed, lanes)
        goes_on = bool(following) and self._goes_on(record, own, following)
        self._added.update(each.near for each in own if not goes_on)
        added = place in self._added
        constants = self.state.zeros(len(each[0]), lanes)
        for (_, lane), own_constants in zip(record, each, strict=True):
            constants[:, lane : lane + own_constants.shape[1]] = own_constants
        slides = any(self.along(j) == _SLIDE for j, _ in record)
        return SweptRow(tuple(joints), place, tuple(angles), own, goes_on, added, slides, constants)

    def _place(self, record: Record) -> int:
        (first, lane), *_ = record
        return self._places[first + 1] - lane

    def _goes_on(self, record: Record, own: Sequence[Pass], following: Record) -> bool:
        """Whether all of a record is handed on to the next one, lane by lane.

        What idle lanes hand on besides does not matter in lanes that are idle, too.
        """
        if len(own) != 1 or not own[0].straight or own[0].near != self._place(following):
            return False
        rows, handed = self.state.rows, set(own[0].sources) - {None}
        lanes, others = (
            {lane + k for j, lane in each for k in range(len(rows.own(j)))}
            for each in (record, following)
        )
        idle = {lane + k for j, lane in record for k in range(len(rows.lanes(j)))} - lanes
        return lanes == handed and idle.isdisjoint(others)

    def _leave(self, j: int) -> None:
        """Leave the numbers of a row."""
        rows, memory, graph = self.state.rows, self.state.memory, self.state.graph
        width, count, along = len(rows.lanes(j)), len(rows.own(j)), self.along(j)
        wrench = self.certificate.wrench_at(j + 1)
        taken = self.taken(j)
        numbers = dict(enumerate(wrench if taken is None else wrench + taken))
        if taken is not None and self.certificate.bases:
            numbers |= dict(enumerate(taken[3:], start=FORCE))
        squares = self.certificate.squares_at(j + 1) + memory["spent", j + 1]
        numbers |= dict(enumerate(squares, start=SQUARES))
        numbers |= dict(enumerate(memory["a", j + 1][:, 0], start=ACCELERATION))
        numbers[TORQUE] = self.certificate.torque_at(j)
        if not self.holds(j):
            body: Articulated = memory["articulated", j]
            inverse = body.factors.inverses[0]
            if count < width:  # a lane that repeats another adds nothing
                inverse = inverse * graph.constant((1,) * count + (0,) * (width - count))
            numbers |= dict(enumerate(body.scaled[0, _ACROSS[along]], start=ACROSS))
            numbers[INVERSE] = inverse
        if along == _SLIDE:
            (numbers[SHIFT], *_), _ = self.state.configuration(j)
        left = {k: x for k, x in sorted(numbers.items()) if x.constant != 0}
        first = self._places[j + 1]
        self._left += [(first + k * self._lanes, x, width) for k, x in left.items()]
        if not left.keys().isdisjoint(range(SQUARES, GATHERED)):
            self._added.add(first - first % self._lanes)

    def _weigh_spent(self) -> None:
        """Weigh squares of what passive forces take, of which the loop knows nothing.

        Their energies are added here; what they leave at near links is among squares there. A joint
        that holds has them in its own equation alone.
        """
        rows, memory = self.state.rows, self.state.memory
        links = (*(j + 1 for j in self.looped), *self.gather)
        memory.update({("spent", link): self.state.zeros(4) for link in links})
        for j in self.looped:
            spent = self.state.spent_squares(j)
            if self.holds(j) or spent[0].constant == 0:
                continue
            found, body = self.certificate, memory["articulated", j]
            found.rounded.add(found.run(j), found.count(j), spent[0] * body.factors.inverses[0])
            noise, nothing = self.state.zeros(4), self.state.zeros(0)
            noise[min(self.along(j), 3)] = spent[0]
            if any(rows.near_links(j)):
                handed = found.handed_noise(j, [], nothing, nothing, noise)
                rows.hand_on("spent", j, handed)

    def taken(self, j: int) -> Array | None:
        """Return the wrench that accelerations of links take whose inertias are set at run time.

        None of others, whose inertias the loop knows.
        """
        inertia = self.certificate.motion.link_inertia(j + 1)
        if all(x.constant is not None for x in inertia.flat):
            return None
        taken: Array = matrix_times(inertia, self.state.memory["a", j + 1][:, 0])
        return taken

    def energy(self, j: int) -> Expression:
        """Return the energy of these accelerations; zero of others."""
        taken, a = self.taken(j), self.state.memory["a", j + 1][:, 0]
        zero = self.state.graph.constant(0)
        return zero if taken is None else total([zero, *(taken * a)])

    def _angles(self, j: int) -> list[int | None]:
        """The places of a row's angles, by lanes; none of slides."""
        if self.along(j) == _SLIDE:
            return [None] * len(self.state.rows.lanes(j))
        (angle, *_), _ = self.state.configuration(j)
        lanes = [angle.graph.lane(angle, k) for k in range(angle.node.width)]
        place = self.state.angles.place_of(tuple(lanes))
        return [place + k for k in range(len(lanes))]

    def _gathers(self, link: int) -> int:
        """The place of what a link gathers, in its lane."""
        row = self.state.rows.row_at(link)
        lane = 0 if row is None else row.lanes.index(link - 1)
        return self._places[self.state.rows.name_of(link)] + lane

    def _constants(self, j: int) -> Array:
        """The constants of a row, shape (their number, its lanes)."""
        state, graph, width = self.state, self.state.graph, len(self.state.rows.lanes(j))
        inertia = self.certificate.motion.link_inertia(j + 1)
        if self.taken(j) is not None:
            inertia = state.zeros(6, 6)
        origin = state.rows.of_joint(j, lambda joint: joint.translation)
        arms = [[*origin[:k], *origin[k + 1 :]] for k in range(3)]
        about_x, about_y, about_z = self._turned(j)
        numbers = [
            *(inertia[i, k] for i, k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))),
            *(inertia[2, 4], inertia[0, 5], inertia[1, 3], inertia[3, 3]),
            *state.rows.of_joint(j, lambda joint: joint.rotation).flat,
            *origin,
            *map(self.certificate.square, arms),
            *about_x,
            *about_z,
            graph.constant(int(self.holds(j))),
            graph.constant(1),
        ]
        if self._slides:
            numbers += [graph.constant(int(self.along(j) == _SLIDE)), *about_y]
        if self._rotors:
            numbers.append(state.rotor(j) or graph.constant(0))
        found = state.zeros(len(numbers), width)
        for k, number in enumerate(numbers):
            found[k] = [graph.lane(number, lane) for lane in range(width)]
        found[CONSTANTS - 1, len(state.rows.own(j)) :] = graph.constant(0)
        return found

    def _turned(self, j: int) -> list[Array]:
        """Which squares of moments turn to be those about each axis: about x, y, and along z.

        Allowances take the larger of them (frames.py). Those across a hinge do likewise.
        """
        x: Transform = self.state.memory["X", j]
        return [x.rotation.magnitudes(axis) for axis in self.state.constants(np.eye(3))]

    # -- what it gives ----------------------------------------------------------------------------

    def gathered(self, link: int) -> tuple[Array, Array, Array]:
        """Return what a link gathers: wrench (6), squares (4), and the motion's force (3)."""
        first, width = self._places[link], len(self.state.rows.lanes(link - 1))
        places = [first + k * self._lanes for k in range(GATHERED)]
        found = np.array([self._given(place, width) for place in places], dtype=object)
        squares = found[SQUARES:FORCE] + self.state.memory["spent", link]
        return found[:SQUARES], squares, found[FORCE:]

    def held(self, j: int) -> tuple[Expression, Expression]:
        """Return what is left along a joint that holds, and the square of what makes it up."""
        first, width = self._places[j + 1], len(self.state.rows.lanes(j))
        moment, square = (self._given(first + k * self._lanes, width) for k in (MOMENT, SQUARE))
        return moment, square

    def holds(self, j: int) -> bool:
        """Return whether a joint holds: its acceleration is an unknown of a closure.

        It passes on all of a wrench.
        """
        return ("articulated", j) not in self.state.memory

    def masses(self) -> dict[int, Array]:
        """Return the masses that links which gather carry by joints in the loop, shape (1,)."""
        rows, memory = self.state.rows, self.state.memory
        for j in self.looped:
            memory["mass", j + 1] = np.array([rows.mass(j + 1)], dtype=object)
        memory.update({("mass", link): self.state.zeros(1) for link in self.gather})
        for j in self.looped:
            if any(rows.near_links(j)):
                rows.hand_on("mass", j, memory["mass", j + 1])
        return {link: memory["mass", link] for link in self.gather}

    def summed(self) -> list[Expression]:
        """Return squared residual error, allowance in units, and energy by links (closed)."""
        return [self._given(self.swept.sums + k) for k in range(3)]

    def _given(self, place: int, width: int = 1) -> Expression:
        last = max(x.node.ready for _, x, _ in self.swept.left)
        found: Expression = self.state.graph.input(
            f"{KEPT}{place}]", last + _WAIT * len(self.swept.rows), width
        )
        return found
