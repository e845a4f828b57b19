"""What an emitted program does with its arguments and its input, and what it reports."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.states import read_result, write_states
from tests.emitted import ROUNDING, Builder, Solver, cores, forward_error, states_text, truth_of
from tests.end_to_end.subjects import Subject, subject
from tests.spoilt import SPOILT, Spoilt, spoil


class TestInput:
    @pytest.mark.parametrize("case", SPOILT, ids=lambda case: case.name)
    def test_a_spoilt_states_file_is_refused_with_its_line(
        self, case: Spoilt, builder: Builder, tmp_path: Path
    ) -> None:
        one = subject("arm7_p1", builder, tmp_path)
        good = states_text(one.model, one.states(), tmp_path)
        path = spoil(case, good, one.model.joints[0].name, tmp_path)
        done = one.solver.run("--states", path, "--result", tmp_path / "r.json")
        assert (done.status, done.stdout) == (1, "")
        (line,) = done.stderr.splitlines()
        number = str(case.line) if case.line else ""
        assert line.startswith(f"{path}:{number}")
        assert line.removeprefix(f"{path}:").split(":")[0].isdigit()
        assert case.says in line
        assert not (tmp_path / "r.json").exists()

    def test_the_spoiling_alone_is_what_is_refused(self, builder: Builder, tmp_path: Path) -> None:
        one = subject("arm7_p1", builder, tmp_path)
        good = states_text(one.model, one.states(), tmp_path)
        path = spoil(Spoilt("nothing", ""), good, one.model.joints[0].name, tmp_path)
        assert one.solver.run("--states", path).status == 0

    @pytest.mark.parametrize("name", ["-", "/dev/stdin"])
    def test_states_may_come_through_a_pipe(
        self, name: str, builder: Builder, tmp_path: Path
    ) -> None:
        one = subject("arm7_p1", builder, tmp_path)
        given = tmp_path / "given.json"
        write_states(one.states(), one.model, given)
        command = [str(one.solver.executable), "--states", name]
        done = subprocess.run(
            command, input=given.read_text(), capture_output=True, text=True, timeout=60
        )
        assert (done.returncode, done.stderr) == (0, "")
        assert done.stdout.strip() == one.solver.run("--states", given).stdout.strip()

    def test_a_bad_file_on_several_processes_is_one_line_too(self, human: Subject) -> None:
        path = human.folder / "s.json"
        path.write_text('{"joints": {}}')
        done = human.solver.run("--states", path)
        assert done.status == 1
        assert done.stderr == f'{path}:1: error: joint "root" is missing'

    @pytest.mark.parametrize("what", ["nothing", "folder"])
    def test_a_file_that_cannot_be_read_is_told(self, arm: Subject, what: str) -> None:
        path = arm.folder if what == "folder" else arm.folder / "none.json"
        done = arm.solver.run("--states", path)
        assert (done.status, done.stdout) == (1, "")
        assert done.stderr == f"{path}: error: cannot read the states file"

    def test_a_result_that_cannot_be_written_is_status_3(self, arm: Subject) -> None:
        write_states(arm.states(), arm.model, arm.folder / "s.json")
        target = arm.folder / "none" / "r.json"
        done = arm.solver.run("--states", arm.folder / "s.json", "--result", target)
        assert done.status == 3
        assert done.stderr == f"{target}: error: cannot write the result"

    def test_types_and_answers_in_the_file_are_passed_over(self, arm: Subject) -> None:
        data = states_text(arm.model, arm.states(), arm.folder)
        for values in data["joints"].values():
            values.update(type="revolute", qdd=[[1, {"a": None}], "x", True, 1e5])
        path = arm.folder / "s.json"
        path.write_text(json.dumps(data))
        assert arm.solver.run("--states", path).status == 0

    def test_members_in_any_order_give_the_same(self, arm: Subject) -> None:
        data = states_text(arm.model, arm.states(), arm.folder)
        first = arm.solver.run("--states", arm.folder / "good.json").stdout
        turned = {k: data[k] for k in reversed(data)}
        turned["joints"] = dict(reversed(data["joints"].items()))
        (arm.folder / "s.json").write_text(json.dumps(turned, indent=3))
        assert arm.solver.run("--states", arm.folder / "s.json").stdout == first


class TestNumbers:
    def test_a_velocity_that_overflows_names_a_joint(self, human: Subject) -> None:
        states = human.states()
        states.v[1, :] = 1e200
        line = human.refuses(states)
        assert line.startswith('state 2: joint "')
        assert "not a finite number" in line or "factorization failed" in line

    @pytest.mark.parametrize("field", ["q", "v", "tau"])
    def test_what_the_scalar_cannot_hold_is_not_finite(
        self, field: str, builder: Builder, tmp_path: Path
    ) -> None:
        arm = subject("arm7_float_p2", builder, tmp_path)
        for j in (0, 4, 8):
            states = arm.states()
            getattr(states, field)[1, j] = 1e39  # finite in double, not in float
            name = arm.model.joints[j].name
            line = f'state 2: joint "{name}": its q, v or tau is not a finite number'
            assert arm.refuses(states) == line

    @pytest.mark.parametrize("size", [0.0, 1e-200, 1e200])
    def test_a_quaternion_that_cannot_be_normalised_names_its_joint(
        self, human: Subject, size: float
    ) -> None:
        states = human.states()
        write_states(states, human.model, human.folder / "s.json")
        data = json.loads((human.folder / "s.json").read_text())
        for name in ("left_wrist", "root"):
            spoilt = json.loads(json.dumps(data))
            spoilt["joints"][name]["q"][0][-4:] = [size, 0.0, 0.0, 0.0]
            (human.folder / "z.json").write_text(json.dumps(spoilt))
            done = human.solver.run("--states", human.folder / "z.json")
            assert (done.status, done.stdout) == (1, "")
            expected = f'state 1: joint "{name}": its quaternion cannot be normalised'
            assert done.stderr == f"{human.folder}/z.json: error: {expected}"

    def test_a_quaternion_is_normalised(self, human: Subject) -> None:
        states = human.states()
        expected = human.solver.solve(human.model, states, human.folder)
        data = json.loads((human.folder / "states.json").read_text())
        for values in data["joints"].values():
            if len(values["q"][0]) if isinstance(values["q"][0], list) else 0:
                for row in values["q"]:
                    row[-4:] = [3.5 * x for x in row[-4:]]
        (human.folder / "n.json").write_text(json.dumps(data))
        result = human.folder / "n_result.json"
        done = human.solver.run("--states", human.folder / "n.json", "--result", result)
        assert done.status == 0
        found = read_result(result, human.model)
        assert forward_error(found, expected) < ROUNDING["double"]  # 3.5 x is rounded

    def test_an_acceleration_at_the_edge_of_double_is_right_or_an_error(self, arm: Subject) -> None:
        states = arm.states(1)
        states.tau[0, 0] = 1e308
        assert arm.refuses(states).startswith('state 1: joint "')

    def test_slaved_joints_follow_whatever_the_file_gives(
        self, builder: Builder, tmp_path: Path
    ) -> None:
        arm = subject("arm7_slaved_p2", builder, tmp_path)
        states = arm.states()
        found = arm.solver.solve(arm.model, states, tmp_path)
        assert forward_error(found, truth_of(arm.model, states)) < ROUNDING["double"]
        data = json.loads((tmp_path / "states.json").read_text())
        del data["joints"]["right_finger_slide"]
        (tmp_path / "less.json").write_text(json.dumps(data))
        done = arm.solver.run("--states", tmp_path / "less.json", "--result", tmp_path / "l.json")
        assert done.status == 0
        given = np.array(states.tau[:, 8])
        states.tau[:, 8] = 0.0  # what is left out is no torque
        assert np.any(given != 0.0)
        less = read_result(tmp_path / "l.json", arm.model)
        assert forward_error(less, truth_of(arm.model, states)) < ROUNDING["double"]


class TestUsage:
    @pytest.mark.parametrize(
        ("words", "says"),
        [
            (["--fast"], "unknown option --fast"),
            (["states.json"], "unknown option states.json"),
            (["--states"], "--states needs a value"),
            (["--result", "r.json"], "--result needs --states"),
            (["--repeat", "0"], "--repeat takes"),
            (["--repeat", "1.5"], "--repeat takes"),
            (["--repeat", "many"], "--repeat takes"),
            (["--seed", "-1"], "--seed takes"),
            (["--seed", "1e300"], "--seed takes"),
            (["--timeout", "0"], "--timeout takes"),
            (["--timeout", "1e300"], "--timeout takes"),
            (["--timeout", "nan"], "--timeout takes"),
            (["--tolerance", "inf"], "--tolerance takes"),
            (["--channel", "pigeon"], "--channel takes auto, window or message"),
            (["--states", "s.json", "--json"], "--json needs --result"),
            (["--states", "-"], "standard input is for solvers of one process"),
            (["--states", "/dev/stdin"], "standard input is for solvers of one process"),
        ],
    )
    def test_a_wrong_command_line_is_status_2_and_one_line(
        self, words: list[str], says: str, arm: Subject
    ) -> None:
        done = arm.solver.run(*words)
        assert (done.status, done.stdout) == (2, "")
        (line,) = done.stderr.splitlines()
        assert line.startswith("error: ") and says in line and line.endswith("see --help")

    @pytest.mark.parametrize("count", [1, 3])
    def test_the_wrong_number_of_processes_is_status_2(self, count: int, arm: Subject) -> None:
        done = Solver(arm.solver.executable, count, arm.solver.toolchain).run("--check")
        assert (done.status, done.stdout) == (2, "")
        assert done.stderr == (
            f"error: this solver is for exactly 2 processes, started with {count}: use mpiexec -n 2"
        )

    def test_help_tells_every_option_on_any_number_of_processes(self, arm: Subject) -> None:
        for count in (1, 2):
            done = Solver(arm.solver.executable, count, arm.solver.toolchain).run("--help")
            assert (done.status, done.stderr) == (0, "")
            assert done.stdout.startswith("usage: mpiexec -n 2 ")
            for option in ("states", "result", "check", "time", "repeat", "seed", "tolerance",
                           "channel", "hosts", "timeout", "no-pin", "stretches", "json",
                           "help"):  # fmt: skip
                assert f"  --{option} " in done.stdout


class TestReports:
    def report(self, done: Any) -> dict[str, Any]:
        assert (done.status, done.stderr) == (0, "")
        data = json.loads(done.stdout)
        assert isinstance(data, dict)
        return data

    def test_json_has_check_and_time(self, arm: Subject) -> None:
        told = self.report(arm.solver.run("--json", "--repeat", "3"))
        assert list(told) == ["model", "processes", "channel", "check", "time"]
        assert (told["model"], told["processes"], told["channel"]) == ("arm7", 2, "window")
        assert told["check"]["ok"] is True
        check = told["check"]
        assert 0 < check["residual_median"] <= check["residual_max"] < 1e-12
        assert 0 < check["backward_error_median"] <= check["backward_error_max"] < 1e-14
        assert check["tolerance"] == 1e-9
        assert (check["digits"] > 12, check["forward_error"] < 1e-12) == (True, True)
        assert check["fault"] is None
        assert told["time"]["source"] == ("clock" if cores() >= 2 else "stretches")
        assert told["time"]["evaluations"] == 192
        assert told["time"]["pinned"] in (True, False)
        for way in ("in_place", "through_root"):
            figures = told["time"][way]
            assert set(figures) == {"median_ns", "min_ns", "p99_ns", "middle_ns"}
            assert 0 < figures["min_ns"] <= figures["median_ns"] <= figures["p99_ns"]
            assert figures["min_ns"] <= figures["middle_ns"] + 1 <= figures["p99_ns"] + 2

    def test_json_of_solved_states(self, arm: Subject) -> None:
        write_states(arm.states(5), arm.model, arm.folder / "s.json")
        words = ["--states", str(arm.folder / "s.json"), "--result", str(arm.folder / "r.json")]
        told = self.report(arm.solver.run(*words, "--json", "--channel", "message"))
        assert told == {"model": "arm7", "processes": 2, "channel": "message", "solved": 5}

    def test_a_check_that_fails_is_status_1_and_says_so(self, arm: Subject) -> None:
        done = arm.solver.run("--check", "--tolerance", "0")
        assert done.status == 1
        assert "of 0e+00: WRONG\ncheck  the solver is at fault: state " in done.stdout
        done = arm.solver.run("--check", "--tolerance", "0", "--json")
        assert json.loads(done.stdout)["check"]["ok"] is False

    def test_the_seed_decides_the_random_states(self, arm: Subject) -> None:
        def residual(seed: int) -> object:
            words = ("--check", "--json", "--seed", str(seed))
            return json.loads(arm.solver.run(*words).stdout)["check"]

        assert residual(1) == residual(1) != residual(2)

    def test_results_go_to_standard_output_or_to_the_file(self, arm: Subject) -> None:
        states = arm.states(3)
        found = arm.solver.solve(arm.model, states, arm.folder)
        done = arm.solver.run("--states", arm.folder / "states.json", "--check")
        assert done.status == 0 and "check  backward error" in done.stderr
        assert done.stdout == (arm.folder / "result.json").read_text()
        assert found.shape == (3, arm.model.nv)
        joints = json.loads(done.stdout)["joints"]
        assert [*joints] == [joint.name for joint in arm.model.joints]

    def test_every_number_of_a_result_reads_back_bit_by_bit(self, arm: Subject) -> None:
        states = arm.states(3)
        one = arm.solver.solve(arm.model, states, arm.folder)
        again = arm.solver.solve(arm.model, states, arm.folder, "--channel", "message")
        assert np.array_equal(one, again)
