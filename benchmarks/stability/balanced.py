"""Strong passive forces that torques balance: what is left of both moves the links.

Damping, friction and springs are rounded before a torque is less them, and that the factors of the
equations of motion do not know.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from adagen.model import Joint, Model, Passive
from adagen.states import States


def balanced(model: Model, states: States, size: float, seed: int = 0) -> tuple[Model, States]:
    """Return a robot with strong passive forces, and the states with torques that balance them.

    Args:
        model: the robot.
        states: its states; torques are those that are left.
        size: of passive forces, about, at unit rates and angles; N m or N.
        seed: which joints have which forces.

    Returns:
        The robot, on about two thirds of whose joints such forces act, as far as their kinds take
        them, and as many states.
    """
    rng = np.random.default_rng((seed, 2))
    joints, tau = [], states.tau.copy()
    for joint, q, v in zip(model.joints, model.q_start, model.v_start, strict=True):
        passive = _drawn(joint, size, rng)
        joints.append(replace(joint, passive=passive))
        entries = slice(v, v + joint.kind.nv)
        rates = states.v[:, entries]
        tau[:, entries] += passive.damping * rates
        tau[:, entries] += passive.friction * np.tanh(rates / passive.friction_speed)
        if passive.stiffness:
            tau[:, v] += passive.stiffness * (states.q[:, q] - passive.rest)
    return replace(model, joints=tuple(joints)), States(states.q, states.v, tau)


def _drawn(joint: Joint, size: float, rng: np.random.Generator) -> Passive:
    """Passive forces of about a size; of each of them as many joints have none."""
    drawn = size * rng.random(3) * (rng.random(3) < 1 / 3)
    damping, friction, stiffness = (float(x) for x in drawn)
    if not joint.kind.takes("damping"):
        return Passive()
    if not joint.kind.takes("friction"):
        return Passive(damping=damping)
    return Passive(damping, friction, 0.1, stiffness, rest=float(rng.normal()))
