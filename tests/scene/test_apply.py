"""What a scene makes of a robot: each reduction changes the answers by rounding only."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import FLOATING, PLANAR, PRISMATIC, REVOLUTE, SPHERICAL, Mimic, Model
from adagen.model.kinds import JointKind
from adagen.reference import (
    bias,
    exact_forward_dynamics,
    forward_dynamics,
    joint_space_inertia,
    kinetic_energy,
    potential_energy,
)
from adagen.scene import apply_scene
from adagen.scene.lock import lock
from adagen.scene.types import Base, JointScene, PointMass, Scene
from adagen.states import random_states
from adagen.tomlfile import Source
from adagen.urdf import read_robot
from tests.models import ALL_KINDS, random_tree, serial_chain
from tests.scene.held import held, rows
from tests.scene.texts import reduced

Array = NDArray[np.float64]
SOURCE = Source("s.toml", "")


def compare(model: Model, small: Model, locked: Sequence[int], seed: int = 1) -> None:
    """Check that locking is the same as holding at rest, to many digits."""
    sample = random_states(model, 1, seed)
    q, v, tau = sample.q[0], sample.v[0], sample.tau[0]
    free = [j for j in range(len(model.joints)) if j not in locked]
    v[rows(model, locked)] = 0.0
    tau[rows(model, locked)] = 0.0
    want = exact_forward_dynamics(held(model, locked), q, v, tau, digits=25).value
    qf, vf = rows(model, free, "q"), rows(model, free)
    got = exact_forward_dynamics(small, q[qf], v[vf], tau[vf], digits=25).value
    error = abs(got - want[vf]).max() / abs(want).max()
    assert error < 1e-12


@settings(max_examples=25)
@given(st.integers(0, 10**6), st.integers(3, 12))
def test_locked_joints_of_any_kind_are_those_held_at_rest(seed: int, n: int) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, n, ALL_KINDS)
    locked = sorted(rng.choice(n, size=rng.integers(1, n), replace=False).tolist())
    sample = random_states(model, 1, seed=1)
    values = {j: sample.q[0][rows(model, [j], "q")].tolist() for j in locked}
    small = lock(model, values)
    assert [joint.name for joint in small.joints] == [
        joint.name for j, joint in enumerate(model.joints) if j not in locked
    ]
    compare(model, small, locked)


def test_a_rotated_child_is_lumped_to_the_last_digit() -> None:
    model = serial_chain(3, axes="xyz")
    small = lock(model, {1: [0.7], 2: [-1.1]})
    assert small.links[1].merged == ("j001_link", "j002_link")
    sample = random_states(small, 1, seed=3)
    q = np.array([sample.q[0][0], 0.7, -1.1])
    v = np.array([sample.v[0][0], 0.0, 0.0])
    assert kinetic_energy(small, q[:1], v[:1]) == pytest.approx(
        kinetic_energy(model, q, v), rel=4e-16
    )
    assert potential_energy(small, q[:1]) == pytest.approx(potential_energy(model, q), rel=4e-15)


def test_locking_at_zero_is_what_a_fixed_joint_is(tmp_path: Path) -> None:
    models = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
    text = (models / "humanoid.urdf").read_text()
    arms = [f"{side}_{part}" for side in ("left", "right") for part in (
        "shoulder_pitch", "shoulder_roll", "shoulder_yaw", "elbow", "wrist_roll", "wrist_pitch",
    )]  # fmt: skip
    for name in arms:
        text = text.replace(
            f'<joint name="{name}" type="revolute">', f'<joint name="{name}" type="fixed">'
        )
    (tmp_path / "fixed.urdf").write_text(text)
    fixed = read_robot(tmp_path / "fixed.urdf", floating=True).model
    whole = read_robot(models / "humanoid.urdf", floating=True).model
    scene = "[lock]\n" + "".join(f"{name} = 0\n" for name in arms)
    small = reduced(whole, tmp_path, scene).model
    assert [j.name for j in small.joints] == [j.name for j in fixed.joints]
    for a, b in zip(small.links, fixed.links, strict=True):
        assert set(a.merged) == set(b.merged)
        assert a.inertia.mass == b.inertia.mass
        np.testing.assert_allclose(a.inertia.com, b.inertia.com, rtol=1e-14, atol=1e-16)
        np.testing.assert_allclose(a.inertia.tensor, b.inertia.tensor, rtol=1e-13, atol=1e-16)
    for mine, other in zip(small.joints, fixed.joints, strict=True):
        assert mine.parent == other.parent
        np.testing.assert_allclose(mine.translation, other.translation, atol=1e-15)


def test_slaved_joints_are_locked_with_their_source(tmp_path: Path) -> None:
    chain = serial_chain(4)
    joints = list(chain.joints)
    joints[3] = replace(joints[3], mimic=Mimic(1, -2.0, 0.5))
    model = replace(chain, joints=tuple(joints))
    reduction = reduced(model, tmp_path, "[lock]\nj001 = 0.3\n")
    assert reduction.locked == {"j001": (0.3,), "j003": (-2.0 * 0.3 + 0.5,)}
    assert [j.name for j in reduction.model.joints] == ["j000", "j002"]
    kept = reduced(model, tmp_path, 'lock_all_but = ["j001"]\n').model
    assert [j.name for j in kept.joints] == ["j001", "j003"]
    assert kept.joints[1].mimic == Mimic(0, -2.0, 0.5)


def test_lock_all_but_takes_the_rest_at_zero_or_as_told(tmp_path: Path) -> None:
    model = serial_chain(4, floating=True)
    text = 'lock_all_but = ["j002"]\n[lock]\nj001 = 0.5\n'
    reduction = reduced(model, tmp_path, text)
    assert [j.name for j in reduction.model.joints] == ["__base__", "j002"]
    assert reduction.locked == {"j000": (0.0,), "j001": (0.5,), "j003": (0.0,)}


@pytest.mark.parametrize(
    ("base", "kind", "rows_of_base"),
    [
        (Base("planar"), PLANAR, [0, 1, 5]),
        (Base("prismatic", (0.0, 3.0, 0.0)), PRISMATIC, [1]),
        (Base("revolute", (1.0, 0.0, 0.0)), REVOLUTE, [3]),
        (Base("spherical"), SPHERICAL, [3, 4, 5]),
    ],
)
def test_a_restricted_base_is_a_floating_one_held_in_the_other_directions(
    base: Base, kind: JointKind, rows_of_base: list[int]
) -> None:
    """At the home pose the base's directions are coordinates of the floating one."""
    model = serial_chain(3, floating=True)
    small = apply_scene(model, Scene(SOURCE, base=base)).model
    assert small.joints[0].kind is kind
    assert not small.floating
    sample = random_states(model, 1)
    q = sample.q[0]
    q[:7] = [0, 0, 0, 0, 0, 0, 1]
    keep = [*rows_of_base, 6, 7, 8]
    tau = sample.tau[0][keep]
    h = joint_space_inertia(model, q)[np.ix_(keep, keep)]
    want = np.linalg.solve(h, tau - bias(model, q, np.zeros(9))[keep])
    start = np.zeros(kind.nq)
    if kind is SPHERICAL:
        start[3] = 1.0
    got = forward_dynamics(small, np.concatenate([start, q[7:]]), np.zeros(kind.nv + 3), tau)
    np.testing.assert_allclose(got, want, rtol=1e-10)


