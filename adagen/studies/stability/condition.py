"""The condition of the joint-space inertia, which a dense solve's error goes with."""

from __future__ import annotations

import numpy as np
from flint import arb_mat, ctx
from numpy.typing import NDArray

from adagen.exact import exact
from adagen.model import Model
from adagen.reference.inertia import inertia_matrix
from adagen.reference.numbers import BALLS

_BITS = 512  # H of cond(H) = 1e25 is inverted to more digits than a double has


def condition(model: Model, q: NDArray[np.float64]) -> float:
    """Return cond(H), the largest eigenvalue of H over the least one, in mixed units.

    H and its inverse are formed in ball arithmetic: in doubles the least eigenvalue is lost where
    cond(H) comes near 1 / eps.

    Args:
        model: the robot.
        q: configuration, shape (nq,).

    Raises:
        FloatingPointError: H is singular.
    """
    before = ctx.prec
    ctx.prec = _BITS
    try:
        inertia = arb_mat(inertia_matrix(BALLS, model, exact(q)).tolist())
        inverse = inertia.inv()
    except ZeroDivisionError:
        raise FloatingPointError("the joint-space inertia is singular") from None
    finally:
        ctx.prec = before
    return _largest(inertia) * _largest(inverse)


def _largest(matrix: arb_mat) -> float:
    """Return the largest eigenvalue of a symmetric matrix."""
    rows = [[float(x.mid()) for x in row] for row in matrix.tolist()]
    return float(np.linalg.eigvalsh(np.array(rows))[-1])
