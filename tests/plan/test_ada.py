"""Plans of form `ada`, carried out by the executor, against independent dynamics."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.errors import InputError, UsageError
from adagen.executor import PlanError, interpret
from adagen.model import REVOLUTE, Inertia, Model
from adagen.plan import FORMS, make_plan, plan_from_json, plan_to_json
from adagen.plan.steps import Join, Receive, Send
from adagen.plan.types import Plan
from adagen.reference import exact_forward_dynamics, forward_dynamics
from adagen.schedule import Node, Topology, load_profile
from adagen.search import find_schedule
from adagen.states import random_states
from tests.links import with_inertia
from tests.models import (
    Part,
    assemble,
    binary,
    human_figure,
    random_tree,
    rod,
    serial_chain,
    star,
)
from tests.schedules import random_schedule, wrapped
from tests.slow import all_but

TIP, AXIS = np.array([0.3, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


def worst(model: Model, plan: Plan, states: int = 2) -> float:
    """Return the largest relative error of a plan against composite bodies and a solve."""
    error = 0.0
    sample = random_states(model, states, seed=5)
    for q, v, tau in sample.each:
        truth = forward_dynamics(model, q, v, tau)
        answer = interpret(plan, q, v, tau)
        error = max(error, float(np.abs(answer - truth).max() / max(1.0, np.abs(truth).max())))
    return error


@settings(max_examples=30)
@given(st.integers(1, 9), st.integers(1, 5), st.integers(0, 2**32 - 1))
def test_any_schedule_of_any_tree_is_right(joints: int, processes: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints)
    schedule = random_schedule(model, processes, rng)
    for form in FORMS:
        assert worst(model, make_plan(model, schedule, form=form)) < 1e-8


@settings(max_examples=30)
@given(st.integers(4, 9), st.integers(1, 4), st.integers(0, 2**32 - 1))
def test_slaved_joints_follow_their_sources(joints: int, processes: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, mimics=2)
    schedule = random_schedule(model, processes, rng)
    for form in FORMS:
        assert worst(model, make_plan(model, schedule, form=form)) < 1e-8


@pytest.mark.parametrize("processes", all_but([1, 2, 3, 4, 7], 2, 4))
@pytest.mark.parametrize(
    "model",
    [serial_chain(16), human_figure(), star(6, floating=True), binary(4, floating=True)],
    ids=lambda model: model.name,
)
@pytest.mark.parametrize("form", FORMS)
def test_known_robots(model: Model, processes: int, form: str) -> None:
    schedule = random_schedule(model, processes, np.random.default_rng(processes))
    assert worst(model, make_plan(model, schedule, form=form)) < 1e-9


def test_against_sixty_digits() -> None:
    model = human_figure()
    plan = make_plan(model, random_schedule(model, 3, np.random.default_rng(1)))
    sample = random_states(model, 1, seed=2)
    q, v, tau = sample.q[0], sample.v[0], sample.tau[0]
    truth = exact_forward_dynamics(model, q, v, tau).value
    assert np.abs(interpret(plan, q, v, tau) - truth).max() < 1e-11 * np.abs(truth).max()


def best(model: Model, processes: int) -> Plan:
    """Return the plan of the best schedule in form ada."""
    topology = Topology.of(model)
    schedule = find_schedule(topology, processes, profile=load_profile("paper"))
    return make_plan(model, schedule, form="ada")


def test_a_hub_shares_one_block() -> None:
    """All joints at one link share its block: twelve arms on a hub are one handle, not twelve."""
    plan = best(star(12, floating=True), 1)
    joins = [step for step in plan.processes[0].steps if isinstance(step, Join)]
    assert len(joins) == 25
    assert max(len(join.couplings) for join in joins) == 1
    assert all(update.target.row == update.target.column for j in joins for update in j.blocks)


def test_trees_that_meet_in_the_ground_exchange_nothing() -> None:
    """Process 1 has an arm of its own on the ground: its chain has no handle to tell of."""
    chains = [Part(f"{arm}0", None, REVOLUTE, rod(1.0, TIP), axis=AXIS) for arm in "ab"]
    chains += [Part(f"{arm}1", f"{arm}0", REVOLUTE, rod(1.0, TIP), TIP, axis=AXIS) for arm in "ab"]
    model = assemble("two_arms", chains)
    assert [joint.parent for joint in model.joints] == [0, 1, 0, 3]
    other = Node(2, (1, 2), None, Node(3, (1, 2), None, None, 0.0, 1), 0.0, 1)
    root = Node(0, (0, 2), other, Node(1, (0, 1), None, None, 0.0, 1), 0.0, 0)
    for form in FORMS:
        plan = make_plan(model, wrapped(root, model, 2), form=form)
        assert [process.owns for process in plan.processes] == [(0, 1), (2, 3)]
        assert plan.messages == ()
        assert worst(model, plan) < 1e-12


def test_every_message_is_sent_and_received_once() -> None:
    model = human_figure()
    plan = make_plan(model, random_schedule(model, 4, np.random.default_rng(4)))
    sends = [s.message for p in plan.processes for s in p.steps if isinstance(s, Send)]
    receives = [s.message for p in plan.processes for s in p.steps if isinstance(s, Receive)]
    assert sorted(sends) == sorted(receives) == list(range(len(plan.messages)))
    assert plan.messages


def test_a_process_reads_no_more_than_its_joints_need() -> None:
    model = human_figure()
    plan = make_plan(model, random_schedule(model, 4, np.random.default_rng(4)))
    for process in plan.processes:
        needed = plan.paths(process.owns)
        assert set(process.reads) == needed


def test_a_lost_message_is_found_out() -> None:
    model = human_figure()
    plan = make_plan(model, random_schedule(model, 2, np.random.default_rng(6)))
    first = plan.processes[1]
    mute = replace(first, steps=tuple(s for s in first.steps if not isinstance(s, Send)))
    broken = replace(plan, processes=(plan.processes[0], mute))
    sample = random_states(model, 1, seed=1)
    with pytest.raises(PlanError, match="waits for ever"):
        interpret(broken, sample.q[0], sample.v[0], sample.tau[0])


def test_json_and_back() -> None:
    model = random_tree(np.random.default_rng(7), 9, mimics=1)
    schedule = random_schedule(model, 3, np.random.default_rng(7))
    for form in FORMS:
        plan = make_plan(model, schedule, form=form, source_hash="ab")
        text = plan_to_json(plan)
        assert plan_from_json(text) == plan
        assert plan_to_json(plan_from_json(text)) == text
        assert json.loads(text)["form"] == form


def test_point_masses_are_named() -> None:
    """Where a schedule joins one by itself."""
    point = Inertia(1.0, np.zeros(3), np.zeros((3, 3)))
    model = with_inertia(serial_chain(3), 2, point)
    schedule = find_schedule(Topology.of(model), 2, profile=load_profile("paper"))
    with pytest.raises(InputError, match="singular rotational inertia"):
        make_plan(model, schedule, form="ada")


def test_unknown_words_are_usage_errors() -> None:
    model = serial_chain(2)
    schedule = random_schedule(model, 1, np.random.default_rng(0))
    with pytest.raises(UsageError, match="unknown form"):
        make_plan(model, schedule, form="magic")