def test_point_masses_add_up_where_they_are(tmp_path: Path) -> None:
    model = serial_chain(2)
    text = """
        [[point_masses]]
        link = "j001_link"
        mass = 2.0
        position = [0.1, 0.2, 0.3]
        [[point_masses]]
        link = "j001_link"
        mass = 1.0
    """
    link = reduced(model, tmp_path, text).model.links[2].inertia
    own = model.links[2].inertia
    assert link.mass == own.mass + 3.0
    first = own.mass * own.com + 2.0 * np.array([0.1, 0.2, 0.3])
    np.testing.assert_allclose(link.com, first / link.mass, rtol=1e-15)

    def about_origin(mass: float, com: Array, tensor: Array) -> Array:
        return tensor + mass * (com @ com * np.eye(3) - np.outer(com, com))

    want = about_origin(own.mass, own.com, own.tensor)
    want = want + about_origin(2.0, np.array([0.1, 0.2, 0.3]), np.zeros((3, 3)))
    np.testing.assert_allclose(about_origin(link.mass, link.com, link.tensor), want, rtol=1e-14)


def test_a_point_mass_on_a_locked_link_goes_where_the_link_goes(tmp_path: Path) -> None:
    model = serial_chain(3)
    text = "[lock]\nj002 = 0.4\n" + '[[point_masses]]\nlink = "j002_link"\nmass = 1.5\n'
    small = reduced(model, tmp_path, text).model
    whole = reduced(model, tmp_path, '[[point_masses]]\nlink = "j002_link"\nmass = 1.5\n').model
    compare_at = random_states(whole, 1, seed=5)
    q, v, tau = compare_at.q[0], compare_at.v[0], compare_at.tau[0]
    q[2], v[2], tau[2] = 0.4, 0.0, 0.0
    want = exact_forward_dynamics(held(whole, [2]), q, v, tau).value[:2]
    got = exact_forward_dynamics(small, q[:2], v[:2], tau[:2]).value
    np.testing.assert_allclose(got, want, rtol=1e-13)


