"""Generating through the command line, on small robots."""

from __future__ import annotations

import json
import os
import re
import shutil
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.plan import plan_from_json
from adagen.plan.steps import StartLink
from adagen.urdf import read_robot
from tests.cli.robots import BALL, LINK, Said, write_arm, write_points
from tests.emitted import WRITTEN
from tests.real import real_robot


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
        assert main([str(arm), *words, "--name", "left-arm"]) == 0
        assert main([str(arm), *words, "--name", "left-arm"]) == 0
        assert main([str(arm), *words, "--name", "left_arm"]) == 2
        assert "left_arm_p1 would have the same names as those of" in said()[1]
        after = {path.name: path.read_bytes() for path in out.rglob("*.*")}
        assert {name: after[name] for name in before} == before
        assert len([name for name in after if name.endswith(".cpp")]) == 6
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

    def test_few_digits_of_hard_poses_are_foretold(self, tmp_path: Path, said: Said) -> None:
        """iCub's neck near its singular pose; in ordinary ones nine digits are left."""
        robot = str(real_robot("icub_description/robots/icub.urdf"))
        assert main([robot, "--procs", "1", "--json", "--out", str(tmp_path)]) == 0
        out, err = said()
        (line,) = [row for row in err.splitlines() if "digits are predicted" in row]
        assert "digits are predicted where axes are nearly parallel" in line
        assert '"neck_' in line
        assert json.loads(out)["digits"] > 8 > 4 > json.loads(out)["hard_digits"]

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

    def test_the_time_of_a_state_of_a_batch_is_predicted(
        self, arm: Path, tmp_path: Path, said: Said
    ) -> None:
        words = [str(arm), "--batch", "--out", str(tmp_path / "o")]
        assert main(words) == 0
        err = " ".join(said()[1].split())
        told = re.search(r"(\S+) ns a state predicted \(default profile\)", err)
        assert told is not None and "us predicted" not in err
        assert main([*words, "--json", "--quiet"]) == 0
        predicted = json.loads(said()[0])["predicted_us"]
        assert f"{1e3 * predicted:.3g}" == told[1]
        (source,) = (tmp_path / "o").glob("*_p[0-9]*.cpp")
        assert f"{predicted:.3g} us a state predicted (default profile)" in source.read_text()
        (drawing,) = (tmp_path / "o").glob("*.svg")
        assert f"{predicted:.3g} µs a state predicted (default profile)" in drawing.read_text()
        assert main([*words, "--profile", "paper"]) == 0
        assert "not predicted: the profile paper prices joins alone" in " ".join(said()[1].split())

    def test_the_stages_are_timed_for_who_asks(self, arm: Path, tmp_path: Path, said: Said) -> None:
        assert main([str(arm), "--procs", "2", "--out", str(tmp_path / "o"), "-v"]) == 0
        line = " ".join(said()[1].partition("stages: ")[2].split())  # which may be wrapped
        for stage in ("read", "schedule", "plan", "emit", "write", "total"):
            assert f"{stage} " in line
