"""What a schedule is searched for: time, accuracy, or both."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.cli import main
from adagen.emit.shapes import chosen_shape
from adagen.executor import interpret
from adagen.executor.join_digits import predicted_growth
from adagen.executor.program_states import program_states
from adagen.executor.refine import Refined, interpret_refined
from adagen.executor.trial import accelerations, carried_out, tried
from adagen.model import SPHERICAL, Model
from adagen.plan import Plan, make_plan
from adagen.plan.own_axes import OwnAxes, balls_lose, joints_in_own_axes
from adagen.plan.steps import Join
from adagen.reference import energy_norm_error, exact_forward_dynamics, joint_space_inertia
from adagen.schedule import Schedule, load_profile
from adagen.search import best_schedule
from adagen.search.objective import (
    OBJECTIVES,
    Digits,
    predicted_digits,
    schedule_for,
    suited_shape,
)
from adagen.states import States, random_states
from adagen.studies.stability import robots
from adagen.urdf import read_robot
from tests.emitted import Builder, plan_of
from tests.golden.examples import FOLDER
from tests.models import serial_chain, star
from tests.real import real_robot
from tests.slow import all_but, slow

SHIPPED = load_profile("xeon")
assert SHIPPED.steps is not None
# Costs under which two processes pay for chains of 80 rods: articulated inertias dearer.
DEAR = {
    name: (10 if name.startswith("articulate") else 1) * x
    for name, x in SHIPPED.steps.table.items()
}
PROFILE = replace(SHIPPED, steps=replace(SHIPPED.steps, table=DEAR))


@cache
def meeting(length: int) -> int:
    """Where two processes meet soonest in a chain of equal rods."""
    return schedule_for("time", robots.rods(length), 2, PROFILE, gather=False).root.joint


def middling(mass: float) -> Model:
    """Rods of which two in three are light around where two processes would meet."""
    light = [i for i in range(meeting(80) - 8, meeting(80) + 8) if i % 3]
    inertias = [robots.rod(mass if i in light else 1.0) for i in range(80)]
    return robots.chain("light middle", inertias)


def searched(model: Model, objective: str, form: str = "segment") -> tuple[Schedule, Plan]:
    """Return a schedule for two processes, and its plan."""
    schedule = schedule_for(objective, model, 2, PROFILE, form, gather=False)
    plan = make_plan(model, schedule, form=form)
    assert all(process.owns for process in plan.processes)
    return schedule, plan


def found(model: Model, objective: str) -> tuple[Schedule, Digits, float]:
    """Return a schedule for two processes, its predicted digits and the error that it has."""
    schedule, plan = searched(model, objective)
    states = random_states(model, 3, seed=1)
    error = 0.0
    for state in states.each:
        truth = exact_forward_dynamics(model, *state, digits=20).value
        wrong = interpret(plan, *state) - truth
        error = max(error, energy_norm_error(joint_space_inertia(model, state[0]), wrong, truth))
    return schedule, predicted_digits(objective, model, plan, "unrolled"), error


@pytest.mark.slow
def test_cuts_move_away_from_light_links_as_the_objective_asks() -> None:
    model = middling(1e-7)
    schedules = {objective: found(model, objective) for objective in OBJECTIVES}
    time, both, accuracy = (schedules[name] for name in ("time", "both", "accuracy"))
    assert time[0].makespan <= both[0].makespan <= accuracy[0].makespan
    assert time[1].growth > 1e5 > both[1].growth >= accuracy[1].growth
    assert time[2] > 100 * both[2]
    assert both[2] < 1e-12
    for _, digits, error in schedules.values():
        assert error < 30 * digits.error


@pytest.mark.slow
@pytest.mark.parametrize("objective", ["time", slow("both")])
@pytest.mark.parametrize(("before", "beyond"), [slow(1, 2), slow(2, 3), (3, 3)])
def test_digits_lost_in_inverting_among_light_links_are_predicted(
    before: int, beyond: int, objective: str
) -> None:
    # Where as many light links as a body has freedoms lie side by side, g is small.
    at = meeting(80)
    light = range(at - before, at + beyond)
    model = robots.chain("m", [robots.rod(1e-7 if i in light else 1.0) for i in range(80)])
    schedule, digits, error = found(model, objective)
    assert error < 30 * digits.error
    # Mobilities are inverted without subtracting: by differences, 1e-3 was lost here.
    assert error < 1e-7
    plan = make_plan(model, schedule)
    growth, swept = predicted_growth(plan).error, tried(plan, joints_in_own_axes(plan)).error
    # Joins add no more than the executor loses in the program's states.
    most = 3 * carried_out(plan).error
    assert digits.error <= max(1e2 * error, 1e-13, growth, swept, most)


def test_what_recovers_from_singular_poses_is_predicted() -> None:
    """No pose of a planar chain lets the ground be held by its first joints."""
    model = serial_chain(32, axes="y")
    plan = plan_of(model, 2, meeting="gather")
    assert all(process.recovery for process in plan.processes)
    emitted = 2.6e-14  # the largest error of loops in the program's states
    assert emitted / 3 < predicted_digits("both", model, plan).error < emitted * 10


@pytest.mark.slow
def test_what_loops_lose_where_one_process_holds_the_ground_is_predicted(
    builder: Builder, tmp_path: Path
) -> None:
    """Rounding of mobilities counts, not growth: that of one process would be 50 times less."""
    model = serial_chain(60)
    schedule = best_schedule(model, 2, SHIPPED)
    plan = make_plan(model, schedule)
    assert sum(bool(process.owns) for process in plan.processes) == 2
    states = States(*program_states(plan))
    found = builder.solver(plan, shape="kernels").solve(model, states, tmp_path)
    truth = accelerations(plan, *states.parts).astype(float)
    rows = zip(states.q, found, truth, strict=True)
    errors = [energy_norm_error(joint_space_inertia(model, q), x - t, t) for q, x, t in rows]
    predicted = predicted_digits("both", model, plan).error
    assert predicted / 10 < max(errors) < predicted * 10**0.5
    assert max(errors) > 3 * tried(plan, joints_in_own_axes(plan)).error


def test_what_acts_on_joints_and_links_changes_nothing() -> None:
    model = robots.rods(20)
    plan = plan_of(model, 2)
    damped = tuple(replace(each, damping=0.1, stiffness=3.0) for each in plan.joints)
    assert carried_out(replace(plan, joints=damped)) == carried_out(plan)
    assert carried_out(plan).error < 1e-12


@pytest.mark.slow
def test_a_float_solver_is_predicted_to_lose_as_many_digits_of_fewer() -> None:
    model = middling(1e-7)
    schedule, _ = searched(model, "time")
    plans = [make_plan(model, schedule, scalar=name) for name in ("double", "float")]
    double, single = (predicted_digits("time", model, plan).error for plan in plans)
    assert double < 1e-2
    assert single == 1.0


def test_few_digits_of_hard_poses_are_foretold() -> None:
    """Rods each 16 times as heavy as the one before: in float some answers are wrong there."""
    model = robots.graded(8, 16.0**7)
    plan = plan_of(model, 1, scalar="float")
    for shape in ("kernels", "unrolled"):
        digits = predicted_digits("both", model, plan, shape)
        assert digits.error < 1e-2 < digits.anywhere == digits.hard


def test_robots_at_rest_keep_their_digits() -> None:
    """What refines an answer knows that they do not move."""
    model = replace(star(4, 3), at_rest=True)
    plan = plan_of(model, 2, meeting="gather")
    assert sum(bool(process.owns) for process in plan.processes) == 2
    assert predicted_digits("both", model, plan, "unrolled").error < 1e-13


def test_ordinary_robots_are_cut_alike_for_time_and_for_both() -> None:
    model = robots.rods(48)
    time, both = (schedule_for(name, model, 2, PROFILE) for name in ("time", "both"))
    assert time.makespan == both.makespan
    assert time.root.joint == both.root.joint


@pytest.mark.slow
def test_in_form_ada_the_order_hardly_matters() -> None:
    model = middling(1e-4)
    both, accuracy = (
        predicted_digits(name, model, searched(model, name, "ada")[1]).error
        for name in ("both", "accuracy")
    )
    assert 1.0 <= both / accuracy < 30.0


def test_one_process_joins_nothing() -> None:
    model = robots.rods(5)
    plan = make_plan(model, schedule_for("accuracy", model, 1, PROFILE))
    assert not [step for step in plan.processes[0].steps if isinstance(step, Join)]
    digits = predicted_digits("accuracy", model, plan)
    assert digits.joint is None
    assert predicted_growth(plan).error < 1e-15
    assert digits.error == tried(plan, OwnAxes(frozenset(), frozenset())).error


@pytest.mark.parametrize("objective", all_but(OBJECTIVES, "time", "accuracy"))
def test_the_command_line_reports_digits(
    objective: str, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["schedule", str(FOLDER / "models" / "humanoid.urdf"), "--procs", "2"]
    assert main([*words, "--objective", objective, "--json"]) == 0
    said = json.loads(capsys.readouterr().out)["accuracy"]
    assert said["objective"] == objective
    assert said["digits"] == pytest.approx(-np.log10(said["error"]), abs=0.01)
    assert main([*words, "--objective", objective]) == 0
    out = capsys.readouterr().out
    assert f"{-np.log10(said['error']):.1f} digits predicted" in out
    assert (said["joint"] or "no loss at joins") in out


def test_accuracy_takes_the_shape_that_loses_less() -> None:
    # Spherical joints are swept in axes of the base in loops, whatever their links look like.
    plan = plan_of(robots.rods(6, kind=SPHERICAL, radius=5e-3), 1)
    assert not balls_lose(plan)
    assert suited_shape("accuracy", plan) == "unrolled"
    assert suited_shape("accuracy", plan, "kernels") == "kernels"
    assert suited_shape("both", plan) == suited_shape("time", plan) == "auto"


def test_accuracy_compares_the_shapes_that_the_profile_offers() -> None:
    """Straight lines of 140 joints are for registers of 256 bits."""
    plan = plan_of(serial_chain(140), 1)
    assert suited_shape("accuracy", plan, profile=load_profile("xeon")) == "kernels"
    assert suited_shape("accuracy", plan, profile=load_profile("avx2")) != "kernels"


def test_accuracy_takes_the_fastest_of_shapes_that_lose_alike() -> None:
    assert suited_shape("accuracy", plan_of(robots.rods(4), 1)) == "auto"


@pytest.mark.parametrize("scalar", ["double", "float"])
def test_accuracy_and_time_differ_on_a_real_robot(scalar: str) -> None:
    path = real_robot("icub_description/robots/icub.urdf")
    plan = plan_of(read_robot(path, floating=True).model, 1, scalar=scalar)
    errors = [tried(plan, joints_in_own_axes(plan)).error, tried(plan, None).error]
    assert errors[0] > 5 * errors[1]  # of the line's hardest state one rounding in ten loses 4e-11
    assert chosen_shape(plan, suited_shape("both", plan)) == "kernels"
    assert chosen_shape(plan, suited_shape("accuracy", plan)) == "unrolled"


def test_where_one_state_fails_the_others_are_tried_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    model = serial_chain(9)
    plan = plan_of(model, 2)
    found, alone = predicted_digits("both", model, plan), interpret_refined

    def failing(plan: Plan, q: Any, v: Any, tau: Any, steps: int) -> Refined:
        if q.ndim > 1:
            raise FloatingPointError("factorization failed")
        return alone(plan, q, v, tau, steps)

    monkeypatch.setattr("adagen.search.objective.interpret_refined", failing)
    assert predicted_digits("both", model, plan) == found
