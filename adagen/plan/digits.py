"""Loss of digits in mobilities: limits for pivots and for joins."""

from __future__ import annotations

from math import fsum  # as sum is rounded differently by Python before 3.12, and this is emitted
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import KINDS
from adagen.plan.robot import PlanJoint
from adagen.plan.steps import Join, Propagate
from adagen.plan.types import Plan

EPSILON = {"double": 2.0**-53, "float": 2.0**-24}

KEPT = 128
"""What of a bare link's mobility must be left, in units of the rounding error of one operation."""

GIMBAL_LOCK = {"double": 1e-7, "float": 2.0**-19}
"""Joints that are joined as one are farther from gimbal lock (1 / |S^+|) than this."""

NEAR_GIMBAL_LOCK = 1e-3
"""Nearer than this they lose three digits and more, of which a warning is given."""

TINY = 2.0**-32
"""Products of four constants below it are subnormal in float."""

FEW_CARRIED = 24
"""Joints through which unit wrenches are carried before any of them is subnormal in float."""

LEAST_PIVOT = {"double": 1e-5, "float": 1e-2}
"""Least pivot of Phi for inverting a mobility to an inertia, angular and linear pivots each
relative to the largest entry of their diagonal."""


def least_mobility(plan: Plan, join: Join) -> list[float]:
    """Return the least value of each diagonal entry of M that has digits; empty if unknown.

    Where the links beside the joint were joined bare, it is a multiple of what they brought.
    """
    if plan.joints[join.joint].rotor_inertia or plan.joints[join.joint].prescribed:
        return []  # the rotor's mobility is added to M; what is prescribed frees nothing
    child, parent = plan.links[join.joint + 1], plan.links[plan.joints[join.joint].parent]
    least = [row[k] for k, row in enumerate(child.phi)] or [0.0] * 6
    if parent.phi:  # at least: 1 / trace of the inertia about any axis, 1 / mass in any direction
        trace = fsum(parent.tensor[k][k] for k in range(3))
        least = [x + 1.0 / (trace if k < 3 else parent.mass) for k, x in enumerate(least)]
    return [KEPT * EPSILON[plan.scalar] * x for x in least] if any(least) else []


def meets_subnormals(plan: Plan) -> bool:
    """Return whether a plan makes numbers that are subnormal in its scalar.

    In double none is to speak of. In float products of constants are, of frames turned by pi / 2 in
    doubles, whose zeros are 1e-17. Unit wrenches are that are carried through a chain: a joint
    passes on a tenth of some.
    """
    if plan.scalar != "float" or plan.reproducible:  # which computes with them, as everywhere
        return False
    if any(len(list(each.steps_of(Propagate))) > FEW_CARRIED for each in plan.processes):
        return True
    joints, links = plan.joints, plan.links
    rows = (
        *(row for joint in joints for row in (*joint.rotation, joint.translation)),
        *(row for link in links for row in (*link.tensor, link.com)),
    )
    return any(0 < abs(x) < TINY for row in rows for x in row)


def lost_mobility(bare: NDArray[Any], assembled: NDArray[Any]) -> float:
    """Return the largest generalised eigenvalue of two symmetric matrices of equal shape.

    Raises:
        LinAlgError: the second one is not positive definite.
    """
    diagonal = np.diag(assembled)
    if not (diagonal > 0).all():
        raise np.linalg.LinAlgError("not positive definite")
    scale = 1.0 / np.sqrt(diagonal)  # mixed units: rotations beside translations
    lower = np.linalg.cholesky(assembled * np.outer(scale, scale))
    half = np.linalg.solve(lower, bare * np.outer(scale, scale))
    return float(np.linalg.eigvalsh(np.linalg.solve(lower, half.T))[-1])


def generic_configuration(joints: tuple[PlanJoint, ...], seed: int) -> NDArray[np.float64]:
    """Return a generic configuration, shape (nq,): irrational steps round the circle."""
    result = []
    for j, joint in enumerate(joints):
        kind = KINDS[joint.kind]
        values = np.sin(1.7 * (j + 1) * seed + np.arange(kind.nq))
        if kind.quaternion is not None:
            part = slice(kind.quaternion, None)
            values[part] /= np.linalg.norm(values[part])
        result.append(values)
    return np.concatenate(result)


def generic_motion(count: int, seed: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return generic velocities and torques, shape (count,) each."""
    places = np.arange(1, count + 1) * seed
    return np.sin(2.3 * places), np.sin(3.1 * places)
