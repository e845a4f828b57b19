"""Joints of closed loops whose accelerations are prescribed."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.executor import interpret
from adagen.model import SPHERICAL, Model
from adagen.plan import closures, make_plan
from adagen.plan.steps import CarryRows
from adagen.program import check
from adagen.program.lower import lower
from adagen.reference import residual
from adagen.reference.closed import closed_forward_dynamics
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States
from tests.emitted import QUICK, Builder
from tests.executor.plans import kinds_of
from tests.executor.test_closed_lanes import linkages
from tests.executor.test_closures import plan_of
from tests.mechanisms import four_bar, geared, looped_tree, quadruped, slider_crank, states_of


def prescribing(model: Model, *names: str) -> Model:
    """Return a robot with accelerations of joints prescribed."""
    assert {joint.name for joint in model.joints}.issuperset(names)
    joints = [
        replace(joint, prescribed=True) if joint.name in names else joint for joint in model.joints
    ]
    return replace(model, joints=tuple(joints))


def given_as_found(model: Model, states: States) -> tuple[States, NDArray[np.float64]]:
    """Return states that prescribe what their torques would do, and the accelerations of all.

    A torque and the acceleration that it makes say the same.
    """
    free = replace(model, joints=tuple(replace(j, prescribed=False) for j in model.joints))
    truth = np.array([closed_forward_dynamics(free, *row) for row in states.each])
    tau = states.tau.copy()
    for j, joint in enumerate(model.joints):
        if joint.prescribed:
            own = slice(model.v_start[j], model.v_start[j] + joint.kind.nv)
            tau[:, own] = truth[:, own]
    return States(states.q, states.v, tau), truth


CASES: dict[str, Callable[[], Model]] = {
    "crank of a four-bar": lambda: prescribing(four_bar(), "p0"),
    "coupler of a four-bar": lambda: prescribing(four_bar(), "p1"),
    "rocker of a floating four-bar": lambda: prescribing(four_bar(floating=True), "p2"),
    "slide": lambda: prescribing(slider_crank(), "slide"),
    "gear": lambda: prescribing(geared(), geared().joints[4].name),
    "one of two linkages": lambda: prescribing(linkages(2, hips=1), "crank0", "h10"),
    "hips of a quadruped": lambda: prescribing(quadruped(), "fl_hip", "rr_hip"),
    "ball in a tree": lambda: prescribing(
        looped_tree("revolute", 3, joints=10, kinds=(SPHERICAL,)), "j2"
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_prescribed_joint_moves_the_loop(name: str) -> None:
    model = CASES[name]()
    plan = plan_of(model)
    states, truth = given_as_found(model, states_of(model, 4))
    for each in plan.alternatives:
        check(lower(each, "unrolled"))
    for k, state in enumerate(states.each):
        found = interpret(plan, *state, lanes=True)
        assert np.abs(found - truth[k]).max() < 1e-10 * np.abs(truth[k]).max()
        dense = closed_forward_dynamics(model, *state)
        assert np.abs(dense - truth[k]).max() < 1e-9 * np.abs(truth[k]).max()
        assert residual(model, *state, dense) < 1e-12


def test_rows_pass_a_prescribed_joint(monkeypatch: pytest.MonkeyPatch) -> None:
    """In a closure of many freedoms, whose joints are articulated."""
    monkeypatch.setattr(closures, "MOST_HELD", 3)
    model = looped_tree("revolute", 3, joints=12, whole=True)
    model = prescribing(model, model.joints[6].name)
    plan = plan_of(model).alternatives[-1]
    assert CarryRows in kinds_of(plan)
    states, truth = given_as_found(model, states_of(model, 3))
    for k, state in enumerate(states.each):
        found = interpret(plan, *state, once=True)
        assert np.abs(found - truth[k]).max() < 1e-9 * np.abs(truth[k]).max()


def test_more_than_the_loop_leaves_free_is_refused() -> None:
    said = 'joints "p0", "p2" cannot all be prescribed'
    with pytest.raises(InputError, match=said):
        plan_of(prescribing(four_bar(), "p0", "p2"))


def test_emitted_with_its_check(builder: Builder, tmp_path: Path) -> None:
    model = prescribing(linkages(2, hips=1), "crank0", "h10")
    plan = plan_of(model)
    solver = builder.solver(plan, QUICK, name="prescribed", shape="unrolled")
    states, truth = given_as_found(model, states_of(model, 4))
    found = solver.solve(model, states, tmp_path)
    assert np.abs(found - truth).max() < 1e-10 * np.abs(truth).max()
    told = json.loads(solver.run("--check", "--json").stdout)["check"]
    assert told["ok"]


@pytest.mark.parametrize("name", ["crank of a four-bar", "gear"])
def test_in_form_ada(name: str) -> None:
    model = CASES[name]()
    schedule = best_schedule(model, 1, load_profile("default"))
    plan = make_plan(model, schedule, form="ada")
    states, truth = given_as_found(model, states_of(model, 3))
    for k, state in enumerate(states.each):
        found = interpret(plan, *state)
        assert np.abs(found - truth[k]).max() < 1e-9 * np.abs(truth[k]).max()
