"""Exit statuses and messages of the command line as a whole."""

from __future__ import annotations

import json
import os
import re
import shlex
import signal
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

import pytest

import adagen
from adagen.cli import env, main
from adagen.cli.main import ALONE, VERBS
from adagen.errors import InputError

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def _no_debugging(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ADAGEN_DEBUG", raising=False)


def run(*words: str) -> subprocess.CompletedProcess[str]:
    variables = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "adagen", *words]
    return subprocess.run(command, capture_output=True, text=True, env=variables, timeout=60)


def fail_with(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> None:
    def run(_: Sequence[str]) -> NoReturn:
        raise error

    monkeypatch.setattr(env, "run", run)


def test_numpy_computes_on_one_core_unless_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(ALONE)
    assert (main(["--version"]), os.environ[ALONE]) == (0, "1")
    monkeypatch.setenv(ALONE, "2")
    assert (main(["--version"]), os.environ[ALONE]) == (0, "2")


class TestUsage:
    @pytest.mark.parametrize(
        ("words", "said"),
        [
            ([], "required: MODEL"),
            (["robot.urdf", "--procs", "0"], "from 1 to"),
            (["robot.urdf", "--procs", "-2"], "argument --procs"),
            (["robot.urdf", "--procs", "two"], "from 1 to"),
            (["robot.urdf", "--procs", "2.0"], "from 1 to"),
            (["robot.urdf", "--procs", "99999999999999999999"], "from 1 to"),
            (["robot.urdf", "--procs", "٢"], "from 1 to"),
            (["robot.urdf", "--proc", "2"], "unknown option --proc (did you mean --procs?); see"),
            (["robot.urdf", "-procs", "2"], "unknown option -procs (did you mean --procs?)"),
            (["robot.urdf", "--processes=2"], "--processes=2 (did you mean --procs?)"),
            (["robot.urdf", "--procs", "2", "--shapes", "joints"], "did you mean --shape?"),
            (["robot.urdf", "--procs", "two", "--flaoting"], "did you mean --floating?"),
            (["robot.urdf", "--procs", "2", "--zzz"], "unknown option --zzz; see adagen --help"),
            (["schedule", "r.urdf", "--jsn"], "--jsn (did you mean --json?); see adagen schedule"),
            (["chart", "r.urdf", "--quik"], "did you mean --quick?"),
            (["robot.urdf", "--vesion"], "did you mean --version?"),
            (["robot.urdf", "--procs", "2", "--gravity", "0", "0", "nan"], "not a finite number"),
            (["robot.urdf", "--procs", "2", "--gravity", "0", "0"], "expected 3 arguments"),
            (["robot.urdf", "--procs", "2", "--form", "other"], "invalid choice"),
            (["robot.urdf", "--procs", "2", "--channel", "pigeon"], "invalid choice"),
            (["robot.urdf", "--procs", "2", "more"], "unrecognized arguments: more"),
            (["schedule", "robot.urdf", "--procs", "0"], "adagen schedule --help"),
            (["solve", "robot.urdf", "--procs", "2"], "required: --states"),
            (["solve", "r", "--procs", "2", "--states", "s", "--timeout", "0"], "more than 0 s"),
            (["env", "--mpicxx", "--eigen"], "not allowed with"),
            (["r.urdf", "--procs", "2", "--name=--"], "cannot have the value --"),
            (["r.urdf", "--procs", "2", "a\nb"], "a\\nb"),
            (["schedul", "robot.urdf", "--procs", "2"], "did you mean 'schedule'?"),
            (["benchmark", "robot.urdf"], "did you mean 'bench'?"),
            (
                ["compile", "robot.urdf", "--procs", "2"],
                "to write a solver: adagen MODEL [--out DIR]",
            ),
            (["compile"], "commands: info, schedule, solve, verify, calibrate, env"),
            (["r.urdf", "--procs", "2", "--batch", "--refine", "1"], "batches are not refined"),
            (["r.urdf", "--procs", "2", "--batch", "--shape", "joints"], "in shapes kernels"),
            (["r.urdf", "--procs", "2", "--shape", "joints"], "add --form ada, or take shape"),
            (["r.urdf", "--procs", "2", "--tuned", "joints:0:"], "add --form ada, or take shape"),
            (["r.urdf", "--procs", "2", "--batch", "--tune"], "batches are not tuned"),
            (["r.urdf", "--procs", "2", "--naive"], "--naive is for --strategy astar or paper"),
            (["r.urdf", "--procs", "2", "--schedule", "balanced", "--tie", "lex"], "--tie is for"),
            (["chart", "r.urdf", "--step", "0.1"], "--step is for --simulate"),
        ],
    )
    def test_a_wrong_command_line_is_one_line_and_status_2(
        self, words: list[str], said: str, capsys: pytest.CaptureFixture[str]
    ) -> None:
        assert main(words) == 2
        told = capsys.readouterr()
        assert told.out == ""
        assert told.err.startswith("error: ")
        assert said in told.err
        assert told.err.count("\n") == 1

    def test_the_process_itself_says_the_same(self) -> None:
        done = run("robot.urdf", "--procs", "0")
        assert (done.returncode, done.stdout) == (2, "")
        assert done.stderr.startswith("error: ") and "Traceback" not in done.stderr

    def test_help_fits_a_screen_and_help_all_has_the_rest(
        self, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("COLUMNS", "80")
        assert main(["--help"]) == 0
        short = capsys.readouterr().out
        assert len(short.splitlines()) < 24  # with the prompt below
        assert max(map(len, short.splitlines())) <= 80
        assert "--procs" in short and "--help-all" in short and "--tie" not in short
        assert main(["--help-all"]) == 0
        everything = capsys.readouterr().out
        for name in ("--procs", "--tie", "--strict", "--shape", "--profile", "--channel"):
            assert name in everything
        assert main(["env", "--help"]) == 0
        assert "--help-all" not in capsys.readouterr().out  # it has no rare options

    @pytest.mark.parametrize("verb", [[], *([verb] for verb in VERBS)], ids=str)
    def test_help_and_version_are_data(
        self,
        verb: list[str],
        capsys: pytest.CaptureFixture[str],
        monkeypatch: pytest.MonkeyPatch,
    ) -> None:
        monkeypatch.setenv("COLUMNS", "80")
        assert main([*verb, "--help"]) == 0
        text = capsys.readouterr().out
        assert "examples:" in text
        assert max(len(line) for line in text.splitlines()) <= 80
        assert len(text.splitlines()) <= 42
        assert main([*verb, "--version"]) == 0
        assert capsys.readouterr().out == f"adagen {adagen.__version__}\n"


class TestFailures:
    def test_input_at_fault(
        self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        fail_with(monkeypatch, InputError("two\nroots", "a.urdf", 7))
        assert main(["env"]) == 1
        assert capsys.readouterr().err == "a.urdf:7: error: two\\nroots\n"

    @pytest.mark.parametrize(
        ("error", "said"),
        [
            (ValueError("strange\nthing"), "error: internal error (ValueError: strange\\nthing)"),
            (MemoryError(), "error: not enough memory"),
            (RecursionError(), "error: the input is nested too deeply"),
            (PermissionError(13, "Permission denied", "x"), "error: Permission denied (x)"),
        ],
    )
    def test_what_nobody_foresaw_is_one_line(
        self,
        error: Exception,
        said: str,
        monkeypatch: pytest.MonkeyPatch,
        capsys: pytest.CaptureFixture[str],
    ) -> None:
        fail_with(monkeypatch, error)
        assert main(["env"]) == 3
        told = capsys.readouterr().err
        assert told.startswith(said)
        assert told.count("\n") == 1

    @pytest.mark.parametrize("how", ["variable", "option"])
    def test_a_traceback_is_there_for_who_asks(
        self, how: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        fail_with(monkeypatch, ValueError("strange"))
        if how == "variable":
            monkeypatch.setenv("ADAGEN_DEBUG", "1")
        assert main(["env", "-vv"] if how == "option" else ["env"]) == 3
        assert "Traceback" in capsys.readouterr().err

    def test_an_interrupt(
        self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        fail_with(monkeypatch, KeyboardInterrupt())
        assert main(["env"]) == 130
        assert capsys.readouterr().err == "interrupted\n"

    def test_a_reader_that_has_gone_is_no_news(self) -> None:
        """The first line is read and the pipe closed before the second is written."""
        code = (
            "import sys, time; from adagen.cli import env, main\n"
            "def run(_):\n    print('first', flush=True)\n    sys.stdin.read()\n"
            "    print('second', flush=True)\n    return 0\n"
            "env.run = run\nsys.exit(main(['env']))\n"
        )
        child = subprocess.Popen(
            [sys.executable, "-c", code],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
        )
        assert child.stdin and child.stdout and child.stderr
        assert child.stdout.readline() == b"first\n"
        child.stdout.close()
        child.stdin.close()
        assert child.wait(30) == 141
        assert child.stderr.read() == b""
        child.stderr.close()

    def test_sigterm_unwinds(self, tmp_path: Path) -> None:
        mark = tmp_path / "mark"
        code = (
            "import sys, time; from pathlib import Path; from adagen.cli import env, main\n"
            "def run(_):\n    try:\n        print('up', flush=True); time.sleep(60)\n"
            f"    finally:\n        Path({str(mark)!r}).write_text('cleaned up')\n"
            "env.run = run\nsys.exit(main(['env']))\n"
        )
        child = subprocess.Popen(
            [sys.executable, "-c", code],
            stdout=subprocess.PIPE,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
        )
        assert child.stdout and child.stdout.readline() == b"up\n"
        child.send_signal(signal.SIGTERM)
        assert child.wait(30) == 143
        child.stdout.close()
        assert mark.read_text() == "cleaned up"


class TestEnv:
    def test_each_answer_alone_and_all_as_json(self, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["env", "--json"]) == 0
        told = json.loads(capsys.readouterr().out)
        for which in ("cxx", "mpicxx", "mpiexec", "flags"):
            assert main(["env", f"--{which}"]) == 0
            assert shlex.split(capsys.readouterr().out) == told[which]
        assert main(["env", "--eigen"]) == 0
        assert shlex.split(capsys.readouterr().out) == [told["eigen"]]
        assert (Path(told["eigen"]) / "Eigen" / "Dense").is_file()
        assert main(["env", "--variables"]) == 0
        words = shlex.split(capsys.readouterr().out)
        assert dict(word.split("=", 1) for word in words) == told["variables"]

    def test_all_answers_fit_a_narrow_terminal(self, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["env", "--json"]) == 0
        told = json.loads(capsys.readouterr().out)
        assert main(["env"]) == 0
        text = capsys.readouterr().out
        long = [line for line in text.splitlines() if len(line) > 80]
        assert all(" " not in line[10:] for line in long)  # one word: a path
        blocks = dict(re.findall(r"^(\w+) +(.*(?:\n {10}.*)*)", text, re.MULTILINE))
        assert list(blocks)[:5] == ["cxx", "mpicxx", "mpiexec", "eigen", "flags"]
        assert shlex.split(blocks["flags"]) == told["flags"]
        words = shlex.split(blocks["variables"])
        assert dict(word.split("=", 1) for word in words) == told["variables"]

    def test_the_user_s_choice_is_told(
        self,
        tmp_path: Path,
        monkeypatch: pytest.MonkeyPatch,
        capsys: pytest.CaptureFixture[str],
    ) -> None:
        for name in ("mpicxx", "mpiexec"):
            (tmp_path / name).write_text("#!/bin/sh\n")
            (tmp_path / name).chmod(0o755)
        monkeypatch.setenv("MPICXX", str(tmp_path / "mpicxx"))
        assert main(["env", "--mpiexec"]) == 0
        assert capsys.readouterr().out == f"{tmp_path / 'mpiexec'}\n"

    def test_what_is_missing_is_status_3(
        self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        monkeypatch.setenv("EIGEN", "nowhere")
        assert main(["env"]) == 3
        assert capsys.readouterr().err.startswith("error: EIGEN=nowhere")


def test_saying_the_version_does_not_wait_for_the_stages() -> None:
    done = run("--version")
    assert done.stdout == f"adagen {adagen.__version__}\n"
    code = "import sys, adagen.cli.main as m; m.main(['--version']); print(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    ).stdout.split()
    assert not {"numpy", "yourdfpy", "rich", "jinja2", "flint"} & set(loaded)
