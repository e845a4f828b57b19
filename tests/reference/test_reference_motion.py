"""Double-precision answers against closed forms of mechanics."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import FLOATING, PLANAR, PRISMATIC, REVOLUTE, SPHERICAL, Inertia, Model
from adagen.reference import (
    bias,
    energy_norm_error,
    forward_dynamics,
    inverse_dynamics,
    joint_space_inertia,
    kinetic_energy,
    potential_energy,
    residual,
)
from tests.links import with_inertia
from tests.models import (
    Part,
    assemble,
    random_rotation,
    random_tree,
    rod,
    serial_chain,
    vector,
)

Array = NDArray[np.float64]
G = 9.81


def point(mass: float, *place: float) -> Inertia:
    """Return a point mass."""
    return Inertia(mass, vector(*place), np.zeros((3, 3)))


def test_double_pendulum() -> None:
    """Point masses hanging in -z, turning about y: the textbook equations."""
    m1, m2, l1, l2 = 1.3, 0.7, 0.9, 0.4
    down = vector(0.0, 0.0, -l1)
    y = vector(0.0, 1.0, 0.0)
    model = assemble(
        "double_pendulum",
        [
            Part("one", None, REVOLUTE, point(m1, 0.0, 0.0, -l1), axis=y),
            Part("two", "one", REVOLUTE, point(m2, 0.0, 0.0, -l2), down, axis=y),
        ],
    )
    q, v, a = vector(0.6, -1.1), vector(1.5, -0.4), vector(0.3, 2.0)
    c, s = np.cos(q[1]), np.sin(q[1])
    inertia = np.array(
        [
            [m1 * l1**2 + m2 * (l1**2 + 2 * l1 * l2 * c + l2**2), m2 * (l1 * l2 * c + l2**2)],
            [m2 * (l1 * l2 * c + l2**2), m2 * l2**2],
        ]
    )
    coriolis = m2 * l1 * l2 * s * vector(-(2 * v[0] * v[1] + v[1] ** 2), v[0] ** 2)
    outer = m2 * l2 * G * np.sin(q[0] + q[1])
    weight = vector((m1 + m2) * l1 * G * np.sin(q[0]) + outer, outer)
    expected = inertia @ a + coriolis + weight
    np.testing.assert_allclose(joint_space_inertia(model, q), inertia, rtol=1e-14)
    np.testing.assert_allclose(inverse_dynamics(model, q, v, a), expected, rtol=1e-14)
    np.testing.assert_allclose(forward_dynamics(model, q, v, expected), a, rtol=1e-13)


def test_free_rigid_body_obeys_euler() -> None:
    """Origin off the centre of mass: Newton at the centre, Euler about it."""
    rng = np.random.default_rng(3)
    inertia = Inertia(2.5, vector(0.1, -0.2, 0.3), np.diag([0.3, 0.5, 0.6]))
    model = assemble("body", [Part("__base__", None, FLOATING, inertia)], floating=True)
    quaternion = rng.normal(size=4)
    q = np.concatenate([rng.normal(size=3), 3.0 * quaternion])
    v, a = rng.normal(size=6), rng.normal(size=6)
    x, y, z, w = quaternion / np.linalg.norm(quaternion)
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    speed, spin, c = v[:3], v[3:], inertia.com
    classical = a[:3] + np.cross(spin, speed) - turn.T @ vector(0.0, 0.0, -G)
    force = inertia.mass * (classical + np.cross(a[3:], c) + np.cross(spin, np.cross(spin, c)))
    moment = inertia.tensor @ a[3:] + np.cross(spin, inertia.tensor @ spin) + np.cross(c, force)
    expected = np.concatenate([force, moment])
    np.testing.assert_allclose(inverse_dynamics(model, q, v, a), expected, rtol=1e-13)
    np.testing.assert_allclose(forward_dynamics(model, q, v, expected), a, rtol=1e-13)


def test_a_body_in_free_fall_keeps_its_spatial_acceleration() -> None:
    """No force at the centre of mass: it falls with g, v's components turn away under it."""
    body = Inertia(1.0, np.zeros(3), np.diag([1.0, 2.0, 3.0]))
    model = assemble("body", [Part("__base__", None, FLOATING, body)], floating=True)
    q = vector(0, 0, 5, 0, 0, 0, 1)
    v = vector(1, 2, 3, 0.01, 3, 0.01)
    qdd = forward_dynamics(model, q, v, np.zeros(6))
    spin = v[3:]
    np.testing.assert_allclose(qdd[:3], vector(0, 0, -G) - np.cross(spin, v[:3]), atol=1e-15)
    euler = -np.cross(spin, vector(1, 2, 3) * spin) / vector(1, 2, 3)
    np.testing.assert_allclose(qdd[3:], euler, atol=1e-15)


