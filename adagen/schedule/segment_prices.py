"""Prices of parts of a schedule of form `segment`, by sweep; ticks on a core of speed 1."""

from __future__ import annotations

from typing import NamedTuple


class Price(NamedTuple):
    """Times of the first sweep and of the second one; ticks."""

    assembly: int
    disassembly: int

    @property
    def total(self) -> int:
        """Both together."""
        return self.assembly + self.disassembly

    def plus(self, other: Price) -> Price:
        """Return the price of both."""
        return Price(self.assembly + other.assembly, self.disassembly + other.disassembly)


class SegmentPrice(NamedTuple):
    """Times of a chain on one process; ticks.

    Attributes:
        kinematics: of its joints and of those between it and the ground, once.
        sweeps: of everything else.
        path: positions of the joints along which mobility is carried outwards.
    """

    kinematics: int
    sweeps: Price
    path: tuple[int, ...]


class Transit(NamedTuple):
    """Times of a chain's two messages; ticks.

    Attributes:
        assembly: to put the first one in, and again to take it out.
        disassembly: the same of the second one.
        send: of the sender besides.
        latency: from sent to seen.
    """

    assembly: int
    disassembly: int
    send: int
    latency: int

    @property
    def away(self) -> tuple[int, int]:
        """How long they are under way in either sweep, apart from the time of the joint's process.

        That process takes the times of the receiver in the first and of the sender in the second.
        """
        return self.assembly + self.send + self.latency, self.disassembly + self.latency

    @property
    def handling(self) -> Price:
        """Time of the joint's process for them in either sweep."""
        return Price(self.assembly, self.disassembly + self.send)
