"""Constraints of closed loops, states that satisfy them, and accelerations by the null space."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.errors import InputError
from adagen.library import read
from adagen.model import (
    LOOP_KINDS,
    PRISMATIC,
    REVOLUTE,
    SPHERICAL,
    JointKind,
    LoopEnd,
    Model,
    NamedLoop,
)
from adagen.reference import exact_forward_dynamics, inverse_dynamics, residual
from adagen.reference.closed import (
    closed_forward_dynamics,
    closed_states,
    constraints,
    moved,
)
from adagen.reference.loop_rows import loop_rows
from adagen.reference.numbers import DOUBLE
from tests.mechanisms import (
    MECHANISMS,
    four_bar,
    looped_tree,
    planar_chain,
    states_of,
    with_loops,
)
from tests.models import shrunk

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
    for q, v, tau in states.each:
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


@pytest.mark.parametrize("floating", [False, True])
@pytest.mark.parametrize("kind", LOOP_KINDS)
def test_drift_is_how_rates_of_gaps_change_along_the_motion(kind: str, floating: bool) -> None:
    model = looped_tree(kind, 3, joints=7, floating=floating, kinds=KINDS)
    (q,), (v,) = closed_states(model, 1, starts=60)
    rows, drift = loop_rows(DOUBLE, model, q, v)
    np.testing.assert_allclose(rows, constraints(model, q).rows, atol=1e-12)
    step = 1e-3
    ahead, behind = (constraints(model, moved(model, q, s * step * v)).rows @ v for s in (1, -1))
    np.testing.assert_allclose((ahead - behind) / (2 * step), drift, atol=1e-4)


@pytest.mark.parametrize("name", MECHANISMS)
def test_exact_accelerations_are_those_of_the_null_space(name: str) -> None:
    model = MECHANISMS[name]()
    states = states_of(model, 3)
    for q, v, tau in states.each:
        truth = exact_forward_dynamics(model, q, v, tau, digits=40)
        size = max(1.0, np.abs(truth.value).max())
        assert truth.error < 1e-40
        assert np.abs(closed_forward_dynamics(model, q, v, tau) - truth.value).max() < 1e-9 * size
        assert residual(model, q, v, tau, truth.value) < 1e-12
        assert residual(model, q, v, tau, truth.value + 1e-3 * size) > 1e-6


def test_exact_accelerations_are_the_true_ones(shared: Path) -> None:
    """Of mechanisms whose answers somebody else computed with 420 bits."""
    count = 0
    for path in sorted((shared / "loops").glob("*.scene.toml")):
        name = path.name.removesuffix(".scene.toml")
        modes = json.loads(path.with_name(f"{name}.json").read_text())["modes"]
        for mode, told in modes.items():
            if told.get("answer", "qdd") != "qdd":
                continue
            urdf = path.with_name(f"{name}.urdf")
            model = read(urdf, scene=path, floating=mode == "floating").model
            q, v, tau, qdd = (
                np.hstack([np.ravel(told["joints"][j.name][key][1]) for j in model.joints])
                for key in ("q", "v", "tau", "qdd")
            )
            found = exact_forward_dynamics(model, q, v, tau, digits=20).value
            size = max(1.0, np.abs(qdd).max())
            assert np.abs(found - qdd).max() < told["tolerance"] / 10 * size, (name, mode)
            count += 1
    assert count >= 50


def test_a_motion_that_nothing_determines_has_no_exact_acceleration() -> None:
    bars = planar_chain(0.2, 0.5, 0.4, massless=2)
    pin = LoopEnd("p1_link", (0.5, 0.0, 0.0)), LoopEnd(bars.links[0].name, (0.45, 0.0, 0.0))
    model = with_loops(bars, (NamedLoop("pin", "spherical", *pin),))
    q, v = closed_states(model, 1)
    with pytest.raises(InputError, match="singular"):
        exact_forward_dynamics(model, q[0], v[0], np.zeros(3))


@pytest.mark.parametrize("kinds", [(REVOLUTE,), (REVOLUTE, PRISMATIC)], ids=["hinges", "slides"])
@pytest.mark.parametrize("kind", ["universal", "revolute", "spherical"])
def test_loops_of_small_robots_are_closed_in_their_own_unit(
    kind: str, kinds: tuple[JointKind, ...]
) -> None:
    """Beside radians, gaps of millimetres were next to nothing: those of hinges were not closed."""
    length, usual = 1e-3, looped_tree(kind, 3, joints=9, kinds=kinds)
    small = shrunk(usual, length**3, length)
    q, _ = closed_states(small, 6)
    assert len(q) == 6
    slides = [small.q_start[j] for j, joint in enumerate(small.joints) if joint.kind is PRISMATIC]
    q[:, slides] /= length
    for one in q:
        assert np.abs(constraints(usual, one).gaps).max() < 1e-9
