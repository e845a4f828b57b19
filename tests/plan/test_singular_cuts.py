"""Cuts that a user asks for where they cannot be made."""

from __future__ import annotations

import numpy as np

from adagen.errors import InputError
from adagen.executor.join_digits import predicted_growth
from adagen.plan import make_plan
from tests.models import three_axis_chain
from tests.schedules import random_schedule


def test_cuts_beside_massless_links_are_named_failures() -> None:
    """The plan is refused, or executing it says which joint cannot be factorized."""
    model = three_axis_chain(3)
    said = []
    for seed in range(12):
        schedule = random_schedule(model, 2, np.random.default_rng(seed))
        try:
            predicted_growth(make_plan(model, schedule))
        except (InputError, FloatingPointError) as error:
            said.append(str(error))
    names = [joint.name for joint in model.joints] + [link.name for link in model.links]
    assert any("factorization failed" in text for text in said)
    assert all(any(f'"{name}"' in text for name in names) for text in said)
