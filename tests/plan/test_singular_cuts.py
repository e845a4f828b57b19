"""Cuts that a user asks for where they cannot be made."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.errors import InputError
from adagen.plan import make_plan
from adagen.plan.growth import predicted_growth
from tests.models import three_axis_chain
from tests.schedules import random_schedule


def test_a_cut_beside_massless_links_is_a_named_failure() -> None:
    """Either the plan is refused, or executing it says which joint cannot be factorized."""
    model = three_axis_chain(3)
    failures = 0
    for seed in range(12):
        schedule = random_schedule(model, 2, np.random.default_rng(seed))
        try:
            predicted_growth(make_plan(model, schedule))
        except (InputError, FloatingPointError) as error:
            failures += 1
            assert "factorization failed" in str(error) or "invert" in str(error)
            assert any(joint.name in str(error) for joint in model.joints) or "link" in str(error)
    assert failures > 0


def test_the_failure_is_a_floating_point_error() -> None:
    model = three_axis_chain(3)
    with pytest.raises(FloatingPointError, match='joint ".*": factorization failed'):
        for seed in range(12):
            schedule = random_schedule(model, 2, np.random.default_rng(seed))
            plan = make_plan(model, schedule)
            if len([process for process in plan.processes if process.owns]) > 1:
                predicted_growth(plan)
