"""The coordinates in which a run of joints is one joint of unit vectors.

With S the motions of the run's joints, one in each column, B S = [1; 0]: the first rows of B are a
left inverse R of S, the others its left null space N. In these coordinates a run is joined and
released as a joint whose freedoms are the first rows.

Lengths are measured in a unit of the robot's size, so that answers do not depend on those of the
file. Distances of the axes are no such unit: of a hinge and a slide along it they are rounding.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model import Inertia
from adagen.model.kinds import JointKind
from adagen.plan.robot import PlanJoint, PlanLink

Array = NDArray[Any]


def run_length(joints: Sequence[PlanJoint], link: PlanLink | Inertia) -> float:
    """Return the unit of length of a run, m: the nearest power of two to the size of its bodies.

    That is the largest of the offsets between its joints, and of the centre of mass and the radius
    of gyration of its last link; 1 where all of these are zero.

    Args:
        joints: of the run, outwards.
        link: the last one.
    """
    lengths = [float(np.linalg.norm(joint.translation)) for joint in joints[1:]]
    if link.mass > 0.0:
        lengths.append(float(np.linalg.norm(link.com)))
        lengths.append(math.sqrt(max(float(np.trace(link.tensor)), 0.0) / link.mass))
    largest = max(lengths, default=0.0)
    return 2.0 ** round(math.log2(largest)) if largest > 0.0 else 1.0


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


def joint_coordinates(s: Array, length: float) -> tuple[Array, float]:
    """Return B with B S = [1; 0], shape (6, 6), and how far the run is from gimbal lock.

    Every column of S is scaled to length one first. The rows of N are orthonormal.

    Args:
        s: motions of the run's joints in the last link's frame, shape (6, n).
        length: the unit of lengths (``run_length``), m.

    Returns:
        B, and 1 / |S^+| (Frobenius norm): at most the least singular value of the scaled S and,
        where only that one is small, nearly equal to it. Zero in gimbal lock; B is then not finite.
    """
    n = s.shape[1]
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
