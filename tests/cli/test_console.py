"""What people see while the tool works."""

from __future__ import annotations

import time

import pytest

from adagen.cli.console import Stages, note, progress, speaking, start, warn, warned

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
