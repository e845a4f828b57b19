"""Refinement by residuals in the solver's own numbers: what it makes good, says, and refuses."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.cli import main
from adagen.emit import emit, program_of
from adagen.errors import UsageError
from adagen.model import Model
from adagen.plan import make_plan
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from adagen.states import States
from adagen.studies.random_states import hard_states
from adagen.urdf import read_robot
from benchmarks.stability.adversary import FAMILIES, robots
from tests.emit.test_kernel_slaved import damped
from tests.emitted import Builder, energy_errors, plan_of
from tests.golden.make_models import MODELS
from tests.models import serial_chain
from tests.slow import spread

NAMES = [family.__name__ for family in FAMILIES]
GAINS = {"slender_tools": 10, "graded": 30, "balls": 100, "tiny_roots": 2, "wrists": 2}
"""By how much the largest error of hard states becomes smaller, at least."""


def _errors(
    model: Model, states: States, builder: Builder, folder: Path, **options: Any
) -> tuple[np.ndarray, list[list[float]]]:
    plan = plan_of(model, 1, scalar=options.pop("scalar", "double"))
    solver = builder.solver(plan, shape="kernels", **options)
    errors = energy_errors(model, states, solver.solve(model, states, folder))
    return errors, json.loads((folder / "result.json").read_text()).get("corrections", [])


@pytest.mark.parametrize("name", spread([*GAINS, "free_bodies"], 2))
def test_lost_digits_come_back_and_are_told(name: str, builder: Builder, tmp_path: Path) -> None:
    model = robots(len(FAMILIES), seed=2)[NAMES.index(name)]
    states = hard_states(model, 30, seed=2)
    plain, _ = _errors(model, states, builder, tmp_path)
    refined, told = _errors(model, states, builder, tmp_path, refine=1)
    assert refined.max() < max(plain.max() / GAINS.get(name, 0.5), 4e-15)
    large = plain > 10 * np.maximum(refined, 1e-15)  # what was lost, not rounding
    said = np.array(told)[:, 0]
    assert ((said < 3 * plain) & (plain < 3 * said))[large].all()
    assert large.any() or name == "free_bodies"


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("mobile", {"refine": 2}),
        ("humanoid", {"refine": 1}),
        pytest.param("human40", {"refine": 1, "scalar": "float"}, marks=pytest.mark.slow),
    ],
    ids=["all kinds of joints, twice", "lanes", "float"],
)
def test_ordinary_robots_keep_their_digits(
    name: str, options: dict[str, Any], builder: Builder, tmp_path: Path
) -> None:
    model = read_robot(MODELS / f"{name}.urdf").model
    states = hard_states(model, 10, seed=3)
    states = states.read_in(options.get("scalar", "double"))
    refined, told = _errors(model, states, builder, tmp_path, **options)
    assert refined.max() < (1e-5 if "scalar" in options else 1e-14)
    assert np.array(told).shape == (10, options["refine"])


def test_passive_torques_are_part_of_the_residual(builder: Builder, tmp_path: Path) -> None:
    """Damping, friction, springs and rotors of a robot that loses digits."""
    model = damped(robots(len(FAMILIES), seed=2)[NAMES.index("graded")])
    states = hard_states(model, 40, seed=2)
    plain, _ = _errors(model, states, builder, tmp_path)
    refined, _ = _errors(model, states, builder, tmp_path, refine=1)
    assert refined.max() < min(plain.max() / 10, 2e-14)


def test_only_loops_of_one_process_have_residuals_of_their_own() -> None:
    model = serial_chain(4)
    profile = load_profile("default")
    two = make_plan(model, named_schedule("balanced", Topology.of(model), 2, profile=profile))
    assert program_of(plan_of(model, 1), refine=1).plan.corrections == 1
    assert program_of(two, refine=1).plan.corrections == 0
    with pytest.raises(UsageError, match="several processes share the robot"):
        program_of(two, refine=1, residual="own")
    with pytest.raises(
        UsageError, match="shape joints computes residuals in higher precision only"
    ):
        emit(plan_of(model, 1, form="ada"), refine=1, residual="own")


def test_the_head_tells_which_it_is(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    given = [str(MODELS / "chain16.urdf"), "--procs", "1", "--refine", "1", "--out", str(tmp_path)]
    for words, said in (([], "refine 1 (own residual)"), (["--residual=wide"], "(wide residual)")):
        assert main([*given, *words]) == 0
        assert said in (tmp_path / "chain16_p1.cpp").read_text()
        assert main(["verify", str(tmp_path)]) == 0
    assert main([*given[:3], "--residual", "wide", "--out", str(tmp_path)]) == 2
    assert "--residual needs --refine" in capsys.readouterr().err
