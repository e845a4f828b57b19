"""The graphs behind shape `unrolled`, evaluated in Python: values, and what they cost."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.emit.shapes import SHAPES, chosen_shape, predict
from adagen.executor import interpret, simulate
from adagen.graph import Operations
from adagen.model import FLOATING, REVOLUTE, Inertia, Model
from adagen.plan import FORMS, make_plan
from adagen.reference import forward_dynamics
from adagen.schedule import load_profile
from adagen.states import random_states
from tests.cost.costs import step_profile
from tests.emitted import plan_of
from tests.models import Part, assemble, random_tree, rod, serial_chain, star, vector
from tests.schedules import random_schedule

PROFILE = load_profile("default")


@pytest.mark.parametrize("form", FORMS)
@settings(max_examples=12)
@given(
    st.integers(1, 6),
    st.integers(1, 3),
    st.integers(0, 1),
    st.booleans(),
    st.booleans(),
    st.integers(0, 2**32 - 1),
)
def test_graphs_and_numbers_say_what_is_true(
    form: str, joints: int, processes: int, mimics: int, floating: bool, aligned: bool, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(
        rng, joints, mimics=mimics, floating=floating, branching=0.5, coordinate_axes=aligned
    )
    plan = make_plan(model, random_schedule(model, processes, rng), form=form)
    states = random_states(model, 1, seed=seed % 1000)
    q, v, tau = states.q[0], states.v[0], states.tau[0]
    expected = forward_dynamics(model, q, v, tau)
    size = max(1.0, float(np.abs(expected).max()))
    for once in (False, True):
        found = interpret(plan, q, v, tau, once=once)
        np.testing.assert_allclose(found / size, expected / size, atol=1e-10)


def operations(model: Model) -> Operations:
    """Return what one process needs for an evaluation."""
    (only,) = simulate(plan_of(model, 1))
    return only.operations


def test_a_planar_chain_costs_a_third_of_a_spatial_one() -> None:
    planar = operations(serial_chain(10, axes="y")).arithmetic
    assert 3 * planar <= operations(oblique(10)).arithmetic
    # Axes x, y, z in turn and bodies of revolution have structure enough of their own.
    assert 9 * planar <= 4 * operations(serial_chain(10, axes="xyz")).arithmetic


def oblique(n: int) -> Model:
    """Return a chain whose axes and inertias have no structure."""
    return random_tree(np.random.default_rng(1), n, [REVOLUTE], branching=0)


def test_what_nobody_feels_costs_nothing() -> None:
    # OwnAxes about a vertical through its centre of mass, a body feels neither gravity nor speed.
    body = Inertia(2.0, np.zeros(3), np.diag([0.3, 0.2, 0.1]))
    count = operations(assemble("wheel", [Part("axle", None, REVOLUTE, body)]))
    assert (count.multiply, count.add, count.divide) == (1, 0, 0)


def test_gravity_reaches_a_floating_robot_once() -> None:
    model = serial_chain(4, floating=True)
    plan = plan_of(model, 1)
    light = plan.__class__(**{**plan.__dict__, "gravity": (0.0, 0.0, 0.0)})
    (with_it,), (without,) = simulate(plan), simulate(light)
    more = with_it.operations.arithmetic - without.operations.arithmetic
    assert 0 < more <= 25


def test_a_floating_body_of_its_own_needs_no_division_by_unknowns() -> None:
    part = Part("__base__", None, FLOATING, rod(1.0, vector(0.3, 0.0, 0.0)))
    assert operations(assemble("body", [part], floating=True)).divide == 1  # of the quaternion


def test_a_straight_line_is_chosen_where_its_price_is_less() -> None:
    assert chosen_shape(plan_of(serial_chain(6), 1)) == "unrolled"
    assert chosen_shape(plan_of(serial_chain(100), 1)) == "kernels"  # too long
    dear = step_profile(unrolled__operation=1.0)
    assert chosen_shape(plan_of(serial_chain(6), 1), profile=dear) == "kernels"


@pytest.mark.parametrize("robot", [serial_chain(6), serial_chain(60), star(4, 3), star(2, 3)])
def test_auto_is_the_shape_of_least_price(robot: Model) -> None:
    for processes in (1, 2):
        plan = plan_of(robot, processes)
        times = {
            shape: predict(plan, PROFILE, shape).makespan
            for shape in ("kernels", "unrolled")
            if SHAPES[shape].why_not(plan) is None
        }
        assert times[chosen_shape(plan)] == min(times.values())
        assert predict(plan, PROFILE).makespan == min(times.values())


def test_form_ada_on_several_processes_is_read_joint_by_joint() -> None:
    assert chosen_shape(plan_of(serial_chain(2), 1, form="ada")) == "unrolled"
    assert chosen_shape(plan_of(serial_chain(4), 2, form="ada")) == "joints"
