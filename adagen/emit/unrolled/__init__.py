"""Code shape `unrolled`: a plan's steps as one straight line of scalar statements.

The steps run over expressions (adagen/executor/), which folds what is known beforehand and computes
nothing twice; what is left is divided into functions (arrangement.py) and printed (text.py). Limbs
that are alike share code, one in each SIMD lane.
"""

from __future__ import annotations

from adagen.emit.unrolled.emission import CHUNK, values

__all__ = [
    "CHUNK",
    "values",
]
