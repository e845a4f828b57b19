"""What a scene asks for beside accelerations, and accelerations that it does not ask for."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pinocchio
import pytest
from numpy.typing import NDArray

import adagen
from adagen.build import find_toolchain
from adagen.cli import main
from adagen.emit import emit, program_of
from adagen.errors import InputError, UsageError
from adagen.executor import interpret, straight_line
from adagen.graph import BALLS
from adagen.library.savings import simplifications
from adagen.model import (
    INVERSE_INERTIA,
    LINK_ACCELERATION,
    REACTION_FORCE,
    Frame,
    Model,
    Output,
    Wrench,
    canonical,
)
from adagen.plan import make_plan, plan_from_json, plan_to_json
from adagen.plan.types import Plan
from adagen.reference import forward_dynamics
from adagen.scene import apply_scene, read_scene
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States, random_states, read_states, write_states
from adagen.urdf import read_robot
from tests.emitted import Builder, Solver, forward_error, text_of
from tests.models import ALL_KINDS, random_tree
from tests.real import real_robot
from tests.scene.texts import reduced
from tests.slow import slow

Array = NDArray[np.float64]
MODELS = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
ASKED = """
[outputs]
link_accelerations = ["left_foot", "torso", "right_hand"]
reaction_forces = ["left_knee", "waist_yaw"]
inverse_inertia = ["left_hand", "right_foot"]
"""


def planned(model: Model, processes: int = 1) -> Plan:
    return make_plan(model, best_schedule(model, processes, load_profile("default")))


def humanoid(folder: Path, text: str, *, floating: bool) -> Model:
    whole = read_robot(MODELS / "humanoid.urdf", floating=floating).model
    return reduced(whole, folder, text).model


def by_pinocchio(model: Model, state: tuple[Array, Array, Array]) -> Array:
    """Return qdd of a humanoid with outputs, shape (nqdd,), by another library."""
    base = [pinocchio.JointModelFreeFlyer()] if model.floating else []
    robot = pinocchio.buildModelFromUrdf(str(MODELS / "humanoid.urdf"), *base)
    data = robot.createData()
    q, v, _ = state
    qdd = pinocchio.aba(robot, data, *state)
    pinocchio.rnea(robot, data, q, v, qdd)
    forces = [np.array(force) for force in data.f]
    inverse = np.triu(pinocchio.computeMinverse(robot, data, q))
    inverse += np.triu(inverse, 1).T
    pinocchio.forwardKinematics(robot, data, q, v, qdd)
    parts = [qdd]
    for output in model.outputs:
        frame = robot.getFrameId(output.name)
        if output.what == LINK_ACCELERATION:
            local = pinocchio.LOCAL
            parts.append(
                np.array(pinocchio.getFrameClassicalAcceleration(robot, data, frame, local))
            )
        elif output.what == REACTION_FORCE:
            parts.append(forces[robot.getJointId(output.name)])
        else:
            jacobian = pinocchio.computeFrameJacobian(robot, data, q, frame, pinocchio.LOCAL)
            parts.append((jacobian @ inverse @ jacobian.T).ravel())
    return np.concatenate(parts)


@pytest.mark.parametrize("floating", [False, True])
def test_outputs_are_those_of_pinocchio(floating: bool, tmp_path: Path) -> None:
    model = humanoid(tmp_path, ASKED, floating=floating)
    plan = planned(model)
    assert plan_from_json(plan_to_json(plan)) == plan
    states = random_states(model, 3, seed=4)
    assert (model.nqdd, plan.nqdd) == (model.nv + 5 * 6 + 2 * 36,) * 2
    for state in states.each:
        want = by_pinocchio(model, state)
        for lanes in (False, True):
            got = interpret(plan, *state, lanes=lanes)
            assert abs(got - want).max() < 1e-10 * abs(want).max()
    assert straight_line(plan)[0].machine.rows.rows  # limbs share code all the same


def test_a_floating_base_is_held_by_what_drives_it_alone(tmp_path: Path) -> None:
    text = (
        '[outputs]\nreaction_forces = ["__base__", "left_knee"]\nlink_accelerations = ["torso"]\n'
    )
    model = humanoid(tmp_path, text, floating=True)
    (state,) = random_states(model, 1, seed=4).each
    for lanes in (False, True):
        got = interpret(planned(model), *state, lanes=lanes)
        first = planned(model).entry_of_output(1)
        assert np.array_equal(got[first : first + 6], state[2][:6])


def asked(model: Model, rng: np.random.Generator) -> Model:
    """Ask a tree for each kind of output, at frames that are anywhere on links."""
    outputs = []
    for what in (LINK_ACCELERATION, REACTION_FORCE, INVERSE_INERTIA):
        for link in rng.choice(np.arange(1, len(model.links)), size=2, replace=False):
            turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
            frame = Frame("there", turn * np.linalg.det(turn), rng.normal(size=3))
            if what == REACTION_FORCE:
                frame = Frame("here", np.eye(3), np.zeros(3))
            outputs.append(Output(what, int(link), frame, f"{what} {link}"))
    return replace(model, outputs=tuple(outputs))


@pytest.mark.parametrize("seed", range(6))
def test_outputs_of_any_tree_keep_their_digits(seed: int) -> None:
    """Joints of all kinds, prescribed ones too; beside balls, whose error is known."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, 7, ALL_KINDS)
    held = int(rng.integers(7))
    joints = tuple(replace(x, prescribed=j == held) for j, x in enumerate(model.joints))
    plan = planned(asked(replace(model, joints=joints), rng))
    states = random_states(model, 1, seed)
    state = states.q[0], states.v[0], states.tau[0]
    exact = interpret(plan, *state, algebra=BALLS)
    truth = np.array([float(x) for x in exact])
    error = abs(interpret(plan, *state) - truth)
    for k, output in enumerate(plan.outputs):
        own = slice(plan.entry_of_output(k), plan.entry_of_output(k) + output.size)
        assert error[own].max() < 1e-12 * max(1.0, abs(truth[own]).max())


