"""Damping, friction, springs, rotors, outer forces, prescribed motions, in plans of both forms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from adagen.executor import interpret
from adagen.model import PRISMATIC, REVOLUTE, Model
from adagen.plan import make_plan, plan_from_json, plan_to_json
from adagen.reference import exact_forward_dynamics
from adagen.states import random_states
from tests.models import ALL_KINDS, random_tree
from tests.scene.effects import with_effects, with_wrenches
from tests.schedules import random_schedule
from tests.slow import spread

Array = NDArray[np.float64]


def state(model: Model, seed: int = 1) -> tuple[Array, Array, Array]:
    sample = random_states(model, 1, seed)
    return sample.q[0], sample.v[0], sample.tau[0]


def check(model: Model, rng: np.random.Generator, form: str, processes: int) -> None:
    """Compare a plan of a random schedule with the certified reference."""
    plan = make_plan(model, random_schedule(model, processes, rng), form=form)
    assert plan_from_json(plan_to_json(plan)) == plan
    q, v, tau = state(model)
    want = exact_forward_dynamics(model, q, v, tau, digits=20).value
    got = interpret(plan, q, v, tau)
    assert abs(got - want).max() < 1e-9 * abs(want).max()


@pytest.mark.parametrize("what", spread(["d", "r", "p", "drp"], 4))
@pytest.mark.parametrize("form", ["segment", "ada"])
@settings(max_examples=6)
@given(seed=st.integers(0, 10**6))
def test_plans_agree_with_the_reference(what: str, form: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    n = int(rng.integers(2, 9))
    model = random_tree(rng, n, ALL_KINDS, floating=bool(rng.random() < 0.3))
    model = with_wrenches(with_effects(model, rng, what), rng, int(rng.integers(0, 3)))
    check(model, rng, form, int(rng.integers(1, min(n, 4) + 1)))


@pytest.mark.parametrize("form", ["segment", "ada"])
@settings(max_examples=6)
@given(seed=st.integers(0, 10**6))
def test_slaved_joints_may_have_rotors_and_springs(form: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 6, (REVOLUTE, PRISMATIC), mimics=2)
    model = with_wrenches(with_effects(model, rng, "drp"), rng)
    check(model, rng, form, int(rng.integers(1, 4)))
