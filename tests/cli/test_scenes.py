"""``--scene FILE``: what is treated, what is said, and what is refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.calibrate.measure import least_times
from adagen.cli.main import main
from adagen.library.savings import counted
from adagen.plan import Plan, make_plan
from adagen.plan.operations import operations
from adagen.reference import forward_dynamics
from adagen.scene import apply_scene, read_scene
from adagen.scene.report import measured
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import random_states, read_result, write_states
from adagen.urdf import read_robot
from tests.models import serial_chain
from tests.urdf.texts import joint, link, robot

MODELS = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
HUMANOID = str(MODELS / "humanoid.urdf")
PAYLOAD = "arm7_payload.toml"
LEGS = str(MODELS / "humanoid_legs.toml")


def run(*words: str) -> int:
    return main([str(word) for word in words])


def scene(folder: Path, text: str) -> str:
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_locked_joints_are_gone_and_what_that_saves_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    timed: list[tuple[list[int], list[float]]] = []

    def kept(plans: list[Plan]) -> list[float]:
        found = least_times(plans)
        timed.append(([len(plan.joints) for plan in plans], found))
        return found

    monkeypatch.setattr("adagen.calibrate.measure.least_times", kept)
    assert run(HUMANOID, "--procs", "1", "--scene", LEGS, "-v", "--out", str(tmp_path)) == 0
    said = capsys.readouterr().err
    assert 'scene: 14 joints locked: "neck_yaw" at 0, "neck_pitch" at 0.1' in said
    assert "scene: 16 of 30 joints and 21 of 35 degrees of freedom left" in said
    ((joints, (before, after)),) = timed  # which is less is not asked: others may take the time
    assert joints == [30, 16] and min(before, after) > 0
    assert measured(before, after) in said.splitlines()
    assert "fewer operations" in said
    plan = json.loads((tmp_path / "humanoid_p1.plan.json").read_text())
    assert len(plan["joints"]) == 16
    assert plan["floating"] is True


def test_what_straight_lines_fold_is_told() -> None:
    """The steps at rest are those in motion; statements that do nothing are left out."""
    profile, model = load_profile("default"), read_robot(MODELS / "arm7.urdf").model
    plan = make_plan(model, best_schedule(model, 1, profile))
    assert operations(replace(plan, at_rest=True)) == operations(plan)
    before, after = counted([plan, replace(plan, at_rest=True)])
    assert after < 0.8 * before < 0.4 * operations(plan)
    chain = make_plan(serial_chain(150), best_schedule(serial_chain(150), 1, profile))
    assert counted([plan, chain]) == [operations(plan), operations(chain)]  # one of them as loops


def test_a_scene_that_only_adds_is_compared_with_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nothing is built to be timed: the robot with and without such a scene is the same."""
    path, loops = str(MODELS / "fourbar.urdf"), str(MODELS / "fourbar.toml")
    assert run(path, "--procs", "1", "--scene", loops, "-v", "--out", str(tmp_path)) == 0
    said = capsys.readouterr().err
    assert "scene: it leaves out nothing of the robot" in said
    assert "building and timing" not in said


def test_without_v_nothing_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(HUMANOID, "--procs", "1", "--scene", LEGS, "--out", str(tmp_path)) == 0
    assert "scene:" not in capsys.readouterr().err


def test_the_schedule_is_that_of_what_is_left(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("schedule", HUMANOID, "--procs", "2", "--scene", LEGS, "--json") == 0
    tree = json.loads(capsys.readouterr().out)
    names = set()
    waiting = [tree["root"]]
    while waiting:
        node = waiting.pop()
        names.add(node["joint"])
        waiting += node["children"]
    assert len(names) == 16
    assert "left_elbow" not in names


@pytest.mark.parametrize(
    ("text", "words", "status", "reason"),
    [
        ('base = "floating"', ["--floating"], 2, "leave out --floating"),
        ("mimic = false", ["--mimic"], 2, "leave out --mimic"),
        ("gravity = [0,0,0]", ["--gravity", "0", "0", "-1"], 1, "scene.toml:1: error: another"),
        ("gravty = 1", [], 1, "scene.toml:1: error: unknown key"),
        ("[lock]\nleft_elbw = 0", [], 1, "scene.toml:2: error: 'left_elbw' is not a moving joint"),
    ],
)
def test_contradictions_and_slips_are_refused(
    text: str,
    words: list[str],
    status: int,
    reason: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    given = scene(tmp_path, text)
    assert run(HUMANOID, "--procs", "1", "--scene", given, *words) == status
    said = capsys.readouterr().err
    assert reason in said
    assert "Traceback" not in said


def test_states_of_locked_joints_are_refused_with_the_reason(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    states = tmp_path / "states.json"
    one = {"q": [0.0], "v": [0.0], "tau": [0.0]}
    states.write_text(json.dumps({"joints": {"left_elbow": one}}))
    words = ["--procs", "1", "--scene", LEGS, "--states", str(states)]
    assert run("solve", HUMANOID, *words) == 1
    assert "joint 'left_elbow' has no state: the scene locks it" in capsys.readouterr().err


def test_a_robot_that_only_the_scene_makes_solvable(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A massless leaf is refused, unless the scene locks it or gives it mass."""
    urdf = tmp_path / "r.urdf"
    urdf.write_text(
        robot(link("a"), link("b"), link("c", ""), joint("j1", "a", "b"), joint("j2", "b", "c"))
    )
    out = ["--procs", "1", "--out", str(tmp_path / "out")]
    assert run(str(urdf), *out) == 1
    assert 'joint "j2" moves no mass' in capsys.readouterr().err
    assert run(str(urdf), *out, "--scene", scene(tmp_path, "[lock]\nj2 = 0"), "-v") == 0
    assert "the whole robot has no forward dynamics" in capsys.readouterr().err
    massive = '[[point_masses]]\nlink = "c"\nmass = 1\nposition = [0, 0, 1]'
    assert run(str(urdf), *out, "--scene", scene(tmp_path, massive)) == 0
    assert run(str(urdf), *out, "--scene", scene(tmp_path, "[lock]\nj1 = 0")) == 1


def test_outer_forces_and_prescribed_motion_are_inputs_of_solve(tmp_path: Path) -> None:
    """The example scene, from the states file to accelerations, against the reference."""
    model = apply_scene(
        read_robot(MODELS / "arm7.urdf", floating=True).model, read_scene(MODELS / PAYLOAD)
    ).model
    assert model.joints[0].prescribed
    assert model.ntau == model.nv + 6
    states = random_states(model, 2, seed=4)
    given, result = tmp_path / "states.json", tmp_path / "result.json"
    write_states(states, model, given)
    assert set(json.loads(given.read_text())["forces"]) == {"hand"}
    words = ["--procs", "2", "--scene", str(MODELS / PAYLOAD)]
    files = ["--states", str(given), "--result", str(result)]
    assert run("solve", str(MODELS / "arm7.urdf"), *words, *files) == 0
    found = read_result(result, model)
    np.testing.assert_array_equal(found[:, 0], states.tau[:, 0])
    for (q, v, tau), qdd in zip(states.each, found, strict=True):
        want = forward_dynamics(model, q, v, tau)
        np.testing.assert_allclose(qdd, want, rtol=0, atol=1e-9 * abs(want).max())
