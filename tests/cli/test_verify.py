"""``adagen verify``: what is there is what is emitted now, or how it differs."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.library.command import command_in
from tests.golden.examples import FOLDER
from tests.golden.make_models import MODELS

Said = Callable[[], tuple[str, str]]


@pytest.fixture
def said(capsys: pytest.CaptureFixture[str]) -> Said:
    def read() -> tuple[str, str]:
        found = capsys.readouterr()
        return found.out, found.err

    return read


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A folder with a robot, and two solvers of it in a folder beside."""
    shutil.copy(MODELS / "mobile.urdf", tmp_path)
    emit(tmp_path / "mobile.urdf", tmp_path / "solvers", "--procs", "1")
    emit(tmp_path / "mobile.urdf", tmp_path / "solvers", "--procs", "2", "--name", "cart")
    return tmp_path / "solvers"


def emit(model: Path, out: Path, *words: str) -> None:
    assert main([str(model), *words, "--out", str(out)]) == 0


def head(place: Path, stem: str) -> list[str] | None:
    return command_in((place / f"{stem}.cpp").read_text())


def test_the_examples_of_this_project_are_verified(said: Said) -> None:
    assert main(["verify", str(FOLDER / "mobile_p1"), str(FOLDER / "arm7_float_p2")]) == 0
    stdout, stderr = said()
    assert stdout == ""
    assert stderr.endswith("2 solvers: up to date\n")


def test_the_head_names_the_robot_from_where_the_source_is(place: Path) -> None:
    assert head(place, "mobile_p1") == ["adagen", "../mobile.urdf", "--procs", "1"]
    assert head(place, "cart_p2") == [*("adagen", "../mobile.urdf", "--procs", "2", "--name=cart")]


def test_it_does_not_matter_where_one_stands(
    place: Path, monkeypatch: pytest.MonkeyPatch, said: Said
) -> None:
    for folder, word in ((place, "."), (place.parent, "solvers"), (Path("/"), str(place))):
        monkeypatch.chdir(folder)
        assert main(["verify", word]) == 0, said()


def test_a_whole_tree_may_move(place: Path, tmp_path: Path) -> None:
    shutil.copytree(place.parent, tmp_path / "copy", ignore=shutil.ignore_patterns("copy"))
    shutil.rmtree(place)
    assert main(["verify", str(tmp_path / "copy")]) == 0


def test_missing_stale_and_different_are_told_and_made_right(place: Path, said: Said) -> None:
    good = {path.name: path.read_bytes() for path in place.rglob("*.*")}
    (place / "notes_p1.svg").write_text("<svg>mine</svg>")
    (place / "cart_p2.h").unlink()
    text = (place / "mobile_p1.cpp").read_text()
    (place / "mobile_p1.cpp").write_text(text.replace("double", "triple", 1))
    shutil.copy(place / "mobile_p1.h", place / "mobile_p7.h")
    said()
    assert main(["verify", str(place)]) == 1
    stdout, stderr = said()
    lines = stdout.splitlines()
    assert lines[:3] == [
        f"missing: {place / 'cart_p2.h'}",
        f"stale: {place / 'mobile_p7.h'}",
        f"different: {place / 'mobile_p1.cpp'}",
    ]
    assert any(line.startswith("-") and "triple" in line for line in lines)
    assert any(line.startswith("+") and "double" in line for line in lines)
    assert "adagen verify --update" in stderr
    assert main(["verify", "--update", str(place)]) == 0
    assert (place / "notes_p1.svg").read_text() == "<svg>mine</svg>"
    (place / "notes_p1.svg").unlink()
    assert {path.name: path.read_bytes() for path in place.rglob("*.*")} == good


def test_what_is_left_of_a_solver_without_its_source_is_stale(place: Path, said: Said) -> None:
    (place / "cart_p2.cpp").unlink()
    assert main(["verify", str(place)]) == 1
    names = {line.rpartition("/")[2] for line in said()[0].splitlines()}
    assert {"cart_p2.h", "cart_p2.plan.json", "cart_p2.svg"} <= names
    assert not any(name.startswith("mobile_p1") for name in names)


def test_a_changed_robot_shows(place: Path, said: Said) -> None:
    robot = place.parent / "mobile.urdf"
    robot.write_text(robot.read_text().replace("7.5", "7.25", 1))
    assert main(["verify", str(place)]) == 1
    stdout, _ = said()
    assert f"different: {place / 'mobile_p1.cpp'}" in stdout
    assert f"different: {place / 'cart_p2.plan.json'}" in stdout
    assert main(["verify", "--update", str(place)]) == 0
    assert main(["verify", str(place)]) == 0


@pytest.mark.parametrize(
    ("model", "words"),
    [
        ("arm7", ["--scene", "SCENE", "--procs", "1", "--scalar", "float"]),
        ("arm7", ["--procs", "2", "--form", "ada", "--schedule", "SCHEDULE"]),
        ("arm7", ["--procs", "1", "--profile", "PROFILE", "--gravity", "0", "0", "-1.62"]),
        ("arm7", ["--mimic", "--procs", "2", "--objective", "time", "--expansions", "1000"]),
        ("arm7", ["--batch", "--floating", "--name=a b"]),
        ("arm7", ["--tuned", "unrolled:250:clang++", "--procs", "1"]),
        ("arm7", ["--procs", "2", "--form=ada", "--strategy=astar", "--naive"]),
        ("arm7", ["--procs", "1", "--loops", "LOOPS"]),
        ("humanoid", ["--floating"]),
        ("arm7", ["--strict", "--procs", "2", "--channel", "message", "--name=é"]),
    ],
)
def test_whatever_is_asked_for_is_made_again(
    model: str, words: list[str], tmp_path: Path, said: Said
) -> None:
    robot = tmp_path / f"my robot's {model}.urdf"
    shutil.copy(MODELS / f"{model}.urdf", robot)
    shutil.copy(MODELS / "arm7_payload.toml", tmp_path / "SCENE")
    (tmp_path / "LOOPS").write_text("closed_loop: [[camera, universe]]\ntype: [3d]\n")
    profiles = Path(__file__).parents[2] / "adagen/schedule/profiles"
    shutil.copy(profiles / "default.toml", tmp_path / "PROFILE")
    if "SCHEDULE" in words:
        said()
        assert main(["schedule", str(robot), "--procs", "2", "--form", "ada", "--json"]) == 0
        (tmp_path / "SCHEDULE").write_text(said()[0])
    given = [str(tmp_path / word) if word.isupper() else word for word in words]
    emit(robot, tmp_path / "deep" / "out", *given)
    assert main(["verify", str(tmp_path / "deep")]) == 0, said()


def test_what_cannot_be_made_again_is_told(place: Path, said: Said, tmp_path: Path) -> None:
    source = place / "mobile_p1.cpp"
    good = source.read_text()
    cases = (
        (good.replace("// command ", "// commend "), 1, "mobile_p1.cpp: error: its head has no"),
        (good.replace("--procs 1", "--procs 3"), 1, "the command in its head writes mobile_p3.cpp"),
        (good.replace("../mobile.urdf", "../gone.urdf"), 1, "gone.urdf"),
        (good.replace("--procs 1", "--prics 1"), 2, "unknown option --prics"),
    )
    for text, status, why in cases:
        source.write_text(text)
        said()
        assert main(["verify", str(place)]) == status
        assert why in said()[1]
    (tmp_path / "empty").mkdir()
    assert main(["verify", str(tmp_path / "empty")]) == 2
    assert main(["verify", str(tmp_path / "nowhere")]) == 2
