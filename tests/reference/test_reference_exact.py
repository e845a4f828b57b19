"""Answers to any precision: certified, consistent, and conserving energy to every digit."""

from __future__ import annotations

import numpy as np
import pytest
from flint import arb, ctx
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.errors import InputError
from adagen.exact import exact
from adagen.model import FLOATING, PLANAR, SPHERICAL, Inertia, Model
from adagen.reference import (
    exact_forward_dynamics,
    exact_inverse_dynamics,
    forward_dynamics,
    inverse_dynamics,
)
from adagen.reference.inertia import inertia_matrix
from adagen.reference.kinematics import placements
from adagen.reference.newton_euler import energies, joint_torques
from adagen.reference.numbers import BALLS, Numeric
from tests.links import with_inertia
from tests.models import human_figure, random_tree, serial_chain, star, three_axis_chain

trees = st.builds(
    lambda seed, n, floating, branching: random_tree(
        np.random.default_rng(seed), n, floating=floating, branching=branching
    ),
    st.integers(0, 2**32 - 1),
    st.integers(1, 10),
    st.booleans(),
    st.sampled_from([0.0, 0.3, 0.8]),
)


def state_of(model: Model, seed: int) -> tuple[Numeric, Numeric, Numeric]:
    rng = np.random.default_rng(seed)
    return rng.normal(size=model.nq), rng.normal(size=model.nv), rng.normal(size=model.nv)


@settings(max_examples=40)
@given(model=trees, seed=st.integers(0, 1000))
def test_double_agrees_and_both_recursions_agree_to_every_digit(model: Model, seed: int) -> None:
    """H of composite bodies is what Newton-Euler needs for unit accelerations: to 1e-60."""
    q, v, tau = state_of(model, seed)
    answer = exact_forward_dynamics(model, q, v, tau)
    assert 0 < answer.error < 1e-60
    scale = max(1.0, float(np.abs(answer.value).max()))
    fast = forward_dynamics(model, q, v, tau)
    assert np.abs(fast - answer.value).max() <= 1e-9 * scale
    before = ctx.prec
    try:
        ctx.prec = answer.bits
        back = joint_torques(BALLS, model, exact(q), exact(v), answer.raw)
        assert all(abs(x - y) < arb(10) ** -55 for x, y in zip(back, exact(tau), strict=True))
    finally:
        ctx.prec = before


@settings(max_examples=15)
@given(model=trees, seed=st.integers(0, 1000))
def test_energy_changes_by_the_work_of_the_torques(model: Model, seed: int) -> None:
    """d/dt (kinetic + potential) = v . tau; with steps of 1e-30 s nothing but digits is lost."""
    q, v, tau = (exact(x) for x in state_of(model, seed))
    answer = exact_forward_dynamics(model, *state_of(model, seed), digits=100)
    before = ctx.prec
    try:
        ctx.prec = 700
        step = arb(10) ** -30
        qd = configuration_rate(model, q, v)
        after = sum(energies(BALLS, model, q + qd * step, v + answer.raw * step))
        earlier = sum(energies(BALLS, model, q - qd * step, v - answer.raw * step))
        power = (after - earlier) / (2 * step)
        size = 1 + abs(power) + sum(abs(x * y) for x, y in zip(v, tau, strict=True))
        assert abs(power - v.dot(tau)) < size * arb(10) ** -45
    finally:
        ctx.prec = before


def configuration_rate(model: Model, q: Numeric, v: Numeric) -> Numeric:
    """Return dq/dt: quaternions turn by half the product with the angular velocity."""
    rate = BALLS.zeros(model.nq)
    placed = placements(BALLS, model, q)
    for j, joint in enumerate(model.joints):
        at, own = model.q_start[j], v[model.v_start[j] : model.v_start[j] + joint.kind.nv]
        if joint.kind in (FLOATING, PLANAR):
            # The child's origin moves along the child's axes, q tells where it is in the joint's.
            base = placements(BALLS, model, at_rest(model))[j].rotation
            turned = base.T.dot(placed[j].rotation).dot(placed[j].linear.dot(own))
            if joint.kind is FLOATING:
                rate[at : at + 3] = turned
            else:
                frame = BALLS.turn(joint.axis)
                rate[at : at + 2] = frame.T.dot(turned)[:2]
                rate[at + 2] = own[2]
        if joint.kind in (FLOATING, SPHERICAL):
            start = at + joint.kind.nq - 4
            rate[start : start + 4] = quaternion_rate(q[start : start + 4], own[-3:])
        if joint.kind.nq == 1:
            rate[at] = own[0]
    return rate


