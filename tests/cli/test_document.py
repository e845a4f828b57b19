"""The schedule's file: what it says, and that it makes the same program when given back."""

from __future__ import annotations

import io
import json
import re
from contextlib import redirect_stdout
from importlib import resources
from pathlib import Path
from typing import Any

import pytest

from adagen.cli import main
from tests.golden.make_models import MODELS
from tests.slow import spread

CASES = [
    ("humanoid", ["--procs", "2"]),  # gathered
    ("humanoid", ["--floating", "--procs", "4"]),
    ("humanoid", ["--procs", "1"]),
    ("chain16", ["--procs", "2", "--form", "ada"]),  # joined
    ("arm7", ["--procs", "2", "--schedule", "balanced"]),
    ("arm7", ["--procs", "2"]),  # one process at work
]


def gathering(folder: Path) -> list[str]:
    """The words for a robot whose processes gather: messages take no time in this profile."""
    text = resources.files("adagen.schedule").joinpath("profiles", "default.toml").read_text()
    profile = folder / "near.toml"
    profile.write_text(re.sub(r"latency = .*", "latency = 0.001", text))
    model = str(MODELS / "humanoid.urdf")
    return [model, "--floating", "--procs", "2", "--profile", str(profile)]


def document(capsys: pytest.CaptureFixture[str], *words: str) -> Any:
    assert main(["schedule", *words, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def emitted(folder: Path, *words: str) -> dict[str, bytes]:
    """What is emitted, but for what names the schedule's file: command, inputs and their texts."""
    assert main([*words, "--out", str(folder)]) == 0
    files = (path for path in folder.rglob("*") if path.is_file())
    found = {str(path.relative_to(folder)): path.read_bytes() for path in files}
    (source,) = (name for name in found if re.search(r"_p[0-9]+\.cpp$", name))
    found[source], commands = re.subn(rb"// command .*\n", b"", found[source])
    assert commands == 1
    found[source] = re.sub(rb"// input     schedule, .*\n", b"", found[source])
    plan = f"{source.removesuffix('.cpp')}.plan.json"
    found[plan], origins = re.subn(rb',\n"made": .*\n', b"\n", found[plan])
    assert origins == 1
    return found


@pytest.mark.parametrize(("robot", "words"), spread(CASES, 2))
def test_the_same_program_is_made_of_it_and_its_figures_are_those_of_the_program(
    robot: str, words: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model = str(MODELS / f"{robot}.urdf")
    said = document(capsys, model, *words)
    file = tmp_path / "schedule.json"
    file.write_text(json.dumps(said, indent=2))
    kept = [word for word in words if word not in ("--schedule", "balanced")]
    again = [*kept, "--schedule", str(file)]
    files = emitted(tmp_path / "a", model, *words)
    assert files == emitted(tmp_path / "b", model, *again)
    (plan,) = (json.loads(text) for name, text in files.items() if name.endswith(".plan.json"))
    require_figures(said, plan)


def require_figures(said: dict[str, Any], plan: dict[str, Any]) -> None:
    """Hold what a schedule's file says against itself and against the plan that is emitted."""
    assert said["predicted"] == said["makespan"] >= max(said["loads"])
    assert said["bound"] <= said["predicted"]
    if said["verdict"] == "optimal":
        assert said["bound"] == pytest.approx(said["predicted"]) and said["gap"] == 0
    elif said["gap"] is not None:
        assert said["gap"] == pytest.approx(said["predicted"] / said["bound"] - 1)
    assert said["families"]
    names = [joint["name"] for joint in plan["joints"]]
    owners = {names[j]: p for p, process in enumerate(plan["processes"]) for j in process["owns"]}
    assert said["owners"] == owners
    assert ("root" in said) != ("gathered" in said)


@pytest.fixture(scope="module")
def edited(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The text of a schedule whose processes gather, to be changed."""
    words, told = gathering(tmp_path_factory.mktemp("near")), io.StringIO()
    with redirect_stdout(told):
        assert main(["schedule", *words, "--json"]) == 0
    return told.getvalue()


def test_where_processes_gather_can_be_edited(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words, file = gathering(tmp_path), tmp_path / "schedule.json"
    said = document(capsys, *words)
    assert said["meeting"] == "gather" and said["gathered"]["owners"]["neck_pitch"] == 1
    said["gathered"]["owners"] |= {"waist_pitch": None, "neck_yaw": 0, "neck_pitch": 0}
    file.write_text(json.dumps(said))
    edited = document(capsys, *words, "--schedule", str(file))
    assert edited["owners"]["neck_pitch"] == edited["owners"]["neck_yaw"] == 0
    assert edited["gathered"] == said["gathered"]


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        ({"roots": ["nobody"]}, '"roots" names the joint above each root'),
        ({"roots": []}, "trees of moving links, not 0"),
        ({"owners": {}}, "has no owner"),
        ({"owners": {"neck_pitch": 7}}, "is no process of 2"),
        ({"owners": {"waist_roll": 1, "waist_yaw": 0}}, "leave it to the core"),
        ({"owners": {"stranger": 1}}, "the robot has no joint 'stranger'"),
    ],
)
def test_what_cannot_be_is_refused(
    change: dict[str, Any],
    complaint: str,
    edited: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    words, file = gathering(tmp_path), tmp_path / "schedule.json"
    said = json.loads(edited)
    for key, value in change.items():
        told = said["gathered"]
        told[key] = {**told[key], **value} if isinstance(value, dict) and value else value
    file.write_text(json.dumps(said))
    assert main(["schedule", *words, "--schedule", str(file)]) == 1
    assert complaint in capsys.readouterr().err
