"""Generating, scheduling and solving through the command line, on small robots."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from adagen.build import find_toolchain
from adagen.cli import main
from adagen.plan import plan_from_json
from adagen.plan.steps import StartLink
from adagen.reference import forward_dynamics
from adagen.states import random_states, read_result, write_states
from adagen.urdf import read_robot
from tests.emitted import WRITTEN

LINK = (
    '<link name="{name}"><inertial><mass value="1.5"/><origin xyz="0.01 0.02 0.1"/>'
    '<inertia ixx="0.02" iyy="0.03" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>'
)
JOINT = (
    '<joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{child}"/>'
    '<axis xyz="{axis}"/><origin xyz="0 0.1 0.3"/></joint>'
)
Said = Callable[[], tuple[str, str]]


def write_arm(path: Path, joints: int = 3, name: str = "arm") -> Path:
    """Write a chain whose axes are not parallel."""
    parts = [LINK.format(name="l0")]
    for j in range(joints):
        parts.append(LINK.format(name=f"l{j + 1}"))
        axis = ("1 0 0", "0 1 0", "0 0 1")[j % 3]
        parts.append(JOINT.format(name=f"j{j}", parent=f"l{j}", child=f"l{j + 1}", axis=axis))
    path.write_text(f'<robot name="{name}">{"".join(parts)}</robot>')
    return path


def write_points(path: Path) -> Path:
    """Write a chain of six point masses at the ends of rods; axes are across the rods."""
    text = write_arm(path, 6).read_text()
    text = re.sub(r'\b(i[xyz]{2})="[^"]*"', r'\1="0"', text)
    text = text.replace("0.01 0.02 0.1", "0 0 0.3").replace("0 0.1 0.3", "0 0 0.3")
    path.write_text(text.replace('axis xyz="0 0 1"', 'axis xyz="1 0 0"'))
    return path


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    return write_arm(tmp_path / "arm.urdf")


@pytest.fixture
def said(capsys: pytest.CaptureFixture[str]) -> Said:
    """What was said to stdout and stderr since the last call."""

    def read() -> tuple[str, str]:
        out, err = capsys.readouterr()
        return out, err

    return read


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cache of builds: what one test has built serves the others."""
    return tmp_path_factory.mktemp("cache")


_BODY = (
    '<inertial><origin xyz="0 0 {}"/><mass value="{}"/>'
    '<inertia ixx="{}" iyy="{}" izz="{}" ixy="0" ixz="0" iyz="0"/></inertial>'
)
BALL = f"""<robot name="ball"><link name="base"/>
<link name="light">{_BODY.format(0, 1e-6, 1e-13, 1e-13, 1e-13)}</link>
<link name="rod">{_BODY.format(0.15, 1, 0.0075, 0.0075, 0.0002)}</link>
<link name="tip">{_BODY.format(0.15, 1, 0.0075, 0.0075, 0.0002)}</link>
<joint name="ball" type="spherical"><parent link="base"/><child link="light"/></joint>
<joint name="along" type="continuous"><parent link="light"/><child link="rod"/><axis xyz="0 0 1"/>
</joint><joint name="across" type="continuous"><parent link="rod"/><child link="tip"/>
<origin xyz="0 0 0.3"/><axis xyz="0 1 0"/></joint></robot>"""
"""A ball joint that moves hardly any mass about the axis of the next joint."""


