"""Successors of a partial chain in form `segment`: its cuts, and divisions of its processes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]
_ANY = 16  # processes up to which a range may be divided anyhow


@dataclass(frozen=True)
class Options:
    """Cuts with ways to divide P, by ascending bound; arrays of equal length, ticks.

    Attributes:
        total: least time of both sweeps.
        assembly: least time of the first one.
        disassembly: least time of the second one.
        position: of the joint that is cut.
        first: processes for the root side.
        guess: the time of both sweeps with what the bound leaves out, on average; ticks.
    """

    total: Ints
    assembly: Ints
    disassembly: Ints
    position: Ints
    first: Ints
    guess: Ints


def divisions(processes: int) -> list[tuple[int, int]]:
    """Return the ways to divide P >= 2 processes: all of them up to 16, else in halves."""
    if processes > _ANY:
        return [(processes // 2, processes - processes // 2)]
    return [(p, processes - p) for p in range(1, processes)]
