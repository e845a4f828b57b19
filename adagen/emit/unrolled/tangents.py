"""Hyperbolic tangents that friction asks for, as a table of the rates that they are taken of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from adagen.program.strips import LANES


@dataclass(frozen=True)
class Tangents:
    """A table ``Tangents`` of templates/include/adagen/tangents.hpp.

    Attributes:
        process: whose it is; beyond the last one, of what recovers.
        count: how many tangents there are.
        places: those of their rates in v, filled up with zeros to whole registers.
        factors: of the rates, as C++ text, filled up likewise.
    """

    process: int
    count: int
    places: tuple[int, ...]
    factors: tuple[str, ...]


def tangents(process: int, of: Sequence[tuple[int, str]], scalar: str) -> list[Tangents]:
    """Return the table of a process's tangents, if it takes any; of rates by place and factor."""
    if not of:
        return []
    places, factors = zip(*of, strict=True)
    empty = -len(of) % LANES[scalar]
    return [Tangents(process, len(of), (*places, *[0] * empty), (*factors, *["0"] * empty))]
