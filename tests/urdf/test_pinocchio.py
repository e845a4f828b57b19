"""Pinocchio reads the same robots: joint order, placements, lumped inertias, accelerations."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.model import Model
from adagen.reference import forward_dynamics
from adagen.urdf import read_robot
from tests.models import random_configuration
from tests.real import real_robot

pin = pytest.importorskip("pinocchio")

ROBOTS = {
    "panda": "panda_description/urdf/panda.urdf",
    "ur5": "ur_description/urdf/ur5_robot.urdf",
    "talos": "talos_data/robots/talos_reduced.urdf",
    "talos_full": "talos_data/robots/talos_full_v2.urdf",
    "anymal": "anymal_c_simple_description/urdf/anymal.urdf",
    "solo12": "solo_description/robots/solo12.urdf",
    "icub": "icub_description/robots/icub.urdf",
    "g1": "g1_description/urdf/g1_29dof_rev_1_0.urdf",
    "tiago_dual": "tiago_description/robots/tiago_dual.urdf",
    "allegro": "allegro_hand_description/urdf/allegro_left_hand.urdf",
}


def theirs(path: Path, floating: bool) -> Any:
    root = (pin.JointModelFreeFlyer(), "__base__") if floating else ()
    return pin.buildModelFromUrdf(str(path), *root)


@pytest.mark.parametrize("floating", [False, True], ids=["fixed", "floating"])
@pytest.mark.parametrize("name", ROBOTS)
def test_same_robot(name: str, floating: bool) -> None:
    path = real_robot(ROBOTS[name])
    ours, other = read_robot(path, floating=floating).model, theirs(path, floating)
    assert [j.name for j in ours.joints] == list(other.names)[1:]
    assert [j.parent for j in ours.joints] == list(other.parents)[1:]
    for j, joint in enumerate(ours.joints):
        place = other.jointPlacements[j + 1]
        assert joint.rotation == pytest.approx(place.rotation, abs=1e-14)
        assert joint.translation == pytest.approx(place.translation, abs=1e-14)
        mine, inertia = ours.links[j + 1].inertia, other.inertias[j + 1]
        assert mine.mass == pytest.approx(inertia.mass, rel=1e-14)
        assert mine.com == pytest.approx(inertia.lever, abs=1e-13)
        assert mine.tensor == pytest.approx(inertia.inertia, rel=1e-12, abs=1e-13)


@pytest.mark.parametrize("floating", [False, True], ids=["fixed", "floating"])
@pytest.mark.parametrize("name", ["panda", "ur5", "talos", "solo12", "g1"])
def test_same_accelerations(name: str, floating: bool) -> None:
    path = real_robot(ROBOTS[name])
    ours, other = read_robot(path, floating=floating).model, theirs(path, floating)
    rng = np.random.default_rng(1)
    angles = random_configuration(ours, rng)
    v, tau = rng.normal(size=ours.nv), rng.normal(size=ours.nv)
    found = forward_dynamics(ours, angles, v, tau)
    q = _pinocchio_configuration(other, ours, angles)
    true = pin.aba(other, other.createData(), q, v, tau)
    assert found == pytest.approx(true, rel=1e-8, abs=1e-8 * float(np.max(np.abs(true))))


def _pinocchio_configuration(other: Any, ours: Model, q: Any) -> Any:
    """Pinocchio tells the angle of a continuous joint by its cosine and sine."""
    result = pin.neutral(other)
    for j, joint in enumerate(ours.joints):
        start, size = other.idx_qs[j + 1], other.nqs[j + 1]
        part = q[ours.q_start[j] : ours.q_start[j] + joint.kind.nq]
        if size == 2 and joint.kind.nq == 1:
            part = [np.cos(part[0]), np.sin(part[0])]
        result[start : start + size] = part
    return result
