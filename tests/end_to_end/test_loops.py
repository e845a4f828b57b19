"""Closed loops from the command line: solved, refused by name, checked, simulated."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.cli.main import main
from adagen.errors import InputError
from adagen.executor import interpret
from adagen.library import read
from adagen.model import Model
from adagen.reference.closed import closed_forward_dynamics, closed_states, constraints
from adagen.states import states_text
from tests.emitted import QUICK, Builder, Solver, text_of
from tests.end_to_end.test_verdict import spoilt
from tests.executor.test_closures import plan_of
from tests.mechanisms import MECHANISMS, four_bar, gripping, states_of
from tests.slow import spread

URDF = """<robot name="bars">
  <link name="base"/>
  <link name="crank">{body}</link>
  <link name="coupler">{body}</link>
  <link name="eye"/>
  <link name="rocker">{body}</link>
  <joint name="crank_pin" type="continuous">
    <parent link="base"/><child link="crank"/><axis xyz="0 1 0"/>
  </joint>
  <joint name="coupler_pin" type="continuous">
    <parent link="crank"/><child link="coupler"/><origin xyz="0.2 0 0"/><axis xyz="0 1 0"/>
  </joint>
  <joint name="eye_joint" type="fixed">
    <parent link="coupler"/><child link="eye"/><origin xyz="0.5 0 0"/>
  </joint>
  <joint name="rocker_pin" type="continuous">
    <parent link="base"/><child link="rocker"/><origin xyz="0.45 0 0"/><axis xyz="0 1 0"/>
  </joint>
