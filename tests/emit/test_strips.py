"""Shape kernels: long runs passed outwards in strips, one in each lane of a register."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from adagen.calibrate.samples import by_method
from adagen.cost import programmed
from adagen.executor.grouping import spared
from adagen.model import KINDS, Model
from adagen.plan.simd_groups import simd_groups
from adagen.program.runs import Run
from adagen.program.strips import LANES, slots_of, split
from adagen.schedule import load_profile
from adagen.states import random_states
from tests.emitted import NARROW, OPTIMISED, QUICK, ROUNDING, Builder, kernels_of, plan_of, text_of
from tests.models import random_tree, serial_chain
from tests.slow import slow, spread

TURNING = [KINDS["revolute"], KINDS["spherical"]]


def balls_and_hinges(joints: int, seed: int = 3) -> Model:
    return random_tree(np.random.default_rng(seed), joints, branching=0.0, kinds=TURNING)


@given(st.integers(1, 200), st.sampled_from(sorted(LANES.values())))
def test_strips_take_turns_in_rows(joints: int, lanes: int) -> None:
    slots = slots_of(Run(7, 6 + joints), lanes)
    lane_of = [[j for j, slot in enumerate(slots) if slot % lanes == lane] for lane in range(lanes)]
    assert [j for own in lane_of for j in own] == list(range(joints))
    for own in lane_of:
        assert [slots[j] // lanes for j in own] == list(range(len(own)))
    lengths = [len(own) for own in lane_of]
    assert lengths == sorted(lengths, reverse=True)
    assert max(lengths) - min(lengths) <= 1


@given(
    st.integers(0, 40),
    st.integers(0, 40),
    st.lists(st.tuples(st.integers(0, 40), st.integers(0, 12)), max_size=4),
)
def test_a_run_is_split_without_losing_a_joint(
    first: int, more: int, drawn: list[tuple[int, int]]
) -> None:
    strips: list[Run] = []
    for start, length in sorted(drawn):
        if not strips or start > strips[-1].last:
            strips.append(Run(start, start + length))
    parts = split(Run(first, first + more), strips)
    joints = [j for run, _ in parts for j in range(run.first, run.last + 1)]
    assert joints == list(range(first, first + more + 1))
    inside = [run for run in strips if run.first >= first and run.last <= first + more]
    assert [run for run, in_strips in parts if in_strips] == inside


def test_only_long_runs_of_turning_joints_are_passed_in_strips() -> None:
    assert "outward_in_strips<0, 15>(w);" in kernels_of(plan_of(serial_chain(16), 1))
    assert "_in_strips" not in kernels_of(plan_of(serial_chain(15), 1))
    floats = plan_of(serial_chain(16), 1, scalar="float")
    assert "_in_strips" not in kernels_of(floats)  # of 16 lanes
    sliding = random_tree(np.random.default_rng(1), 24, branching=0.0, kinds=[KINDS["prismatic"]])
    assert "_in_strips" not in kernels_of(plan_of(sliding, 1))


def test_states_of_a_batch_keep_their_lanes() -> None:
    assert "_in_strips" not in kernels_of(plan_of(serial_chain(24), 1), batch=1)


def test_processes_agree_on_the_runs_in_strips() -> None:
    plan = plan_of(serial_chain(70), 3)
    slots = programmed(plan, "kernels").slots
    assert len(slots.in_strips) == 3
    assert sorted(slots.slots) == sorted(set(slots.slots))
    text = kernels_of(plan)
    for run in slots.in_strips:
        assert f"  outward_in_strips<{run.first}, {run.last}>(w);" in text
    ways = [run for run in slots.in_strips if run.last < 69]
    for run in ways:  # others pass them on their way to the ground
        assert f"  pass_outward_in_strips<{run.first}, {run.last}>(w);" in text


@pytest.mark.parametrize(
    ("flags", "scalar"),
    spread(
        [
            (QUICK, "double"),
            (QUICK, "float"),
            (OPTIMISED, "float"),  # double in test_columns.py
            (NARROW, "double"),
            (NARROW, "float"),
        ],
        2,
    ),
)
def test_chains_that_leave_lanes_empty_are_solved(
    flags: tuple[str, ...], scalar: str, builder: Builder, tmp_path: Path
) -> None:
    model = balls_and_hinges(35)
    plan = plan_of(model, 1, scalar=scalar)
    assert "outward_in_strips<0, 34>(w);" in kernels_of(plan)
    states = random_states(model, 4, seed=5)
    solver = builder.solver(plan, flags, name="strips", shape="kernels")
    assert solver.error(model, states, tmp_path) < ROUNDING[scalar]


@pytest.mark.parametrize("joints", [16, 17, 31])
def test_hinges_in_order_are_solved(joints: int, builder: Builder, tmp_path: Path) -> None:
    model = serial_chain(joints)
    states = random_states(model, 4, seed=joints)
    solver = builder.solver(plan_of(model, 1), name="strips", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < 5 * ROUNDING["double"]


@pytest.mark.parametrize(
    ("processes", "meeting"),
    [slow(3, "join"), slow(2, "gather"), (2, "join")],
)
def test_strips_on_the_way_to_others_are_solved(
    processes: int, meeting: str, builder: Builder, tmp_path: Path
) -> None:
    model = balls_and_hinges(56, seed=6)
    plan = plan_of(model, processes, meeting=meeting)
    assert "pass_outward_in_strips<" in kernels_of(plan)
    states = random_states(model, 4, seed=processes)
    solver = builder.solver(plan, name="strips", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


def test_few_rows_of_known_constants_are_solved(builder: Builder, tmp_path: Path) -> None:
    """Of runs of 17 joints g++ 12 knows all origins, and would add some of them up wrongly."""
    model = serial_chain(70)
    plan = plan_of(model, 4)
    assert "pass_outward_in_strips<17, 33>" in kernels_of(plan)
    states = random_states(model, 4, seed=1)
    solver = builder.solver(plan, name="strips", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < 5 * ROUNDING["double"]


@pytest.mark.parametrize(("seed", "processes"), [(9, 1), slow(8, 2)])
def test_strips_beside_limbs_are_solved(
    seed: int, processes: int, builder: Builder, tmp_path: Path
) -> None:
    """Both are asked for, whatever they cost."""
    model = random_tree(np.random.default_rng(seed), 60, branching=0.04, kinds=TURNING)
    plan = plan_of(model, processes)
    asked: dict[str, Any] = {
        "shape": "kernels",
        "profile": by_method(load_profile("default"), "columns"),
        "limbs": tuple(tuple(simd_groups(plan, p, spared)) for p in plan.processes),
    }
    text = text_of(plan, "strips", **asked)
    assert "  outward_in_strips<" in text
    assert " kLimbs0{" in text
    states = random_states(model, 3, seed=seed)
    solver = builder.solver(plan, name="strips", **asked)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]
