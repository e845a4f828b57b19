"""The least that something takes inwards, outwards, and in all."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Floor:
    """The least that a joint takes, microseconds.

    Attributes:
        inwards: kinematics and the sweep inwards.
        outwards: the sweep outwards.
        both: all of it; at least the sum of the two.
    """

    inwards: float
    outwards: float
    both: float

    def plus(self, other: Floor) -> Floor:
        """Return the sum of two."""
        return Floor(
            self.inwards + other.inwards, self.outwards + other.outwards, self.both + other.both
        )


NOTHING = Floor(0.0, 0.0, 0.0)


def longest_of(floors: Iterable[Floor]) -> Floor:
    """Return the largest of each, 0 for none."""
    inwards = outwards = both = 0.0
    for floor in floors:
        inwards = max(inwards, floor.inwards)
        outwards = max(outwards, floor.outwards)
        both = max(both, floor.both)
    return Floor(inwards, outwards, both)
