"""Straight lines near gimbal lock: what is small beside other entries of an inertia is exact."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.executor import interpret
from adagen.model import REVOLUTE, Inertia, Model
from adagen.plan.own_axes import losing_joints
from adagen.reference import exact_forward_dynamics
from adagen.states import random_states
from adagen.studies.stability import robots
from tests.emitted import ROUNDING, forward_error, plan_of
from tests.models import AXES, POINT, Part, assemble, rod, vector


def wrists(axes: str, between: Inertia) -> Model:
    """Return two rods, each on three axes through two links of no inertia."""
    parts: list[Part] = []
    for i in range(2):
        for k, axis in enumerate(axes):
            body = rod(1.0, vector(0.1, 0.2, 0.3)) if k == 2 else between
            place = vector(0.3, 0.0, 0.0) if k == 0 and parts else np.zeros(3)
            above = parts[-1].name if parts else None
            own = vector(*AXES[axis])
            parts.append(Part(f"{axis}{i}{k}", above, REVOLUTE, body, place, axis=own))
    return assemble("wrists", parts)


@pytest.mark.parametrize("between", [Inertia.zero(), POINT], ids=["no mass", "points"])
@pytest.mark.parametrize(("axes", "lock"), [("xyz", np.pi / 2), ("xyx", np.pi), ("zxz", 0.0)])
def test_straight_lines_are_right_near_gimbal_lock(
    axes: str, lock: float, between: Inertia
) -> None:
    model = wrists(axes, between)
    plan = plan_of(model, 1)
    assert {0, 1, 3, 4} <= losing_joints(plan)
    for joint in (1, 4):
        for angle in (1e-2, 1e-4, 1e-6):
            states = random_states(model, 3, seed=2)
            states.q[:, model.q_start[joint]] = lock + angle
            for state in states.each:
                truth = exact_forward_dynamics(model, *state).value
                found = interpret(plan, *state)
                assert forward_error(found[None], truth[None]) < ROUNDING["double"]


def test_ordinary_robots_turn_as_cheaply_as_before() -> None:
    assert not losing_joints(plan_of(robots.coil(12), 1))
