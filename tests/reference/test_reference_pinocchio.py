"""Against pinocchio, which reads the URDF by itself, on robots of public packages."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.model import Model
from adagen.reference import (
    exact_forward_dynamics,
    forward_dynamics,
    inverse_dynamics,
    joint_space_inertia,
)
from adagen.reference.coupling import coupling
from adagen.reference.numbers import DOUBLE
from adagen.states import random_states
from adagen.urdf import read_robot

pin = pytest.importorskip("pinocchio")
Array = NDArray[np.float64]

# Of each the tolerance: some ten times what was measured. The icub has links of 1e-6 kg m^2 whose
# accelerations are 1e5 times those of the others.
ROBOTS = {
    "panda": 1e-12,
    "ur5_robot": 1e-12,
    "talos_full_v2": 1e-12,
    "talos_reduced": 1e-12,
    "anymal": 1e-12,
    "solo12": 1e-12,
    "g1_29dof_with_hand_rev_1_0": 1e-12,
    "icub": 1e-9,
    "tiago_dual": 1e-12,
}


@pytest.fixture(scope="module")
def robots() -> dict[str, Path]:
    try:
        listed = files("example-robot-data") or []
    except PackageNotFoundError:
        pytest.skip("the package example-robot-data is not installed")
    return {Path(f).stem: Path(str(f.locate())) for f in listed if f.name.endswith(".urdf")}


def their_index(model: Any, name: str) -> int:
    return int(model.getJointId("root_joint" if name == "__base__" else name))


def configuration(theirs: Any, ours: Model, q: Array) -> Array:
    """Return q as pinocchio has it: a continuous joint by the cosine and sine of its angle."""
    result: Array = pin.neutral(theirs)
    for joint, start in zip(ours.joints, ours.q_start, strict=True):
        other = theirs.joints[their_index(theirs, joint.name)]
        own = q[start : start + joint.kind.nq]
        if other.nq != joint.kind.nq:
            own = np.array([np.cos(own[0]), np.sin(own[0])])
        result[other.idx_q : other.idx_q + other.nq] = own
    return result


@pytest.mark.parametrize("floating", [False, True], ids=["fixed", "floating"])
@pytest.mark.parametrize("name", ROBOTS)
def test_robots(name: str, floating: bool, robots: dict[str, Path]) -> None:
    ours = read_robot(robots[name], floating=floating).model
    root = [pin.JointModelFreeFlyer()] if floating else []
    theirs = pin.buildModelFromUrdf(str(robots[name]), *root)
    known = ["root_joint" if j.name == "__base__" else j.name for j in ours.joints]
    assert list(theirs.names)[1:] == known  # depth-first, siblings by name: the same order
    data, states, tolerance = theirs.createData(), random_states(ours, 3, 1), ROBOTS[name]
    for q, v, tau in zip(states.q, states.v, 10 * states.tau, strict=True):
        at = configuration(theirs, ours, q)
        qdd = forward_dynamics(ours, q, v, tau)
        scale = max(1.0, np.abs(qdd).max())
        np.testing.assert_allclose(pin.aba(theirs, data, at, v, tau), qdd, atol=tolerance * scale)
        needed = inverse_dynamics(ours, q, v, qdd)
        scale = max(1.0, np.abs(needed).max())
        np.testing.assert_allclose(
            pin.rnea(theirs, data, at, v, qdd), needed, atol=tolerance * scale
        )
        upper = np.triu(pin.crba(theirs, data, at))
        inertia = joint_space_inertia(ours, q)
        np.testing.assert_allclose(
            upper + np.triu(upper, 1).T, inertia, atol=1e-14 * np.abs(inertia).max()
        )


@pytest.mark.parametrize("name", ["panda", "ur5_robot"])
def test_exact(name: str, robots: dict[str, Path]) -> None:
    ours = read_robot(robots[name], floating=True).model
    theirs = pin.buildModelFromUrdf(str(robots[name]), pin.JointModelFreeFlyer())
    states = random_states(ours, 1, 3)
    q, v, tau = states.q[0], states.v[0], states.tau[0]
    answer = exact_forward_dynamics(ours, q, v, tau).value
    near = pin.aba(theirs, theirs.createData(), configuration(theirs, ours, q), v, tau)
    np.testing.assert_allclose(near, answer, atol=1e-12 * np.abs(answer).max())


@pytest.mark.parametrize("floating", [False, True], ids=["fixed", "floating"])
@pytest.mark.parametrize("name", ["panda", "pr2", "tiago_pro"])
def test_slaved_joints(name: str, floating: bool, robots: dict[str, Path]) -> None:
    """Pinocchio's own projection of mimic joints (which it refuses where the source is later)."""
    ours = read_robot(robots[name], floating=floating, mimic=True).model
    assert any(joint.mimic for joint in ours.joints)
    root = [pin.JointModelFreeFlyer()] if floating else []
    theirs = pin.buildModelFromUrdf(str(robots[name]), *root, mimic=True)
    shares = coupling(DOUBLE, ours)
    data, states = theirs.createData(), random_states(ours, 2, 4)
    assert theirs.nv == shares.shape[1]
    for q, v, tau in states.each:
        at, own = pin.neutral(theirs), np.zeros(theirs.nv)
        reduced = np.zeros((ours.nv, theirs.nv))  # our rows from their columns
        for joint, iq, iv in zip(ours.joints, ours.q_start, ours.v_start, strict=True):
            if joint.mimic:
                continue
            other = theirs.joints[their_index(theirs, joint.name)]
            value = q[iq : iq + joint.kind.nq]
            if other.nq != joint.kind.nq:
                value = np.array([np.cos(value[0]), np.sin(value[0])])
            at[other.idx_q : other.idx_q + other.nq] = value
            rows = slice(iv, iv + joint.kind.nv)
            own[other.idx_v : other.idx_v + other.nv] = v[rows]
            reduced[rows, other.idx_v : other.idx_v + other.nv] = np.eye(other.nv)
        qdd = forward_dynamics(ours, q, v, tau)
        needed = pin.rnea(theirs, data, at, own, reduced.T @ qdd)
        given = shares.T @ tau
        scale = max(1.0, np.abs(needed).max())
        order = (reduced.T @ shares).argmax(axis=1)
        np.testing.assert_allclose(needed, given[order], atol=1e-11 * scale)
        upper = np.triu(pin.crba(theirs, data, at))
        inertia = (shares.T @ joint_space_inertia(ours, q) @ shares)[np.ix_(order, order)]
        np.testing.assert_allclose(
            upper + np.triu(upper, 1).T, inertia, atol=1e-13 * np.abs(inertia).max()
        )