def test_gravity_is_the_scenes(tmp_path: Path) -> None:
    model = serial_chain(2)
    assert reduced(model, tmp_path, "gravity = [0, 0, -1.62]").model.gravity[2] == -1.62
    assert not reduced(model, tmp_path, "gravity = [0, 0, 0]").model.gravity.any()


NAMES = {
    # scene: (line, words)
    'keep = ["j000_lnk"]': (1, "'j000_lnk' is not a link of the robot; did you mean 'j000_link'?"),
    'forces = ["x"]': (1, "'x' is not a link of the robot"),
    'forces = ["ground"]': (1, "fixed to the ground"),
    '\naccelerations = ["j00"]': (2, "'j00' is not a moving joint of the robot; did you mean"),
    'lock_all_but = ["j9"]': (1, "'j9' is not a moving joint"),
    "[lock]\nj0000 = 1": (2, "did you mean 'j000'?"),
    "[lock]\n__base__ = [0,0,0,0,0,0,1]": (2, "the base is fixed; write base"),
    "[lock]\nj000 = [1, 2]": (2, "2 numbers; a revolute joint needs a number"),
    "[lock]\nball = 1": (2, "1 numbers; a spherical joint needs 4 numbers"),
    "[lock]\nball = [0,0,0,2]": (2, "the quaternion has length 2, not 1"),
    "[lock]\nj003 = 1": (2, "joint 'j003' follows 'j001': lock that one"),
    'lock_all_but = ["j003"]': (1, "joint 'j003' follows 'j001': name that one"),
    'lock_all_but = ["j000"]\n[lock]\nj000 = 1': (3, "is locked and in 'lock_all_but'"),
    "[lock]\nj000 = 1\n[joints.j000]\ndamping = 1": (3, "is locked: it can have no other keys"),
    "lock_all_but = []": (1, "leaves no joint that can move"),
    "[joints.j00x]\ndamping = 1": (1, "'j00x' is not a moving joint"),
    "[joints.ball]\nfriction = 1": (2, "is spherical: friction has no single meaning"),
    "[joints.j003]\nprescribed = true": (2, "follows 'j001': its motion is known"),
    "[joints.j001]\nprescribed = true": (2, "a joint that is followed cannot be prescribed"),
    '[[point_masses]]\nlink = "hand"\nmass = 1': (2, "'hand' is not a link"),
    '[[point_masses]]\nlink = "ground"\nmass = 1': (2, "a mass there has no effect"),
    'accelerations = ["j000"]\n[lock]\nj000 = 1': (1, "is locked: its acceleration"),
    "accelerations = []": (1, "names no joint"),
}


@pytest.mark.parametrize("text", NAMES)
def test_what_the_robot_does_not_have_is_refused_by_line(text: str, tmp_path: Path) -> None:
    chain = serial_chain(5)
    joints = list(chain.joints)
    joints[3] = replace(joints[3], mimic=Mimic(1, 1.0, 0.0))
    joints[4] = replace(joints[4], name="ball", kind=SPHERICAL, axis=np.array([0.0, 0.0, 1.0]))
    model = replace(chain, joints=tuple(joints))
    line, words = NAMES[text]
    with pytest.raises(InputError) as refusal:
        reduced(model, tmp_path, text)
    assert str(refusal.value).startswith(f"{tmp_path / 'scene.toml'}:{line}: error: ")
    assert words in str(refusal.value)


def test_a_scene_in_which_all_motion_is_known_has_nothing_to_solve() -> None:
    model = serial_chain(1)
    scene = Scene(SOURCE, joints={"j000": JointScene(prescribed=True)})
    with pytest.raises(InputError, match="every joint's acceleration is prescribed"):
        apply_scene(model, scene)


def test_a_scene_with_a_free_base_needs_a_robot_with_one() -> None:
    with pytest.raises(ValueError, match="floating base"):
        apply_scene(serial_chain(1), Scene(SOURCE, base=Base("floating")))


def test_the_mass_of_a_reduced_robot_is_that_of_the_whole() -> None:
    model = serial_chain(4, floating=True)
    scene = Scene(
        SOURCE, lock={"j001": (0.2,)}, point_masses=(PointMass("j003_link", 1.0, (0, 0, 0)),)
    )
    small = apply_scene(model, scene).model
    assert sum(link.inertia.mass for link in small.links) == pytest.approx(5 * 0.5 + 1.0)
    assert small.joints[0].kind is FLOATING