def at_rest(model: Model) -> Numeric:
    q = np.zeros(model.nq)
    for joint, start in zip(model.joints, model.q_start, strict=True):
        if joint.kind.quaternion is not None:
            q[start + joint.kind.nq - 1] = 1.0
    return exact(q)


def quaternion_rate(p: Numeric, w: Numeric) -> Numeric:
    x, y, z, s = p
    return np.array(
        [
            (s * w[0] + y * w[2] - z * w[1]) / 2,
            (s * w[1] + z * w[0] - x * w[2]) / 2,
            (s * w[2] + x * w[1] - y * w[0]) / 2,
            -(x * w[0] + y * w[1] + z * w[2]) / 2,
        ],
        dtype=object,
    )


@pytest.mark.parametrize(
    "model",
    [human_figure(), star(5), three_axis_chain(3), serial_chain(6, kind=SPHERICAL)],
    ids=lambda m: m.name,
)
def test_double_is_right(model: Model) -> None:
    q, v, tau = state_of(model, 11)
    answer = exact_forward_dynamics(model, q, v, tau)
    fast = forward_dynamics(model, q, v, tau)
    assert np.abs(fast - answer.value).max() <= 1e-12 * np.abs(answer.value).max()
    torque = exact_inverse_dynamics(model, q, v, answer.value)
    assert 0 < torque.error < 1e-60
    near = inverse_dynamics(model, q, v, answer.value)
    assert np.abs(near - torque.value).max() <= 1e-12 * np.abs(torque.value).max()


def test_slaved_joints() -> None:
    model = random_tree(np.random.default_rng(5), 20, mimics=3, floating=True)
    q, v, tau = state_of(model, 2)
    answer = exact_forward_dynamics(model, q, v, tau)
    fast = forward_dynamics(model, q, v, tau)
    assert np.abs(fast - answer.value).max() <= 1e-11 * np.abs(answer.value).max()
    followers = 0
    for joint, row in zip(model.joints, model.v_start, strict=True):
        if joint.mimic:
            followers += 1
            source = answer.value[model.v_start[joint.mimic.source]]
            assert answer.value[row] == pytest.approx(source * joint.mimic.multiplier, rel=1e-15)
    assert followers == 3


def test_digits_are_kept_and_the_precision_around_is_left_alone() -> None:
    model = serial_chain(40, axes="y")
    q, v, tau = state_of(model, 1)
    before = ctx.prec
    short, long = (exact_forward_dynamics(model, q, v, tau, digits=d) for d in (20, 200))
    assert ctx.prec == before
    assert short.error < 1e-20
    assert long.error < 1e-200
    assert long.bits > short.bits
    np.testing.assert_array_equal(short.value, long.value)
    assert all(a.overlaps(b) for a, b in zip(short.raw, long.raw, strict=True))


def test_the_inertia_matrix_is_symmetric_to_the_ball() -> None:
    model = random_tree(np.random.default_rng(9), 8, floating=True)
    inertia = inertia_matrix(BALLS, model, exact(state_of(model, 0)[0]))
    assert all(a.overlaps(b) for a, b in zip(inertia.flat, inertia.T.flat, strict=True))


def test_singular_is_refused_at_every_precision() -> None:
    model = with_inertia(serial_chain(3), 3, Inertia.zero())
    with pytest.raises(InputError, match="singular"):
        exact_forward_dynamics(model, np.ones(3), np.ones(3), np.ones(3))
