"""Errors of a scene's simplifications, in states in which they do not hold."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from adagen.errors import AdagenError
from adagen.model import Model, Passive
from adagen.reference import forward_dynamics
from adagen.scene import Reduction
from adagen.scene.report import Simplification
from adagen.states import random_states

Array = NDArray[np.float64]
STATES = 16
MANY = 100
"""Joints beyond which nothing is compared: that would take seconds."""


def simplifications(reduction: Reduction) -> Iterator[Simplification]:
    """Yield the errors of locking joints, omitting gravity and zero velocities, one by one.

    Random states of the whole robot are solved with and without, in double precision by composite
    rigid bodies. Robots with loops, slaved joints or prescribed motions are not compared.
    """
    full, model = _bare(reduction.full), _bare(reduction.model)
    tied = full.closed or any(j.mimic or j.prescribed for j in (*full.joints, *model.joints))
    if tied or len(full.joints) > MANY or not model.joints:
        return
    if reduction.locked and not reduction.dropped:
        with suppress(AdagenError):  # the whole robot has no accelerations
            yield _of(
                "the locked joints are held where they are",
                "they move freely and without torque",
                _unlocked(full, replace(model, gravity=full.gravity), reduction),
            )
    if not model.gravity.any() and full.gravity.any():
        drawn = random_states(model, STATES, 1)
        weighed = replace(model, gravity=full.gravity)
        pairs = [
            (forward_dynamics(model, *state), forward_dynamics(weighed, *state))
            for state in drawn.each
        ]
        yield _of("there is no gravity", "there is", pairs)
    if model.at_rest:
        drawn = random_states(replace(model, at_rest=False), STATES, 1)
        pairs = [
            (forward_dynamics(model, q, 0 * v, tau), forward_dynamics(model, q, v, tau))
            for q, v, tau in drawn.each
        ]
        yield _of("velocities are zero", "they are up to 1 rad/s and 1 m/s", pairs)


def _bare(model: Model) -> Model:
    """The robot without passive effects and outer forces, which are no simplifications."""
    joints = tuple(replace(joint, passive=Passive()) for joint in model.joints)
    return replace(model, joints=joints, wrenches=())


def _unlocked(full: Model, model: Model, reduction: Reduction) -> list[tuple[Array, Array]]:
    """Accelerations of the remaining joints, with the others locked and free."""
    drawn = random_states(full, STATES, 1)
    names = {joint.name: j for j, joint in enumerate(full.joints)}
    left = [names[joint.name] for joint in model.joints]
    in_q = _entries(full, left, "q")
    in_v = _entries(full, left, "v")
    pairs = []
    for q, v, tau in drawn.each:
        for name, at in reduction.locked.items():
            own = _entries(full, [names[name]], "v")
            q[_entries(full, [names[name]], "q")], v[own], tau[own] = at, 0.0, 0.0
        held = forward_dynamics(model, q[in_q], v[in_v], tau[in_v])
        pairs.append((held, forward_dynamics(full, q, v, tau)[in_v]))
    return pairs


def _entries(model: Model, joints: list[int], vector: str) -> list[int]:
    """Entries of joints in q, or in v."""
    starts = model.q_start if vector == "q" else model.v_start
    counts = [getattr(model.joints[j].kind, "nq" if vector == "q" else "nv") for j in joints]
    return [starts[j] + k for j, count in zip(joints, counts, strict=True) for k in range(count)]


def _of(holds: str, else_: str, pairs: list[tuple[Array, Array]]) -> Simplification:
    sizes = [(float(np.linalg.norm(a - b)), float(np.linalg.norm(b))) for a, b in pairs]
    apart = [off / max(size, 1e-300) for off, size in sizes]
    return Simplification(holds, else_, len(pairs), float(np.median(apart)), float(max(apart)))
