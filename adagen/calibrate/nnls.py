"""Non-negative least squares (Lawson and Hanson 1974, ch. 23)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
_TOLERANCE = 1e-12
"""Of the optimality conditions, relative to the largest slope at x = 0."""


def nnls(A: Array, b: Array) -> Array:
    """Return the x >= 0 that minimises |A x - b|.

    Args:
        A: shape (m, n), of full column rank.
        b: shape (m,).

    Returns:
        x, shape (n,).
    """
    n = A.shape[1]
    x = np.zeros(n)
    free = np.zeros(n, dtype=np.bool_)
    limit = _TOLERANCE * max(1e-300, float(np.abs(A.T @ b).max(initial=0.0)))
    for _ in range(10 * n):
        slope = A.T @ (b - A @ x)
        slope[free] = -np.inf
        best = int(np.argmax(slope))
        if slope[best] <= limit:
            break
        free[best] = True
        x = _inner(A, b, x, free)
    return x


def _inner(A: Array, b: Array, x: Array, free: NDArray[np.bool_]) -> Array:
    """Solve for the free unknowns, giving up those that would turn negative; changes ``free``."""
    while True:
        trial = np.zeros_like(x)
        trial[free] = np.linalg.lstsq(A[:, free], b, rcond=None)[0]
        bad = free & (trial <= 0)
        if not bad.any():
            return trial
        step = float(np.min(x[bad] / (x[bad] - trial[bad])))
        x = x + step * (trial - x)
        x[bad & (x <= 1e-15 * np.abs(x).max(initial=0.0))] = 0.0
        free &= x > 0
        x[~free] = 0.0
