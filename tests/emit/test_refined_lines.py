"""Robots with closed loops, refined: what corrections make good, say and refuse."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flint import ctx
from numpy.typing import NDArray

from adagen.emit import emit, program_of
from adagen.errors import UsageError
from adagen.executor import interpret
from adagen.graph import BALLS, FLOAT
from adagen.model import Model
from adagen.plan import Plan, plan_from_json, plan_to_json
from adagen.plan.refine import corrected
from adagen.program import check
from adagen.reference import energy_norm_error, joint_space_inertia
from adagen.states import States
from benchmarks.stability.adversary import FAMILIES, robots
from tests.emitted import EXACT, Builder, energy_errors, forward_error, plan_of, truth_of
from tests.executor.test_closed_processes import divided, figure, poor_and_good
from tests.mechanisms import MECHANISMS, quadruped, standing, states_of
from tests.models import serial_chain

NAMES = [family.__name__ for family in FAMILIES]
GAINS = {"balls": 1000, "free_bodies": 10, "point_masses": 10, "graded": 3}
"""By how much the largest error of some closed robots becomes smaller, at least."""


def losing(name: str) -> Model:
    """Return a robot that loses digits, its last link held by a ball joint on the ground."""
    model = robots(len(FAMILIES), seed=2)[NAMES.index(name)]
    return standing(model, "point", model.links[-1].name)


def answers(plan: Plan, states: States, **options: Any) -> NDArray[np.float64]:
    """Return what the executor answers."""
    return np.array([interpret(plan, *row, **options) for row in states.each], dtype=float)


def emitted(
    plan: Plan, model: Model, states: States, builder: Builder, folder: Path, refine: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return what an emitted solver answers, and the sizes of its corrections."""
    solver = builder.solver(plan, EXACT, refine=refine)
    found = solver.solve(model, states, folder)
    return found, np.array(json.loads((folder / "result.json").read_text())["corrections"])


@pytest.mark.parametrize("name", MECHANISMS)
def test_ordinary_mechanisms_keep_their_digits(name: str) -> None:
    model = MECHANISMS[name]()
    plan = corrected(plan_of(model, 1), 2)
    assert plan_from_json(plan_to_json(plan)) == plan
    check(program_of(plan_of(model, 1), refine=2))
    states = states_of(model, 4)
    found = answers(plan, states)
    with ctx.workprec(200):
        exact = answers(plan, states, algebra=BALLS)
    assert forward_error(found, exact) < 2e-14
    # Doubles close loops up to rounding, and the truth leaves other rows out: up to 3e-14.
    assert forward_error(found, truth_of(model, states)) < 1e-13


@pytest.mark.parametrize("name", GAINS)
def test_lost_digits_come_back(name: str) -> None:
    model = losing(name)
    states, plan = states_of(model, 12), plan_of(model, 1)
    plain, once = (
        energy_errors(model, states, answers(p, states)) for p in (plan, corrected(plan, 1))
    )
    assert once.max() < plain.max() / GAINS[name]


@pytest.mark.parametrize("name", ["wrists", "graded", "free_bodies"])
def test_floats_lose_less(name: str) -> None:
    """Beside doubles of the same numbers, refined twice."""
    model = losing(name)
    states, plan = states_of(model, 8), plan_of(model, 1, scalar="float")
    rounded = states.read_in("float")
    wide = answers(corrected(plan_of(model, 1), 2), rounded)
    plain, twice = (answers(p, rounded, algebra=FLOAT) for p in (plan, corrected(plan, 2)))
    inertias = [joint_space_inertia(model, q) for q in rounded.q]
    errors = [max(map(energy_norm_error, inertias, found - wide, wide)) for found in (plain, twice)]
    assert errors[1] < errors[0] / 20


