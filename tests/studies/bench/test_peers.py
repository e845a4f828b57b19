"""Peers solve the same robots as adagen, whatever their own coordinates are."""

from __future__ import annotations

import importlib.util
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.errors import EnvironmentFault
from adagen.model import Model, canonical
from adagen.reference import forward_dynamics
from adagen.states import random_states
from adagen.studies.bench.contest import Contestant
from adagen.studies.bench.peers import contestants, missing
from adagen.studies.truth import DOUBLE, truth_of
from tests.models import random_tree, serial_chain, star

pytestmark = pytest.mark.skipif(
    not any(map(shutil.which, ("g++", "clang++"))), reason="no compiler"
)


def made(name: str, model: Model, folder: Path) -> list[Contestant]:
    reason = missing(name)
    if reason is not None:
        pytest.skip(reason)
    states = random_states(model, 4, seed=2)
    return list(contestants(name, model, states, folder))


def check(field: list[Contestant], model: Model) -> None:
    truth = truth_of(model, random_states(model, 3, seed=5), digits=DOUBLE)
    assert field
    for one in field:
        errors = truth.errors(one.solve(truth.states))
        assert errors.forward < 1e-9, one.name
        turn = one.turn(1)["in_place"]
        assert 0 < turn.least <= turn.median


# Every kind of joint, also inside the tree and in turned frames.
def every_kind() -> Model:
    return random_tree(np.random.default_rng(3), 12)


@pytest.mark.parametrize("name", ["casadi", "mujoco"])
@pytest.mark.parametrize("model", [every_kind, lambda: star(3, floating=True)])
def test_a_peer_gives_the_true_accelerations(
    name: str, model: Callable[[], Model], tmp_path: Path
) -> None:
    robot = model()
    check(made(name, robot, tmp_path), robot)


@pytest.mark.slow
def test_every_build_of_pinocchio_gives_them_too(tmp_path: Path) -> None:
    robot = every_kind()
    check(made("pinocchio", robot, tmp_path), robot)


@pytest.mark.skipif(importlib.util.find_spec("casadi") is None, reason="casadi is not installed")
@settings(max_examples=15)
@given(seed=st.integers(0, 10**6), joints=st.integers(1, 8), exact=st.booleans())
def test_the_symbolic_recursion_is_right_on_random_trees(
    seed: int, joints: int, exact: bool
) -> None:
    from adagen.studies.bench.peers.symbolic_aba import forward_dynamics as symbolic

    model = random_tree(np.random.default_rng(seed), joints)
    states = random_states(model, 1, seed=seed)
    state = (states.q[0], states.v[0], states.tau[0])
    truth = forward_dynamics(model, *state)
    found = np.array(symbolic(canonical(model), exact=exact)(*state)).ravel()
    assert np.abs(found - truth).max() < 1e-8 * max(1.0, np.abs(truth).max())


def test_a_robot_too_large_for_a_straight_line_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if missing("casadi"):
        pytest.skip("casadi is not installed")
    monkeypatch.setattr("adagen.studies.bench.peers.casadi.MOST_OPERATIONS", 100)
    with pytest.raises(EnvironmentFault, match="straight-line code would have"):
        made("casadi", serial_chain(4), tmp_path)


def test_what_is_not_installed_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("adagen.studies.bench.peers.package", lambda _: None)
    assert missing("mujoco") == "the package mujoco is not installed: pip install 'adagen[bench]'"
