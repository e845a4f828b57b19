"""Slaved joints in shape kernels: the sweeps once more for each torque that holds one in step."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import emit, program_of
from adagen.emit.shapes import SHAPES, predict
from adagen.errors import UsageError
from adagen.model import Mimic, Model, Passive
from adagen.plan import Plan
from adagen.schedule import load_profile
from adagen.states import random_states
from adagen.urdf import read_robot
from tests.emit.test_fused import slaved_chain
from tests.emit.test_gimbal_lock import two_arms
from tests.emitted import ROUNDING, Builder, energy_errors, plan_of
from tests.golden.examples import FOLDER
from tests.models import serial_chain, star
from tests.slow import slow


def slaved(model: Model, *pairs: tuple[int, int, float]) -> Model:
    """Return the model with joints (slaved, source, multiplier) held in step."""
    joints = list(model.joints)
    for k, (j, source, multiplier) in enumerate(pairs):
        joints[j] = replace(joints[j], mimic=Mimic(source, multiplier, 0.2 * k - 0.1))
    return replace(model, joints=tuple(joints))


def damped(model: Model) -> Model:
    """Return the model with damping, friction, a spring and a rotor at every joint."""
    passive = Passive(damping=0.3, friction=0.1, stiffness=2.0, rest=0.3, rotor_inertia=0.1)
    return replace(model, joints=tuple(replace(joint, passive=passive) for joint in model.joints))


@pytest.mark.parametrize(
    ("model", "processes"),
    [
        pytest.param(
            slaved(star(4, 3, floating=True), (2, 1, -0.5), (8, 1, 2.0)), 1, marks=pytest.mark.slow
        ),
        (damped(slaved(serial_chain(9), (3, 1, -0.5), (7, 1, 1.5), (8, 5, 1.0))), 2),
        pytest.param(slaved(serial_chain(12), (4, 11, 0.7)), 3, marks=pytest.mark.slow),
        pytest.param(
            read_robot(FOLDER / "models" / "arm7.urdf", mimic=True).model, 2, marks=pytest.mark.slow
        ),
        pytest.param(slaved_chain(), 1, marks=pytest.mark.slow),
        (slaved(two_arms(), (7, 1, -0.5), (9, 3, 1.5)), 1),
    ],
    ids=["in lanes", "damped on two", "across three", "arm", "in own axes", "in lanes, own axes"],
)
def test_slaved_joints_are_held_in_step(
    model: Model, processes: int, builder: Builder, tmp_path: Path
) -> None:
    plan = plan_of(model, processes)
    assert plan.slaved and SHAPES["kernels"].why_not(plan) is None
    states = random_states(model, 4, seed=7)
    solver = builder.solver(plan, name="slaved", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


@pytest.mark.parametrize(
    ("model", "processes", "scalar"),
    [
        pytest.param(
            slaved(star(4, 3, floating=True), (2, 1, -0.5), (8, 1, 2.0)),
            1,
            "double",
            marks=pytest.mark.slow,
        ),
        pytest.param(slaved(serial_chain(12), (4, 11, 0.7)), 3, "double", marks=pytest.mark.slow),
        slow(slaved(serial_chain(9), (3, 1, -0.5), (7, 1, 1.5), (8, 5, 1.0)), 2, "double"),
        pytest.param(slaved_chain(), 1, "double", marks=pytest.mark.slow),
        (slaved(two_arms(), (7, 1, -0.5), (9, 3, 1.5)), 1, "double"),
    ],
    ids=["in lanes", "across three", "on two", "in own axes", "in lanes, own axes"],
)
def test_slaved_joints_are_refined(
    model: Model, processes: int, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    """The first correction is as large as the error was; what it leaves is rounding."""
    plan = plan_of(model, processes, scalar=scalar)
    assert chosen_by_refinement(plan) == "kernels"
    states = random_states(model, 4, seed=7)
    solver = builder.solver(plan, name="slaved", refine=3, shape="kernels")
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-14
    said = np.array(json.loads((tmp_path / "result.json").read_text())["corrections"])
    assert (said[:, 1] < 1e-2 * said[:, 0]).all()


def chosen_by_refinement(plan: Plan) -> str:
    """Return the shape that a refined plan is emitted in."""
    return program_of(plan, refine=2).shape


def test_each_slaved_joint_costs_the_sweeps_again() -> None:
    free, profile = serial_chain(9), load_profile("default")
    held = slaved(free, (3, 1, -0.5))
    once, twice = (predict(plan_of(m, 1), profile, "kernels").makespan for m in (free, held))
    assert once < twice < 2 * once


def test_what_loops_do_not_do_for_slaved_joints_is_refused() -> None:
    held = slaved(serial_chain(4), (2, 1, -0.5))
    plan = plan_of(held, 1)
    with pytest.raises(UsageError, match="slaved to another"):
        emit(plan, shape="kernels", batch=1)