def test_emitted_corrections_tell_the_error(builder: Builder, tmp_path: Path) -> None:
    """Rounded as the executor rounds, so that the answer before them is known."""
    model = losing("balls")
    states, plan = states_of(model, 12), plan_of(model, 1)
    errors = energy_errors(model, states, answers(plan, states))
    found, told = emitted(plan, model, states, builder, tmp_path, 2)
    assert told.shape == (12, 2)
    assert energy_errors(model, states, found).max() < errors.max() / 1e4
    large = errors > 1e-12
    assert large.any()
    assert ((told[:, 0] < 3 * errors) & (errors < 3 * told[:, 0]))[large].all()


@pytest.mark.slow
def test_feet_in_lanes_are_corrected_in_every_way(builder: Builder, tmp_path: Path) -> None:
    """Feet side by side in lanes, and poses in which something else is done."""
    model = quadruped()
    plan = plan_of(model, 1)
    states = poor_and_good(model, plan, 2)
    found, told = emitted(plan, model, states, builder, tmp_path, 1)
    truth = truth_of(model, states)
    assert forward_error(found, truth) < 1e-12
    assert told.max() < 1e-9


@pytest.mark.slow
def test_two_processes_correct_together(builder: Builder, tmp_path: Path) -> None:
    """A human figure on both feet: residuals at the pelvis are reported, and step sizes."""
    model = figure()
    plan = divided(model, 2, [None, *[0] * 3, *[1] * 11])
    program = program_of(plan, refine=2)
    told = [message.repeats for message in program.plan.messages]
    assert told == [None, None, 0, 1, 0, 1, None, None]
    check(program)
    states = states_of(model, 4)
    found, sizes = emitted(plan, model, states, builder, tmp_path, 2)
    assert forward_error(found, truth_of(model, states)) < 1e-14
    alone = emitted(plan_of(model, 1), model, states, builder, tmp_path, 2)[1]
    assert sizes.shape == (4, 2)
    assert sizes.max() < 1e-12 and 0 < sizes[:, 0].min() < 10 * alone[:, 0].max()


@pytest.mark.parametrize("name", ["slider-crank", "gear"])
def test_form_ada_is_refined(name: str, builder: Builder, tmp_path: Path) -> None:
    """Whose joins lose digits that corrections of accelerations and joint forces bring back."""
    model = MECHANISMS[name]()
    states, plan = states_of(model, 6), plan_of(model, 1, form="ada")
    truth = truth_of(model, states)
    plain = forward_error(answers(plan, states), truth)
    found, _ = emitted(plan, model, states, builder, tmp_path, 1)
    assert forward_error(found, truth) < max(plain / 5, 3e-15)


def test_forces_of_loops_are_corrected() -> None:
    model = losing("balls")
    states = states_of(model, 6)
    plan = plan_of(model, 1, loop_forces=True)
    plain, once = (answers(p, states)[:, model.nv :] for p in (plan, corrected(plan, 1)))
    with ctx.workprec(400):
        truth = np.array(
            [[float(x) for x in interpret(plan, *row, BALLS)[model.nv :]] for row in states.each]
        )
    size = np.abs(truth).max(axis=1, keepdims=True)
    assert np.abs((once - truth) / size).max() < np.abs((plain - truth) / size).max() / 100


def test_what_is_not_refined_is_said() -> None:
    model = MECHANISMS["four-bar"]()
    two = divided(figure(), 2, [None, *[0] * 3, *[1] * 11])
    cases: list[tuple[Plan, dict[str, Any], str]] = [
        (plan_of(model, 1), {"residual": "wide"}, "residuals in their own numbers; leave out"),
        (plan_of(model, 2, form="ada"), {}, "in form ada on one process alone"),
        (plan_of(serial_chain(4), 1), {"shape": "unrolled"}, "no refinement, but for closed loops"),
    ]
    for plan, options, said in cases:
        with pytest.raises(UsageError, match=said):
            emit(plan, refine=1, **options)
    assert program_of(two, refine=1, residual="own").plan.corrections == 1