</robot>
""".replace(
    "{body}",
    '<inertial><origin xyz="0.1 0 0"/><mass value="1"/>'
    '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/></inertial>',
)
CHECKED = {**MECHANISMS, "four-bar beside a gripper": gripping}
PARTS = 4
"""Parts of the mechanisms with true answers, all of which slow tests take."""
SCENE = """[[loops]]
name = "eye pin"
kind = "revolute"
link1 = "eye"
link2 = "rocker"
origin2 = { xyz = [0.4, 0, 0] }
axis = [0, 1, 0]
"""


@pytest.fixture
def bars(tmp_path: Path) -> Path:
    """A four-bar linkage: bars.urdf, bars.toml and its states in a folder."""
    return write_bars(tmp_path)


def write_bars(folder: Path) -> Path:
    """Write a four-bar linkage: bars.urdf, bars.toml and its states; return the folder."""
    (folder / "bars.urdf").write_text(URDF)
    (folder / "bars.toml").write_text(SCENE)
    model = read(folder / "bars.urdf", scene=folder / "bars.toml").model
    q, v = closed_states(model, 3, seed=2)
    write_states(folder / "states.json", q, v)
    return folder


def write_states(path: Path, q: np.ndarray, v: np.ndarray) -> None:
    names = ("crank_pin", "coupler_pin", "rocker_pin")
    joints = {
        name: {"q": q[:, k].tolist(), "v": v[:, k].tolist(), "tau": [0.5] * len(q)}
        for k, name in enumerate(names)
    }
    path.write_text(json.dumps({"joints": joints}))


def solve(folder: Path, *more: str) -> int:
    words = [str(folder / "bars.urdf"), "--scene", str(folder / "bars.toml")]
    states = ["--states", str(folder / "states.json"), "--result", str(folder / "result.json")]
    return main(["solve", *words, *states, *more])


@pytest.mark.parametrize("processes", ["1", "2"])
def test_a_four_bar_is_solved(bars: Path, processes: str) -> None:
    assert solve(bars, "--procs", processes) == 0
    model = read(bars / "bars.urdf", scene=bars / "bars.toml").model
    found = json.loads((bars / "result.json").read_text())["joints"]
    given = json.loads((bars / "states.json").read_text())["joints"]
    for s in range(3):
        q, v, tau = (
            np.array([given[j.name][key][s] for j in model.joints]) for key in ("q", "v", "tau")
        )
        truth = closed_forward_dynamics(model, q, v, tau)
        answer = [found[joint.name]["qdd"][s] for joint in model.joints]
        np.testing.assert_allclose(answer, truth, atol=1e-9 * np.abs(truth).max())


@pytest.mark.parametrize("batch", [[], ["--batch"]])
def test_an_open_loop_is_refused_by_name_with_the_distance(
    batch: list[str], bars: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    model = read(bars / "bars.urdf", scene=bars / "bars.toml").model
    given = json.loads((bars / "states.json").read_text())
    given["joints"]["rocker_pin"]["q"][1] += 0.02
    (bars / "states.json").write_text(json.dumps(given))
    assert solve(bars, *batch) == 1
    q, v = (
        np.array([given["joints"][joint.name][key] for joint in model.joints]) for key in ("q", "v")
    )
    by = float(np.linalg.norm(constraints(model, q[:, 1]).gaps[:3]))
    said = capfd.readouterr().err
    assert 'state 2: loop "eye pin": it is not closed in this configuration' in said
    assert f": it is open by {by:.3g} m\n" in said
    given["joints"]["rocker_pin"]["q"][1] -= 0.02
    given["joints"]["rocker_pin"]["v"][0] += 0.5
    (bars / "states.json").write_text(json.dumps(given))
    assert solve(bars, *batch) == 1
    v[2, 0] += 0.5
    by = float(np.linalg.norm(constraints(model, q[:, 0]).rows[:3] @ v[:, 0]))
    said = capfd.readouterr().err
    assert f'state 1: loop "eye pin": the velocity violates it: it opens by {by:.3g} m/s\n' in said


def test_a_coupling_that_does_not_hold_is_refused_with_the_angle(
    bars: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """What it is off by is counted behind the rows of all loops."""
    with (bars / "bars.toml").open("a") as scene:
        scene.write("[[couplings]]\nname = 'none'\nterms = { crank_pin = 0.5 }\noffset = 7.0\n")
    given = json.loads((bars / "states.json").read_text())
    for joint in given["joints"].values():
        joint["v"] = [0.0] * len(joint["v"])
    (bars / "states.json").write_text(json.dumps(given))
    assert solve(bars, "--loop-forces") == 1  # nothing moves with it
    by = 7.0 - 0.5 * given["joints"]["crank_pin"]["q"][0]
    said = capfd.readouterr().err
    assert 'state 1: coupling "none": it is not closed in this configuration' in said
    assert f": it is open by {by:.3g} rad\n" in said


@pytest.mark.parametrize("name", spread(CHECKED, 3))
def test_check_is_right_of_mechanisms_and_wrong_of_spoilt_ones(name: str, builder: Builder) -> None:
    """Slaved joints follow in poses that were drawn again, too."""
    plan = plan_of(CHECKED[name]())
    solver = builder.solver(plan, QUICK, shape="unrolled", name="closed")
    told = json.loads(solver.run("--check", "--json").stdout)["check"]
    assert told["ok"]
    assert told["backward_error_max"] < 1e-9
    text = spoilt(text_of(plan, shape="unrolled"), 1, 1 + 1e-5)
    wrong = Solver(builder.compile(text, "spoilt", QUICK), 1, builder.toolchain).run(
        "--check", "--json"
    )
    assert wrong.status == 1
    assert not json.loads(wrong.stdout)["check"]["ok"]


def test_a_simulation_stays_closed(builder: Builder, tmp_path: Path) -> None:
    model = four_bar()
    solver = builder.solver(plan_of(model), QUICK, shape="unrolled", name="closed")
    path = tmp_path / "motion.npz"
    solver.run("--simulate", "2", "--step", "0.001", "--trajectory", path)
    motion = {name: np.asarray(values) for name, values in np.load(path).items()}
    gaps = [np.abs(constraints(model, q).gaps).max() for q in motion["q"]]
    rates = [
        np.abs(constraints(model, q).rows @ v).max()
        for q, v in zip(motion["q"], motion["v"], strict=True)
    ]
    assert len(gaps) == 2001
    assert max(gaps) < 1e-10
    assert max(rates) < 1e-10
    assert np.ptp(motion["q"][:, 0]) > 0.1
    torn = solver.run("--simulate", "20", "--step", "0.5")
    assert torn.status == 1
    assert "within this step it opens" in torn.stderr and "at t = " in torn.stderr
    assert torn.stderr.endswith("take a smaller --step")


def held(folder: Path) -> Model:
    """Return a floating base with a hinge and a slide that a point holds still: of its three rows,
    one follows from the others, and rounding alone moves the base along it.
    """
    body = URDF.partition('<link name="crank">')[2].partition("</link>")[0]
    joints = {"hinge": ("revolute", "0.3 -0.5 0.8"), "slide": ("prismatic", "0.5 -0.6 -1.2")}
    text, above = f'<link name="base">{body}</link>', "base"
    for name, (kind, axis) in joints.items():
        text += f"""<link name="{name}_link">{body}</link><joint name="{name}" type="{kind}">
          <parent link="{above}"/><child link="{name}_link"/><origin xyz="0.1 0.2 -0.15"/>
          <axis xyz="{axis}"/><limit lower="-3" upper="3" effort="9" velocity="9"/></joint>"""
        above = f"{name}_link"
    (folder / "held.urdf").write_text(f'<robot name="held">{text}</robot>')
    (folder / "held.toml").write_text(
        """[[loops]]
        kind = "spherical"
        link1 = "base"
        origin1 = { xyz = [0.25, 0.3, -0.1] }
        link2 = "slide_link"
        origin2 = { xyz = [0.05, -0.1, 0.2] }
        """
    )
    return read(folder / "held.urdf", scene=folder / "held.toml", floating=True).model


MOVING = {"four-bar": lambda _: four_bar(floating=True), "held by a point": held}


@pytest.mark.parametrize("robot", MOVING)
@pytest.mark.parametrize(("scalar", "near"), [("double", 1e-5), ("float", 0.05)])
def test_a_simulation_takes_nothing_of_rows_that_are_rounding(
    robot: str, scalar: str, near: float, builder: Builder, tmp_path: Path
) -> None:
    model, path = MOVING[robot](tmp_path), tmp_path / "motion.npz"
    plan, states = plan_of(model, scalar=scalar), states_of(model, 1, seed=3)
    solver = builder.solver(plan, QUICK, shape="unrolled", name="closed")
    (tmp_path / "states.json").write_text(states_text(states, model))
    asked = ("--states", tmp_path / "states.json", "--trajectory", path)
    solver.run(*asked, "--simulate", "0.003", "--step", "0.0001")
    with np.load(path) as motion:
        q, v = motion["q"][1:-1], motion["v"]
        found = (v[2:] - v[:-2]) / 2e-4
    rows = zip(q, v[1:-1], strict=True)
    truth = np.array([closed_forward_dynamics(model, *row, states.tau[0]) for row in rows])
    assert np.abs(found - truth).max() < near * np.abs(truth).max()


@pytest.mark.parametrize("part", spread(range(PARTS), 1))
def test_mechanisms_with_true_answers(shared: Path, part: int) -> None:
    """Mechanisms with known answers, as the executor solves them; every fourth in each part."""
    folder = shared / "loops"
    count = 0
    for path in sorted(folder.glob("*.scene.toml"))[part::PARTS]:
        name = path.name.removesuffix(".scene.toml")
        truth = json.loads((folder / f"{name}.json").read_text())
        for mode, told in truth["modes"].items():
            robot = read(folder / f"{name}.urdf", scene=path, floating=mode == "floating")
            model, joints = robot.model, told.get("joints") or {}
            try:
                plan = plan_of(model)
                answers = []
                for s in range(len(next(iter(joints.values()))["q"])):
                    q, v, tau = (
                        np.hstack([np.ravel(joints[j.name][key][s]) for j in model.joints])
                        for key in ("q", "v", "tau")
                    )
                    found = interpret(plan, q, v, tau, once=True)
                    qdd = np.hstack([np.ravel(joints[j.name]["qdd"][s]) for j in model.joints])
                    answers.append(np.abs(found - qdd).max() / max(1.0, np.abs(qdd).max()))
            except (InputError, FloatingPointError):
                assert told.get("answer", "qdd") != "qdd", (name, mode)
            else:
                assert told.get("answer", "qdd") != "refuse", (name, mode)
                assert max(answers) <= told["tolerance"], (name, mode)
            count += 1
    assert count >= 50 // PARTS


def test_a_mimic_at_a_loop_is_a_coupling(tmp_path: Path) -> None:
    """A five-bar whose second crank mimics the first one has one freedom left."""
    scene = SCENE.replace("eye pin", "pin")
    urdf = URDF.replace(
        '<joint name="rocker_pin" type="continuous">',
        '<joint name="rocker_pin" type="continuous"><mimic joint="crank_pin" multiplier="-0.5"/>',
    )
    fifth = """  <link name="second">{body}</link>
  <joint name="second_pin" type="continuous">
    <parent link="rocker"/><child link="second"/><origin xyz="0.3 0 0"/><axis xyz="0 1 0"/>
  </joint>
</robot>""".replace("{body}", URDF.split('<link name="crank">')[1].split("</link>")[0])
    (tmp_path / "five.urdf").write_text(urdf.replace("</robot>", fifth))
    (tmp_path / "five.toml").write_text(scene.replace('link2 = "rocker"', 'link2 = "second"'))
    model = read(tmp_path / "five.urdf", scene=tmp_path / "five.toml", mimic=True).model
    assert [coupling.name for coupling in model.couplings] == ["rocker_pin"]
    assert not any(joint.mimic for joint in model.joints)
    plan = plan_of(model)
    q, v = closed_states(model, 3, seed=2, starts=60)
    tau = np.full(model.ntau, 0.5)
    for s in range(3):
        truth = closed_forward_dynamics(model, q[s], v[s], tau)
        found = interpret(plan, q[s], v[s], tau)
        names = [joint.name for joint in model.joints]
        crank, rocker = names.index("crank_pin"), names.index("rocker_pin")
        assert found[rocker] == pytest.approx(-0.5 * found[crank])
        np.testing.assert_allclose(found, truth, atol=1e-10 * np.abs(truth).max())
