"""Shape kernels with outer forces, joints of prescribed motion and rotors at cuts."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.cost import programmed
from adagen.emit.shapes import SHAPES, predict
from adagen.executor import interpret
from adagen.model import Model, Passive
from adagen.model.kinds import REVOLUTE, SPHERICAL
from adagen.plan import Plan, make_plan
from adagen.plan.simd_groups import placed_links
from adagen.plan.steps import (
    Articulate,
    Disassemble,
    HoldMobility,
    Join,
    Propagate,
    SolveMobility,
)
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import random_states, write_states
from tests.emitted import ROUNDING, Builder, Solver, forward_error, kernels_of, plan_of, truth_of
from tests.models import human_figure, random_tree, serial_chain
from tests.scene.effects import with_effects, with_wrenches
from tests.scene.held import held, rows
from tests.schedules import random_schedule
from tests.slow import slow

PROFILE = load_profile("default")
NUMBER = {"double": np.float64, "float": np.float32}


def figure(*names: str) -> Model:
    """The human figure, pushed at three links, with the motion of some joints prescribed."""
    model = with_wrenches(human_figure(), np.random.default_rng(3), 3)
    return held(model, [j for j, joint in enumerate(model.joints) if joint.name in names])


def require_right(
    plan: Plan, model: Model, builder: Builder, folder: Path, magnified: float = 1.0
) -> Solver:
    """Build the plan, run it with its own check, compare with the truth and with what was given."""
    states = random_states(model, 3, seed=3)
    solver = builder.solver(plan, name="effects", shape="kernels")
    found = solver.solve(model, states, folder, "--check")
    given = rows(model, [j for j, joint in enumerate(model.joints) if joint.prescribed])
    number = NUMBER[plan.scalar]
    assert np.array_equal(found[:, given].astype(number), states.tau[:, given].astype(number))
    assert forward_error(found, truth_of(model, states)) < magnified * ROUNDING[plan.scalar]
    return solver


def test_limbs_with_joints_of_prescribed_motion_are_taken_side_by_side(
    builder: Builder, tmp_path: Path
) -> None:
    """All but spherical ones, beside joints that move freely."""
    model = figure("left_knee", "right_elbow", "neck")
    plan = make_plan(model, best_schedule(model, 1, PROFILE))
    assert SHAPES["kernels"].why_not(plan) is None
    grouped = {j for limbs in programmed(plan, "kernels").slots.limbs[0] for j in limbs.members()}
    given = {plan.joints[j].name for j in grouped if plan.joints[j].prescribed}
    assert given == {"left_knee", "right_elbow"}
    require_right(plan, model, builder, tmp_path)


@pytest.mark.parametrize(
    ("processes", "meeting", "scalar"),
    [
        pytest.param(2, "join", "double", marks=pytest.mark.slow),
        pytest.param(3, "join", "double", marks=pytest.mark.slow),
        pytest.param(2, "gather", "double", marks=pytest.mark.slow),
        (4, "gather", "float"),
    ],
)
def test_processes_share_such_robots(
    processes: int, meeting: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    model = figure("left_knee", "waist", "__base__" if processes == 2 else "right_hip")
    plan = plan_of(model, processes, meeting=meeting, scalar=scalar)
    assert SHAPES["kernels"].why_not(plan) is None
    assert predict(plan, PROFILE).makespan > 0
    solver = require_right(plan, model, builder, tmp_path)
    if scalar == "float":
        states, given = random_states(model, 1, seed=1), tmp_path / "infinite.json"
        states.tau[0, model.nv] = 1e300
        write_states(states, model, given)
        done = solver.run("--states", given)
        name = model.joints[model.wrenches[0].link - 1].name
        assert (done.status, f'joint "{name}"' in done.stderr) == (1, True)


def test_what_is_joined_may_be_prescribed_or_have_a_rotor(builder: Builder, tmp_path: Path) -> None:
    """And so may the joints that mobility passes on its way from a cut."""
    model = with_wrenches(serial_chain(14, axes="xyz"), np.random.default_rng(2))
    plan = plan_of(model, 3, meeting="join")
    steps = [step for process in plan.processes for step in process.steps]
    first, *others = [step.joint for step in steps if isinstance(step, Disassemble)]
    passed = [step.joint for step in steps if isinstance(step, Propagate)]
    model = held(model, [first, passed[0], passed[-1]])
    joints = list(model.joints)
    for j in others:
        joints[j] = replace(joints[j], passive=Passive(rotor_inertia=0.3, damping=0.1))
    model = replace(model, joints=tuple(joints))
    assert others
    plan = plan_of(model, 3, meeting="join")
    assert SHAPES["kernels"].why_not(plan) is None
    require_right(plan, model, builder, tmp_path)


def grounded() -> tuple[Model, Plan]:
    chain = with_wrenches(serial_chain(28, axes="xyz"), np.random.default_rng(4))
    model = held(chain, [1, 4])
    return model, plan_of(model, 2, meeting="gather")


def test_the_ground_is_held_by_joints_that_move_freely() -> None:
    """Joints of prescribed motion give way to nothing: a mobility needs others to be regular."""
    model, plan = grounded()
    steps = [step for process in plan.processes for step in process.steps]
    assert [step.link for step in steps if isinstance(step, HoldMobility)] == [10]
    states = random_states(model, 2, seed=1)
    found = np.array([interpret(plan, *row) for row in states.each])
    assert forward_error(found, truth_of(model, states)) < ROUNDING["double"]


@pytest.mark.slow
def test_the_ground_is_held_in_emitted_code_too(builder: Builder, tmp_path: Path) -> None:
    model, plan = grounded()
    # Pivots of the mobility that is inverted may be 1e-5 of the largest, and lose as many digits.
    require_right(plan, model, builder, tmp_path, magnified=200)


@pytest.mark.slow
@pytest.mark.parametrize(("processes", "meeting"), [(1, "join"), (2, "join"), (3, "gather")])
def test_trees_of_all_kinds_are_solved(
    processes: int, meeting: str, builder: Builder, tmp_path: Path
) -> None:
    rng = np.random.default_rng(1)
    model = random_tree(rng, 10, branching=0.5, floating=True)
    model = with_wrenches(with_effects(model, rng, "p"), rng, 3)
    plan = make_plan(model, random_schedule(model, processes, rng), meeting=meeting)
    require_right(plan, model, builder, tmp_path)


def alone() -> tuple[Model, Plan]:
    """A process alone, and the ground beyond the root."""
    rng = np.random.default_rng(25)
    model = random_tree(rng, 10, branching=0.3)
    return model, make_plan(model, random_schedule(model, 3, rng), meeting="gather")


def test_a_root_that_is_swept_to_twice_is_put_down_before() -> None:
    """Else what the sweep finds there includes what an earlier evaluation left."""
    _, plan = alone()
    solved = [s.link for p in plan.processes for s in p.steps if isinstance(s, SolveMobility)]
    assert len(solved) == 1
    assert not plan.messages
    assert placed_links(plan) == set(solved)


@pytest.mark.slow
def test_earlier_evaluations_leave_nothing_at_such_a_root(builder: Builder, tmp_path: Path) -> None:
    model, plan = alone()
    require_right(plan, model, builder, tmp_path)


@pytest.mark.slow
def test_batches_have_outer_forces_and_prescribed_motions(builder: Builder, tmp_path: Path) -> None:
    model = figure("left_knee", "waist", "__base__")
    plan = make_plan(model, best_schedule(model, 1, PROFILE))
    solver = builder.solver(plan, name="effects", batch=2, shape="kernels")
    states = random_states(model, 21, seed=6)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


def test_robots_without_such_inputs_have_none_of_it_in_their_code() -> None:
    for meeting in ("join", "gather"):
        text = kernels_of(plan_of(human_figure(), 2, meeting=meeting))
        for word in ("prescribed_motion", "void push(Workspace", "struct Held"):
            assert word not in text


def test_outer_forces_act_once_each_and_at_their_links_alone() -> None:
    model = figure()
    calls = [
        line.strip()
        for line in kernels_of(plan_of(model, 2, meeting="gather")).splitlines()
        if line.startswith("  push<")
    ]
    wanted = [f'push<{k}>(w);  // on link "{w.frame.name}"' for k, w in enumerate(model.wrenches)]
    assert sorted(calls) == wanted


def driven(model: Model) -> Model:
    """The robot with rotors on two joints of three, and damping on every second one."""
    joints = [
        replace(joint, passive=Passive(damping=0.4 * (j % 2), rotor_inertia=0.1 * (j % 3)))
        if joint.kind in (SPHERICAL, REVOLUTE)
        else joint
        for j, joint in enumerate(model.joints)
    ]
    return replace(model, joints=tuple(joints))


def geared_balls(plan: Plan) -> set[int]:
    return {j for j, x in enumerate(plan.joints) if x.rotor_inertia and x.kind == "spherical"}


def test_spherical_joints_have_damping_and_rotors(builder: Builder, tmp_path: Path) -> None:
    """Limbs side by side among them."""
    model = driven(human_figure())
    plan = make_plan(model, best_schedule(model, 1, PROFILE))
    grouped = {j for limbs in programmed(plan, "kernels").slots.limbs[0] for j in limbs.members()}
    assert geared_balls(plan) & grouped
    assert SHAPES["kernels"].why_not(plan) is None
    require_right(plan, model, builder, tmp_path)


@pytest.mark.parametrize(
    ("processes", "meeting", "floating"),
    [
        (1, "join", False),
        slow(3, "join", False),
        slow(2, "join", True),
        (2, "gather", True),
    ],
)
def test_processes_share_spherical_joints_with_rotors(
    processes: int, meeting: str, floating: bool, builder: Builder, tmp_path: Path
) -> None:
    """In runs that are taken by columns, at cuts, on the way from cuts to roots, turned round."""
    kinds = (SPHERICAL, SPHERICAL if floating else REVOLUTE)
    rng = np.random.default_rng(5)
    model = driven(random_tree(rng, 15, kinds, branching=0, floating=floating))
    plan = plan_of(model, processes, meeting=meeting)
    steps = [step for process in plan.processes for step in process.steps]
    balls = geared_balls(plan)
    if processes == 3:
        assert balls & {step.joint for step in steps if isinstance(step, Join)}
        assert balls & {step.joint for step in steps if isinstance(step, Propagate)}
    if floating:
        assert balls & {s.joint for s in steps if isinstance(s, Articulate) and s.reversed}
    assert SHAPES["kernels"].why_not(plan) is None
    require_right(plan, model, builder, tmp_path)
