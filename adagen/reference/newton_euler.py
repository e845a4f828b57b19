"""Recursive Newton-Euler with 3-vectors (Luh, Walker and Paul 1980), and mechanical energy."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from adagen.model import Model
from adagen.reference.kinematics import Body, Placement, bodies, moving_links, placements
from adagen.reference.numbers import Numbers, Numeric, cross


@dataclass(frozen=True, eq=False)
class Motion:
    """How a link moves, each of shape (3,) and in the link's own frame.

    Attributes:
        spin: angular velocity, rad/s.
        turn: angular acceleration, rad/s^2.
        pull: classical acceleration of the link's origin less that of free fall, m/s^2.
    """

    spin: Numeric
    turn: Numeric
    pull: Numeric


def joint_torques(
    numbers: Numbers,
    model: Model,
    q: Numeric,
    v: Numeric,
    a: Numeric,
    tau: Numeric | None = None,
) -> Numeric:
    """Return the joint torques, shape (nv,), that give the accelerations a.

    Args:
        numbers: the kind of number that q, v and a hold.
        model: the robot; slaved joints count as independent here.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        a: time derivative of the components of v, shape (nv,).
        tau: where outer forces are looked up, shape (ntau,); None where there are none.
    """
    placed = placements(numbers, model, q)
    motions = _motions(numbers, model, placed, v, a)
    forces, moments = [], []
    for body, motion in zip(bodies(numbers, model), motions[1:], strict=True):
        force, moment = _needed(body, motion)
        forces.append(force)
        moments.append(moment)
    for j, force, moment in [] if tau is None else pushes(numbers, model, tau):
        forces[j], moments[j] = forces[j] - force, moments[j] - moment
    result = numbers.zeros(model.nv)
    for j in reversed(range(len(placed))):
        place, parent, start = placed[j], model.joints[j].parent, model.v_start[j]
        own = place.angular.T.dot(moments[j]) + place.linear.T.dot(forces[j])
        result[start : start + len(own)] = own
        if parent:
            force = place.rotation.dot(forces[j])
            moment = place.rotation.dot(moments[j]) + cross(place.position, force)
            forces[parent - 1] = forces[parent - 1] + force
            moments[parent - 1] = moments[parent - 1] + moment
    return result + passive_torques(numbers, model, q, v, a)


def _motions(
    numbers: Numbers, model: Model, placed: list[Placement], v: Numeric, a: Numeric
) -> list[Motion]:
    """Return the motion of every link, the ground (which falls upward) first."""
    still = numbers.zeros(3)
    motions = [Motion(still, still, -numbers.array(model.gravity))]
    for joint, start, place in zip(model.joints, model.v_start, placed, strict=True):
        own = slice(start, start + joint.kind.nv)
        above, back, r = motions[joint.parent], place.rotation.T, place.position
        spin, slide = place.angular.dot(v[own]), place.linear.dot(v[own])
        carried = back.dot(above.spin)
        turn = back.dot(above.turn) + cross(carried, spin) + place.angular.dot(a[own])
        pull = above.pull + cross(above.turn, r) + cross(above.spin, cross(above.spin, r))
        # The sliding velocity turns with the child's axes: Coriolis twice, and its own turning.
        pull = back.dot(pull) + 2 * cross(carried, slide) + cross(spin, slide)
        motions.append(Motion(carried + spin, turn, pull + place.linear.dot(a[own])))
    return motions


def _needed(body: Body, motion: Motion) -> tuple[Numeric, Numeric]:
    """Return force and moment about the link's origin that the motion takes (Newton, Euler)."""
    lever = cross(motion.spin, cross(motion.spin, body.com))
    force = body.mass * (motion.pull + cross(motion.turn, body.com) + lever)
    moment = body.tensor.dot(motion.turn) + cross(motion.spin, body.tensor.dot(motion.spin))
    return force, moment + cross(body.com, force)


def energies(numbers: Numbers, model: Model, q: Numeric, v: Numeric) -> tuple[Any, Any]:
    """Return kinetic and potential energy (J), rotors and springs included.

    The potential energy is zero with all masses at the origin and all springs at rest.

    Args:
        numbers: the kind of number that q and v hold.
        model: the robot.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
    """
    down = numbers.array(model.gravity)
    kinetic = potential = numbers.zeros(1)[0]
    starts = zip(model.joints, model.q_start, model.v_start, strict=True)
    for (joint, start_q, start), link in zip(
        starts, moving_links(numbers, model, q, v), strict=True
    ):
        own, body = v[start : start + joint.kind.nv], link.body
        twice = body.mass * link.speed.dot(link.speed) + link.spin.dot(body.tensor.dot(link.spin))
        kinetic = kinetic + twice / 2
        potential = potential - body.mass * down.dot(link.origin + link.axes.dot(body.com))
        rotor, stiffness, rest = numbers.array(
            [joint.passive.rotor_inertia, joint.passive.stiffness, joint.passive.rest]
        )
        kinetic = kinetic + rotor * own.dot(own) / 2
        if joint.passive.stiffness:
            stretch = q[start_q] - rest
            potential = potential + stiffness * stretch * stretch / 2
    return kinetic, potential


def passive_torques(numbers: Numbers, model: Model, q: Numeric, v: Numeric, a: Numeric) -> Numeric:
    """Return the torques, shape (nv,), that damping, friction, springs and rotors take up.

    Args:
        numbers: the kind of number that q, v and a hold.
        model: the robot.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        a: acceleration, shape (nv,).
    """
    result = numbers.zeros(model.nv)
    for j, joint in enumerate(model.joints):
        passive = joint.passive
        start = model.v_start[j]
        damping, friction, speed, rotor = numbers.array(
            [passive.damping, passive.friction, passive.friction_speed, passive.rotor_inertia]
        )
        for k in range(start, start + joint.kind.nv):
            result[k] = damping * v[k] + rotor * a[k]
            if passive.friction:
                result[k] = result[k] + friction * numbers.tanh(v[k] / speed)
        if passive.stiffness:
            stiffness, rest = numbers.array([passive.stiffness, passive.rest])
            result[start] = result[start] + stiffness * (q[model.q_start[j]] - rest)
    return result


def pushes(numbers: Numbers, model: Model, tau: Numeric) -> list[tuple[int, Numeric, Numeric]]:
    """Return what each outer force does: joint above its link, force (3,) and moment (3,) there.

    Args:
        numbers: the kind of number that tau holds.
        model: the robot.
        tau: torques and outer forces, shape (ntau,).
    """
    result = []
    for k, wrench in enumerate(model.wrenches):
        given = tau[model.nv + 6 * k : model.nv + 6 * k + 6]
        turn = numbers.array(wrench.frame.rotation)
        force, moment = turn.dot(given[:3]), turn.dot(given[3:])
        lever = cross(numbers.array(wrench.frame.translation), force)
        result.append((wrench.link - 1, force, moment + lever))
    return result