@pytest.mark.parametrize("seed", range(6))
def test_outputs_of_any_tree_fulfil_what_defines_them(seed: int) -> None:
    """A unit force on the link moves it by a column; the reaction does the torque's work."""
    rng = np.random.default_rng(seed)
    model = asked(random_tree(rng, 6, ALL_KINDS), rng)
    outputs = [
        Output(LINK_ACCELERATION, o.link, o.frame, o.name)
        for o in model.outputs
        if o.what == INVERSE_INERTIA
    ]
    both = replace(model, outputs=(*outputs, *model.outputs))
    pushed = replace(both, wrenches=tuple(Wrench(o.link, o.frame) for o in outputs))
    plan = planned(pushed)
    drawn = random_states(pushed, 1, seed)
    q, v, tau = drawn.q[0], drawn.v[0], drawn.tau[0]
    rest = interpret(plan, q, v, tau)
    for k, output in enumerate(plan.outputs):
        at = plan.entry_of_output(k)
        if output.what == REACTION_FORCE:
            joint = model.joints[output.link - 1]
            force = rest[at : at + 6]
            free = list(joint.kind.free)  # [angular; linear], of the canonical frame
            # Reactions are in the description's axes: those of the canonical frame are turned.
            turn = canonical(model).outputs[k - len(outputs)].frame.rotation
            turned = np.concatenate([turn @ force[3:], turn @ force[:3]])
            own = slice(model.v_start[output.link - 1], model.v_start[output.link - 1] + len(free))
            want = tau[own] if joint.kind.name != "floating" else np.r_[tau[own][3:], tau[own][:3]]
            got = turned[free] if joint.kind.name != "floating" else turned
            assert abs(got - want).max() < 1e-9 * max(1, abs(force).max())
        if output.what == INVERSE_INERTIA:
            matrix = rest[at : at + 36].reshape(6, 6)
            place = next(i for i, o in enumerate(outputs) if o.name == output.name)
            for column in range(6):
                more = tau.copy()
                more[model.nv + 6 * place + column] += 1
                moved = interpret(plan, q, v, more) - rest
                first = plan.entry_of_output(place)
                assert abs(moved[first : first + 6] - matrix[:, column]).max() < 1e-8 * max(
                    1, abs(matrix).max()
                )


def solved(solver: Solver, model: Model, states: States, folder: Path) -> Array:
    answer = solver.solve(model, states, folder)
    assert answer.shape == (states.count, model.nqdd)
    return answer


