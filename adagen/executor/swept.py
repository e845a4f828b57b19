"""What a straight line leaves in memory for a loop that sweeps residuals, row by row of joints.

The memory has a record for each row: ``FIELDS`` numbers, each in as many lanes as the widest row
has. The first ``GATHERED`` of them are what links beyond hand on; they begin with the wrench that
the field takes of the link itself. Links whose residuals no loop sweeps, the ground and others,
gather in shorter records, which are zero before.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from adagen.graph import Expression

Array = NDArray[Any]

KEPT = "w.x.data()["
"""What names of inputs that lie in a line's memory begin with."""
GATHERED = 13
"""Numbers that a link gathers: wrench (6), squares (4), force of the field (3)."""
FORCE = 10
"""Which of them is the first one of the field's force."""
FIELDS = 27
"""Numbers of a row: gathered ones, acceleration (6), D^-1 U across the joint (5), 1 / D, u, and the
torque."""
CONSTANTS = 25
"""Constants of a row: moments and products of inertia about the origin (6), mass times centre (3),
mass, placement (9), origin (3), squares of lever arms (3)."""
_OPERATIONS, _OF_FORCE = 105, 20
"""Operations for each row, and more where forces of the field are handed on."""
STATEMENTS = 300
"""Statements of the function, whatever the number of rows."""


@dataclass(frozen=True)
class SweptRow:
    """Joints that are swept together, one in each lane.

    Attributes:
        place: of their numbers in the line's memory.
        angle: the first one's place among angles; those of other lanes come behind it.
        width: lanes with a joint.
        hands_on: lanes that hand something on; none where all near links are the ground.
        aligned: whether the near links are a row in the same lanes.
        turned: squares of moments that turn to be those about the parent's axes: 0 those across the
            axis, 1 those along it, 2 both.
        near: places of what the near links gather, by lanes; in lanes without a joint the ground's.
        constants: shape (CONSTANTS, lanes).
    """

    place: int
    angle: int
    width: int
    hands_on: int
    aligned: bool
    turned: tuple[int, int, int]
    near: tuple[int, ...]
    constants: Array


@dataclass(frozen=True)
class Swept:
    """What a line leaves for the sweep.

    Attributes:
        lanes: of every number.
        rows: in the order in which they are swept, inwards.
        left: what is to be in memory: its place, its value, and the lanes that it fills. The rest
            is zero, also in lanes without a joint, and stays so.
        gathered: where records of links begin that only gather; they end at ``sums``.
        sums: place of the squared residual error, the allowance in units, and the answer's energy.
        places: size of the memory.
        floats: whether forces of the field are handed on, for a floating base.
    """

    lanes: int
    rows: tuple[SweptRow, ...]
    left: tuple[tuple[int, Expression, int], ...]
    gathered: int
    sums: int
    places: int
    floats: bool

    @property
    def operations(self) -> int:
        """How many operations the sweep takes, about."""
        each = _OPERATIONS + _OF_FORCE * self.floats
        apart = sum(row.hands_on for row in self.rows if not row.aligned)
        handed = GATHERED if self.floats else FORCE  # one by one where lanes part
        return each * len(self.rows) + handed * apart

    def first_places(self) -> dict[int, int]:
        """Return the first place of each value, by its index, that fills its lanes."""
        found: dict[int, int] = {}
        for place, x, lanes in self.left:
            if x.node.width == lanes:
                found.setdefault(x.index, place)
        return found
