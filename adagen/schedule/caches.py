"""How many joints of a long chain a core's second-level cache holds.

A profile tells its size (``process.cache``); each limit says how much of it a joint takes by a way
to compute chains. Beside it lie code, constants and what else a process works with, so that less
than all of it is counted on. The sizes were measured with 2 MB, in double.
"""

from __future__ import annotations

from adagen.schedule.costs import StepCosts

_SWEPT_WHOLE = 1400
_IN_LANES = 7000
_STRAIGHT = 512


def swept_whole(costs: StepCosts) -> int:
    """Return the joints up to which a run is swept as a whole, longer ones by tiles.

    Some 900 bytes of each lie in two thirds of the cache. To pass a joint twice costs less than to
    fetch its memory from the next level.
    """
    return int(costs["process.cache"] // _SWEPT_WHOLE)


def solved_in_lanes(joints: int, costs: StepCosts) -> bool:
    """Tell whether a batch solves one state of a chain in each SIMD lane, not each in parts.

    Where the states fit, that is faster than one state after the other in parts. Chains of up to
    512 are straight lines in batches (adagen/emit/shapes.py); in loops, eight states need some 7 kB
    for each joint. Four states of 256 bits are the faster ones at any length: 23 us for each 1000
    joints, up to 5000, where the parts of a state take 42 (AMD EPYC, Zen 4, 1 MB, AVX2).
    """
    return costs.narrow or joints <= max(_STRAIGHT, costs["process.cache"] // _IN_LANES)
