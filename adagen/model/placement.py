"""Pose of a joint's child link at a configuration, in exact arithmetic."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from flint import arb

from adagen.exact import Exact, exact, identity, rotation_taking_z_to, skew
from adagen.model.model import Joint
from adagen.model.rigid import Pose


def placed(joint: Joint, q: Sequence[Any]) -> Pose:
    """Return the pose of a joint's child link in its parent link's frame.

    Args:
        joint: the joint.
        q: its configuration, floats or arb; a quaternion of any length but zero.
    """
    turn, shift = _motion(joint, [x if isinstance(x, arb) else arb(x) for x in q])
    at_parent = Pose.home().then(exact(joint.rotation), exact(joint.translation))
    return at_parent.then(turn, shift)


def _motion(joint: Joint, q: list[arb]) -> tuple[Exact, Exact]:
    """Return rotation and origin of the child frame in the joint frame."""
    kind, still = joint.kind, exact([0.0, 0.0, 0.0])
    if kind.quaternion is not None:
        turn = rotation_of_quaternion(q[kind.quaternion :])
        return turn, still + q[:3] if kind.quaternion else still
    axis = exact(joint.axis)
    axis = axis / axis.dot(axis).sqrt()
    if kind.name == "prismatic":
        return identity(), axis * q[0]
    if kind.name == "revolute":
        return rotation_about(axis, q[0]), still
    if kind.name == "planar":
        frame = rotation_taking_z_to(joint.axis)
        return rotation_about(axis, q[2]), frame[:, 0] * q[0] + frame[:, 1] * q[1]
    raise AssertionError(f"unknown kind {kind.name}")


def rotation_about(axis: Exact, angle: arb) -> Exact:
    """Return Rodrigues' rotation about a unit axis."""
    sine, cosine = angle.sin_cos()
    k = skew(axis)
    turn: Exact = identity() + k * sine + k.dot(k) * (1 - cosine)
    return turn


def rotation_of_quaternion(xyzw: list[arb]) -> Exact:
    """Return the rotation that a quaternion of any length but zero stands for."""
    square = sum((x * x for x in xyzw), arb(0))
    k = skew(exact(xyzw[:3]))
    turn: Exact = identity() + (k * xyzw[3] + k.dot(k)) * (2 / square)
    return turn
