"""Passive joint torques, and outer forces on links."""

from __future__ import annotations

from adagen.model import Model
from adagen.reference.numbers import Numbers, Numeric, cross


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
