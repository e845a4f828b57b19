"""Scalar mixed: factors in float, states and answers in double, refined to the digits of double."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import emit
from adagen.emit.runtime import joined
from adagen.errors import UsageError
from adagen.plan import make_plan, plan_from_json, plan_to_json
from adagen.plan.cuts import cuttable_joints
from adagen.reference import inverse_dynamics
from adagen.states import States, random_states, write_states
from adagen.studies.stability.robots import with_mass
from tests.emitted import Builder, energy_errors, text_of
from tests.links import with_light_link
from tests.models import random_tree, serial_chain
from tests.schedules import random_schedule


@pytest.mark.parametrize(
    ("form", "processes"),
    [("segment", 1), ("ada", 2), pytest.param("segment", 4, marks=pytest.mark.slow)],
)
def test_answers_have_the_digits_of_double(
    form: str, processes: int, builder: Builder, tmp_path: Path
) -> None:
    """Slaved joints, all kinds of joints, a floating base; states that no float can hold."""
    model = random_tree(np.random.default_rng(4), 9, floating=True, mimics=2)
    schedule = random_schedule(model, processes, np.random.default_rng(processes))
    plan = make_plan(model, schedule, form=form, scalar="mixed")
    states = random_states(model, 5, seed=3)
    found = builder.solver(plan, refine=3).solve(model, states, tmp_path)
    assert energy_errors(model, states, found).max() < 1e-13
    said = np.array(json.loads((tmp_path / "result.json").read_text())["corrections"])
    assert ((said[:, 0] > 1e-9) & (said[:, 0] < 1e-2)).all()  # the error of a float
    assert (said[:, 1] < 1e-2 * said[:, 0]).all()
    assert said[:, 2].max() < 1e-9


def test_the_program_checks_and_times_itself_as_in_double(builder: Builder) -> None:
    model = serial_chain(4)
    plan = make_plan(
        model, random_schedule(model, 2, np.random.default_rng(0)), scalar="mixed", form="ada"
    )
    solver = builder.solver(plan, refine=2)
    done = solver.run("--check", "--time", "--repeat", "1", "--json")
    report = json.loads(done.stdout)
    assert (done.status, report["refine"]["steps"]) == (0, 2)
    assert report["check"]["residual_max"] < 1e-12
    assert report["time"]["in_place"]["median_ns"] > 0


def test_where_it_does_not_converge_it_says_so(builder: Builder) -> None:
    """In form ada a light link's mobility is lost to its neighbours, down to noise in float."""
    model = with_light_link(serial_chain(6), 3, 1e-6)
    schedule = random_schedule(model, 1, np.random.default_rng(0))
    plan = make_plan(model, schedule, form="ada", scalar="mixed")
    done = builder.solver(plan, refine=3).run("--check")
    assert done.status == 1
    assert "refinement does not converge" in done.stderr or "no digits left" in done.stderr


def test_where_its_steps_are_too_few_it_says_so(builder: Builder) -> None:
    model = with_light_link(serial_chain(6), 3, 1e-3)
    schedule = random_schedule(model, 1, np.random.default_rng(0))
    plan = make_plan(model, schedule, form="ada", scalar="mixed")
    done = builder.solver(plan, refine=2).run("--check")
    assert done.status == 1
    assert "refinement converges too slowly" in done.stderr
    assert builder.solver(plan, refine=5).run("--check").status == 0


def test_what_is_left_is_not_taken_for_less_than_is_certain(
    builder: Builder, tmp_path: Path
) -> None:
    """Under a heavy tip what converges slowest is seen last.

    Of the states that are refused, 27 has first corrections of 2.8e-5 and 1.6e-7. Their rate would
    promise an error of 9e-10 after the second; it is 2.6e-9.
    """
    model = with_mass(8, 8, 1e6)
    schedule = random_schedule(model, 1, np.random.default_rng(0))
    plan = make_plan(model, schedule, scalar="mixed")
    solver = builder.solver(plan, refine=2, shape="joints")
    states = random_states(model, 3000, seed=3)

    def some(*chosen: int) -> States:
        rows = list(chosen)
        return States(states.q[rows], states.v[rows], states.tau[rows])

    for s in (25, 27):
        write_states(some(s), model, tmp_path / "slow.json")
        done = solver.run("--states", tmp_path / "slow.json", "--result", tmp_path / "no.json")
        assert done.status == 1 and "refinement converges too slowly" in done.stderr
        assert not (tmp_path / "no.json").exists()
    quick = some(124, 251)
    assert energy_errors(model, quick, solver.solve(model, quick, tmp_path)).max() < 1e-9


def test_what_is_held_up_may_be_more_than_what_accelerates(
    builder: Builder, tmp_path: Path
) -> None:
    """The answer is a small difference, but each step makes it right by as much as any other."""
    model = random_tree(np.random.default_rng(7), 5)
    schedule = random_schedule(model, 1, np.random.default_rng(0))
    plan = make_plan(model, schedule, form="ada", scalar="mixed")
    states = random_states(model, 3, seed=3)
    still, slow = np.zeros(model.nv), np.full(model.nv, 0.5)
    torques = np.array([inverse_dynamics(model, q, still, slow) for q in states.q])
    held = replace(states, v=np.zeros_like(states.v), tau=torques)
    found = builder.solver(plan, refine=2).solve(model, held, tmp_path)
    assert energy_errors(model, held, found).max() < 1e-12
    said = np.array(json.loads((tmp_path / "result.json").read_text())["corrections"])
    assert said[:, 0].max() > 1e-5  # the error of a float, of what is held up


def test_steps_are_three_unless_said_otherwise_and_never_fewer_than_two() -> None:
    model = serial_chain(3)
    plan = make_plan(model, random_schedule(model, 1, np.random.default_rng(0)), scalar="mixed")
    text = text_of(plan)
    assert "constexpr int kRefine = 3;" in text
    assert "using Real = float;" in text
    assert "using Number = double;" not in text  # the runtime's settings say that
    assert "using Number = double;" in joined(text)
    assert '#include "adagen/c_interface.hpp"' in text  # whose functions take Number
    with pytest.raises(UsageError, match=r"only a second one can show .*; say --refine 2 or more"):
        emit(plan, refine=1)
    with pytest.raises(UsageError, match="leave out --batch"):
        emit(plan, batch=1)
    with pytest.raises(UsageError, match=r"shape unrolled .* computes in one number type"):
        emit(plan, shape="unrolled")
    assert plan_from_json(plan_to_json(plan)) == plan


def test_processes_meet_where_floats_can() -> None:
    for ratio in (1e-2, 1e-4):
        model = with_light_link(serial_chain(6), 3, ratio)
        assert cuttable_joints(model, "mixed") == cuttable_joints(model, "float")
