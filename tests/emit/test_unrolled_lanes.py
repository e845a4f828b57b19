"""Limbs that share a straight line, one in each lane: as right as single ones, and less work."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from adagen.executor import Grouping, interpret, simulate, straight_line
from adagen.executor.grouping import groupings_of
from adagen.executor.lane_frames import aligned, unlike
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL, Model
from adagen.plan import Plan, make_plan
from adagen.plan.simd_groups import Limbs
from adagen.states import random_states, write_states
from tests.emit.limbs import alike
from tests.emitted import QUICK, ROUNDING, Builder, Solver, plan_of, text_of
from tests.models import human_figure, serial_chain, star
from tests.scene.effects import with_effects, with_wrenches
from tests.schedules import random_schedule

KINDS = st.lists(st.sampled_from([REVOLUTE, PRISMATIC, SPHERICAL]), min_size=1, max_size=3)
CLANG = pytest.param(
    "clang++", marks=pytest.mark.skipif(shutil.which("clang++") is None, reason="no clang++")
)


def assert_lanes_agree(model: Model, plan: Plan, grouping: Grouping, seed: int) -> None:
    """The answer with limbs in lanes is the one without."""
    state = next(iter(random_states(model, 1, seed=seed % 1000).each))
    expected = interpret(plan, *state)
    found = interpret(plan, *state, lanes=grouping)
    size = max(1.0, float(np.abs(expected).max()))
    np.testing.assert_allclose(found / size, expected / size, atol=1e-12)


@settings(max_examples=25)
@given(
    st.integers(2, 5),
    KINDS,
    st.integers(1, 3),
    st.booleans(),
    st.booleans(),
    st.integers(0, 2),
    st.booleans(),
    st.integers(0, 2**32 - 1),
)
def test_limbs_in_lanes_move_as_single_ones(
    count: int,
    kinds: list,  # type: ignore[type-arg]
    trunk: int,
    floating: bool,
    oblique: bool,
    beside: int,
    pushed: bool,
    seed: int,
) -> None:
    """Whatever their axes, offsets, masses and near links are, and with joints hanging on them."""
    rng = np.random.default_rng(seed)
    robot = alike(rng, count, kinds, trunk=trunk, floating=floating, oblique=oblique, beside=beside)
    model = with_wrenches(robot.model, rng, 2) if pushed else robot.model
    plan = plan_of(model, 1)
    assert_lanes_agree(model, plan, ((robot.limbs(plan),),), seed)


@settings(max_examples=12)
@given(st.integers(2, 4), st.integers(1, 3), st.integers(0, 2**32 - 1))
def test_each_process_has_limbs_of_its_own(count: int, processes: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    model = alike(rng, 2 * count, [REVOLUTE] * 2, floating=False).model
    plan = make_plan(model, random_schedule(model, processes, rng), form="segment")
    grouping = groupings_of(plan)[0]
    assume(any(grouping))
    assert_lanes_agree(model, plan, grouping, seed)


def test_prescribed_motions_go_together_with_their_like() -> None:
    rng = np.random.default_rng(7)
    model = with_effects(alike(rng, 4, [REVOLUTE] * 2).model, rng, "p")
    plan = plan_of(model, 1)
    for limbs in groupings_of(plan)[0][0]:
        for row in limbs.rows:
            assert len({plan.joints[j].prescribed for j in row}) == 1


class TestStructure:
    def test_four_limbs_cost_little_more_than_one(self) -> None:
        model = alike(np.random.default_rng(2), 4, [REVOLUTE] * 3, trunk=1).model
        plan = plan_of(model, 1)
        (alone,), (together,) = simulate(plan), straight_line(plan)
        assert 2.5 * together.operations.instructions < alone.operations.instructions
        assert together.operations.wide > 0.7 * together.operations.arithmetic

    def test_links_are_turned_until_limbs_agree(self) -> None:
        """Mirrored limbs whose frames were chosen otherwise have the same constants' places."""
        model = alike(np.random.default_rng(3), 4, [REVOLUTE] * 3, oblique=False).model
        plan = plan_of(model, 1)
        limbs = groupings_of(plan)[0][0][0]
        assert unlike(aligned(plan, [limbs]), limbs) <= unlike(plan, limbs)
        state = random_states(model, 1)
        row = state.q[0], state.v[0], state.tau[0]
        turned = interpret(aligned(plan, [limbs]), *row)
        np.testing.assert_allclose(turned, interpret(plan, *row), rtol=1e-9, atol=1e-9)

    def test_what_is_no_work_saved_is_not_done(self) -> None:
        plan = plan_of(serial_chain(5), 1)
        assert not any(groupings_of(plan)[0])
        assert straight_line(plan) is simulate(plan)

    def test_lanes_can_be_turned_off(self) -> None:
        plan = plan_of(star(4, 2), 1)
        assert "const Four " in text_of(plan, shape="unrolled")
        off = text_of(plan, shape="unrolled", limbs=((),))
        assert "const Four " not in off
        assert "const Four " not in text_of(plan, shape="unrolled", batch=2)

    def test_limbs_may_be_chosen(self) -> None:
        plan = plan_of(star(4, 2), 1)
        (whole,) = groupings_of(plan)[0][0]
        pair = Limbs(tuple(row[:2] for row in whole.rows))
        (found,) = simulate(plan, ((pair,),))
        assert found.machine.rows.rows.keys() == {row[0] for row in pair.rows}

    def test_wide_values_lie_aligned(self) -> None:
        text = text_of(plan_of(star(4, 3), 1), shape="unrolled", chunk=40)
        places = re.findall(r"load<Four>\(w\.x\.data\(\) \+ (\d+)\)", text)
        assert len(places) > 20
        assert all(int(place) % 4 == 0 for place in places)


