"""Constants computed once and rounded once, so that they are the same on every machine.

``sin`` and ``cos`` of the C library, fused multiply-adds and BLAS differ in the last bit between
machines. Whatever ends up in emitted text is therefore computed here with 200-bit ball arithmetic
(python-flint) and rounded to the nearest double at the very end.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray

BITS = 200

Matrix = NDArray[np.float64]
Exact = NDArray[Any]  # numpy array of python-flint arb

if ctx.prec < BITS:
    ctx.prec = BITS


def exact(values: Any) -> Exact:
    """Return values (a float array of any shape) as an object array of arb, without rounding."""
    array = np.asarray(values)
    if array.dtype == object:
        return array
    result = np.empty(array.shape, dtype=object)
    flat = result.reshape(-1)
    for i, value in enumerate(array.reshape(-1).tolist()):
        flat[i] = arb(value)
    return result


def rounded(values: Exact) -> Matrix:
    """Return exact values rounded to the nearest double; negative zero becomes zero.

    So does what is zero as far as is known: of turns about parallel axes that are no coordinate
    axes, cancelled entries of 1e-61 would otherwise take part in all arithmetic.
    """
    array = np.asarray(values, dtype=object)
    result = np.empty(array.shape, dtype=np.float64)
    flat = result.reshape(-1)
    for i, value in enumerate(array.reshape(-1)):
        flat[i] = 0.0 if value.contains(0) else float(value)
    return result


def skew(v: Exact) -> Exact:
    """Return the 3x3 matrix v x with (v x) u = cross(v, u)."""
    zero = arb(0)
    return np.array([[zero, -v[2], v[1]], [v[2], zero, -v[0]], [-v[1], v[0], zero]], dtype=object)


def identity() -> Exact:
    """Return the 3x3 identity."""
    return exact(np.eye(3))


def rotation_from_rpy(rpy: Sequence[float]) -> Exact:
    """Return the 3x3 rotation Rz(yaw) Ry(pitch) Rx(roll) of a URDF ``rpy`` (rad)."""
    (sr, cr), (sp, cp), (sy, cy) = (arb(angle).sin_cos() for angle in rpy)
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ],
        dtype=object,
    )


def rotation_taking_z_to(axis: Sequence[float] | Matrix) -> Exact:
    """Return a rotation whose third column is the unit vector along ``axis`` (length 3, not zero).

    An axis along a coordinate axis gives a signed permutation, so that nothing is rounded; any
    other axis gives the rotation of least angle from z (from -z, flipped, where it points down).
    """
    a = [float(x) for x in axis]
    nonzero = [k for k in range(3) if a[k] != 0.0]
    if len(nonzero) == 1:
        k = nonzero[0]
        s = 1.0 if a[k] > 0 else -1.0
        result = np.zeros((3, 3))
        result[(k + 1) % 3, 0] = 1.0
        result[(k + 2) % 3, 1] = s
        result[k, 2] = s
        return exact(result)
    x, y, z = exact(a)
    length = (x * x + y * y + z * z).sqrt()
    x, y, z = x / length, y / length, z / length
    if a[2] >= 0:
        k = 1 / (1 + z)
        return np.array(
            [[1 - k * x * x, -k * x * y, x], [-k * x * y, 1 - k * y * y, y], [-x, -y, z]],
            dtype=object,
        )
    k = 1 / (1 - z)
    return np.array(
        [[1 - k * x * x, k * x * y, x], [-k * x * y, k * y * y - 1, y], [x, -y, z]], dtype=object
    )


def rotated_inertia(rotation: Exact, tensor: Exact) -> Exact:
    """Return R T R^T, exactly symmetric, for a rotation and an inertia tensor (both 3x3)."""
    product: Exact = rotation.dot(tensor).dot(rotation.T)
    return np.asarray((product + product.T) / 2, dtype=object)
