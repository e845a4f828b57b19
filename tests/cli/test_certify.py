"""``--certify`` on the command line: what is emitted, said, solved and refused."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import adagen
from adagen.cli import main
from adagen.library.command import command_in
from adagen.states import random_states, read_result, write_states
from adagen.urdf import read_robot
from tests.cli.robots import write_arm
from tests.emitted import OPTIMISED, Builder, Solver, energy_errors
from tests.golden.make_models import MODELS
from tests.options import words_of
from tests.slow import slow

ARM, CHAIN, FOURBAR, MOBILE = (
    str(MODELS / f"{name}.urdf") for name in ("arm7", "chain16", "fourbar", "mobile")
)


def test_the_head_makes_it_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([MOBILE, "--certify", "--procs", "1", "--out", str(tmp_path)]) == 0
    source = (tmp_path / "mobile_p1.cpp").read_text()
    assert ", certified, channel" in source
    assert "double mobile_p1_error_bound(" in (tmp_path / "mobile_p1.h").read_text()
    assert "--certify" in (command_in(source) or ())
    assert main(["verify", str(tmp_path)]) == 0
    assert capsys.readouterr().err.endswith("1 solver: up to date\n")


@pytest.mark.parametrize(
    "more",
    [
        ("--shape", "kernels"),
        ("--shape", "unrolled"),
        ("--batch",),
        slow(("--batch", "--procs", "2")),
        ("--reproducible",),
        slow(("--reproducible", "--batch")),
    ],
)
def test_a_bound_for_each_state_is_in_the_result(tmp_path: Path, more: tuple[str, ...]) -> None:
    model = read_robot(Path(CHAIN)).model
    given, found = tmp_path / "states.json", tmp_path / "result.json"
    write_states(random_states(model, 5, seed=1), model, given)
    words = ["--procs", "1", "--certify", *more, "--states", str(given), "--result", str(found)]
    assert main(["solve", CHAIN, *words]) == 0
    bounds = json.loads(found.read_text())["error_bounds"]
    assert len(bounds) == 5
    assert all(1e-17 < bound < 1e-12 for bound in bounds)
    assert read_result(found, model).shape == (5, model.nv)


def test_mpi_processes_bound_what_they_answer_together(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Three of four processes have limbs of a humanoid; their bounds are those of one."""
    robot = str(MODELS / "humanoid.urdf")
    model = read_robot(Path(robot)).model
    given = tmp_path / "states.json"
    write_states(random_states(model, 5, seed=1), model, given)
    bounds = []
    for count in ("1", "4"):
        found = tmp_path / f"result{count}.json"
        words = ["--procs", count, "--states", str(given)]
        words += ["--certify", "--channel", "window", "--profile", "zen4"]
        assert main(["solve", robot, *words, "--result", str(found)]) == 0
        assert "do not pay" not in capsys.readouterr().err
        bounds.append(json.loads(found.read_text())["error_bounds"])
    assert bounds[1] == pytest.approx(bounds[0], rel=0.1)


