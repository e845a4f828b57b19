"""Plans of robots with closed loops against dense algebra in the null space."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.errors import InputError
from adagen.executor import interpret
from adagen.executor.trial import tried_closed
from adagen.graph import BALLS
from adagen.model import (
    LOOP_KINDS,
    PRISMATIC,
    REVOLUTE,
    SPHERICAL,
    WORLD,
    Inertia,
    LoopEnd,
    Model,
    NamedLoop,
)
from adagen.plan import Plan, closures, make_plan, plan_from_json, plan_to_json
from adagen.plan.closure_steps import nothing_moves
from adagen.plan.steps import CarryRows, Eliminate, HoldBack
from adagen.program import check
from adagen.program.lower import lower
from adagen.reference.closed import closed_forward_dynamics
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States
from tests.emitted import EXACT, QUICK, Builder
from tests.executor.plans import kinds_of
from tests.mechanisms import (
    MECHANISMS,
    four_bar,
    geared,
    gripping,
    looped_tree,
    planar_chain,
    standing,
    states_of,
    truss,
    with_loops,
)
from tests.models import Part, assemble, human_figure, rod, vector
from tests.slow import every_other

TREES = (REVOLUTE, PRISMATIC, SPHERICAL)


def plan_of(model: Model, processes: int = 1, scalar: str = "double") -> Plan:
    """Return the plan that is taken for a robot."""
    schedule = best_schedule(model, processes, load_profile("default"))
    return make_plan(model, schedule, scalar=scalar)


def worst(model: Model, plan: Plan, states: States) -> float:
    """Return the largest error of a plan, relative to the largest acceleration of its state."""
    errors = []
    for q, v, tau in states.each:
        truth = closed_forward_dynamics(model, q, v, tau)
        found = interpret(plan, q, v, tau, once=True)
        errors.append(np.abs(found - truth).max() / max(1.0, np.abs(truth).max()))
    return float(max(errors))


@pytest.mark.parametrize("name", MECHANISMS)
def test_mechanisms_move_as_dense_algebra_says(name: str) -> None:
    model = MECHANISMS[name]()
    plan = plan_of(model)
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states_of(model, 6)) < 1e-12


@pytest.mark.parametrize("floating", [False, True])
@pytest.mark.parametrize("form", ["segment", "ada"])
def test_joints_beside_loops_are_slaved(form: str, floating: bool) -> None:
    """One process does it: torques between slaved joints come last, where a pose is poor, too."""
    model = gripping(floating=floating)
    schedule = best_schedule(model, 2, load_profile("default"), form)
    plan = make_plan(model, schedule, form=form)
    for each in plan.alternatives:
        check(lower(each, "unrolled"))
        assert worst(model, each, states_of(model, 4)) < 1e-11


@pytest.mark.parametrize(("kind", "floating"), every_other(LOOP_KINDS))
def test_loops_of_every_kind(kind: str, floating: bool) -> None:
    for seed in (3, 4):
        model = looped_tree(kind, seed, joints=8, floating=floating, kinds=TREES)
        plan = plan_of(model)
        check(lower(plan, "unrolled"))
        assert worst(model, plan, states_of(model, 3)) < 1e-10


@pytest.mark.parametrize("kind", ["revolute", "spherical", "cylindrical", "weld"])
def test_rows_are_carried_through_articulated_joints(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A closure of many freedoms holds back few of them; the answer is the same."""
    monkeypatch.setattr(closures, "MOST_HELD", 3)
    model = looped_tree(kind, 3, joints=14, whole=True)
    plan = plan_of(model)
    usual = plan.alternatives[-1]
    assert {CarryRows, HoldBack, Eliminate} <= kinds_of(usual)
    check(lower(plan, "unrolled"))
    assert worst(model, usual, states_of(model, 3)) < 1e-12


@pytest.mark.parametrize("kind", ["spherical", "cylindrical", "weld"])
def test_what_the_ground_holds_ends_at_the_first_link_that_can_follow(kind: str) -> None:
    """A chain pinned at both ends is a tree but for its last joints; both ways agree."""
    model = looped_tree(kind, 3, joints=14, whole=True)
    plan, states = plan_of(model), states_of(model, 3)
    steps = plan.processes[0].steps
    (top,) = (step.link for step in steps if isinstance(step, Eliminate))
    held = [step.joint for step in steps if isinstance(step, HoldBack)]
    assert top >= 5
    assert held == list(reversed(range(top, 14)))
    for each in plan.alternatives:
        check(lower(each, "unrolled"))
        assert worst(model, each, states) < 1e-10