@pytest.mark.parametrize("batch", [slow(False), True])
def test_outputs_are_emitted(batch: bool, builder: Builder, tmp_path: Path) -> None:
    model = humanoid(tmp_path, ASKED, floating=True)
    plan = planned(model)
    solver = builder.solver(plan, batch=int(batch))
    states = random_states(model, 9, seed=7)
    got = solved(solver, model, states, tmp_path)
    want = np.array([interpret(plan, *x) for x in states.each])
    assert abs(got - want).max() < 1e-11 * abs(want).max()
    assert solver.run("--check", "--time", "--repeat", "1").status == 0


def test_reproducible_solvers_give_them(builder: Builder, tmp_path: Path) -> None:
    text = """[outputs]
link_accelerations = ["hand"]
reaction_forces = ["elbow_pitch"]
inverse_inertia = ["hand"]
"""
    model = reduced(read_robot(MODELS / "arm7.urdf").model, tmp_path, text).model
    plan = replace(planned(model), reproducible=True)
    states = random_states(model, 3, seed=7)
    got = solved(builder.solver(plan), model, states, tmp_path)
    want = np.array([interpret(planned(model), *x) for x in states.each])
    assert got.shape == (3, model.nv + 6 + 6 + 36)
    assert abs(got - want).max() < 1e-12 * abs(want).max()


@pytest.mark.parametrize(
    ("robot", "floating", "scalar", "batch"),
    [
        ("panda_description/urdf/panda.urdf", False, "double", 0),
        slow("solo_description/robots/solo12.urdf", True, "float", 0),
        slow("talos_data/robots/talos_left_arm.urdf", True, "double", 1),
        ("allegro_hand_description/urdf/allegro_right_hand.urdf", False, "float", 1),
    ],
)
def test_outputs_of_real_robots_keep_their_digits(
    robot: str, floating: bool, scalar: str, batch: int, builder: Builder, tmp_path: Path
) -> None:
    """Beside balls of 400 bits: as many as the accelerations beside them keep.

    Reaction forces cancel by some tens of units. In the first state, solo12's knee is nearly
    straight (0.0085 rad).
    """
    whole = read_robot(real_robot(robot), floating=floating).model
    joint, link = whole.joints[-1].name, whole.links[-1].name
    text = f'[outputs]\nlink_accelerations = ["{link}"]\nreaction_forces = ["{joint}"]\n'
    model = reduced(whole, tmp_path, f'{text}inverse_inertia = ["{link}"]\n').model
    plan = replace(planned(model), scalar=scalar)
    number = np.dtype({"double": "float64", "float": "float32"}[scalar])
    limit = {"double": 1e-14, "float": 3e-6}[scalar]
    states = random_states(model, 3, seed=5).read_in(scalar)
    got = solved(builder.solver(plan, batch=batch), model, states, tmp_path)
    for state, answer in zip(states.each, got, strict=True):
        truth = np.array([float(x) for x in interpret(plan, *state, algebra=BALLS)])
        firsts = [0, *(plan.entry_of_output(k) for k in range(len(plan.outputs))), len(truth)]
        errors = [
            abs(answer - truth)[first:last].max() / abs(truth[first:last]).max()
            for first, last in pairwise(firsts)
        ]
        assert errors[0] < limit
        assert max(errors) < max(500 * np.finfo(number).eps, 4 * errors[0])


