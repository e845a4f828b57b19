"""Bounds of errors that certified solvers tell."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.errors import SolveError, UsageError
from adagen.plan import plan_from_json
from adagen.states import random_states
from tests.emitted import energy_errors
from tests.golden.make_models import MODELS
from tests.library.solvers import ARM


def test_scene_and_profile_are_in_head_and_plan(tmp_path: Path) -> None:
    scene = tmp_path / "s.toml"
    scene.write_text("gravity = [0, 0, 0]\r\n", newline="")
    made = adagen.compile(adagen.read(ARM, scene=scene))
    files = made.in_folder(tmp_path / "out")
    plan, head = files["arm7_p1.plan.json"], files["arm7_p1.cpp"][:3000]
    origin = json.loads(plan)["made"]
    assert origin["command"][:3] == ["adagen", origin["command"][1], "--scene=../s.toml"]
    inputs = {each["what"]: each for each in origin["inputs"]}
    assert inputs["scene"]["text"].encode() == scene.read_bytes()
    assert 'name = "default"' in inputs["profile default"]["text"]
    for what, each in inputs.items():
        digest = hashlib.sha256(each["text"].encode()).hexdigest()
        assert f"// input     {what}, sha256 {digest}\n" in head
    assert plan_from_json(plan).gravity == plan_from_json(made.files["arm7_p1.plan.json"]).gravity


@pytest.mark.parametrize("asked", [{"shape": "kernels"}, {"shape": "unrolled"}, {"batch": True}])
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