def solved(
    builder: Builder, model: Model, folder: Path, scalar: str = "double", chunk: int = 0
) -> float:
    plan = plan_of(model, 1, scalar=scalar)
    text = text_of(plan, shape="unrolled", chunk=chunk)
    assert any(f"const {kind} " in text for kind in ("Two", "Four", "Eight"))
    solver = Solver(builder.compile(text, f"lanes_{scalar}", QUICK), 1, builder.toolchain)
    return solver.error(model, random_states(model, 3, seed=2), folder)


@pytest.mark.parametrize("compiler", ["", CLANG], ids=["default", "clang++"])
@pytest.mark.parametrize("scalar", ["double", pytest.param("float", marks=pytest.mark.slow)])
def test_legs_and_arms_on_a_floating_trunk_are_solved(
    compiler: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    """Four limbs with a spherical joint, one of them further out, and one of a chunk each."""
    model = alike(np.random.default_rng(11), 4, [REVOLUTE, SPHERICAL, PRISMATIC], beside=1).model
    builder = builder.with_compiler(compiler) if compiler else builder
    error = solved(builder, model, tmp_path, scalar, chunk=150)
    assert error < ROUNDING[scalar]


@pytest.mark.parametrize("count", [2, 3])
def test_idle_lanes_say_nothing(count: int, builder: Builder, tmp_path: Path) -> None:
    model = alike(np.random.default_rng(5), count, [REVOLUTE] * 3, floating=False).model
    assert solved(builder, model, tmp_path) < ROUNDING["double"]


@pytest.mark.slow
@pytest.mark.parametrize("flags", [("-O0",), ("-O3", "-march=x86-64-v2")])
def test_other_flags_do(flags: tuple[str, ...], builder: Builder, tmp_path: Path) -> None:
    model = star(4, 3, floating=True)
    plan = plan_of(model, 1)
    solver = builder.solver(plan, flags, name="flags", shape="unrolled")
    assert solver.error(model, random_states(model, 3), tmp_path) < ROUNDING["double"]


class TestFailures:
    @pytest.fixture
    def human(self, builder: Builder) -> tuple[Model, Solver]:
        model = human_figure()
        text = text_of(plan_of(model, 1), shape="unrolled")
        assert "const Two " in text or "const Four " in text
        return model, Solver(builder.compile(text, "human"), 1, builder.toolchain)

    @staticmethod
    def said(solver: Solver, path: Path) -> str:
        done = solver.run("--states", path, "--result", path.with_suffix(".result"))
        assert (done.status, done.stdout) == (1, "")
        return done.stderr.removeprefix(f"{path}: error: ")

    def test_each_lane_names_its_joint(self, human: tuple[Model, Solver], tmp_path: Path) -> None:
        model, solver = human
        write_states(random_states(model, 1), model, tmp_path / "good.json")
        data = json.loads((tmp_path / "good.json").read_text())
        quaternions = [joint.name for joint in model.joints if joint.kind is SPHERICAL]
        assert len(quaternions) > 4
        for name in quaternions:
            spoilt = json.loads(json.dumps(data))
            spoilt["joints"][name]["q"][0] = [0.0, 0.0, 0.0, 0.0]
            (tmp_path / "s.json").write_text(json.dumps(spoilt))
            expected = f'state 1: joint "{name}": its quaternion cannot be normalised'
            assert self.said(solver, tmp_path / "s.json") == expected

    def test_an_overflow_names_a_joint(self, human: tuple[Model, Solver], tmp_path: Path) -> None:
        model, solver = human
        states = random_states(model, 1)
        states.v[0, :] = 1e200
        write_states(states, model, tmp_path / "s.json")
        assert self.said(solver, tmp_path / "s.json").startswith('state 1: joint "')
