"""Robots with effects at random, for tests."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from adagen.model import Frame, Model, Passive, Wrench
from tests.models import random_rotation


def with_effects(model: Model, rng: np.random.Generator, what: str = "drp") -> Model:
    """Return the robot with effects on about half of its joints.

    Args:
        model: the robot.
        rng: where randomness comes from.
        what: d damping, friction and springs; r rotors; p prescribed motions.
    """
    followed = {joint.mimic.source for joint in model.joints if joint.mimic is not None}
    joints = []
    for j, joint in enumerate(model.joints):
        d, k, f, r, q0 = rng.uniform(0.1, 1.0, size=5)
        passive, one = Passive(), joint.kind.nv == 1
        if "d" in what and rng.random() < 0.5 and (one or joint.kind.name == "spherical"):
            passive = Passive(damping=d)
            if one:
                passive = Passive(d, f, 0.1 + q0, k, q0)
        if "r" in what and rng.random() < 0.5 and (one or joint.kind.name == "spherical"):
            passive = replace(passive, rotor_inertia=r)
        tied = joint.mimic is not None or j in followed
        prescribed = "p" in what and rng.random() < 0.3 and not tied
        joints.append(replace(joint, passive=passive, prescribed=prescribed))
    if all(joint.prescribed for joint in joints):
        joints[0] = replace(joints[0], prescribed=False)
    return replace(model, joints=tuple(joints))


def with_wrenches(model: Model, rng: np.random.Generator, count: int = 2) -> Model:
    """Return the robot with outer forces on random links, told in frames fixed to them."""
    wrenches = tuple(
        Wrench(
            int(rng.integers(1, len(model.links))),
            Frame(f"tool{k}", random_rotation(rng), rng.uniform(-0.2, 0.2, size=3)),
        )
        for k in range(count)
    )
    return replace(model, wrenches=wrenches)
