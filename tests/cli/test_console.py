"""What people see while the tool works."""

from __future__ import annotations

import json
import time
from pathlib import Path

import pytest

from adagen.cli import time_estimates
from adagen.cli.console import Stages, note, progress, speaking, start, warn, warned, wrote

Captured = pytest.CaptureFixture[str]


def test_words_for_people_are_single_lines(capsys: Captured) -> None:
    warn("a.urdf:3: warning: two\nlines")
    warn("plain")
    note("\x1b[31mred")
    assert tuple(capsys.readouterr()) == (
        "",
        "a.urdf:3: warning: two\\nlines\nwarning: plain\n\\x1b[31mred\n",
    )


def test_what_is_quick_is_silent_and_what_is_slow_is_told(
    capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    with progress("compiling"):
        pass
    assert tuple(capsys.readouterr()) == ("", "")
    monkeypatch.setattr("adagen.cli.console._PATIENCE_SECONDS", 0.0)
    with progress("compiling"):
        time.sleep(0.2)
    assert tuple(capsys.readouterr()) == ("", "compiling ...\n")


def test_work_done_before_says_about_how_long_it_takes(
    capsys: Captured, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr("adagen.cli.console._PATIENCE_SECONDS", 0.0)
    assert time_estimates.expected("brewing", 1000) is None
    first = time_estimates.expected(
        "compiling", 172_000
    )  # what a machine expects that did nothing yet
    assert first is not None and 2.0 < first < 60.0
    time_estimates.learn("compiling", 1000, 30.0)
    time_estimates.learn("compiling", 100_000, 500.0)
    time_estimates.learn("compiling", 10, 0.1)  # too short to teach anything
    assert time_estimates.expected("compiling", 10) == 0.3
    for size in (2000, 200_000, 10, 0):
        with progress("compiling arm", size):
            time.sleep(0.2)
    assert capsys.readouterr().err.splitlines() == [
        "compiling arm (about 60 s) ...",
        "compiling arm (about 17 min) ...",
        "compiling arm ...",
        "compiling arm ...",
    ]
    (tmp_path / "adagen" / "pace.json").write_text("no JSON")
    assert time_estimates.expected("compiling", 172_000) == first
    for k in range(30):
        time_estimates.learn("compiling", 1000 + k, 30.0)
    assert len(json.loads((tmp_path / "adagen" / "pace.json").read_text())["compiling"]) == 20
    (tmp_path / "adagen").chmod(0o500)
    time_estimates.learn("compiling", 1000, 30.0)


def test_stages_are_told_in_their_order_also_after_a_failure() -> None:
    stages = Stages()
    assert str(stages) == "stages: none"
    with stages.stage("read"):
        pass
    with pytest.raises(ValueError), stages.stage("plan"):
        raise ValueError
    words = str(stages).replace(",", "").split()
    assert words[1::3] == ["read", "plan", "total"]


def test_a_quiet_command_says_its_warnings_alone(
    capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("adagen.cli.console._PATIENCE_SECONDS", 0.0)
    start(quiet=True)
    try:
        note("wrote")
        with progress("compiling"), speaking("timing") as said:
            said("round 1")
            time.sleep(0.1)
        warn("odd")
        assert tuple(capsys.readouterr()) == ("", "warning: odd\n")
        assert warned() == ["warning: odd"]
    finally:
        start(quiet=False)
    assert warned() == []
    note("wrote")
    assert capsys.readouterr().err == "wrote\n"


def test_written_files_are_listed_below_their_folder_in_80_columns(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    names = [f"a_long_robot_s_name_p{k}.cpp" for k in range(5)]
    wrote([Path("out", name) for name in names] + [Path("here.json")])
    first, *_, second, last = capsys.readouterr().err.splitlines()
    assert first.startswith("wrote out: a_long_robot_s_name_p0.cpp, ") and len(first) <= 80
    assert second.startswith("  ") and second.endswith("p4.cpp")
    assert last == "wrote here.json"


def test_counted_work_says_how_long_the_rest_takes(
    monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    clock = iter([100.0, 100.0, 103.0, 103.0, 400.0, 400.0] * 2)
    monkeypatch.setattr("adagen.cli.console.time.monotonic", lambda: next(clock))
    monkeypatch.setattr("adagen.cli.console._SILENCE_SECONDS", 0.0)
    with speaking("arm") as said:
        said("compiling 1 of 20")
        said("compiling 2 of 20")
        said("compiling 3 of 20")
    assert capsys.readouterr().err.splitlines() == [
        "arm: compiling 1 of 20 ...",
        "arm: compiling 2 of 20 (about 57 s left) ...",
        "arm: compiling 3 of 20 (about 45 min left) ...",
    ]
    with speaking("arm") as said:  # also where a line begins with the count
        said("1 of 20: one")
        said("2 of 20: another")
    assert capsys.readouterr().err.splitlines() == [
        "arm: 1 of 20: one ...",
        "arm: 2 of 20: another (about 57 s left) ...",
    ]
