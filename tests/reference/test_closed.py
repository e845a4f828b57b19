"""Constraints of closed loops, states that satisfy them, and accelerations by the null space."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.model import LOOP_KINDS, PRISMATIC, REVOLUTE, SPHERICAL, Model
from adagen.reference import inverse_dynamics
from adagen.reference.closed import (
    closed_forward_dynamics,
    closed_states,
    constraints,
    moved,
)
from tests.mechanisms import MECHANISMS, four_bar, looped_tree, states_of

KINDS = (REVOLUTE, PRISMATIC, SPHERICAL)


@pytest.mark.parametrize("floating", [False, True])
@pytest.mark.parametrize("kind", LOOP_KINDS)
def test_rows_are_the_rates_of_gaps(kind: str, floating: bool) -> None:
    model = looped_tree(kind, 3, joints=7, floating=floating, kinds=KINDS)
    (q,), _ = closed_states(model, 1, starts=60)
    rows, step = constraints(model, q).rows, 1e-6
    for k in range(model.nv):
        unit = np.eye(model.nv)[k] * step
        ahead, behind = (constraints(model, moved(model, q, s * unit)).gaps for s in (1, -1))
        np.testing.assert_allclose((ahead - behind) / (2 * step), rows[:, k], atol=1e-8)


@pytest.mark.parametrize("name", MECHANISMS)
def test_states_are_closed_and_stay_so(name: str) -> None:
    model = MECHANISMS[name]()
    states = states_of(model, 5)
    for q, v in zip(states.q, states.v, strict=True):
        found = constraints(model, q)
        assert np.abs(found.gaps).max() < 1e-11
        assert np.abs(found.rows @ v).max() < 1e-12
        assert np.abs(v).max() > 1e-3


@pytest.mark.parametrize("name", MECHANISMS)
def test_what_is_left_over_are_forces_of_constraints(name: str) -> None:
    """ID(qdd) - tau is a combination of the rows of J, and J qdd = -Jdot v."""
    model = MECHANISMS[name]()
    states = states_of(model, 4)
    for q, v, tau in zip(states.q, states.v, states.tau, strict=True):
        qdd = closed_forward_dynamics(model, q, v, tau)
        left = inverse_dynamics(model, q, v, qdd) - tau
        rows = constraints(model, q).rows
        forces = np.linalg.lstsq(rows.T, left, rcond=1e-10)[0]
        np.testing.assert_allclose(rows.T @ forces, left, atol=1e-9 * (1 + np.abs(left).max()))
        step = 1e-4
        ahead = moved(model, q, v * step + qdd * step**2 / 2)
        behind = moved(model, q, -v * step + qdd * step**2 / 2)
        gaps = (constraints(model, ahead).gaps + constraints(model, behind).gaps) / step**2
        assert np.abs(gaps).max() < 1e-6 * (1 + np.abs(qdd).max())


def test_a_loop_that_cannot_close_has_no_states() -> None:
    model = four_bar()
    far = model.loops[0].frame2
    far.translation[0] = 5.0
    q, _ = closed_states(model, 1)
    assert not len(q)


def _rank(model: Model, q: np.ndarray) -> int:
    sizes = np.linalg.svd(constraints(model, q).rows, compute_uv=False)
    return int((sizes > 1e-9 * sizes[0]).sum())


def test_rows_of_planar_loops_follow_from_two() -> None:
    model = four_bar()
    assert {_rank(model, q) for q in states_of(model, 6).q} == {2}