class TestGenerate:
    def test_the_files_are_written_and_told(self, arm: Path, tmp_path: Path, said: Said) -> None:
        out = tmp_path / "out"
        assert main([str(arm), "--procs", "2", "--out", str(out)]) == 0
        names = {f"arm_p2.{ending}" for ending in ("cpp", "h", "pc", "plan.json", "svg")}
        names |= {"adagen", "adagen_program.cpp", "Makefile", "CMakeLists.txt"}
        assert {p.name for p in out.iterdir()} == names
        stdout, stderr = said()
        assert stdout == ""
        assert all(name in stderr for name in names)
        assert "us predicted" in stderr
        json.loads((out / "arm_p2.plan.json").read_text())
        ET.fromstring((out / "arm_p2.svg").read_text())

    def test_no_machine_path_and_the_same_bytes_anywhere(self, arm: Path, tmp_path: Path) -> None:
        elsewhere = tmp_path / "elsewhere"
        elsewhere.mkdir()
        other = elsewhere / arm.name
        other.write_bytes(arm.read_bytes())
        for model in (arm, other):
            assert main([str(model), "--procs", "2", "--out", str(model.parent / "out")]) == 0
        for file in (tmp_path / "out").rglob("*.*"):
            there = elsewhere / "out" / file.relative_to(tmp_path / "out")
            assert file.read_bytes() == there.read_bytes()
            assert str(tmp_path) not in file.read_text()

    def test_generating_again_replaces_and_keeps_other_files(
        self, arm: Path, tmp_path: Path
    ) -> None:
        (tmp_path / "out").mkdir()
        (tmp_path / "out" / "notes.txt").write_text("mine")
        for _ in range(2):
            assert main([str(arm), "--procs", "2", "--out", str(tmp_path / "out")]) == 0
        assert (tmp_path / "out" / "notes.txt").read_text() == "mine"

    def test_what_is_right_already_is_left_as_it_is(self, arm: Path, tmp_path: Path) -> None:
        words = [str(arm), "--procs", "2", "--out", str(tmp_path / "out")]
        assert main(words) == 0
        for path in (tmp_path / "out").rglob("*.*"):
            os.utime(path, (1e9, 1e9))
        assert main(words) == 0
        assert {path.stat().st_mtime for path in (tmp_path / "out").rglob("*.*")} == {1e9}
        assert main([*words, "--scalar", "float"]) == 0
        renewed = {p.name for p in (tmp_path / "out").rglob("*.*") if p.stat().st_mtime != 1e9}
        assert "arm_p2.cpp" in renewed
        assert not renewed & {"Makefile", "CMakeLists.txt", "adagen_program.cpp"}

    def test_solvers_of_one_folder_leave_each_other_alone(
        self, arm: Path, tmp_path: Path, said: Said
    ) -> None:
        other = tmp_path / "other" / arm.name
        other.parent.mkdir()
        other.write_text(arm.read_text().replace('mass value="', 'mass value="1'))
        out = tmp_path / "out"
        words = ["--procs", "1", "--out", str(out)]
        assert main([str(arm), *words]) == 0
        before = {path.name: path.read_bytes() for path in out.rglob("*.*")}
        assert main([str(other), *words]) == 2
        assert "arm_p1.cpp was made of another robot, ../arm.urdf; choose" in said()[1]
        assert main([str(other), *words, "--name", "heavy"]) == 0
        assert main([str(arm), *words, "--name", "arm" * 20]) == 0
        assert main([str(arm), *words, "--name", "arm" * 20 + "x"]) == 0
        after = {path.name: path.read_bytes() for path in out.rglob("*.*")}
        assert {name: after[name] for name in before} == before
        assert len([name for name in after if name.endswith(".cpp")]) == 5
        shutil.copy(arm, tmp_path / "moved.urdf")  # the same robot, from another place
        assert main([str(tmp_path / "moved.urdf"), *words, "--name", "arm"]) == 0

    def test_a_makefile_of_somebody_else_is_left(
        self, arm: Path, tmp_path: Path, said: Said
    ) -> None:
        (tmp_path / "Makefile").write_text("all: ; my own\n")
        assert main([str(arm), "--procs", "2", "--out", str(tmp_path)]) == 2
        assert "was not written by adagen" in said()[1]
        assert sorted(p.name for p in tmp_path.iterdir()) == ["Makefile", "arm.urdf"]

    @pytest.mark.parametrize("name", ["../escape", "/etc/x", "a b\n", "-", "é", "."])
    def test_a_hostile_name_stays_in_the_folder(self, name: str, arm: Path, tmp_path: Path) -> None:
        out = tmp_path / "deep" / "out"
        words = [str(arm), "--procs", "1", "--out", str(out), f"--name={name}"]
        assert main(words) == 0
        assert len(list(out.iterdir())) == WRITTEN
        assert [p.name for p in (tmp_path / "deep").iterdir()] == ["out"]

    def test_a_refused_robot_writes_nothing(self, tmp_path: Path, said: Said) -> None:
        bad = tmp_path / "bad.urdf"
        bad.write_text("<robot name='x'><link")
        assert main([str(bad), "--procs", "2", "--out", str(tmp_path / "out")]) == 1
        stdout, stderr = said()
        assert stdout == ""
        assert stderr.startswith(f"{bad}:1: error: ") and stderr.count("\n") == 1
        assert not (tmp_path / "out").exists()

    def test_gravity_and_base_reach_the_plan(self, arm: Path, tmp_path: Path) -> None:
        words = [str(arm), "--procs", "1", "--out", str(tmp_path / "o"), "--floating"]
        assert main([*words, "--gravity", "0", "-1.5", "0"]) == 0
        text = (tmp_path / "o" / "arm_p1.plan.json").read_text()
        plan = json.loads(text)
        assert plan["gravity"] == [0.0, -1.5, 0.0]
        assert plan["floating"] is True

    @pytest.mark.parametrize("processes", ["1", "2", "auto"])
    @pytest.mark.parametrize("form", ["segment", "ada"])
    def test_a_mixed_solver_is_told_like_any_other(
        self, form: str, processes: str, arm: Path, tmp_path: Path, said: Said
    ) -> None:
        how = ["--procs", processes, "--form", form, "--scalar", "mixed"]
        assert main([str(arm), *how, "--out", str(tmp_path / "o")]) == 0
        assert "us predicted" in said()[1]
        assert main(["schedule", str(arm), *how]) == 0
        assert "us predicted" in said()[0]

    def test_lost_digits_are_foretold(self, tmp_path: Path, said: Said) -> None:
        """A link of a microgram between two of 1.5 kg."""
        text = write_arm(tmp_path / "arm.urdf").read_text()
        assert main([str(tmp_path / "arm.urdf"), "--procs", "2", "--out", str(tmp_path / "a")]) == 0
        assert "digits are predicted" not in said()[1]
        light = LINK.format(name="l2")
        for number in ("1.5", "0.02", "0.03", "0.01"):
            light = light.replace(f'="{number}"', f'="{number}e-9"')
        (tmp_path / "b.urdf").write_text(text.replace(LINK.format(name="l2"), light))
        words = ["--procs", "2", "--form", "ada", "--out", str(tmp_path / "b")]
        assert main([str(tmp_path / "b.urdf"), *words]) == 0
        (line,) = [row for row in said()[1].splitlines() if "digits are predicted" in row]
        assert line.startswith(f"{tmp_path / 'b.urdf'}: warning: ")
        assert "form segment keeps more digits" in line

    def test_few_digits_of_form_segment_are_foretold(self, tmp_path: Path, said: Said) -> None:
        robot = tmp_path / "ball.urdf"
        robot.write_text(BALL)
        words = [str(robot), "--procs", "1", "--out", str(tmp_path / "a"), "--shape"]
        assert main([*words, "unrolled"]) == 0
        assert "digits are predicted" not in said()[1]
        assert main([*words, "kernels", "--refine", "1"]) == 0
        assert "digits are predicted" not in said()[1]
        assert main([*words, "kernels"]) == 0
        (line,) = [row for row in said()[1].splitlines() if "digits are predicted" in row]
        assert re.search(r'\d\.\d digits are predicted; the largest loss is at joint "\w+"; ', line)
        assert line.endswith("--shape unrolled or --refine 1 may keep more")

    def test_a_link_that_cannot_be_inverted_is_joined_with_its_neighbour_in_form_ada(
        self, tmp_path: Path
    ) -> None:
        text = write_arm(tmp_path / "arm.urdf").read_text()
        point = LINK.format(name="l2")
        for number in ("0.02", "0.03", "0.01"):
            point = point.replace(f'="{number}"', '="0"')
        (tmp_path / "b.urdf").write_text(text.replace(LINK.format(name="l2"), point))
        words = ["--procs", "2", "--form", "ada", "--out", str(tmp_path / "b")]
        assert main([str(tmp_path / "b.urdf"), *words]) == 0
        plan = plan_from_json((tmp_path / "b" / "b_p2.plan.json").read_text())
        steps = [step for process in plan.processes for step in process.steps]
        assert any(isinstance(step, StartLink) and step.link == 2 for step in steps)

    def test_a_named_schedule_that_cuts_where_that_fails_is_refused_by_the_cut(
        self, tmp_path: Path, said: Said
    ) -> None:
        words = [str(write_points(tmp_path / "b.urdf")), "--out", str(tmp_path / "b")]
        assert main([*words, "--procs", "2", "--schedule", "middle-out"]) == 1
        line = said()[1].splitlines()[-1]
        start = f"{words[0]}: error: --schedule middle-out lets processes meet at "
        assert line.startswith(start + '"j2", beside links')
        assert line.endswith("leave out --schedule, or use --procs 1")
        assert not (tmp_path / "b").exists()
        assert main([*words, "--procs", "2"]) == 0
        assert main([*words, "--procs", "1", "--schedule", "middle-out"]) == 0

    def test_a_robot_of_one_cluster_has_no_order_to_name(self, tmp_path: Path, said: Said) -> None:
        words = [str(write_points(tmp_path / "b.urdf")), "--procs", "2", "--form", "ada"]
        words += ["--out", str(tmp_path / "b")]
        assert main([*words, "--schedule", "balanced"]) == 1
        assert "form ada treats all links of this robot as one" in said()[1]
        assert main(words) == 0

    def test_as_json(self, arm: Path, tmp_path: Path, said: Said) -> None:
        folder = tmp_path / "out"
        assert main([str(arm), "--procs", "2", "--out", str(folder), "--json", "--quiet"]) == 0
        out, err = said()
        told = json.loads(out)
        assert "wrote" not in err
        assert (told["robot"], told["processes"]) == (read_robot(arm).model.name, 2)
        assert sorted(told["files"]) == sorted(map(str, folder.iterdir()))
        assert told["source"] in told["files"] and told["source"].endswith("_p2.cpp")
        assert told["predicted_us"] > 0.0 and told["digits"] > 9.0
        assert told["warnings"] == err.splitlines()

    def test_the_stages_are_timed_for_who_asks(self, arm: Path, tmp_path: Path, said: Said) -> None:
        assert main([str(arm), "--procs", "2", "--out", str(tmp_path / "o"), "-v"]) == 0
        (line,) = [row for row in said()[1].splitlines() if row.startswith("stages: ")]
        for stage in ("read", "schedule", "plan", "emit", "write", "total"):
            assert f"{stage} " in line


