"""Code shape `unrolled`: a plan's steps as one straight line of scalar statements.

The steps run over expressions (adagen/executor/), which folds constants and computes nothing twice;
the statements are divided into functions (arrangement.py) and printed (text.py). Similar limbs
share code, one in each SIMD lane.
"""

from __future__ import annotations

from adagen.emit.unrolled.emission import values

__all__ = [
    "values",
]
