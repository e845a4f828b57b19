"""Emitted refinement: what it reaches, what it says of the error, and where it gives up."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import emit
from adagen.errors import UsageError
from adagen.plan import make_plan
from adagen.plan.refine import exchanges, links_of_process
from adagen.plan.steps import FusedJoin
from adagen.reference import inverse_dynamics
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import random_states
from tests.emitted import Builder, energy_errors
from tests.links import with_light_link
from tests.models import random_tree, serial_chain, three_axis_chain
from tests.schedules import random_schedule
from tests.slow import slow


@pytest.mark.parametrize(
    ("form", "processes"), [("segment", 2), slow("segment", 4), slow("ada", 2)]
)
def test_one_step_leaves_only_rounding_and_says_what_there_was(
    form: str, processes: int, builder: Builder, tmp_path: Path
) -> None:
    """Slaved joints, all kinds of joints, a floating base; parts of it on several processes."""
    model = random_tree(np.random.default_rng(4), 9, floating=True, mimics=2)
    schedule = random_schedule(model, processes, np.random.default_rng(processes))
    plan = make_plan(model, schedule, form=form)
    states = random_states(model, 5, seed=3)
    solver = builder.solver(plan, refine=2)
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-14
    said = np.array(json.loads((tmp_path / "result.json").read_text())["corrections"])
    raw = energy_errors(model, states, builder.solver(plan).solve(model, states, tmp_path))
    assert said.shape == (5, 2)
    large = raw > 4e-15  # below that, constants of the frames are rounded as much
    assert ((said[:, 0] < 3 * raw) & (raw < 3 * said[:, 0]))[large].all()
    assert (said[:, 1] < 1e-3 * said[:, 0]).all()


@pytest.mark.parametrize("processes", [slow(2), 1])
def test_joints_joined_over_massless_links_are_refined(
    processes: int, builder: Builder, tmp_path: Path
) -> None:
    model = three_axis_chain(3)
    schedule = best_schedule(model, processes, load_profile("default"), "ada")
    plan = make_plan(model, schedule, form="ada")
    assert any(isinstance(step, FusedJoin) for p in plan.processes for step in p.steps)
    states = random_states(model, 3, seed=3)
    solver = builder.solver(plan, refine=3)
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-13
    said = np.array(json.loads((tmp_path / "result.json").read_text())["corrections"])
    assert (said[:, 1] < 1e-2 * said[:, 0]).all()


def test_check_tells_the_corrections(builder: Builder) -> None:
    model = with_light_link(serial_chain(6), 3, 1e-6)
    plan = make_plan(model, random_schedule(model, 1, np.random.default_rng(0)), form="ada")
    solver = builder.solver(plan, refine=2)
    done = solver.run("--check", "--json")
    report = json.loads(done.stdout)["refine"]
    assert (done.status, report["steps"]) == (0, 2)
    assert 1e-11 < report["correction_max"][0] < 1e-7  # what the light link costs form ada
    assert report["correction_max"][1] < 1e-3 * report["correction_max"][0]
    assert "error before step 2" in solver.run("--check").stdout


@pytest.mark.slow
def test_where_it_does_not_converge_it_says_so(builder: Builder) -> None:
    """The light link is lost in the factors of form ada in float: all that it says is noise."""
    model = with_light_link(serial_chain(6), 3, 1e-6)
    schedule = random_schedule(model, 1, np.random.default_rng(0))
    done = builder.solver(make_plan(model, schedule, form="ada", scalar="float"), refine=3).run(
        "--check"
    )
    assert done.status == 1
    assert "refinement does not converge" in done.stderr or "no digits left" in done.stderr
    assert "nan" not in done.stdout


def test_every_link_is_looked_after_once() -> None:
    model = random_tree(np.random.default_rng(2), 12)
    for form in ("ada", "segment"):
        plan = make_plan(model, random_schedule(model, 4, np.random.default_rng(1)), form=form)
        links = [link for process in plan.processes for link in links_of_process(process)]
        assert sorted(links) == list(range(1, 13))
        for exchange in exchanges(plan):
            assert exchange.source != exchange.target
            owned = set(plan.processes[exchange.source].owns)
            assert owned.issuperset((*exchange.accelerations, *exchange.forces))


def test_what_cannot_be_refined_is_refused() -> None:
    model = serial_chain(2)
    plan = make_plan(model, random_schedule(model, 1, np.random.default_rng(0)))
    with pytest.raises(UsageError, match="0 to 9"):
        emit(plan, refine=10)
    with pytest.raises(UsageError, match="no refinement"):
        emit(plan, refine=1, shape="unrolled")
    damped = (replace(plan.joints[0], damping=0.1), *plan.joints[1:])
    with pytest.raises(UsageError, match="cannot be refined"):
        emit(replace(plan, joints=damped), refine=1, residual="wide")


@pytest.mark.slow
def test_a_robot_that_is_held_at_rest_is_answered(builder: Builder, tmp_path: Path) -> None:
    """What accelerates is the rounding of its torques alone, which no correction makes smaller."""
    model = random_tree(np.random.default_rng(4), 6)
    schedule = random_schedule(model, 2, np.random.default_rng(2))
    plan = make_plan(model, schedule, form="ada")
    states = random_states(model, 3, seed=3)
    still = np.zeros(model.nv)
    torques = np.array([inverse_dynamics(model, q, still, still) for q in states.q])
    held = replace(states, v=np.zeros_like(states.v), tau=torques)
    found = builder.solver(plan, refine=3).solve(model, held, tmp_path)
    assert np.abs(found).max() < 1e-12