class TestSchedule:
    def test_for_people(self, arm: Path, said: Said) -> None:
        assert main(["schedule", str(arm), "--procs", "2"]) == 0
        stdout, stderr = said()
        assert all(f"j{j}" in stdout for j in range(3))
        assert re.search(r"0\.\d+ us predicted \(default profile", stdout)
        assert "2 processes do not pay: predicted" in stderr and stderr.count("warning:") == 1

    def test_as_json_and_back(self, arm: Path, tmp_path: Path, said: Said) -> None:
        assert main(["schedule", str(arm), "--procs", "2", "--json"]) == 0
        text = said()[0]
        told = json.loads(text)
        assert told["verdict"] == "optimal"
        (tmp_path / "s.json").write_text(text)
        words = ["schedule", str(arm), "--procs", "2", "--json"]
        assert main([*words, "--schedule", str(tmp_path / "s.json")]) == 0
        again = json.loads(said()[0])
        assert again["root"] == told["root"]
        assert again["makespan"] == told["makespan"]

    def test_a_schedule_for_other_processes_is_refused(
        self, arm: Path, tmp_path: Path, said: Said
    ) -> None:
        assert main(["schedule", str(arm), "--procs", "2", "--json"]) == 0
        (tmp_path / "s.json").write_text(said()[0])
        words = ["schedule", str(arm), "--procs", "1", "--schedule", str(tmp_path / "s.json")]
        assert main(words) == 1
        assert "is for 2 processes, not 1" in said()[1]

    @pytest.mark.parametrize("name", ["auto", "balanced", "sequential", "middle-out"])
    def test_by_name(self, name: str, arm: Path, said: Said) -> None:
        words = ["schedule", str(arm), "--procs", "2", "--schedule", name, "--json"]
        assert main(words) == 0
        told = json.loads(said()[0])
        assert told["strategy"] == ("exact" if name == "auto" else name)
        assert len(told["loads"]) == 2

    def test_drawn(self, arm: Path, tmp_path: Path) -> None:
        assert main(["schedule", str(arm), "--procs", "2", "--svg", str(tmp_path / "t.svg")]) == 0
        assert ET.fromstring((tmp_path / "t.svg").read_text()).tag.endswith("svg")

    @pytest.mark.parametrize("words", [["--profile", "none"], ["--schedule", "none"]])
    def test_a_file_that_is_not_there_is_told(
        self, words: list[str], arm: Path, said: Said
    ) -> None:
        assert main(["schedule", str(arm), "--procs", "2", *words]) == 2
        stderr = said()[1]
        assert "error: " in stderr and "none" in stderr and stderr.count("\n") == 1


