"""Batches of robots with several ways to solve a state: those that leave one go the next."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.plan import Plan
from adagen.plan.certificate import certified
from adagen.reference.closed import closed_forward_dynamics
from adagen.states import States
from tests.emit.test_reproducible_constants import Library
from tests.emit.test_reproducible_loops import is_poor
from tests.emitted import QUICK, Array, Builder, plan_of
from tests.mechanisms import quadruped, states_of
from tests.slow import slow

COUNT = 120
MODEL = quadruped()


@pytest.fixture(scope="module")
def states() -> States:
    return states_of(MODEL, COUNT, seed=5)


@pytest.fixture(scope="module")
def poor(states: States) -> NDArray[np.bool_]:
    """Whether the first way cannot stand the pose of each state."""
    plan = plan_of(MODEL, 1)
    found = np.array([is_poor(plan, row) for row in states.each])
    assert 8 < found.sum() < COUNT / 2
    return found


@pytest.fixture(scope="module")
def truth(states: States) -> Array:
    return np.array([closed_forward_dynamics(MODEL, *row) for row in states.each])


def some(states: States, chosen: Any) -> States:
    return replace(states, q=states.q[chosen], v=states.v[chosen], tau=states.tau[chosen])


@pytest.mark.parametrize("kind", ["plain", slow("certified"), slow("reproducible")])
def test_every_state_has_its_answer_whatever_way_its_neighbours_go(
    kind: str,
    states: States,
    poor: NDArray[np.bool_],
    truth: Array,
    builder: Builder,
    tmp_path: Path,
) -> None:
    """Few poor poses, many, all and none; two states that nothing can solve are left without."""
    plan: Plan = plan_of(MODEL, 1)
    plan = certified(plan) if kind == "certified" else plan
    plan = replace(plan, reproducible=kind == "reproducible")
    solver = Library(plan, builder, QUICK, tmp_path, refused=True, batch=1)
    every = np.arange(COUNT)
    size = np.abs(truth).max(axis=1)
    for chosen in (
        every,
        np.concatenate([every[poor], every[~poor]]),
        np.tile(every[poor], 20),
        every[~poor],
        every[:1],
        every[poor][:9],
        np.tile(every, 5),
    ):
        found = solver.solve(some(states, chosen))
        off = np.abs(found - truth[chosen]).max(axis=1) / size[chosen]
        assert off.max() < 1e-9
    bad = some(states, np.tile(every, 3))
    bad.q[[17, 200], 9] = np.nan
    found, full = solver.solve(bad), np.tile(truth, (3, 1))
    lost = np.isnan(found).any(axis=1)
    assert np.array_equal(np.flatnonzero(lost), [17, 200])
    assert (np.abs(found - full)[~lost].max(axis=1) / np.tile(size, 3)[~lost]).max() < 1e-9
