"""The coordinates in which a run of joints is one joint of unit vectors.

With S the motions of the run's joints, one in each column, B S = [1; 0]: the first rows of B are a
left inverse R of S, the others its left null space N. In these coordinates a run is joined and
released as a joint whose freedoms are the first rows.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import JointKind

Array = NDArray[Any]


def run_motion(transforms: Sequence[Array], kinds: Sequence[JointKind]) -> tuple[Array, Array]:
    """Return X of a whole run, shape (6, 6), and S = [X_(last<-j) S_j], shape (6, n).

    Args:
        transforms: X of each joint, outwards.
        kinds: kind of each joint.
    """
    whole, motions = np.eye(6), np.zeros((6, 0))
    for x, kind in zip(transforms, kinds, strict=True):
        own = np.zeros((6, kind.nv))
        own[list(kind.free), range(kind.nv)] = 1.0
        whole, motions = x @ whole, np.hstack([x @ motions, own])
    return whole, motions


def joint_coordinates(s: Array) -> tuple[Array, float]:
    """Return B with B S = [1; 0], shape (6, 6), and how far the run is from gimbal lock.

    S is scaled first: lengths by the largest distance of an axis from the link's origin, so that
    the answer does not depend on units, and every column to length one. The rows of N are
    orthonormal in these units.

    Args:
        s: motions of the run's joints in the last link's frame, shape (6, n).

    Returns:
        B, and 1 / |S^+| (Frobenius norm): at most the least singular value of the scaled S and,
        where only that one is small, nearly equal to it. Zero in gimbal lock; B is then not finite.
    """
    n = s.shape[1]
    turning = np.linalg.norm(s[:3], axis=0) > 0
    length = float(np.linalg.norm(s[3:, turning], axis=0).max(initial=0.0)) or 1.0
    units = np.array([1.0] * 3 + [1.0 / length] * 3)
    columns = 1.0 / np.linalg.norm(units[:, None] * s, axis=0)
    q, r = np.linalg.qr(units[:, None] * s * columns, mode="complete")
    with np.errstate(divide="ignore", invalid="ignore"):
        if not np.diag(r[:n]).all():
            return np.full((6, 6), np.nan), 0.0
        inverse = np.linalg.inv(r[:n])
    b = q.T * units
    b[:n] = columns[:, None] * (inverse @ b[:n])
    return b, float(1.0 / np.linalg.norm(inverse))
