"""Bounds of errors that certified solvers tell."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import adagen
from adagen.errors import SolveError, UsageError
from adagen.states import random_states
from tests.emitted import energy_errors
from tests.golden.make_models import MODELS
from tests.slow import slow


@pytest.mark.parametrize(
    "asked", [{"shape": "kernels"}, slow({"shape": "unrolled"}), {"batch": True}]
)
def test_certified_solvers_tell_bounds(asked: dict[str, Any]) -> None:
    robot = adagen.read(MODELS / "arm7.urdf")
    solver = adagen.compile(robot, certify=True, **asked).build()
    with pytest.raises(UsageError, match="there is no bound"):
        _ = solver.error_bound
    states = random_states(robot.model, 9, seed=3)
    found = solver(states.q, states.v, states.tau)
    bounds = solver.error_bound
    assert bounds.shape == (9,)
    assert (energy_errors(robot.model, states, found) <= 3 * bounds).all()
    assert (bounds < 1e-12).all()
    shared = solver(states.q, states.v, states.tau, threads=2)
    assert np.array_equal(shared, found)
    assert np.array_equal(solver.error_bound, bounds)
    solver(states.q[4], states.v[4], states.tau[4])
    assert solver.error_bound == pytest.approx(bounds[4], rel=1e-6)
    spoilt = states.q.copy()
    spoilt[2] = np.nan
    with pytest.raises(SolveError):
        solver(spoilt, states.v, states.tau)
    assert np.isnan(solver.error_bound).tolist() == [k == 2 for k in range(9)]


def test_others_tell_none(arm: adagen.Solver) -> None:
    with pytest.raises(UsageError, match="compile with certify=True"):
        _ = arm.error_bound
