"""Limbs side by side, columns and strips: what takes least by the profile is what runs."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.calibrate.robots import robot
from adagen.calibrate.samples import by_method
from adagen.cost import operation_features, programmed, timeline
from adagen.cost.features import added
from adagen.cost.lane_choice import _loops, chosen_limbs, offered_limbs
from adagen.executor import chosen_grouping, groupings
from adagen.executor.grouping import spared
from adagen.model import Model
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.plan.simd_groups import simd_groups
from adagen.plan.tip_mobility import mentions
from adagen.program import Program, lower
from adagen.schedule import CostProfile, Topology, load_profile, step_costs
from adagen.search import find_schedule
from tests.cost.costs import step_profile
from tests.models import human_figure, random_tree, serial_chain, star
from tests.scene.effects import with_effects
from tests.schedules import random_schedule

DEFAULT = load_profile("default")


def plan_of(model: Model, processes: int = 1) -> Plan:
    schedule = find_schedule(Topology.of(model), processes, profile=load_profile("paper"))
    return make_plan(model, schedule)


def methods(program: Program) -> set[str]:
    return {o.method for process in program.processes for o in process.operations}


def cheap(**changes: float) -> CostProfile:
    """A profile in which limbs side by side and other methods cost next to nothing, or a lot."""
    return step_profile((), **changes)


@settings(max_examples=30)
@given(st.integers(2, 24), st.floats(0.0, 1.0), st.integers(0, 2**32 - 1))
def test_no_grouping_that_is_offered_takes_less(joints: int, branching: float, seed: int) -> None:
    model = random_tree(np.random.default_rng(seed), joints, branching=branching)
    plan = plan_of(model)
    for profile in (DEFAULT, step_profile()):
        costs = step_costs(profile)
        best = timeline(programmed(plan, "kernels", profile), profile).makespan
        for limbs in offered_limbs(plan, plan.processes[0], costs):
            other = lower(plan, "kernels", limbs=(limbs,), costs=costs)
            assert best <= timeline(other, profile).makespan * (1 + 1e-12)


@settings(max_examples=40)
@given(
    st.integers(2, 24),
    st.integers(1, 3),
    st.floats(0.0, 1.0),
    st.sampled_from(["join", "gather"]),
    st.integers(0, 2**32 - 1),
)
def test_the_grouping_of_least_time_is_chosen(
    joints: int, processes: int, branching: float, meeting: str, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, branching=branching, floating=bool(rng.integers(2)))
    model = with_effects(model, rng, str(rng.choice(["", "drp"])))
    plan = make_plan(model, random_schedule(model, processes, rng), meeting=meeting)
    for costs in (step_costs(DEFAULT), step_costs(step_profile())):
        for process in plan.processes:
            offers = offered_limbs(plan, process, costs)
            alone, named = replace(plan, processes=(process,)), mentions(plan, process)
            times = [_loops(alone, limbs, costs, named).time for limbs in offers]
            assert times[offers.index(chosen_limbs(plan, process, costs))] == min(times)


def test_straight_lines_are_grouped_by_their_price() -> None:
    plan = plan_of(star(5, 3, floating=True))
    offers = groupings(plan)
    assert len(offers) > 2
    for profile in (DEFAULT, step_profile()):
        costs = step_costs(profile)
        times = {
            offer: timeline(lower(plan, "unrolled", limbs=offer, costs=costs), profile).makespan
            for offer in offers
        }
        assert times[chosen_grouping(plan, costs)] == pytest.approx(min(times.values()))


def test_lanes_that_cost_too_much_are_not_used() -> None:
    plan = plan_of(star(4, 3, floating=True))
    assert "lanes" in methods(programmed(plan, "kernels", DEFAULT))
    dear = cheap(limbs__two=10.0, limbs__four=10.0)
    assert "lanes" not in methods(programmed(plan, "kernels", dear))
    pairs = cheap(
        limbs__two=0.0,
        limbs__four=10.0,
        **{f"{group}_two__revolute": 0.0 for group in ("kinematics", "articulate", "accelerate")},
    )
    found = programmed(plan, "kernels", pairs)
    assert {limbs.lanes for limbs in found.slots.limbs[0]} == {2}


@pytest.mark.parametrize("method", ["columns", "strips"])
def test_methods_follow_their_prices(method: str) -> None:
    """A run is passed as it takes least, however long it is."""
    group = {"columns": "articulate_columns", "strips": "kinematics_strips"}[method]
    plan = plan_of(serial_chain(20))
    free = cheap(**{f"{group}__revolute": 0.0, f"{group}__run": 0.0})
    dear = cheap(**{f"{group}__run": 10.0})
    assert method in methods(programmed(plan, "kernels", free))
    assert method not in methods(programmed(plan, "kernels", dear))


@pytest.mark.parametrize("shape", ["kernels", "unrolled"])
def test_a_plan_read_back_makes_the_same_program(shape: str) -> None:
    plan = plan_of(human_figure(), 2)
    again = plan_from_json(plan_to_json(plan))
    for profile in (None, step_profile()):
        one, other = (programmed(each, shape, profile) for each in (plan, again))
        assert (one.slots, one.processes) == (other.slots, other.processes)


def test_batches_leave_lanes_to_states() -> None:
    program = programmed(plan_of(star(4, 3, floating=True)), "kernels", DEFAULT, batch=True)
    assert not any(program.slots.limbs) and not {"lanes", "columns"} & methods(program)


@pytest.mark.parametrize("method", ["each", "columns"])
@pytest.mark.parametrize("count", [0, 2, 4])
def test_what_hangs_on_the_ground_hands_nothing_on(method: str, count: int) -> None:
    """Four joints, then chains of two: the first of each is swept onto the ground, in any way."""
    profile = by_method(DEFAULT, method)
    for joints in (1, 2):
        parents = [below for k in range(4) for below in (0, k * joints + 1)[:joints]]
        model = robot("bases", parents, ["revolute"])
        plan = plan_of(model)
        counts = (count,) if count else ()
        limbs = (tuple(simd_groups(plan, plan.processes[0], spared, counts)),) if count else ((),)
        program = lower(plan, "kernels", limbs=limbs, costs=step_costs(profile))
        found = added(
            operation_features(operation, plan.joints)
            for operation in program.processes[0].operations
        )
        rows = 4 // (count or 1)
        assert found["articulate.ground"] == rows
        swept = sum(n for name, n in found.items() if re.match(r"articulate\w*\.revolute", name))
        assert swept == rows * (joints - 1)
        once = sum(n for name, n in found.items() if name.endswith(".run") or "limbs." in name)
        assert (once > 0) == (joints > 1)
