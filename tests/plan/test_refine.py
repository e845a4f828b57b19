"""Iterative refinement of plans in numpy: what it reaches, and what its size says."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.executor.refine import interpret_refined
from adagen.model import Model
from adagen.plan import make_plan
from adagen.reference import energy_norm_error, exact_forward_dynamics, joint_space_inertia
from adagen.schedule import Schedule, load_profile
from adagen.search import best_schedule
from adagen.states import random_states
from tests.links import with_light_link
from tests.models import human_figure, random_tree, serial_chain, three_axis_chain
from tests.schedules import random_schedule


def errors(
    model: Model, form: str, processes: int, steps: int, schedule: Schedule | None = None
) -> list[tuple[float, ...]]:
    """Return for two states the errors after 0, 1, ... steps, then the corrections' sizes."""
    if schedule is None:
        schedule = random_schedule(model, processes, np.random.default_rng(processes))
    plan = make_plan(model, schedule, form=form)
    sample = random_states(model, 2, seed=3)
    rows = []
    for state in sample.each:
        truth = exact_forward_dynamics(model, *state).value
        inertia = joint_space_inertia(model, state[0])
        answers = [interpret_refined(plan, *state, k) for k in range(steps + 1)]
        found = [energy_norm_error(inertia, a.qdd - truth, truth) for a in answers]
        rows.append((*found, *answers[-1].corrections))
    return rows


@settings(max_examples=15)
@given(st.integers(2, 8), st.integers(1, 4), st.integers(0, 2**32 - 1))
def test_a_correction_is_as_large_as_the_error(joints: int, processes: int, seed: int) -> None:
    model = random_tree(np.random.default_rng(seed), joints, mimics=seed % 2)
    for form in ("ada", "segment"):
        for raw, once, size in errors(model, form, processes, 1):
            assert once < 1e-13
            # The error before is the correction and the error after; 2e-15: they are doubles.
            assert abs(raw - size) < 1.01 * once + 0.01 * size + 2e-15


@pytest.mark.parametrize("form", ["ada", "segment"])
@pytest.mark.parametrize(
    "model", [serial_chain(12), human_figure()], ids=lambda model: str(model.name)
)
def test_axes_along_coordinates_are_solved_to_the_last_bit(model: Model, form: str) -> None:
    """Their frames hold no rounded constant, so that nothing but the answer itself is rounded."""
    for raw, once, size in errors(model, form, 2, 1):
        assert once < 4e-16
        assert size / 3 < raw < 3 * size


@pytest.mark.parametrize("form", ["ada", "segment"])
def test_states_at_once_have_the_bits_of_single_ones(form: str) -> None:
    model = random_tree(np.random.default_rng(2), 7, mimics=1)
    plan = make_plan(model, random_schedule(model, 2, np.random.default_rng(2)), form=form)
    sample = random_states(model, 3, seed=3)
    together = interpret_refined(plan, sample.q.T, sample.v.T, sample.tau.T, 2)
    assert together.qdd.shape == (model.nv, 3)
    for s, state in enumerate(sample.each):
        alone = interpret_refined(plan, *state, 2)
        assert np.array_equal(together.qdd[:, s], alone.qdd)
        assert tuple(sizes[s] for sizes in together.corrections) == alone.corrections


def test_a_light_link_takes_two_steps_in_form_ada() -> None:
    model = with_light_link(serial_chain(20, radius=0.05), 10, 1e-8)
    for raw, once, twice, size, second in errors(model, "ada", 1, 2):
        assert raw > 1e-9
        assert twice < 1e-15 < once < 1e-3 * raw
        assert size / 3 < raw < 3 * size
        assert second / 3 < once < 3 * second


def test_massless_links_are_no_obstacle_inside_a_segment() -> None:
    for _, once, _ in errors(three_axis_chain(3), "segment", 1, 1):
        assert once < 1e-15


@pytest.mark.parametrize("processes", [1, 2])
def test_runs_through_massless_links_are_refined_as_one(processes: int) -> None:
    model = three_axis_chain(3)
    schedule = best_schedule(model, processes, load_profile("default"), "ada")
    for raw, once, size in errors(model, "ada", processes, 1, schedule):
        assert once < 1e-15
        assert size / 3 < raw < 3 * size
