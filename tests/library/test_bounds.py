"""Bounds of errors that certified solvers tell."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.errors import SolveError, UsageError
from adagen.executor.refine import WideLinks
from adagen.plan import make_plan
from adagen.plan.certificate import certified
from adagen.reference import exact_forward_dynamics
from adagen.schedule import Topology, schedule_to_json
from adagen.states import random_states
from tests.cli.robots import write_arm
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


def test_a_file_may_ask_for_certified_parts(tmp_path: Path) -> None:
    """Their links are weighed with masses and gravity as they are set."""
    robot = adagen.read(write_arm(tmp_path / "arm.urdf", 30))
    schedule = adagen.compile(robot, procs=1, parts="none").schedule
    given = tmp_path / "schedule.json"
    given.write_text(schedule_to_json(replace(schedule, parts=8), Topology.of(robot.model)))
    asked: dict[str, Any] = {"certify": True, "schedule": str(given), "shape": "kernels"}
    compiled = adagen.compile(robot, runtime="gravity,mass:l12", **asked)
    assert compiled.schedule.parts == 8
    solver = compiled.build()
    solver.gravity = (1.0, 2.0, -3.0)
    solver.set_mass("l12", 40.0)
    links = list(robot.model.links)
    (place,) = (k for k, link in enumerate(links) if link.name == "l12")
    links[place] = replace(links[place], inertia=replace(links[place].inertia, mass=40.0))
    changed = replace(robot.model, links=tuple(links), gravity=np.array([1.0, 2.0, -3.0]))
    states = random_states(changed, 5, seed=4)
    plan = certified(make_plan(changed, compiled.schedule))
    for state in states.each:
        qdd = solver(*state)
        true = exact_forward_dynamics(changed, *state, digits=20).value
        chain = WideLinks(plan, state[0], state[1], np.longdouble)
        error = np.sqrt(chain.energy(qdd - true) / chain.energy(true))
        assert error <= solver.error_bound < 1e-12


def test_others_tell_none(arm: adagen.Solver) -> None:
    with pytest.raises(UsageError, match="compile with certify=True"):
        _ = arm.error_bound
