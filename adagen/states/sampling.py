"""Random states, and states at rest."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from adagen.model import Model
from adagen.states.slaved import follow_sources
from adagen.states.types import States, columns

Array = NDArray[np.float64]


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


def hardened(
    q: Array, v: Array, tau: Array, hinges: Iterable[int], rng: np.random.Generator
) -> tuple[Array, Array, Array]:
    """Return states made hard to solve: what cancels there, cancels most.

    Half of the angles come near multiples of a quarter turn, from 1e-9 to 1 rad, so that axes are
    nearly parallel. Velocities and torques are multiplied by up to 100 and 1000, or as much
    divided by 100, by orders of magnitude, one factor for each state.

    Args:
        q: configurations, shape (S, nq).
        v: velocities, shape (S, nv).
        tau: torques, shape (S, ntau).
        hinges: places of angles in a configuration.
        rng: what is drawn from.
    """
    q, count = q.copy(), len(q)
    for at in hinges:
        near = np.pi / 2 * rng.integers(-2, 3, size=count)
        near = near + 10.0 ** rng.uniform(-9, 0, size=count) * rng.choice([-1.0, 1.0], size=count)
        q[:, at] = np.where(rng.random(count) < 0.5, near, q[:, at])
    fast = 10.0 ** rng.uniform(-2, 2, size=(count, 1))
    strained = 10.0 ** rng.uniform(-2, 3, size=(count, 1))
    return q, v * fast, tau * strained