def test_feet_on_the_ground_are_closures_of_their_own() -> None:
    """Two feet that are held by the ground end at the body that both legs are at."""
    model = standing(human_figure(), "weld", "left_ankle_link", "right_ankle_link")
    plan, states = plan_of(model), states_of(model, 3)
    tops = [step.link for step in plan.processes[0].steps if isinstance(step, Eliminate)]
    assert len(tops) == 2
    assert 0 not in tops
    for each in plan.alternatives:
        assert worst(model, each, states) < 1e-10


def test_a_plan_with_loops_is_read_back() -> None:
    plan = plan_of(looped_tree("universal", 4, joints=8))
    assert plan_from_json(plan_to_json(plan)) == plan


def test_other_choices_are_at_hand_where_one_is_poor() -> None:
    """All ways agree in a pose in which all are good; some pose needs another than the first."""
    model = looped_tree("spherical", 7, joints=6, floating=False)
    plan = plan_of(model)
    states = states_of(model, 40, seed=3)
    assert worst(model, plan, states) < 1e-12


@pytest.mark.parametrize("processes", [2, 3])
def test_one_process_has_all_of_a_closed_robot(processes: int) -> None:
    model = four_bar()
    plan = plan_of(model, processes)
    assert [len(process.owns) for process in plan.processes] == [3] + [0] * (processes - 1)
    assert worst(model, plan, states_of(model, 2)) < 1e-9


def test_an_open_loop_is_refused_by_name() -> None:
    model = four_bar()
    plan, states = plan_of(model), states_of(model, 1)
    q, v, tau = states.q[0], states.v[0], states.tau[0]
    with pytest.raises(FloatingPointError, match='loop "pin": it is open'):
        interpret(plan, q + 1e-3, v, tau)
    with pytest.raises(FloatingPointError, match='loop "pin": the velocity violates it'):
        interpret(plan, q, v + 0.1, tau)
    model = geared()
    plan, states = plan_of(model), states_of(model, 1)
    with pytest.raises(FloatingPointError, match='coupling "gear": it is open'):
        interpret(plan, states.q[0] + 0.01, states.v[0], states.tau[0])


def test_a_change_point_is_refused() -> None:
    """A parallelogram lying flat: its two branches meet, and its rank drops."""
    model = planar_chain(0.2, 0.5, 0.2)
    model = _closed_flat(model)
    plan = plan_of(model)
    q, none = np.zeros(3), np.zeros(3)
    q[2] = np.pi
    with pytest.raises(FloatingPointError, match='loop "pin": singular pose'):
        interpret(plan, q, none, none)


@pytest.mark.parametrize("scalar", ["double", "float"])
def test_a_change_point_is_passed_at_speed(scalar: str) -> None:
    """Nearer and nearer to it, until the pose counts as singular; no digit is wrong before.

    As near as to an angle e, the state that is given tells the answer to 1e-16 / e, 6e-8 / e.
    """
    from adagen.graph import DOUBLE, FLOAT

    plan = plan_of(_closed_flat(planar_chain(0.2, 0.5, 0.2)), scalar=scalar)
    algebra, rounding = (FLOAT, 6e-8) if scalar == "float" else (DOUBLE, 1.1e-16)
    v, tau = np.array([3.0, -3.0, 3.0]), np.array([0.3, 0.2, -0.1])
    answered = 0
    for place in range(12):
        near = 2.0 ** (-3 * place)
        q = np.array([near, -near, np.pi + near])
        if scalar == "float":
            q = q.astype(np.float32).astype(float)
        try:
            found = np.array(interpret(plan, q, v, tau, algebra), dtype=float)
        except FloatingPointError:
            with pytest.raises(FloatingPointError, match="singular pose"):
                interpret(plan, q, v, tau, algebra)
            break
        answered += 1
        turned = replace(plan, scalar="double")
        exact = np.array([float(x) for x in interpret(turned, q, v, tau, BALLS)])
        error = np.abs(found - exact).max() / np.abs(exact).max()
        assert error < 100 * rounding * (1 + 1 / near)
    assert answered >= (3 if scalar == "float" else 6)


def _closed_flat(model: Model) -> Model:
    ends = LoopEnd("p2_link", (0.2, 0.0, 0.0)), LoopEnd("ground", (0.5, 0.0, 0.0))
    return with_loops(model, (NamedLoop("pin", "revolute", *ends, (0.0, 1.0, 0.0)),))