def test_spherical_pendulum_precesses() -> None:
    """A bob going round a vertical cone at the rate sqrt(g / (l cos)) has no acceleration.

    With the frame not turning about the rod, the bob's angular velocity in the child frame is
    constant but for the turning of the frame itself.
    """
    length, tilt = 0.8, 0.7
    model = assemble("bob", [Part("ball", None, SPHERICAL, rod(1.0, vector(0, 0, -length), 0.05))])
    body = model.links[1].inertia
    about = body.tensor + body.mass * (length / 2) ** 2 * np.diag([1.0, 1.0, 0.0])
    # Steady precession of a symmetric top without own spin in the frame that precesses with it:
    # (A - C) W^2 sin cos = m g (l / 2) sin, spin about the rod W cos in the direction of C.
    rate = np.sqrt(body.mass * G * length / 2 / ((about[0, 0] - about[2, 2]) * np.cos(tilt)))
    half = tilt / 2
    q = vector(0.0, np.sin(half), 0.0, np.cos(half))
    up = vector(-np.sin(tilt), 0.0, np.cos(tilt))  # the vertical in the child frame
    qdd = forward_dynamics(model, q, rate * up, np.zeros(3))
    np.testing.assert_allclose(qdd, np.zeros(3), atol=1e-12 * rate**2)


@pytest.mark.parametrize("axis", [(0, 0, 1), (1, 0, 0), (0, -1, 0), (0.36, 0.48, -0.8)])
def test_a_planar_joint_slides_in_its_plane(axis: tuple[float, float, float]) -> None:
    """In the plane the weight's part along it pulls, turned into the child frame by theta."""
    rng = np.random.default_rng(7)
    inertia = Inertia(2.0, np.zeros(3), 0.1 * np.eye(3))
    placed = random_rotation(rng)
    part = Part("slide", None, PLANAR, inertia, rotation=placed, axis=vector(*axis))
    model = assemble("slab", [part])
    q, v = vector(0.4, -0.3, 0.9), vector(1.0, 2.0, -0.5)
    qdd = forward_dynamics(model, q, v, np.zeros(3))
    normal = placed @ vector(*axis)
    weight = vector(0.0, 0.0, -G)
    along = weight - normal * (normal @ weight)
    # The classical acceleration in the plane is qdd + w x v.
    classical = vector(qdd[0] - v[2] * v[1], qdd[1] + v[2] * v[0])
    assert np.linalg.norm(classical) == pytest.approx(np.linalg.norm(along), rel=1e-14)
    assert qdd[2] == pytest.approx(0.0, abs=1e-14)
    turned = forward_dynamics(model, vector(0, 0, 0.9 + np.pi / 2), v * 0, np.zeros(3))
    still = forward_dynamics(model, vector(0, 0, 0.9), v * 0, np.zeros(3))
    np.testing.assert_allclose(turned[:2], [still[1], -still[0]], atol=1e-14)


def test_planar_about_z_uses_the_axes_of_the_joint_frame() -> None:
    model = assemble("slab", [Part("slide", None, PLANAR, point(2.0, 0.0, 0.0, 0.0))])
    model = model.with_gravity(vector(3.0, 4.0, 0.0))
    model = with_inertia(model, 1, Inertia(2.0, np.zeros(3), np.eye(3)))
    q = vector(5.0, 6.0, np.pi / 2)
    qdd = forward_dynamics(model, q, np.zeros(3), vector(2.0, 0.0, 3.0))
    np.testing.assert_allclose(qdd, vector(4.0 + 1.0, -3.0, 3.0), atol=1e-14)


def test_prismatic_joint_on_a_slope() -> None:
    axis = vector(np.cos(0.3), 0.0, -np.sin(0.3))
    model = assemble("sled", [Part("slide", None, PRISMATIC, point(3.0, 0.1, 0, 0), axis=axis)])
    qdd = forward_dynamics(model, [0.7], [0.2], [6.0])
    np.testing.assert_allclose(qdd, [G * np.sin(0.3) + 2.0], rtol=1e-14)


