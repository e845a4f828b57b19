"""States that nobody gave: drawn at random, or at rest."""

from __future__ import annotations

import numpy as np

from adagen.model import Model
from adagen.states.slaved import follow_sources
from adagen.states.types import States, columns


def random_states(model: Model, count: int, seed: int = 0) -> States:
    """Return states drawn at random: angles within pi, lengths and all rates within 1, SI units.

    Quaternions are uniformly distributed; slaved joints follow. The same arguments give the same
    states on every machine up to rounding.

    Args:
        model: the robot.
        count: how many, at least 1.
        seed: at least 0.
    """
    rng = np.random.default_rng(seed)
    v, torques = rng.uniform(-1.0, 1.0, size=(2, count, model.nv))
    v *= not model.at_rest
    q = rng.uniform(-1.0, 1.0, size=(count, model.nq))
    for j, joint in enumerate(model.joints):
        at = columns(model, j, "q")
        if joint.kind.quaternion is not None:
            four = rng.normal(size=(count, 4))
            q[:, at.stop - 4 : at.stop] = four / np.linalg.norm(four, axis=1, keepdims=True)
        elif 2 in joint.kind.free:  # it turns about its axis: an angle, the last of its q
            q[:, at.stop - 1] *= np.pi
    forces = rng.uniform(-1.0, 1.0, size=(count, model.ntau - model.nv))
    states = States(q, v, np.hstack([torques, forces]))
    follow_sources(states, model, {})
    return states


def resting_states(model: Model, count: int) -> States:
    """Return ``count`` equal states: every q zero or a unit quaternion, no velocity, no torque."""
    q = np.zeros((count, model.nq))
    for j, joint in enumerate(model.joints):
        if joint.kind.quaternion is not None:
            q[:, columns(model, j, "q").stop - 1] = 1.0
    states = States(q, np.zeros((count, model.nv)), np.zeros((count, model.ntau)))
    follow_sources(states, model, {})
    return states
