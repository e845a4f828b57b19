"""Limbs side by side: which joints are passed together, and in which order that can be done."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.executor.grouping import spared
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.order import Unit, ends_of, inward_order, outward_order
from adagen.plan.simd_groups import KINDS, Limbs, simd_groups
from adagen.plan.steps import Accelerate, Articulate, Deliver, Kinematics, Propagate
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule, named_schedule
from adagen.urdf import read_robot
from tests.golden.examples import FOLDER
from tests.models import binary, random_tree, serial_chain, star
from tests.schedules import random_schedule


def alone(model: Model) -> Plan:
    return make_plan(model, find_schedule(Topology.of(model), 1, profile=load_profile("paper")))


def limbs_of(model: Model) -> list[Limbs]:
    plan = alone(model)
    return simd_groups(plan, plan.processes[0], spared)


def joints_of(units: Sequence[Unit]) -> list[int]:
    return [j for u in units for j in (u.members() if isinstance(u, Limbs) else [u])]


def test_four_equal_limbs_are_one_row_after_another() -> None:
    rows = ((1, 4, 7, 10), (2, 5, 8, 11), (3, 6, 9, 12))
    assert limbs_of(star(4, 3, floating=True)) == [Limbs(rows)]


def test_two_limbs_share_two_lanes() -> None:
    [limbs] = limbs_of(star(2, 6, floating=True))
    assert limbs.count == 2
    assert len(limbs.rows) == 6


def test_three_limbs_leave_a_lane_idle() -> None:
    [limbs] = limbs_of(star(3, 2, floating=True))
    assert limbs.rows == ((1, 3, 5), (2, 4, 6))
    assert (limbs.count, limbs.lanes, limbs.idle) == (3, 4, 1)


def test_no_more_limbs_go_together_than_may() -> None:
    plan = alone(star(4, 3, floating=True))
    for most in (2, 3):
        found = simd_groups(plan, plan.processes[0], spared, range(2, most + 1))
        assert max(limbs.count for limbs in found) == most


def test_limbs_that_save_nothing_are_left_alone() -> None:
    plan = alone(star(4, 3, floating=True))
    assert simd_groups(plan, plan.processes[0], lambda _kinds, _count: 0.0) == []


def test_what_a_handles_mobility_goes_through_is_passed_singly() -> None:
    """The waist of the shipped humanoid, pelvis held, beside an ankle that is like it."""
    model = read_robot(FOLDER / "models" / "humanoid.urdf").model
    schedule = named_schedule("balanced", Topology.of(model), 4, profile=load_profile("default"))
    plan = make_plan(model, schedule)
    [process] = [p for p in plan.processes if any(isinstance(s, Propagate) for s in p.steps)]
    through = {s.joint for s in process.steps if isinstance(s, Propagate)}
    assert {model.joints[j].name for j in through} == {"waist_yaw", "waist_roll"}
    assert not through & {j for each in simd_groups(plan, process, spared) for j in each.members()}


def test_a_chain_has_nothing_beside_it() -> None:
    assert limbs_of(serial_chain(30)) == []


def test_levels_of_a_binary_tree_are_passed_together() -> None:
    model = binary(5)
    beside = {j for limbs in limbs_of(model) for j in limbs.members()}
    assert len(beside) > len(model.joints) / 2


@settings(max_examples=80)
@given(
    st.integers(2, 30),
    st.integers(1, 3),
    st.booleans(),
    st.sampled_from(["join", "gather"]),
    st.floats(0.0, 1.0),
    st.integers(0, 2**32 - 1),
)
def test_limbs_of_any_plan_can_be_passed_in_order(
    joints: int, processes: int, floating: bool, meeting: str, branching: float, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, branching=branching, floating=floating)
    plan = make_plan(model, random_schedule(model, processes, rng), meeting=meeting)
    for process in plan.processes:
        limbs = simd_groups(plan, process, spared)
        members = [j for each in limbs for j in each.members()]
        assert len(set(members)) == len(members)
        assert set(members) <= set(process.owns)
        handles = {s.joint for s in process.steps if isinstance(s, Propagate | Deliver)}
        assert not handles & set(members)
        for each in limbs:
            for row in each.rows:
                [kind] = {plan.joints[j].kind for j in row}
                assert kind in KINDS
            for row, next_ in zip(each.rows, each.rows[1:], strict=False):
                assert all(plan.joints[j].parent == i + 1 for i, j in zip(row, next_, strict=True))
            for lane, first in enumerate(each.rows[0]):
                own = {row[lane] for row in each.rows}
                assert not plan.paths([first]) & (set(each.members()) - own)
        sweep = {
            s.joint: ends_of(plan.joints, s.joint)
            for s in process.steps
            if isinstance(s, Kinematics)
        }
        order = joints_of(outward_order(sweep, limbs))
        assert sorted(order) == sorted(sweep)
        place = {j: k for k, j in enumerate(order)}
        for j in sweep:
            assert place.get(plan.joints[j].parent - 1, -1) < place[j]


@settings(max_examples=60)
@given(st.integers(2, 30), st.booleans(), st.floats(0.0, 1.0), st.integers(0, 2**32 - 1))
def test_sweeps_of_one_process_pass_each_link_when_it_is_whole(
    joints: int, floating: bool, branching: float, seed: int
) -> None:
    model = random_tree(np.random.default_rng(seed), joints, branching=branching, floating=floating)
    plan = alone(model)
    [process] = plan.processes
    limbs = simd_groups(plan, process, spared)
    inward = [s for s in process.steps if isinstance(s, Articulate)]
    sweep = {s.joint: ends_of(plan.joints, s.joint, s.reversed) for s in inward}
    seen: set[int] = set()
    for unit in inward_order(sweep, limbs):
        own = set(unit.members()) if isinstance(unit, Limbs) else {unit}
        for j in own:
            beyond = {i for i, ends in sweep.items() if ends.near == sweep[j].far}
            assert beyond <= seen | own
        seen |= own
    assert seen == set(sweep)
    outward = [s for s in process.steps if isinstance(s, Accelerate)]
    back = {s.joint: ends_of(plan.joints, s.joint, s.reversed) for s in outward}
    assert sorted(joints_of(outward_order(back, limbs))) == sorted(back)
