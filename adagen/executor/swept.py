"""What a straight line leaves in memory for a loop that sweeps residuals, record by record.

A record is for joints that are swept together, one in each lane. Its numbers are ``FIELDS``, each
in as many lanes as all records have. The first ``GATHERED`` of them are what links beyond hand on;
they begin with the wrench that the field takes of the link itself. Links whose residuals no loop
sweeps gather in shorter records, which are zero before.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from adagen.executor.swept_records import Pass
from adagen.graph import Expression

Array = NDArray[Any]

KEPT = "w.x.data()["
"""What names of inputs that lie in a line's memory begin with."""
GATHERED = 13
"""Numbers that a link gathers: wrench (6), squares (4), force that its motion takes (3)."""
SQUARES, FORCE, ACCELERATION, ACROSS = 6, 10, 13, 19
"""Which of them are the first square and force, and the first acceleration and factor behind."""
INVERSE, TORQUE, MOMENT, SQUARE = 24, 25, 26, 27
FIELDS = 28
"""Numbers of a record: gathered ones, acceleration (6), D^-1 U across the joint (5; the last one is
of the force along a hinge, of the moment about a slide), 1 / D, and the torque, less what a rotor
takes; then the moment (force) along the joint that is left, and the square of all that came
together there, which the loop leaves for joints that hold; where joints slide, how far."""
SHIFT = 28
CONSTANTS = 33
"""Constants of a record: moments and products of inertia about the origin (6), mass times centre
(3), mass, placement (9), origin (3), squares of lever arms (3), whether squares about x turn to be
those about each axis (3), and those about z (3), whether the joint holds, and whether it is one of
its own and repeats no other. Where joints slide, whether it does, and squares about y likewise (3);
where rotors turn, the rotor's inertia."""
_OPERATIONS, _OF_FORCE, _OF_LINKS = 90, 20, 12
"""Operations of a line that take as long as a record, within 2 % on an Intel Xeon; more where
forces are handed on, and more where energy is links'."""
_OF_SLIDES, _OF_ROTORS = 16, 2
"""More of records in which joints slide, and of all where some have rotors."""
STATEMENTS = 300
"""Statements of the function, whatever the number of records."""


@dataclass(frozen=True)
class SweptRow:
    """A record: joints that are swept together, one in each lane.

    Attributes:
        joints: by lanes; None in lanes without one.
        place: of their numbers in the line's memory.
        angles: their places among angles, by lanes; None in lanes without a joint.
        passes: what it hands on; nothing where all near links are the ground.
        next: whether that is all to the next record, lane by lane.
        added: whether squares and forces are added to its numbers, by others or the line.
        slides: whether one of the joints slides.
        constants: shape (constants of each, lanes).
    """

    joints: tuple[int | None, ...]
    place: int
    angles: tuple[int | None, ...]
    passes: tuple[Pass, ...]
    next: bool
    added: bool
    slides: bool
    constants: Array


@dataclass(frozen=True)
class Swept:
    """What a line leaves for the sweep.

    Attributes:
        lanes: of every number.
        rows: records in the order in which they are swept, inwards.
        count: rows of the line's joints that these are made of.
        left: what is to be in memory: its place, its value, and the lanes that it fills. The rest
            is zero, also in lanes without a joint, and stays so.
        gathered: where records of links begin that only gather; they end at ``sums``.
        sums: place of the squared residual error, the allowance in units, and the energy of the
            answer of robots with closed loops.
        places: size of the memory.
        floats: whether forces are handed on, for a floating base.
        closed: whether some joints hold, and the energy of the answer is that of the links.
        slides: whether some joints slide.
        rotors: whether some joints have rotors.
    """

    lanes: int
    rows: tuple[SweptRow, ...]
    count: int
    left: tuple[tuple[int, Expression, int], ...]
    gathered: int
    sums: int
    places: int
    floats: bool
    closed: bool
    slides: bool
    rotors: bool

    @property
    def operations(self) -> int:
        """How many operations the sweep takes, about."""
        each = _OPERATIONS + _OF_FORCE * self.floats + _OF_LINKS * self.closed
        each += _OF_ROTORS * self.rotors
        handed = GATHERED if self.floats else FORCE
        apart = sum(len(row.passes) for row in self.rows if not row.next)
        sliding = _OF_SLIDES * sum(row.slides for row in self.rows)
        return each * len(self.rows) + sliding + handed * apart

    def first_places(self) -> dict[int, int]:
        """Return the first place of each value, by its index, that fills its lanes."""
        found: dict[int, int] = {}
        for place, x, lanes in self.left:
            if x.node.width == lanes:
                found.setdefault(x.index, place)
        return found
