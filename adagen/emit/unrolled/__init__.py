"""Code shape `unrolled`: a plan's steps as one straight line of scalar statements.

The steps run over expressions (machine.py), which folds what is known beforehand and computes
nothing twice; what is left is cut into functions (layout.py) and printed (text.py). Limbs that are
alike share code, one in each SIMD lane (lanes.py, rows.py, align.py).
"""

from __future__ import annotations

from adagen.emit.unrolled.emission import CHUNK, unrolled_values, why_not_unrolled
from adagen.emit.unrolled.simulate import (
    Grouping,
    Simulated,
    grouping_of,
    pays_unrolled,
    pays_unrolled_in_lanes,
    simulate,
    straight_line,
)

__all__ = [
    "CHUNK",
    "Grouping",
    "Simulated",
    "grouping_of",
    "pays_unrolled",
    "pays_unrolled_in_lanes",
    "simulate",
    "straight_line",
    "unrolled_values",
    "why_not_unrolled",
]