@pytest.mark.parametrize("words", [("--shape", "kernels"), ("--schedule", "balanced")])
def test_outputs_elsewhere_are_refused(
    words: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """They are straight lines of one process, which --procs 2 alone is given."""
    scene = tmp_path / "scene.toml"
    scene.write_text(ASKED)
    command = [str(MODELS / "humanoid.urdf"), "--scene", str(scene), "--out", str(tmp_path / "out")]
    assert main([*command, "--procs", "2"]) == 0
    assert "2 processes do not pay" in capsys.readouterr().err
    assert main([*command, "--procs", "2", *words]) == 2
    assert "outputs" in capsys.readouterr().err.partition("error: ")[2]


def test_an_output_is_told_where_it_is(tmp_path: Path) -> None:
    model = humanoid(tmp_path, ASKED, floating=True)
    text = "".join(text for name, text in emit(planned(model)).items() if name.endswith(".h"))
    assert f"_NQDD = {model.nqdd}" in text
    assert re.search(r'//   41 to 46  link acceleration of "torso"', text)


@pytest.mark.parametrize("batch", [0, 1])
def test_the_header_tells_how_many_numbers_outer_forces_add(batch: int, tmp_path: Path) -> None:
    model = humanoid(tmp_path, 'forces = ["left_foot"]\n', floating=True)
    files = emit(planned(model), batch=batch)
    text = "".join(text for name, text in files.items() if name.endswith(".h"))
    assert ("of v, 41 of tau, 35 of qdd" if batch else "v: 35, tau: 41, qdd: 35") in text


def test_limbs_that_outputs_hang_on_stay(tmp_path: Path) -> None:
    """Of a humanoid that is held: one leg for its acceleration, the other one for its foot."""
    outputs = """
[outputs]
link_accelerations = ["left_foot"]
inverse_inertia = ["left_foot"]
"""
    whole = humanoid(tmp_path, outputs, floating=False)
    small = humanoid(tmp_path, 'accelerations = ["right_knee"]\n' + outputs, floating=False)
    at = {joint.name: j for j, joint in enumerate(whole.joints)}
    kept = [at[joint.name] for joint in small.joints]
    assert {whole.joints[j].name.partition("_")[0] for j in kept} == {"left", "right"}
    assert len(kept) == 12 and all(joint.kind.nq == joint.kind.nv for joint in whole.joints)
    own = [k for j in kept for k in _entries(whole, j)]
    plan = planned(small)
    for q, v, tau in random_states(whole, 3, seed=6).each:
        want = by_pinocchio(whole, (q, v, tau))[whole.nv :]
        got = interpret(plan, q[own], v[own], tau[own])[small.nv :]
        assert len(got) == len(want) == 6 + 36
        assert abs(got - want).max() < 1e-10 * abs(want).max()


WANTED = 'accelerations = ["__base__", "left_knee"]\n'


@pytest.mark.parametrize(
    ("processes", "shape"),
    [(1, "unrolled"), (2, "kernels"), slow(1, "kernels"), slow(2, "unrolled")],
)
def test_accelerations_that_are_not_wanted_are_not_computed(
    shape: str, processes: int, builder: Builder, tmp_path: Path
) -> None:
    whole = read_robot(MODELS / "humanoid.urdf", floating=True).model
    model = reduced(whole, tmp_path, WANTED).model
    wanted = [k for j in model.wanted for k in _entries(model, j)]
    assert [model.joints[j].name for j in model.wanted] == ["__base__", "left_knee"]
    plan = planned(model, processes)
    states = random_states(model, 4, seed=3)
    solver = builder.solver(plan, shape=shape)
    got = solved(solver, model, states, tmp_path)
    truth = np.array([forward_dynamics(whole, *x) for x in states.each])
    assert abs(got[:, wanted] - truth[:, wanted]).max() < 1e-9 * abs(truth).max()
    others = np.delete(np.arange(model.nv), wanted)
    assert np.isnan(got[:, others]).all()
    done = solver.run("--check", "--json")
    assert done.status == 0
    assert json.loads(done.stdout)["check"]["backward_error_max"] < 1e-13
    assert solver.run("--simulate", "0.01").status == 2


def _entries(model: Model, j: int) -> range:
    return range(model.v_start[j], model.v_start[j] + model.joints[j].kind.nv)


def test_wanting_less_is_less_work(tmp_path: Path) -> None:
    """On an arm with a fixed base: the first joint's alone needs no sweep outwards."""
    whole = read_robot(MODELS / "arm7.urdf").model
    first = reduced(whole, tmp_path, 'accelerations = ["base_yaw"]\n').model
    every, one = (straight_line(planned(model))[0].operations for model in (whole, first))
    assert one.multiply + one.add < 0.9 * (every.multiply + every.add)
    shapes = [program_of(planned(model), "kernels") for model in (whole, first)]
    outwards = [
        sum(len(op.steps) for op in shape.processes[0].operations if op.does == "accelerate")
        for shape in shapes
    ]
    assert outwards == [9, 1]


def test_the_check_of_wanted_accelerations_can_fail(builder: Builder, tmp_path: Path) -> None:
    whole = read_robot(MODELS / "arm7.urdf").model
    model = reduced(whole, tmp_path, 'accelerations = ["elbow_pitch"]\n').model
    text = text_of(planned(model), shape="unrolled")
    wrong, count = re.subn(r"w\.result\[3\] = (x\d+);", r"w.result[3] = \1 * Real(1.001);", text)
    assert count == 1
    good, bad = (builder.compile(each, "arm7_p1") for each in (text, wrong))
    toolchain = find_toolchain()
    assert Solver(good, 1, toolchain).run("--check").status == 0
    done = Solver(bad, 1, toolchain).run("--check")
    assert (done.status, "WRONG" in done.stdout) == (1, True)


def test_at_rest_velocities_cost_nothing(builder: Builder, tmp_path: Path) -> None:
    whole = read_robot(MODELS / "arm7.urdf").model
    model = reduced(whole, tmp_path, "at_rest = true\n").model
    states = random_states(model, 3, seed=1)
    assert not states.v.any()
    every, still = (straight_line(planned(x))[0].operations for x in (whole, model))
    assert still.multiply + still.add < 0.85 * (every.multiply + every.add)
    solver = builder.solver(planned(model))
    truth = [forward_dynamics(whole, *x) for x in states.each]
    assert forward_error(solved(solver, model, states, tmp_path), np.array(truth)) < 1e-12
    assert solver.run("--check").status == 0
    moving, path = random_states(whole, 1, seed=1), tmp_path / "moving.json"
    write_states(moving, whole, path)
    assert solver.run("--states", path).status == 1
    with pytest.raises(InputError, match="at_rest"):
        read_states(path, model)


@pytest.mark.parametrize("shape", [slow("unrolled"), "kernels"])
def test_at_rest_velocities_are_not_read(shape: str, tmp_path: Path) -> None:
    """Loops swept the state that they were given, while straight lines left velocities out."""
    scene = tmp_path / "scene.toml"
    scene.write_text("at_rest = true\n")
    robot = adagen.read(MODELS / "chain16.urdf", scene=scene)
    solver = adagen.compile(robot, shape=shape).build()
    states = random_states(robot.model, 3, seed=2)
    found = solver(states.q, np.full_like(states.v, 0.7), states.tau)
    still = np.zeros(robot.nv)
    want = [forward_dynamics(robot.model, q, still, tau) for q, _, tau in states.each]
    assert forward_error(found, np.array(want)) < 1e-10


def test_what_a_simplification_does_is_told(tmp_path: Path) -> None:
    whole = read_robot(MODELS / "humanoid.urdf", floating=True).model
    legs = apply_scene(whole, read_scene(MODELS / "humanoid_legs.toml"))
    (locked,) = simplifications(legs)
    assert "locked" in locked.holds
    assert 0 < locked.median < locked.largest < 1
    rest = reduced(whole, tmp_path, "gravity = [0, 0, 0]\nat_rest = true\n")
    assert [each.holds for each in simplifications(rest)] == [
        "there is no gravity",
        "velocities are zero",
    ]
    assert not list(simplifications(reduced(whole, tmp_path, WANTED)))


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ('[outputs]\nlink_acceleration = ["torso"]\n', "unknown output"),
        ('[outputs]\nlink_accelerations = ["torsos"]\n', "'torsos' is not a link"),
        ('[outputs]\nreaction_forces = ["torso"]\n', "'torso' is not a moving joint"),
        ('[outputs]\nlink_accelerations = ["pelvis"]\n', "fixed to the ground"),
        (
            '[outputs]\nreaction_forces = ["left_knee"]\n[lock]\nleft_knee = 0.0\n',
            "is locked: the force through it",
        ),
    ],
)
def test_outputs_that_cannot_be_are_refused(text: str, says: str, tmp_path: Path) -> None:
    whole = read_robot(MODELS / "humanoid.urdf").model
    with pytest.raises(InputError, match=says) as refused:
        reduced(whole, tmp_path, text)
    assert refused.value.line is not None


def test_outputs_are_one_processs(tmp_path: Path) -> None:
    model = humanoid(tmp_path, ASKED, floating=True)
    with pytest.raises(UsageError, match="form ada"):
        make_plan(model, best_schedule(model, 1, load_profile("default")), form="ada")
    plain = replace(model, outputs=())
    schedule = best_schedule(plain, 2, load_profile("paper"))
    with pytest.raises(UsageError, match="by one process"):
        make_plan(model, schedule)
    with pytest.raises(UsageError, match="straight lines"):
        program_of(planned(model), "kernels")