class TestSolve:
    @pytest.fixture(autouse=True)
    def _cache(self, cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setenv("XDG_CACHE_HOME", str(cache))
        monkeypatch.setenv("CXXFLAGS", "-O1")  # the compiler's time, not the program's

    @pytest.mark.parametrize("processes", ["2", "3", "auto"])
    def test_states_of_a_batch_are_shared_by_the_processes(
        self, processes: str, arm: Path, tmp_path: Path
    ) -> None:
        model = read_robot(arm).model
        states = random_states(model, 40)
        write_states(states, model, tmp_path / "states.json")
        words = ["solve", str(arm), "--procs", processes, "--batch"]
        words += ["--states", str(tmp_path / "states.json")]
        assert main([*words, "--result", str(tmp_path / "r.json")]) == 0
        found = read_result(tmp_path / "r.json", model)
        for q, v, tau, qdd in zip(states.q, states.v, states.tau, found, strict=True):
            np.testing.assert_allclose(qdd, forward_dynamics(model, q, v, tau), rtol=1e-10)

    @pytest.mark.parametrize("processes", [1, 2])
    def test_right_accelerations_and_a_second_call_without_a_compiler(
        self, processes: int, arm: Path, tmp_path: Path, said: Said, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        model = read_robot(arm, gravity=[0.0, 1.0, -3.0]).model
        states = random_states(model, 4)
        write_states(states, model, tmp_path / "states.json")
        words = ["solve", str(arm), "--procs", str(processes)]
        words += ["--states", str(tmp_path / "states.json"), "-v"]
        assert main([*words, "--result", str(tmp_path / "r.json")]) == 0
        assert "build " in said()[1]
        found = read_result(tmp_path / "r.json", model)
        for q, v, tau, qdd in zip(states.q, states.v, states.tau, found, strict=True):
            np.testing.assert_allclose(qdd, forward_dynamics(model, q, v, tau), rtol=1e-10)

        def no_compiler(*_: object) -> None:
            raise AssertionError("it was compiled again")

        monkeypatch.setattr("adagen.build.cache._compile", no_compiler)
        assert main(words) == 0
        assert said()[0] == (tmp_path / "r.json").read_text()

    def test_states_of_another_robot_are_refused_before_anything_is_built(
        self, arm: Path, tmp_path: Path, said: Said, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
        states = tmp_path / "states.json"
        states.write_text('{"joints": {"j9": {"q": [0], "v": [0], "tau": [0]}}}')
        assert main(["solve", str(arm), "--procs", "1", "--states", str(states)]) == 1
        stdout, stderr = said()
        assert stdout == ""
        assert stderr.startswith(f"{states}") and "j9" in stderr
        assert not (tmp_path / "cache").exists()

    def test_a_compiler_that_fails_is_status_3(
        self, arm: Path, tmp_path: Path, said: Said, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("CXXFLAGS", "-no-such-option")
        model = read_robot(arm).model
        write_states(random_states(model, 1), model, tmp_path / "states.json")
        words = ["solve", str(arm), "--procs", "1", "--states", str(tmp_path / "states.json")]
        assert main(words) == 3
        assert "no-such-option" in said()[1]

    def test_a_run_over_its_time_is_status_3(self, arm: Path, tmp_path: Path, said: Said) -> None:
        model = read_robot(arm).model
        write_states(random_states(model, 1), model, tmp_path / "states.json")
        words = ["solve", str(arm), "--procs", "2", "--states", str(tmp_path / "states.json")]
        assert main([*words, "--timeout", "0.001"]) == 3
        assert "no answer within 0.001 s" in said()[1]


@pytest.mark.parametrize("words", [("--procs", "1"), ("--procs", "2", "--scalar", "float")])
def test_a_single_file_stands_alone(words: tuple[str, ...], arm: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert main([str(arm), *words, "--single-file", "--out", str(out)]) == 0
    assert not (out / "adagen_program.cpp").exists()
    (source,) = out.glob("*.cpp")
    assert "// links " not in source.read_text()
    assert main(["verify", str(out)]) == 0
    toolchain = find_toolchain()
    command = [
        "make",
        "-C",
        str(out),
        f"MPICXX={toolchain.mpicxx[0]}",
        "CXXFLAGS=-O0 -Wall -Wextra",
    ]
    command += [f"MPIEXEC={toolchain.mpiexec[0]}", "check"]
    environment = toolchain.variables(os.environ)
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=300)
    assert (done.returncode, done.stderr) == (0, "")
    assert ": right" in done.stdout


@pytest.mark.parametrize(("processes", "form"), [(1, "segment"), (2, "ada")])
def test_the_emitted_makefile_builds_and_checks(
    processes: int, form: str, arm: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    assert main([str(arm), "--procs", str(processes), "--form", form, "--out", str(out)]) == 0
    toolchain = find_toolchain()
    source = next(out.glob("*_p[0-9]*.cpp")).read_text()
    # Joints by themselves are told in 6x6 blocks; a straight line needs no Eigen.
    assert ("Eigen" in source) == (processes == 2)
    command = [
        "make",
        "-C",
        str(out),
        f"MPICXX={toolchain.mpicxx[0]}",
        f"MPIEXEC={toolchain.mpiexec[0]}",
        f"EIGEN={toolchain.eigen if processes == 2 else 'nowhere'}",
        "CXXFLAGS=-O1 -Wall -Wextra -Wpedantic -Werror",
        "check",
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    assert "right" in done.stdout
