"""The digits that form `ada` loses beside light links, predicted and measured."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.executor import interpret
from adagen.executor.join_digits import predicted_growth
from adagen.plan import make_plan
from adagen.reference import energy_norm_error, exact_forward_dynamics, joint_space_inertia
from adagen.states import random_states
from tests.links import with_light_link
from tests.models import human_figure, serial_chain
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
