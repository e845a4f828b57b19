"""Poses and motions of all child links, directly from the original model, and momenta.

Everything is written with plain 3-vectors in the child link's own frame, never with spatial vectors
and never in the canonical frames that the emitted code uses.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from adagen.errors import InputError
from adagen.model import FLOATING, PLANAR, PRISMATIC, REVOLUTE, SPHERICAL, Joint, Model
from adagen.reference.numbers import Numbers, Numeric, cross, cross_matrix


@dataclass(frozen=True, eq=False)
class Placement:
    """Where a joint puts its child link, and how the child can move.

    Attributes:
        rotation: child axes in the parent link's frame, shape (3, 3).
        position: the child's origin in the parent link's frame, shape (3,), m.
        angular: shape (3, nv): the child's angular velocity relative to the parent is
            ``angular @ v``, in the child frame, constant there.
        linear: shape (3, nv): likewise the velocity of the child's origin.
    """

    rotation: Numeric
    position: Numeric
    angular: Numeric
    linear: Numeric


@dataclass(frozen=True, eq=False)
class Body:
    """Mass, centre of mass (3,) and rotational inertia about it (3, 3) in link coordinates."""

    mass: Any
    com: Numeric
    tensor: Numeric


def bodies(numbers: Numbers, model: Model) -> list[Body]:
    """Return the N moving links, joint j's child at index j."""
    result = []
    for link in model.links[1:]:
        tensor = numbers.array(link.inertia.tensor)
        mass = numbers.array([link.inertia.mass])[0]
        result.append(Body(mass, numbers.array(link.inertia.com), (tensor + tensor.T) / 2))
    return result


def placements(numbers: Numbers, model: Model, q: Numeric) -> list[Placement]:
    """Return each joint's placement at configuration q, shape (nq,).

    Raises:
        InputError: a quaternion is zero.
    """
    result = []
    for joint, start in zip(model.joints, model.q_start, strict=True):
        own = q[start : start + joint.kind.nq]
        base = orthonormal(numbers, numbers.array(joint.rotation))
        turned, moved, angular, linear = _motion(numbers, joint, own)
        place = numbers.array(joint.translation) + base.dot(moved)
        result.append(Placement(base.dot(turned), place, angular, linear))
    return result


def _motion(
    numbers: Numbers, joint: Joint, q: Numeric
) -> tuple[Numeric, Numeric, Numeric, Numeric]:
    """Return rotation and position in the joint frame, then the two maps from the velocity."""
    one, none = numbers.array(np.eye(3)), numbers.zeros(3, 3)
    if joint.kind is SPHERICAL:
        return _rotation_of_quaternion(numbers, joint, q), numbers.zeros(3), one, none
    if joint.kind is FLOATING:
        turned = _rotation_of_quaternion(numbers, joint, q[3:])
        return turned, q[:3], np.hstack([none, one]), np.hstack([one, none])
    axis = _unit(numbers, numbers.array(joint.axis))
    column, still = axis.reshape(3, 1), numbers.zeros(3, 1)
    if joint.kind is REVOLUTE:
        return _rotation_about(numbers, axis, q[0]), numbers.zeros(3), column, still
    if joint.kind is PRISMATIC:
        return one, axis * q[0], still, column
    if joint.kind is PLANAR:
        turn = numbers.turn(joint.axis)
        across = np.hstack([still, still, turn[:, 2:]])
        along = np.hstack([turn[:, :2], still])
        moved = turn[:, 0] * q[0] + turn[:, 1] * q[1]
        return _rotation_about(numbers, turn[:, 2], q[2]), moved, across, along
    raise InputError(f"joint '{joint.name}': the kind '{joint.kind.name}' has no reference")


def _rotation_about(numbers: Numbers, axis: Numeric, angle: Any) -> Numeric:
    """Return Rodrigues' rotation about a unit axis."""
    sine, cosine = numbers.sincos(angle)
    k = cross_matrix(axis)
    result: Numeric = numbers.array(np.eye(3)) + k * sine + k.dot(k) * (1 - cosine)
    return result


def _rotation_of_quaternion(numbers: Numbers, joint: Joint, xyzw: Numeric) -> Numeric:
    """Return the rotation of a quaternion of any length but zero."""
    square = xyzw.dot(xyzw)
    if not float(square) > 1e-200:
        raise InputError(f"joint '{joint.name}': the quaternion is zero; give [x, y, z, w]")
    k = cross_matrix(xyzw[:3])
    result: Numeric = numbers.array(np.eye(3)) + (k * xyzw[3] + k.dot(k)) * (2 / square)
    return result


def _unit(numbers: Numbers, vector: Numeric) -> Numeric:
    result: Numeric = vector / numbers.sqrt(vector.dot(vector))
    return result


def orthonormal(numbers: Numbers, rotation: Numeric) -> Numeric:
    """Return the rotation that a matrix rounded to double stands for.

    Without this the recursions below, each exact, would differ by the rounding of the model.
    """
    x = _unit(numbers, rotation[:, 0])
    y = rotation[:, 1] - x * x.dot(rotation[:, 1])
    y = _unit(numbers, y)
    return np.stack([x, y, cross(x, y)], axis=1)


@dataclass(frozen=True, eq=False)
class Moving:
    """A link in motion.

    Attributes:
        body: the link.
        axes: its axes in ground coordinates, shape (3, 3).
        origin: its origin in ground coordinates, shape (3,), m.
        spin: its angular velocity in its own frame, shape (3,), rad/s.
        speed: the velocity of its centre of mass in its own frame, shape (3,), m/s.
    """

    body: Body
    axes: Numeric
    origin: Numeric
    spin: Numeric
    speed: Numeric


def moving_links(numbers: Numbers, model: Model, q: Numeric, v: Numeric) -> list[Moving]:
    """Return the N moving links, joint j's child at index j.

    Args:
        numbers: the kind of number that q and v hold.
        model: the robot; slaved joints count as independent here.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
    """
    still = numbers.zeros(3)
    poses = [(numbers.array(np.eye(3)), still, still, still)]
    found = []
    every = zip(
        model.joints,
        model.v_start,
        placements(numbers, model, q),
        bodies(numbers, model),
        strict=True,
    )
    for joint, start, place, body in every:
        axes, origin, spin, speed = poses[joint.parent]
        own, back = v[start : start + joint.kind.nv], place.rotation.T
        speed = back.dot(speed + cross(spin, place.position)) + place.linear.dot(own)
        spin = back.dot(spin) + place.angular.dot(own)
        origin, axes = origin + axes.dot(place.position), axes.dot(place.rotation)
        poses.append((axes, origin, spin, speed))
        found.append(Moving(body, axes, origin, spin, speed + cross(spin, body.com)))
    return found


def momenta(numbers: Numbers, model: Model, q: Numeric, v: Numeric) -> tuple[Numeric, Numeric]:
    """Return linear momentum (kg m/s) and angular momentum about the common centre of mass.

    Both have shape (3,) and are given in ground coordinates; the latter is in kg m^2/s. Arguments
    as for `moving_links`.
    """
    mass = numbers.zeros(1)[0]
    moment, linear, angular = numbers.zeros(3), numbers.zeros(3), numbers.zeros(3)
    for link in moving_links(numbers, model, q, v):
        body, place = link.body, link.origin + link.axes.dot(link.body.com)
        push = link.axes.dot(link.speed) * body.mass
        mass, moment, linear = mass + body.mass, moment + place * body.mass, linear + push
        angular = angular + cross(place, push) + link.axes.dot(body.tensor.dot(link.spin))
    return linear, angular - cross(moment / mass, linear)