@pytest.mark.parametrize("seed", range(6))
def test_inertia_is_what_unit_accelerations_take(seed: int) -> None:
    """Two recursions that share nothing: composite bodies, and Newton-Euler column by column."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 14, floating=bool(seed % 2))
    q, still = rng.normal(size=model.nq), np.zeros(model.nv)
    weight = bias(model, q, still)
    columns = [inverse_dynamics(model, q, still, unit) - weight for unit in np.eye(model.nv)]
    inertia = joint_space_inertia(model, q)
    np.testing.assert_allclose(inertia, np.array(columns).T, atol=1e-12)
    np.testing.assert_array_equal(inertia, inertia.T)


@pytest.mark.parametrize("seed", range(4))
def test_kinetic_energy_is_half_v_inertia_v(seed: int) -> None:
    rng = np.random.default_rng(100 + seed)
    model = random_tree(rng, 12, mimics=3, floating=bool(seed % 2))
    q, v = rng.normal(size=model.nq), rng.normal(size=model.nv)
    for joint, start in zip(model.joints, model.v_start, strict=True):
        if joint.mimic:
            v[start] = v[model.v_start[joint.mimic.source]] * joint.mimic.multiplier
    half = v @ joint_space_inertia(model, q) @ v / 2
    assert kinetic_energy(model, q, v) == pytest.approx(half, rel=1e-13)


def test_potential_energy_of_a_lifted_rod() -> None:
    model = serial_chain(1, axes="y", mass=2.0, length=1.0)
    assert potential_energy(model, [-np.pi / 2]) == pytest.approx(2.0 * G * 0.5, rel=1e-14)


class TestSlaved:
    """Joints slaved to others, against the same mechanism with fewer coordinates."""

    def model(self) -> Model:
        y = vector(0.0, 1.0, 0.0)
        step = vector(0.3, 0.0, 0.0)
        return assemble(
            "hand",
            [
                Part("a", None, REVOLUTE, rod(1.0, step), axis=y),
                Part("b", "a", REVOLUTE, rod(0.5, step), step, axis=y, mimic=("a", -2.0, 0.3)),
                Part("c", "b", REVOLUTE, rod(0.3, step), step, axis=y),
                Part("d", "c", REVOLUTE, rod(0.2, step), step, axis=y, mimic=("b", 0.5, 0.1)),
            ],
        )

    def free(self) -> Model:
        model = self.model()
        return replace(model, joints=tuple(replace(j, mimic=None) for j in model.joints))

    def test_projected_equations_hold(self) -> None:
        shares = np.array([[1, 0], [-2, 0], [0, 1], [-1, 0]])
        q, tau = vector(0.4, -0.5, 0.7, -0.15), vector(0.1, -0.7, 0.3, 2.0)
        v = shares @ vector(1.1, -0.6)
        qdd = forward_dynamics(self.model(), q, v, tau)
        np.testing.assert_allclose(qdd, shares @ qdd[[0, 2]], rtol=1e-14)
        needed = inverse_dynamics(self.free(), q, v, qdd)
        np.testing.assert_allclose(shares.T @ needed, shares.T @ tau, atol=1e-13)
        assert residual(self.model(), q, v, tau, qdd) < 1e-14
        assert residual(self.free(), q, v, tau, qdd) > 1e-2

    def test_what_is_said_of_a_follower_is_not_used(self) -> None:
        q, v = vector(0.4, -0.5, 0.7, -0.15), vector(1.1, -2.2, -0.6, -1.1)
        wrong_q, wrong_v = vector(0.4, 9.0, 0.7, 9.0), vector(1.1, 9.0, -0.6, 9.0)
        tau = vector(1.0, 2.0, 3.0, 4.0)
        right = forward_dynamics(self.model(), q, v, tau)
        np.testing.assert_allclose(
            forward_dynamics(self.model(), wrong_q, wrong_v, tau), right, rtol=1e-13
        )

    def test_a_followers_torque_counts_through_its_multiplier(self) -> None:
        q, v = vector(0.4, -0.5, 0.7, -0.15), vector(1.1, -2.2, -0.6, -1.1)
        one = forward_dynamics(self.model(), q, v, vector(0.0, 1.5, 0.0, 0.0))
        other = forward_dynamics(self.model(), q, v, vector(-3.0, 0.0, 0.0, 0.0))
        np.testing.assert_allclose(one, other, rtol=1e-14)

    def test_inverse_gives_the_share_to_the_source(self) -> None:
        q, v, a = vector(0.4, 0, 0.7, 0), vector(1.1, 0, -0.6, 0), vector(0.5, 0, 0.2, 0)
        tau = inverse_dynamics(self.model(), q, v, a)
        assert tau[1] == tau[3] == 0.0
        qdd = forward_dynamics(self.model(), q, v, tau)
        np.testing.assert_allclose(qdd, [0.5, -1.0, 0.2, -0.5], rtol=1e-12)

    def test_a_ring_is_refused(self) -> None:
        model = self.model()
        joints = list(model.joints)
        mimic = joints[1].mimic
        assert mimic is not None
        joints[0] = replace(joints[0], mimic=replace(mimic, source=3))
        model = replace(model, joints=tuple(joints))
        with pytest.raises(InputError, match="ring"):
            forward_dynamics(model, np.zeros(4), np.zeros(4), np.zeros(4))


def test_residual_sees_an_error_and_no_nan_passes() -> None:
    model = serial_chain(5)
    rng = np.random.default_rng(0)
    q, v, tau = rng.normal(size=5), rng.normal(size=5), rng.normal(size=5)
    qdd = forward_dynamics(model, q, v, tau)
    assert residual(model, q, v, tau, qdd) < 1e-14
    assert residual(model, q, v, tau, qdd * (1 + 1e-6)) > 1e-9
    assert residual(model, q, v, tau, np.full(5, np.nan)) == np.inf
    floating = model.with_gravity(np.zeros(3))
    assert residual(floating, q, np.zeros(5), np.zeros(5), np.zeros(5)) == 0.0
    assert residual(floating, q, np.zeros(5), np.zeros(5), qdd) == 1.0


def test_energy_norm() -> None:
    h = np.diag([4.0, 9.0])
    assert energy_norm_error(h, [1.0, 0.0], [0.0, 1.0]) == pytest.approx(2 / 3)
    assert energy_norm_error(h, [0.0, 0.0], [0.0, 0.0]) == 0.0
    assert energy_norm_error(h, [1.0, 0.0], [0.0, 0.0]) == np.inf
    assert energy_norm_error(h, [np.nan, 0.0], [1.0, 0.0]) == np.inf
