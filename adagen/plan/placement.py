"""Spatial transforms and poses of child links, in numpy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model import Inertia
from adagen.model.kinds import KINDS, JointKind
from adagen.plan.robot import PlanJoint, PlanLink

Array = NDArray[np.float64]

_NEXT, _LAST = np.array([1, 2, 0]), np.array([2, 0, 1])


def configuration(joints: Sequence[PlanJoint], joint: PlanJoint, q: NDArray[Any]) -> NDArray[Any]:
    """Return the configuration of a joint; that of a slaved joint follows from its source's.

    Args:
        joints: of the plan.
        joint: one of them.
        q: of one state or several, shape (..., nq), in any type of numbers.
    """
    if joint.mimic is None:
        return q[..., joint.q : joint.q + KINDS[joint.kind].nq]
    (source, multiplier, offset), number = joint.mimic, q.dtype.type
    at = joints[source].q
    return np.asarray(number(multiplier) * q[..., at : at + 1] + number(offset))


def motion_transform(e: Array, r: Array) -> Array:
    """Return X = [[E, 0], [-E rx, E]] for a rotation E (3x3) and the child origin r (3,)."""
    x = np.zeros((6, 6))
    x[:3, :3] = x[3:, 3:] = e
    x[3:, :3] = -e @ _skew(r)
    return x


def _skew(v: Array) -> Array:
    """The matrix of a cross product with a vector, shape (3, 3)."""
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])


def spatial_inertia(body: Inertia | PlanLink) -> Array:
    """Return an inertia about the link's origin, [angular; linear], shape (6, 6), SI units."""
    mass, arm = body.mass, _skew(np.array(body.com))
    found = np.zeros((6, 6))
    found[:3, :3] = np.array(body.tensor) - mass * arm @ arm
    found[:3, 3:], found[3:, :3] = mass * arm, -mass * arm
    found[3:, 3:] = mass * np.eye(3)
    return found


def joint_transform(joint: PlanJoint, q: Array) -> Array:
    """Return X from a joint's parent link to its child link, shape (6, 6).

    Args:
        joint: the joint.
        q: its own configuration, shape (nq,).
    """
    turn, shift = placement(KINDS[joint.kind], q)
    base = np.array(joint.rotation)
    origin = np.array(joint.translation) + base @ shift
    return motion_transform((base @ turn).T, origin)


def cross_motion(v: Array, m: Array) -> Array:
    """Return v x m of two motion vectors [angular; linear], shape (6,)."""
    # Three products at once: each call of np.cross takes as long as ten operations.
    (a, b), (c, d) = v.reshape(2, 3), m.reshape(2, 3)
    first, second = np.array([a, a, b]), np.array([c, d, c])
    turned = first[:, _NEXT] * second[:, _LAST] - first[:, _LAST] * second[:, _NEXT]
    return np.concatenate([turned[0], turned[1] + turned[2]])


def placement(kind: JointKind, q: Array) -> tuple[Array, Array]:
    """Return rotation, shape (3, 3), and origin, shape (3,), m, of the child in the joint's frame.

    Args:
        kind: of the joint, whose axis is z.
        q: its configuration, shape (nq,); quaternions need not be of unit length.
    """
    turn, shift = np.eye(3), np.zeros(3)
    if kind.quaternion is not None:
        x, y, z, w = q[kind.quaternion :] / np.linalg.norm(q[kind.quaternion :])
        turn = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]
        )
        shift = q[: kind.quaternion] if kind.quaternion else shift
    elif kind.name == "prismatic":
        shift = np.array([0.0, 0.0, q[0]])
    else:
        angle = q[-1]
        c, s = np.cos(angle), np.sin(angle)
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        if kind.name == "planar":
            shift = np.array([q[0], q[1], 0.0])
    return turn, shift
