"""Bounds of slides that take back how far their joints are placed: both are rounded."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.build import Toolchain
from adagen.model import PLANAR, PRISMATIC, REVOLUTE, JointKind, Model
from adagen.states import States, random_states
from benchmarks.stability.bounds import Certified, bounded
from tests.emitted import Builder
from tests.models import random_tree
from tests.slow import spread

FAR = 1e4  # m


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


def taken_back(kind: JointKind, seed: int) -> tuple[Model, States]:
    """A robot with joints that are placed far off and slide back, and states of it."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 7, kinds=(REVOLUTE, kind))
    states = random_states(model, 15, seed=3)
    q, joints = states.q.copy(), []
    for joint, first in zip(model.joints, model.q_start, strict=True):
        if joint.kind is kind:
            x, _, z = np.eye(3)
            if kind is PLANAR:  # its first number is along x where its normal is z
                joint = replace(joint, axis=z)
            place = joint.rotation @ (x if kind is PLANAR else joint.axis) * FAR
            joint = replace(joint, translation=place + 0.01 * rng.normal(size=3))
            q[:, first] = -FAR + 0.02 * rng.normal(size=len(q))
        joints.append(joint)
    return replace(model, joints=tuple(joints)), States(q, states.v, states.tau)


CASES = {
    "line": (PRISMATIC, Certified("unrolled")),
    "line with a loop": (PRISMATIC, Certified("unrolled", looped=1000)),
    "planar joints in a line": (PLANAR, Certified("unrolled")),
    "loops": (PRISMATIC, Certified("kernels")),
    "planar joints in loops": (PLANAR, Certified("kernels")),
    "batch": (PRISMATIC, Certified("kernels", batch=True)),
}


@pytest.mark.parametrize("name", spread(CASES, 2))
def test_bounds_hold_what_slides_take_back(name: str, quick: Toolchain) -> None:
    kind, way = CASES[name]
    model, states = taken_back(kind, 11)
    found = bounded(model, states, [way], quick)[way]
    assert found.refused == 0 and found.errors.max() > 1e-13
    assert (found.ratios <= 1).all() and np.isfinite(found.bounds).all()
