"""Refinement in shape kernels: every way in which a joint gets its force."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.model import Model
from adagen.model.kinds import SPHERICAL
from adagen.plan import make_plan
from adagen.schedule import Topology, load_profile
from adagen.schedule.tree import Named
from adagen.search import named_schedule
from adagen.states import random_states
from tests.emit.test_gimbal_lock import two_arms
from tests.emitted import Builder, energy_errors, text_of
from tests.models import binary, human_figure, random_tree, serial_chain, star
from tests.schedules import random_schedule
from tests.slow import slow

PROFILE = load_profile("default")


@pytest.mark.parametrize(
    ("model", "name", "processes", "meeting", "scalar"),
    [
        pytest.param(
            star(4, 3, floating=True), "sequential", 1, "gather", "double", marks=pytest.mark.slow
        ),
        slow(human_figure(), "balanced", 3, "join", "double"),
        slow(serial_chain(12, kind=SPHERICAL), "balanced", 2, "gather", "double"),
        pytest.param(two_arms(), "balanced", 2, "gather", "double", marks=pytest.mark.slow),
        (two_arms(), "sequential", 1, "gather", "double"),
    ],
    ids=["lanes", "three joined", "held by balls", "in own axes", "lanes in own axes"],
)
def test_named_schedules_are_refined(
    model: Model,
    name: Named,
    processes: int,
    meeting: str,
    scalar: str,
    builder: Builder,
    tmp_path: Path,
) -> None:
    schedule = named_schedule(name, Topology.of(model), processes, profile=PROFILE)
    plan = make_plan(model, schedule, meeting=meeting, scalar=scalar)
    states = random_states(model, 3, seed=2)
    solver = builder.solver(plan, shape="kernels", refine=3, residual="wide")
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-14
    said = np.array(json.loads((tmp_path / "result.json").read_text())["corrections"])
    assert (said[:, 1] < 1e-2 * said[:, 0]).all()


@pytest.mark.slow
@pytest.mark.parametrize("meeting", ["gather", pytest.param("join", marks=pytest.mark.slow)])
def test_trees_of_all_kinds_are_refined(meeting: str, builder: Builder, tmp_path: Path) -> None:
    """Planar, spherical and floating joints, and a floating base; the raw error is told."""
    model = random_tree(np.random.default_rng(1), 9, branching=0.5, floating=True)
    plan = make_plan(model, random_schedule(model, 2, np.random.default_rng(1)), meeting=meeting)
    states = random_states(model, 4, seed=1)
    solver = builder.solver(plan, shape="kernels", refine=1)
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-15
    said = np.array(json.loads((tmp_path / "result.json").read_text())["corrections"])[:, 0]
    plain = builder.solver(plan, shape="kernels").solve(model, states, tmp_path)
    raw = energy_errors(model, states, plain)
    large = raw > 4e-15
    assert ((said < 3 * raw) & (raw < 3 * said))[large].all()


@pytest.mark.slow
def test_a_straight_arm_is_refined_the_other_way(builder: Builder, tmp_path: Path) -> None:
    """What holds an arm is no body where it is straight: answer and corrections are done anew."""
    model = serial_chain(24, axes="xy")
    schedule = named_schedule("balanced", Topology.of(model), 2, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="gather")
    assert any(process.recovery for process in plan.processes)
    states = random_states(model, 2, seed=2)
    states.q[:] = 0
    solver = builder.solver(plan, shape="kernels", refine=2)
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-14


def test_loops_are_what_refinement_is_emitted_as() -> None:
    plan = make_plan(binary(3), random_schedule(binary(3), 1, np.random.default_rng(0)))
    assert "shape kernels" in text_of(plan, refine=1)
    ada = make_plan(binary(3), random_schedule(binary(3), 1, np.random.default_rng(0)), form="ada")
    assert "shape joints" in text_of(ada, refine=1)
