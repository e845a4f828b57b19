"""Plans carried out in several arithmetics: they agree, and balls hold the truth."""

from __future__ import annotations

import numpy as np
import pytest
from flint import arb, ctx, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.executor import Run, interpret
from adagen.executor.frames import columnwise
from adagen.graph import BALLS, DOUBLE, Evaluation, Graph, Numbers
from adagen.model import Model
from adagen.plan import make_plan
from adagen.reference import exact_forward_dynamics
from adagen.states import random_states
from tests.emitted import plan_of
from tests.models import random_tree, serial_chain, three_axis_chain
from tests.plan.test_fused import balanced
from tests.scene.effects import with_effects, with_wrenches


def affected(seed: int) -> Model:
    rng = np.random.default_rng(seed)
    return with_wrenches(with_effects(random_tree(rng, 6, branching=0.4), rng, "rp"), rng)


@pytest.mark.parametrize("meeting", ["join", "gather"])
def test_balls_hold_the_truth(meeting: str) -> None:
    model = affected(4)
    plan, states = plan_of(model, 2, meeting=meeting), random_states(model, 1, seed=2)
    state = states.q[0], states.v[0], states.tau[0]
    bits, ctx.prec = ctx.prec, 200
    try:
        balls = interpret(plan, *state, BALLS)
        truth = exact_forward_dynamics(model, *state, digits=20).value
        for ball, value in zip(balls, truth, strict=True):
            assert abs(ball.rad()) < 1e-40  # what differs is that the plan's constants are rounded
            assert abs(float(ball - arb(float(value)))) < 1e-13 * max(1.0, abs(value))
    finally:
        ctx.prec = bits


def test_many_states_at_once_are_each_by_itself_to_the_bit() -> None:
    model = affected(7)
    plan, states = plan_of(model, 3), random_states(model, 5, seed=3)
    together = interpret(plan, states.q.T, states.v.T, states.tau.T)
    np.testing.assert_array_equal(together.T, [interpret(plan, *row) for row in states.each])


@settings(max_examples=20)
@given(st.integers(1, 4), st.sampled_from(["ada", "segment"]), st.integers(0, 2**32 - 1))
def test_what_is_computed_at_once_differs_by_rounding(p: int, form: str, seed: int) -> None:
    model = affected(seed)
    plan, states = plan_of(model, p, form=form), random_states(model, 1, seed=seed % 1000)
    state = states.q[0], states.v[0], states.tau[0]
    expected, found = interpret(plan, *state), interpret(plan, *state, once=True)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9 * max(1, abs(expected).max()))


def test_the_frame_of_a_run_makes_its_motions_units() -> None:
    """B S = 1 in the first rows and nothing in the others."""
    model = three_axis_chain(2)
    plan = make_plan(model, balanced(model, 1, "ada"), form="ada")
    states = random_states(model, 1, seed=5)
    run = Run(plan, {"q": states.q[0], "v": states.v[0], "tau": states.tau[0]})
    frame = run.machines[0].memory["join", 5].frame
    assert frame.run == (3, 4, 5)
    motions = run.machines[0].constants(np.eye(6)[:, [2]])  # all of them turn about z
    last = motions
    for x in frame.transforms[1:]:
        motions = np.hstack([columnwise(x.motion, motions), last])
    units = run.of(0, frame.from_child(motions))
    np.testing.assert_allclose(units, np.eye(6)[:, :3], atol=1e-14)


def test_a_pose_in_which_the_ground_cannot_be_held_is_solved_the_other_way() -> None:
    model = serial_chain(24, axes="xy")
    plan = plan_of(model, 2, meeting="gather")
    assert all(process.recovery for process in plan.processes)
    zero = np.zeros(24)
    found = interpret(plan, zero, zero, zero + 1.0)
    truth = exact_forward_dynamics(model, zero, zero, zero + 1.0).value
    assert np.abs(found - truth).max() < 1e-12 * np.abs(truth).max()


FUNCTIONS = ("sqrt", "sign")


@pytest.mark.parametrize("x", [0.25, 2.0, 1e-9, 3.7])
def test_functions_say_the_same_in_graphs_and_numbers(x: float) -> None:
    graph, numbers = Graph(), Numbers(lambda _: x)
    for name in FUNCTIONS:
        expression = getattr(graph, name)(graph.input("x"))
        (value,) = Evaluation(graph, lambda _: DOUBLE.given(x)).of([expression])
        assert value == getattr(numbers, name)(numbers.input("x")).x


def test_functions_of_what_is_known_are_folded() -> None:
    graph = Graph()
    assert graph.sqrt(graph.constant(2.25)).constant == fmpq(3, 2)
    assert graph.sign(graph.constant(-3)).constant == -1
    assert graph.larger(graph.constant(2), graph.constant(3)).constant == 3
    x = graph.input("x")
    assert graph.larger(x, x) == x
