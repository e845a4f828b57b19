"""Form segment with one exchange: processes that gather inertias at a small core."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.executor import interpret
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.steps import (
    Articulate,
    HoldMobility,
    Join,
    Kinematics,
    Propagate,
    Receive,
    Send,
    SolveRoot,
)
from adagen.schedule import Schedule, Topology, load_profile
from adagen.search import best_schedule, find_schedule
from adagen.states import random_states
from tests.links import with_light_link
from tests.models import random_tree, serial_chain
from tests.schedules import random_schedule


def by_process(model: Model, processes: int) -> Schedule:
    return find_schedule(Topology.of(model), processes, profile=load_profile("paper"))


def gathered(model: Model, processes: int) -> Plan:
    return make_plan(model, by_process(model, processes), meeting="gather")


def error(model: Model, plan: Plan) -> float:
    """Largest difference from the plan of one process, relative to the largest acceleration."""
    alone = make_plan(model, by_process(model, 1))
    states = random_states(model, 3, seed=3)
    worst = 0.0
    for q, v, tau in states.each:
        right, found = interpret(alone, q, v, tau), interpret(plan, q, v, tau)
        worst = max(worst, float(np.abs(found - right).max() / max(1.0, np.abs(right).max())))
    return worst


def bent_arm_error(model: Model, plan: Plan, bend: float) -> float:
    """Return the error of a plan at a chain of hinges whose angles are of a size."""
    rng = np.random.default_rng(4)
    q = bend * rng.normal(size=model.nq)
    v, tau = rng.normal(size=model.nv), rng.normal(size=model.nv)
    right = interpret(make_plan(model, by_process(model, 1)), q, v, tau)
    return float(np.abs(interpret(plan, q, v, tau) - right).max() / np.abs(right).max())


@settings(max_examples=30)
@given(st.integers(1, 12), st.integers(1, 5), st.booleans(), st.integers(0, 2**32 - 1))
def test_any_schedule_of_any_tree_can_gather(
    joints: int, processes: int, floating: bool, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, branching=0.6, floating=floating)
    plan = make_plan(model, random_schedule(model, processes, rng), meeting="gather")
    assert error(model, plan) < 1e-8


@settings(max_examples=30)
@given(st.integers(2, 12), st.integers(1, 5), st.integers(0, 2**32 - 1))
def test_every_joint_is_given_by_one_process_and_computed_where_it_is_needed(
    joints: int, processes: int, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, branching=0.6)
    plan = make_plan(model, random_schedule(model, processes, rng), meeting="gather")
    assert plan.messages == () or len(plan.processes) > 1
    owned = sorted(j for process in plan.processes for j in process.owns)
    assert owned == list(range(joints))
    for process in plan.processes:
        assert not set(process.owns) & set(process.shares)
        swept = {s.joint for s in process.steps if isinstance(s, Articulate)}
        own = {j for j in (*process.owns, *process.shares) if not _base(plan, j)}
        assert swept == own
        assert set(own) <= set(process.reads)
        assert [s.joint for s in process.steps if isinstance(s, Kinematics)] == list(process.reads)


def _base(plan: Plan, j: int) -> bool:
    return plan.joints[j].parent == 0 and plan.joints[j].kind == "floating"


def test_two_halves_of_a_floating_chain_meet_in_one_exchange() -> None:
    model = serial_chain(20, floating=True)
    plan = gathered(model, 2)
    for process in plan.processes:
        kinds = [type(step) for step in process.steps]
        assert kinds.count(Send) == kinds.count(Receive) == kinds.count(SolveRoot) == 1
        assert not {Join, Propagate} & set(kinds)
    assert [len(message.inertias) for message in plan.messages] == [1, 1]
    assert not any(process.shares for process in plan.processes)


@pytest.mark.parametrize("ratio", [1e-6, 1e-9, 1e-12])
def test_light_links_at_the_meeting_cost_no_digits(ratio: float) -> None:
    """Nothing is inverted there but what all processes have added up."""
    model = with_light_link(serial_chain(12), 6, ratio)
    assert error(model, gathered(model, 2)) < 1e-9


def test_limbs_of_a_figure_are_shared_out_evenly() -> None:
    """Two arms and two legs on a spine: each process takes one of each, and both the spine."""
    rng = np.random.default_rng(5)
    model = random_tree(rng, 40, branching=0.7, floating=True)
    few = 500  # it finds the same as twenty times as many
    plan = make_plan(model, best_schedule(model, 2, load_profile("default"), expansions=few))
    work = [len(process.owns) + len(process.shares) for process in plan.processes]
    assert max(work) <= 0.7 * 40
    assert error(model, plan) < 1e-8


@pytest.mark.parametrize("bend", [0.0, 1e-12, 1e-8, 1e-4, 1.0])
def test_a_straight_arm_is_as_right_as_a_bent_one(bend: float) -> None:
    """Where the mobility of the first joints is singular, it is not inverted."""
    model = serial_chain(30, axes="xy")
    plan = gathered(model, 2)
    held = [s.link for p in plan.processes for s in p.steps if isinstance(s, HoldMobility)]
    assert held == [8]
    assert all(process.recovery for process in plan.processes)
    assert bent_arm_error(model, plan, bend) < 1e-8
