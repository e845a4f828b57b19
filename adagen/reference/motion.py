"""Poses and motions of links, and momenta of the whole robot."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from adagen.model import Model
from adagen.reference.kinematics import Body, bodies, placements
from adagen.reference.numbers import Numbers, Numeric, cross


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
