"""How many processes pay, as the command line says it."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import adagen
from adagen.calibrate import profile_text
from adagen.cli import main
from adagen.cli.predicted import prediction
from adagen.emit.shapes import predict
from adagen.plan import make_plan
from adagen.schedule import load_profile
from adagen.search import best_schedule
from tests.cli.robots import write_arm
from tests.cost.costs import step_profile
from tests.models import serial_chain


@pytest.fixture
def cheap(tmp_path: Path) -> Path:
    """A profile under which cuts cost next to nothing."""
    names = ("join", "disassemble", "propagate", "deliver")
    kinds = ("revolute", "ground")
    free = {f"{n}__{k}": 0.0 for n in names for k in kinds if (n, k) not in _MISSING}
    file = tmp_path / "cheap.toml"
    costs = dict.fromkeys(("root__invert", "process__evaluation"), 0.0)
    profile = step_profile((), **free, **costs, articulate__revolute=1.0)
    file.write_text(profile_text(profile, "cheap cuts"))
    return file


_MISSING = {("disassemble", "ground"), ("deliver", "ground")}


def test_more_processes_than_pay_are_obeyed_with_a_warning(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = write_arm(tmp_path / "arm.urdf", 6)
    assert main(["schedule", str(arm), "--procs", "4", "--json"]) == 0
    stdout, stderr = capsys.readouterr()
    assert json.loads(stdout)["root"]["processes"] == [0, 4]
    assert "4 processes do not pay: " in stderr
    assert "us on one (default profile), which does everything; use" in stderr


def test_where_they_pay_there_is_no_warning(
    tmp_path: Path, cheap: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = write_arm(tmp_path / "arm.urdf", 6)
    assert main(["schedule", str(arm), "--procs", "2", "--profile", str(cheap), "--json"]) == 0
    assert "warning" not in capsys.readouterr().err


def test_what_saves_less_than_predictions_are_off_is_left_to_one(
    tmp_path: Path, cheap: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By every way to ask; a schedule with a name is obeyed."""
    arm = write_arm(tmp_path / "arm.urdf", 6)
    text = cheap.read_text()
    (margin,) = re.findall(r"^margin = .*$", text, re.MULTILINE)
    cheap.write_text(text.replace(margin, "margin = 0.9"))

    def told(*more: str) -> tuple[dict[str, Any], str]:
        words = ["schedule", str(arm), "--procs", "2", "--profile", str(cheap), "--json"]
        assert main([*words, *more]) == 0
        stdout, stderr = capsys.readouterr()
        return json.loads(stdout), stderr

    found, said = told()
    assert set(found["owners"].values()) == {0} and found["processes"] == 2
    many, one = re.findall(r"(\d\.\d+) us", said)
    assert float(many) < float(one) == pytest.approx(found["makespan"], abs=0.005)
    assert found["lower_bound"] < found["makespan"] and found["verdict"] == "gap"
    assert "(steps profile), which does everything; use --procs 1 or auto" in said
    library = adagen.compile(adagen.read(arm), procs=2, profile=str(cheap))
    assert [bool(process.owns) for process in library.plan.processes] == [True, False]
    for more in (("--schedule", "balanced"), ("--objective", "accuracy")):
        found, said = told(*more)
        assert set(found["owners"].values()) == {0, 1}
        assert "steps profile); use --procs 1 or auto" in said


def test_auto_takes_one_for_an_arm_and_more_where_it_pays(
    tmp_path: Path,
    cheap: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("adagen.library.choice.cores", lambda: 4)
    arm = write_arm(tmp_path / "arm.urdf", 6)
    assert main(["schedule", str(arm), "--procs", "auto", "--json"]) == 0
    stdout, stderr = capsys.readouterr()
    assert json.loads(stdout)["root"]["processes"][1] <= 2 and "--procs auto: " in stderr
    words = ["schedule", str(arm), "--procs", "auto", "--profile", str(cheap), "--json"]
    assert main(words) == 0
    assert json.loads(capsys.readouterr().out)["root"]["processes"][1] >= 2


def test_auto_works_with_the_paper_profile_and_form_ada(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = write_arm(tmp_path / "arm.urdf", 9)
    for more in (["--profile", "paper"], ["--form", "ada"]):
        assert main(["schedule", str(arm), "--procs", "auto", *more]) == 0
        assert "--procs auto: " in capsys.readouterr().err


@pytest.mark.parametrize("text", ["0", "Auto", "auto2", "-1", "1025", ""])
def test_other_words_are_refused(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = write_arm(tmp_path / "arm.urdf")
    assert main(["schedule", str(arm), f"--procs={text}"]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_generating_for_auto_names_the_processes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = write_arm(tmp_path / "arm.urdf")
    assert main([str(arm), "--procs", "auto", "--out", str(tmp_path / "o")]) == 0
    assert (tmp_path / "o" / "arm_p1.cpp").is_file()
    capsys.readouterr()


def test_stored_profiles_are_found_by_name(
    tmp_path: Path,
    cheap: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    folder = tmp_path / "config" / "adagen" / "profiles"
    folder.mkdir(parents=True)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    (folder / "machine.toml").write_text(cheap.read_text())
    (folder / "default.toml").write_text("not the shipped one")
    arm = write_arm(tmp_path / "arm.urdf")
    for name, status in (("machine", 0), ("default", 0), ("other", 2)):
        assert main(["schedule", str(arm), "--procs", "1", "--profile", name]) == status
    assert "one of default, xeon, zen4, avx2, paper, native, machine;" in capsys.readouterr().err


def test_the_same_time_is_told_everywhere(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also where limbs are side by side, which is faster than what the search prices."""
    robot = Path(__file__).resolve().parents[2] / "generated_examples/models/humanoid.urdf"
    scene = tmp_path / "planar.toml"
    scene.write_text('base = { kind = "planar" }\n')
    words = [str(robot), "--procs", "2", "--scene", str(scene)]
    assert main(["schedule", *words]) == 0
    stdout, stderr = capsys.readouterr()
    (told,) = re.findall(r"processes do not pay: (\S+) us predicted", stderr)
    assert f"{told} us predicted" in stdout
    assert "at most -" not in stdout
    assert main([*words, "--out", str(tmp_path / "o")]) == 0
    assert f"{told} us predicted" in capsys.readouterr().err
    assert main(["schedule", str(robot), "--procs", "1"]) == 0
    stdout = capsys.readouterr().out
    (told,) = re.findall(r"(\S+) us predicted", stdout)
    assert main([str(robot), "--procs", "1", "--out", str(tmp_path / "one")]) == 0
    assert f"{told} us predicted" in capsys.readouterr().err


def test_a_proof_is_told_of_the_price_that_was_searched_and_of_no_other() -> None:
    model, profile = serial_chain(4), load_profile("default")
    schedule = best_schedule(model, 1, profile)
    line = predict(make_plan(model, schedule), profile, "kernels")
    told = f"{line.makespan:.2f} us predicted (default profile"
    assert prediction(replace(schedule, makespan=9.0), line) == f"{told})"
    searched = replace(schedule, makespan=line.makespan, lower_bound=line.makespan)
    assert prediction(searched, line) == f"{told}; optimal)"