def test_processes_are_priced_with_their_certificates(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([CHAIN, "--certify", "--procs", "2", "--out", str(tmp_path)]) == 0
    said = capsys.readouterr().err
    (told,) = re.findall(r"processes do not pay: (\S+) us predicted, \1 us on one", said)
    assert f"\n{told} us predicted" in said


@pytest.mark.slow
def test_processes_that_gather_beyond_the_ground_bound_what_they_answer(tmp_path: Path) -> None:
    """Two processes share a long chain by themselves; one bound is as good as the other."""
    robot = str(MODELS / "snake100.urdf")
    model = read_robot(Path(robot)).model
    given, states = tmp_path / "states.json", random_states(model, 3, seed=1)
    write_states(states, model, given)
    found, bounds = [], []
    for count in ("1", "2"):
        result = tmp_path / f"result{count}.json"
        words = ["--procs", count, "--certify", "--states", str(given), "--result", str(result)]
        words += ["--parts", "none"]  # one process in parts would take less than two that gather
        assert main(["solve", robot, *words]) == 0
        found.append(read_result(result, model))
        bounds.append(json.loads(result.read_text())["error_bounds"])
    assert np.abs(found[1] - found[0]).max() > 0  # they are not one process's
    for qdd, own in zip(found, bounds, strict=True):
        assert (energy_errors(model, states, qdd) <= 3 * np.array(own)).all()
    assert np.array(bounds[1]) == pytest.approx(bounds[0], rel=4)
    assert max(bounds[1]) < 1e-11


def test_limbs_in_lanes_are_certified_without_warnings_of_an_optimising_compiler(
    builder: Builder, tmp_path: Path
) -> None:
    words = ["--procs", "1", "--certify", "--shape", "unrolled", "--out", str(tmp_path)]
    assert main([str(MODELS / "humanoid.urdf"), *words]) == 0
    source = (tmp_path / "humanoid_p1.cpp").read_text()
    assert "max_of(" in source
    solver = builder.compile(source, "humanoid_p1", OPTIMISED)
    assert Solver(solver, 1, builder.toolchain).run("--check").status == 0


@pytest.mark.parametrize("scene", ["pushed", "first", "outputs"])
def test_scenes_that_want_more_or_less_are_certified_as_straight_lines(
    scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    case = {"robot": "arm7", "--procs": "1", "--certify": "yes", "--scene": scene}
    assert main([*words_of(case, tmp_path), "--out", str(tmp_path)]) == 0
    assert "w.certificate" in (tmp_path / "arm7_p1.cpp").read_text()
    loops = words_of({**case, "--shape": "kernels"}, tmp_path)
    assert main([*loops, "--out", str(tmp_path / "loops")]) == 2
    assert "shape kernels cannot be emitted: " in capsys.readouterr().err


@pytest.mark.slow
def test_two_processes_share_a_long_arm_whose_plain_schedule_tells_motions(tmp_path: Path) -> None:
    arm = adagen.read(write_arm(tmp_path / "arm.urdf", 420))
    plain = adagen.compile(arm, procs=2, parts="none").schedule.gathered
    assert plain is not None and plain.told
    certified = adagen.compile(arm, procs=2, certify=True, parts="none")
    assert certified.plan.several
    alone = adagen.compile(arm, procs=1, certify=True, parts="none")
    assert certified.predicted is not None and alone.predicted is not None
    assert certified.predicted < 0.8 * alone.predicted
    in_parts = adagen.compile(arm, procs=2, certify=True)  # by one process, which is faster
    assert in_parts.schedule.parts == 8 and not in_parts.plan.several
    assert in_parts.predicted is not None and in_parts.predicted < certified.predicted


def test_one_process_is_chosen_where_none_is_asked_for(tmp_path: Path) -> None:
    long = str(MODELS / "snake100.urdf")  # for which two processes pay
    assert main([long, "--certify", "--out", str(tmp_path)]) == 0
    assert (tmp_path / "snake100_p1.cpp").is_file()


def test_a_schedule_in_a_file_says_how_many_processes_certify(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    robot = str(MODELS / "arm7.urdf")
    assert main(["schedule", robot, "--procs", "2", "--json"]) == 0
    given = tmp_path / "schedule.json"
    given.write_text(capsys.readouterr().out)
    assert main([robot, "--certify", "--schedule", str(given), "--out", str(tmp_path)]) == 0
    assert ", certified, channel" in (tmp_path / "arm7_p2.cpp").read_text()


def test_a_certified_batch_is_shared_by_as_many_cores_as_another(tmp_path: Path) -> None:
    stems = []
    for folder, more in (("plain", ()), ("certified", ("--certify",))):
        assert main([ARM, "--batch", *more, "--out", str(tmp_path / folder)]) == 0
        stems.append([path.name for path in (tmp_path / folder).glob("*.h")])
    assert stems[0] == stems[1]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--form", "ada"), "form ada has no factors to certify answers with"),
        (("--refine", "1"), "refined answers come with an estimate of their own"),
        (("--shape", "joints"), "it is for form ada"),
        (("--target", "embedded"), "certified solvers are not emitted with --target"),
        (("--tune",), "certified solvers are not emitted with --tune"),
        (("--procs", "2", "--schedule", "balanced"), "otherwise than by limbs of a link"),
        (("--mimic",), 'joint "right_finger_slide" is slaved to another'),
    ],
)
def test_what_is_not_certified_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], words: tuple[str, ...], said: str
) -> None:
    given = [ARM, "--certify", "--procs", "1", *words, "--out", str(tmp_path)]
    assert main(given) == 2
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("more", [(), ("--batch",), ("--batch", "--procs", "2")])
def test_closed_loops_are_certified_as_straight_lines(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], more: tuple[str, ...]
) -> None:
    scene = str(MODELS / "fourbar.toml")
    given = [FOURBAR, "--scene", scene, "--certify", "--procs", "1", *more]
    states, found = tmp_path / "states.json", tmp_path / "result.json"
    assert main(["info", FOURBAR, "--scene", scene, "--states", "3"]) == 0
    states.write_text(capsys.readouterr().out)
    assert main(["solve", *given, "--states", str(states), "--result", str(found)]) == 0
    bounds = json.loads(found.read_text())["error_bounds"]
    assert bounds
    assert all(1e-17 < bound < 1e-12 for bound in bounds)
    assert main([*given, "--shape", "kernels", "--out", str(tmp_path / "loops")]) == 2
    assert "robots with closed loops are emitted as straight lines" in capsys.readouterr().err


def test_loops_refuse_what_straight_lines_certify(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    beside = tmp_path / "beside.urdf"
    beside.write_text(BESIDE)
    given = [str(beside), "--certify", "--procs", "1", "--out", str(tmp_path / "out")]
    assert main([*given, "--shape", "kernels"]) == 2
    assert "they certify a floating robot only if it is the only one" in capsys.readouterr().err
    assert main(given) == 0


INERTIA = '<inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/>'
BESIDE = f"""<robot name="beside"><link name="world"/>
<link name="arm"><inertial><mass value="1"/>{INERTIA}</inertial></link>
<link name="drone"><inertial><mass value="1"/>{INERTIA}</inertial></link>
<joint name="turns" type="continuous"><parent link="world"/><child link="arm"/></joint>
<joint name="flies" type="floating"><parent link="world"/><child link="drone"/></joint>
</robot>
"""
