"""The least that something takes inwards, outwards, and in all."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple


class SweepBound(NamedTuple):
    """The least that a joint takes, microseconds.

    Attributes:
        inwards: kinematics and the sweep inwards.
        outwards: the sweep outwards.
        both: all of it; at least the sum of the two.
    """

    inwards: float
    outwards: float
    both: float

    def plus(self, other: SweepBound) -> SweepBound:
        """Return the sum of two."""
        return SweepBound(
            self.inwards + other.inwards, self.outwards + other.outwards, self.both + other.both
        )


NOTHING = SweepBound(0.0, 0.0, 0.0)


def longest_of(bounds: Iterable[SweepBound]) -> SweepBound:
    """Return the largest of each, 0 for none."""
    inwards = outwards = both = 0.0
    for bound in bounds:
        inwards = max(inwards, bound.inwards)
        outwards = max(outwards, bound.outwards)
        both = max(both, bound.both)
    return SweepBound(inwards, outwards, both)