def test_what_cannot_be_solved_is_refused_at_once() -> None:
    model = four_bar()
    model.loops[0].frame2.translation[0] = 5.0
    with pytest.raises(InputError, match='loop "pin" cannot be closed') as caught:
        plan_of(model)
    by = re.search(r'leaves "pin" open by (\S+) \(m or rad\)', str(caught.value))
    assert by is not None and float(by[1]) == 3.9  # the others together span 1.1 m of 5 m
    massless = planar_chain(0.2, 0.5, 0.4, 0.3, massless=3)
    loops = four_bar().loops
    with pytest.raises(InputError, match='joint "p3" can move with no inertia'):
        plan_of(replace(massless, loops=loops))


def test_predicted_digits_are_of_states_that_are_closed() -> None:
    model = four_bar()
    found = tried_closed(model, plan_of(model))
    assert 0.0 < found.error < 1e-13
    assert tried_closed(model, plan_of(model, scalar="float")).error < 1e-4


def test_where_nothing_moves_no_digit_is_lost() -> None:
    plan = plan_of(truss())
    assert nothing_moves(plan) and not nothing_moves(plan_of(four_bar()))
    assert tried_closed(truss(), plan).error == 0.0


def test_balls_hold_what_double_finds() -> None:
    model = looped_tree("revolute", 3, joints=8)
    plan, states = plan_of(model), states_of(model, 1)
    state = states.q[0], states.v[0], states.tau[0]
    exact = np.array([float(x) for x in interpret(plan, *state, BALLS)])
    np.testing.assert_allclose(interpret(plan, *state), exact, rtol=0, atol=1e-11)


@pytest.mark.parametrize("name", ["four-bar on a floating base", "gear"])
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_emitted_code_is_the_executor(
    name: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    from adagen.graph import DOUBLE, FLOAT

    model = MECHANISMS[name]()
    plan, states = plan_of(model, scalar=scalar), states_of(model, 3)
    solver = builder.solver(plan, EXACT, name="closed", shape="unrolled")
    found = solver.solve(model, states, tmp_path)
    algebra = {"double": DOUBLE, "float": FLOAT}[scalar]
    expected = np.array([interpret(plan, *row, algebra, lanes=True) for row in states.each])
    np.testing.assert_array_equal(found.astype(expected.dtype), expected)


@pytest.mark.slow
def test_limbs_beside_loops_share_lanes(builder: Builder, tmp_path: Path) -> None:
    """A figure holding its own hand: its legs go side by side, and the answer is right."""
    model = human_figure()
    plan = plan_of(model)
    assert not plan.closed
    names = [joint.name for joint in model.joints]
    arms = [k for k, name in enumerate(names) if "wrist" in name or "hand" in name][:2]
    assert len(arms) == 2
    ends = (LoopEnd(model.links[arms[0] + 1].name), LoopEnd(model.links[arms[1] + 1].name))
    held = with_loops(model, (NamedLoop("grasp", "point", *ends),))
    plan, states = plan_of(held), states_of(held, 3)
    assert worst(held, plan, states) < 1e-9
    found = builder.solver(plan, QUICK, shape="unrolled").solve(held, states, tmp_path)
    truth = np.array([closed_forward_dynamics(held, *row) for row in states.each])
    assert np.abs(found - truth).max() < 1e-9 * np.abs(truth).max()


def test_a_body_that_loops_hold_may_have_no_inertia() -> None:
    model = four_bar(massless=True)
    assert model.links[2].inertia.mass == Inertia.zero().mass
    assert worst(model, plan_of(model), states_of(model, 3)) < 1e-13


def test_many_freedoms_that_many_rows_tie_are_all_held_back(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A row of windows: 17 hinges, of which one is free; else 16 and 16 forces were solved for."""
    monkeypatch.setattr(closures, "MOST_HELD", 15)
    y, up, along = (0.0, 1.0, 0.0), vector(0.0, 0.0, 1.0), vector(1.0, 0.0, 0.0)
    parts = [Part("post0", None, REVOLUTE, rod(1.0, up), axis=vector(*y))]
    loops = []
    for k in range(1, 9):
        last = f"beam{k - 1}" if k > 1 else "post0"
        start = along if k > 1 else up
        parts += [
            Part(f"beam{k}", last, REVOLUTE, rod(1.0, along), start, axis=vector(*y)),
            Part(f"post{k}", f"beam{k}", REVOLUTE, rod(1.0, -up), along, axis=vector(*y)),
        ]
        foot, place = LoopEnd(f"post{k}_link", (0.0, 0.0, -1.0)), (1.1 * k, 0.0, 0.1 * (k % 3))
        loops.append(NamedLoop(f"pin{k}", "revolute", foot, LoopEnd(WORLD, place), y))
    model = with_loops(assemble("windows", parts), tuple(loops))
    (closure,) = closures.closures_of(model)
    assert len(closure.path) == 17 and closure.held == closure.path
    assert worst(model, plan_of(model), states_of(model, 2)) < 1e-9
