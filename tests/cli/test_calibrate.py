"""``adagen calibrate``: its words, what it stores, and (slow) a real measurement."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from adagen.calibrate import Calibration, Progress
from adagen.cli import main
from adagen.schedule import load_profile
from tests.cost.costs import step_profile


@pytest.fixture
def made_up(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A calibration that takes no time, and a place of its own to store it."""

    def calibrate(name: str, toolchain: object, *, quick: bool, progress: Progress) -> Calibration:
        assert toolchain is not None and not quick
        progress("compiling", 1, 2)
        progress("timing", 2, 2)
        profile = step_profile()
        object.__setattr__(profile, "name", name)
        errors = {"assembly": [0.01, -0.02], "kinematics": [0.005]}
        return Calibration(profile, errors, [("segment x P=1", 2.0, 2.1)], False, True)

    monkeypatch.setattr("adagen.calibrate.calibrate", calibrate)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


@pytest.mark.usefixtures("made_up")
class TestWords:
    def test_it_stores_by_name(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["calibrate", "--name", "mine"]) == 0
        file = tmp_path / "config" / "adagen" / "profiles" / "mine.toml"
        assert load_profile("mine").name == "mine" and load_profile("mine").steps is not None
        assert str(tmp_path) not in file.read_text()
        stdout, stderr = capsys.readouterr()
        assert "segment x P=1" in stdout and "+5.0%" in stdout
        assert "compiling ... (1 of 2)" in stderr and "use it with --profile mine" in stderr
        assert "could not be held to a core" in stderr

    def test_it_writes_to_a_file(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["calibrate", "--out", str(tmp_path / "x.toml"), "--json"]) == 0
        report = json.loads(capsys.readouterr().out)
        assert report["median_error"] == pytest.approx(0.05)
        assert report["stages"]["assembly"]["largest_error"] == pytest.approx(0.02)
        assert load_profile(str(tmp_path / "x.toml")).name == "machine"
        assert not (tmp_path / "config").exists()

    @pytest.mark.parametrize("name", ["default", "paper", "../x", ".x", "", "a b", "x" * 65])
    def test_bad_names_are_refused(self, name: str, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["calibrate", f"--name={name}"]) == 2
        assert capsys.readouterr().err.count("\n") == 1

    def test_nowhere_to_store_is_one_line(
        self, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        (tmp_path / "config").write_text("a file in the way")
        assert main(["calibrate"]) == 3
        assert "XDG_CONFIG_HOME" in capsys.readouterr().err.splitlines()[-1]


@pytest.mark.slow
def test_a_quick_calibration_tells_its_own_programs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "quick.toml"
    assert main(["calibrate", "--quick", "--out", str(file), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["median_error"] < 0.25
    assert main(["calibrate", "--help"]) == 0
