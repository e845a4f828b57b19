"""The digits that form `ada` loses beside light links, predicted and measured."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.executor import interpret
from adagen.executor.join_digits import growth_and_loss, predicted_growth
from adagen.executor.refine import interpret_refined
from adagen.model import Passive
from adagen.plan import make_plan
from adagen.plan.digits import EPSILON, generic_configuration, generic_motion
from adagen.plan.steps import Join
from adagen.reference import energy_norm_error, exact_forward_dynamics, joint_space_inertia
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import random_states
from tests.links import with_light_link
from tests.models import human_figure, serial_chain
from tests.plan.test_parts import hinges
from tests.schedules import random_schedule


@pytest.mark.parametrize("ratio", [1e-4, 1e-6, 1e-8])
def test_the_prediction_is_right_within_two_digits(ratio: float) -> None:
    model = with_light_link(serial_chain(10), 5, ratio)
    plan = make_plan(model, random_schedule(model, 1, np.random.default_rng(2)), form="ada")
    growth = predicted_growth(plan)
    assert growth.joint in (4, 5)  # above or below the light link
    assert growth.largest > 0.1 / ratio
    sample = random_states(model, 5, seed=3)
    worst = 0.0
    for q, v, tau in sample.each:
        truth = exact_forward_dynamics(model, q, v, tau).value
        error = interpret(plan, q, v, tau) - truth
        worst = max(worst, energy_norm_error(joint_space_inertia(model, q), error, truth))
    assert growth.error / 100 < worst < growth.error * 100


def test_ordinary_robots_lose_nothing() -> None:
    model = human_figure()
    plan = make_plan(model, random_schedule(model, 2, np.random.default_rng(0)), form="ada")
    assert predicted_growth(plan).error < 1e-13


def test_float_is_told_apart() -> None:
    model = with_light_link(serial_chain(10), 5, 1e-2)
    schedule = random_schedule(model, 1, np.random.default_rng(2))
    double = predicted_growth(make_plan(model, schedule, form="ada"))
    single = predicted_growth(make_plan(model, schedule, form="ada", scalar="float"))
    assert single.error == pytest.approx(double.error * 2.0**29)


@pytest.mark.parametrize(("parts", "processes"), [(8, 1), (0, 2)])
def test_one_run_tells_of_long_chains_what_growth_and_refinement_tell(
    parts: int, processes: int
) -> None:
    model = hinges(60, seed=2)
    held = Passive(stiffness=2.0, damping=0.1, friction=0.1)
    sprung = replace(model, joints=tuple(replace(j, passive=held) for j in model.joints))
    schedule = replace(best_schedule(model, processes, load_profile("default")), parts=parts)
    for scalar in ("double", "float"):
        plan = make_plan(model, schedule, scalar=scalar)
        found = growth_and_loss(plan)
        assert found is not None
        growth, loss = found
        assert any(plan.steps_of(Join)) == bool(parts) == (growth.largest > 1.0)
        assert growth.error == pytest.approx(predicted_growth(plan).error, rel=0.1)
        q = generic_configuration(plan.joints, 1)
        v, tau = generic_motion(plan.nv, 1)
        (size,) = interpret_refined(plan, q, v, tau, steps=1).corrections
        truth = exact_forward_dynamics(model, q, v, tau).value
        error = interpret(plan, q, v, tau, once=True) - truth
        true = energy_norm_error(joint_space_inertia(model, q), error, truth)
        # Neither knows how the plan's constants are rounded, a part of these few roundings.
        for told in (loss * EPSILON["double"] / EPSILON[scalar], size):
            assert true / 2 < told < true * 2
        assert growth_and_loss(make_plan(sprung, schedule, scalar=scalar)) == found
