"""The code shape `unrolled`: emitted, compiled and run, it is right and fails as the others do."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit.shapes import chosen_shape, offered
from adagen.model import Inertia, Model
from adagen.schedule import load_profile
from adagen.states import random_states, write_states
from tests.emit.unusual import CASES, chain_with_thin_link, require_solved
from tests.emitted import ROUNDING, Builder, Solver, plan_of, text_of
from tests.links import with_light_link
from tests.mechanisms import four_bar, quadruped
from tests.models import human_figure, random_tree, serial_chain
from tests.scene.effects import with_effects, with_wrenches


def built(builder: Builder, model: Model, processes: int, name: str, form: str) -> Solver:
    plan = plan_of(model, processes, form=form)
    return builder.solver(plan, name=name, shape="unrolled")


QUICK_CASES = ("float",)


def slow_unless(quick: bool, *values: object) -> object:
    return pytest.param(*values, marks=() if quick else pytest.mark.slow)


@pytest.mark.parametrize("name", [slow_unless(name in QUICK_CASES, name) for name in CASES])
def test_an_unusual_robot_is_solved(name: str, builder: Builder, tmp_path: Path) -> None:
    require_solved(name, builder, tmp_path, "unrolled")


@pytest.mark.parametrize(
    ("processes", "form"),
    [
        slow_unless((p, form) == (2, "segment"), p, form)
        for p in (1, 2, 3)
        for form in ("segment", "ada")
    ],
)
def test_a_floating_tree_of_all_kinds_is_solved(
    processes: int, form: str, builder: Builder, tmp_path: Path
) -> None:
    model = random_tree(np.random.default_rng(3), 8, floating=True, mimics=1)
    solver = built(builder, model, processes, "floating tree", form)
    states = random_states(model, 3, seed=2)
    assert solver.error(model, states, tmp_path) < ROUNDING["double"]


@pytest.mark.parametrize(
    ("processes", "form"),
    [
        slow_unless((p, form) == (2, "ada"), p, form)
        for p in (1, 2, 3)
        for form in ("segment", "ada")
    ],
)
def test_outer_forces_and_prescribed_motions_are_taken(
    processes: int, form: str, builder: Builder, tmp_path: Path
) -> None:
    """Of four kinds, the base among them, beside a slaved joint."""
    rng = np.random.default_rng(35)
    model = random_tree(rng, 8, floating=True, mimics=1)
    model = with_wrenches(with_effects(model, rng, "p"), rng, 3)
    assert len({joint.kind for joint in model.joints if joint.prescribed}) == 4
    solver = built(builder, model, processes, "pushed tree", form)
    states = random_states(model, 3, seed=2)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


def test_a_pushed_arm_is_unrolled() -> None:
    model = with_wrenches(serial_chain(6), np.random.default_rng(1))
    assert chosen_shape(plan_of(model, 1)) == "unrolled"


@pytest.mark.parametrize("chunk", [40, slow_unless(False, 300)])
def test_functions_of_any_length_give_the_same(
    chunk: int, builder: Builder, tmp_path: Path
) -> None:
    model = random_tree(np.random.default_rng(5), 4)
    plan = plan_of(model, 2, form="ada")
    text = text_of(plan, shape="unrolled", chunk=chunk)
    assert text.count("ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_") > 1000 // chunk
    assert f"shape unrolled (functions of {chunk} values)" in text
    solver = Solver(builder.compile(text, f"chunks{chunk}"), 2, builder.toolchain)
    states = random_states(model, 3, seed=2)
    assert solver.error(model, states, tmp_path) < ROUNDING["double"]


def test_a_batch_in_which_a_joint_moves_nothing_is_refused_in_all_lanes(
    builder: Builder, tmp_path: Path
) -> None:
    """Its pivot is known to be zero, a number; what it is compared with has lanes."""
    chain = serial_chain(3)
    point = Inertia(1.0, np.zeros(3), np.zeros((3, 3)))
    model = replace(chain, links=(*chain.links[:-1], replace(chain.links[-1], inertia=point)))
    solver = builder.solver(plan_of(model, 1), name="point", batch=1, shape="unrolled")
    write_states(random_states(model, 9), model, tmp_path / "states.json")
    done = solver.run("--states", tmp_path / "states.json")
    assert done.status == 1
    assert done.stderr.count('joint "j002"') == 9


def test_large_angles_keep_their_digits(builder: Builder, tmp_path: Path) -> None:
    model = serial_chain(3)
    solver = built(builder, model, 1, "far", "segment")
    states = random_states(model, 3)
    states.q[0], states.q[1], states.q[2] = 99999.7, 1e9 + 0.25, [3.1e-9, -1.5707963267948966, 0.0]
    assert solver.error(model, states, tmp_path) < ROUNDING["double"]


class TestFailures:
    @pytest.fixture
    def human(self, builder: Builder) -> tuple[Model, Solver]:
        model = human_figure()
        return model, built(builder, model, 2, "human", "segment")

    @staticmethod
    def said(solver: Solver, path: Path) -> str:
        done = solver.run("--states", path, "--result", path.with_suffix(".result"))
        assert (done.status, done.stdout) == (1, "")
        assert not path.with_suffix(".result").exists()
        return done.stderr.removeprefix(f"{path}: error: ")

    @pytest.mark.parametrize("field", ["q", "v", "tau"])
    def test_what_the_scalar_cannot_hold_is_not_finite(
        self, field: str, builder: Builder, tmp_path: Path
    ) -> None:
        model = serial_chain(5)
        plan = plan_of(model, 2, scalar="float", form="ada")
        solver = builder.solver(plan, name="narrow", shape="unrolled")
        for j in (0, 2, 4):
            states = random_states(model, 2)
            getattr(states, field)[1, j] = 1e39
            write_states(states, model, tmp_path / "s.json")
            name = model.joints[j].name
            line = f'state 2: joint "{name}": its q, v or tau is not a finite number'
            assert self.said(solver, tmp_path / "s.json") == line

    def test_an_outer_force_that_the_scalar_cannot_hold_names_its_link_by_the_joint(
        self, builder: Builder, tmp_path: Path
    ) -> None:
        model = with_wrenches(serial_chain(4), np.random.default_rng(1), 1)
        plan = plan_of(model, 1, scalar="float")
        solver = builder.solver(plan, name="pushed", shape="unrolled")
        states = random_states(model, 1)
        states.tau[0, model.nv] = 1e39
        write_states(states, model, tmp_path / "s.json")
        name = model.joints[model.wrenches[0].link - 1].name
        assert f'joint "{name}": ' in self.said(solver, tmp_path / "s.json")

    @pytest.mark.parametrize("size", [0.0, 1e-200, 1e200])
    def test_a_quaternion_that_cannot_be_normalised_names_its_joint(
        self, size: float, human: tuple[Model, Solver], tmp_path: Path
    ) -> None:
        model, solver = human
        write_states(random_states(model, 1), model, tmp_path / "good.json")
        data = json.loads((tmp_path / "good.json").read_text())
        for name in ("left_wrist", "__base__"):
            spoilt = json.loads(json.dumps(data))
            values = spoilt["joints"][name]["q"]
            values[0][-4:] = [size, 0.0, 0.0, 0.0]
            (tmp_path / "s.json").write_text(json.dumps(spoilt))
            expected = f'state 1: joint "{name}": its quaternion cannot be normalised'
            assert self.said(solver, tmp_path / "s.json") == expected

    def test_an_acceleration_that_overflows_names_a_joint(
        self, human: tuple[Model, Solver], tmp_path: Path
    ) -> None:
        model, solver = human
        states = random_states(model, 2)
        states.v[1, :] = 1e200
        write_states(states, model, tmp_path / "s.json")
        line = self.said(solver, tmp_path / "s.json")
        assert line.startswith('state 2: joint "')
        assert "not a finite number" in line or "factorization failed" in line

    @pytest.mark.slow
    def test_a_failed_factorization_names_the_joint(self, builder: Builder, tmp_path: Path) -> None:
        model = chain_with_thin_link()
        plan = plan_of(model, 2, scalar="float", form="ada")
        solver = builder.solver(plan, name="thin u", shape="unrolled")
        write_states(random_states(model, 2), model, tmp_path / "s.json")
        line = self.said(solver, tmp_path / "s.json")
        assert line.startswith('state 1: joint "j00')
        assert "factorization failed" in line


@pytest.mark.parametrize("mechanism", [four_bar, quadruped])
def test_a_batch_has_two_ways_and_a_reproducible_one_has_all(
    mechanism: Callable[[], Model],
) -> None:
    """Groups go one way or the other; of reproducible ones, lanes have answers of several."""
    plan = plan_of(mechanism(), 1)
    assert plan.recovers
    found, all_ways = (
        [each.processes[0].steps for each in some.alternatives] for some in (plan.for_batches, plan)
    )
    assert found == [all_ways[0], all_ways[-1]]
    assert text_of(plan, batch=1).count("Way{k") == 2
    again = replace(plan, reproducible=True)
    assert again.for_batches == again
    text = text_of(again, batch=1)
    assert text.count("constexpr std::array kRecoverParts_") == len(all_ways) - 1
    assert text.count("Way{k") == len(all_ways)


@pytest.mark.parametrize(("profile", "joints"), [("xeon", 128), ("avx2", 256)])
def test_lines_are_longer_where_registers_are_narrower(profile: str, joints: int) -> None:
    costs = load_profile(profile)
    assert offered(plan_of(serial_chain(joints), 1), costs) == ("kernels", "unrolled")
    assert offered(plan_of(serial_chain(joints + 1), 1), costs) == ("kernels",)


@pytest.mark.parametrize("light", [4, 5])
def test_what_is_computed_is_used_where_light_links_turn_about_one_axis(light: int) -> None:
    model = with_light_link(serial_chain(8), light, 1e-5)
    joints = list(model.joints)
    for j in (4, 5):  # what is beyond both has no part in the inertia about their axis
        joints[j] = replace(joints[j], axis=np.array([0.0, 0.0, 1.0]), rotation=np.eye(3))
    joints[5] = replace(joints[5], translation=np.zeros(3))
    text = text_of(plan_of(replace(model, joints=tuple(joints)), 1), shape="unrolled", batch=4)
    uses = Counter(re.findall(r"\bx\d+\b", text))
    assert all(uses[name] > 1 for name in re.findall(r"const \w+ (x\d+) =", text))
