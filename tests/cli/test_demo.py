"""The demonstration, on a robot that is built quickly."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.cli import demo
from adagen.errors import EnvironmentFault
from tests.cli.test_generate import write_arm


def test_it_generates_builds_runs_and_sums_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    model = write_arm(tmp_path / "arm.urdf", joints=4)
    monkeypatch.chdir(tmp_path)
    assert demo.main([str(model)]) == 0
    told = capsys.readouterr()
    rows = [line.split() for line in told.out.splitlines()]
    (one,) = [row for row in rows if row[:2] == ["1", "none"]]
    (two,) = [row for row in rows if row[:2] == ["2", "none"]]  # one does it all
    for row in (one, two):
        median, least, most, speedup, residual = (float(word) for word in row[2:7])
        assert 0 < least <= median <= most
        assert speedup > 0
        assert residual < 1e-9
        assert row[7] == "right"
    assert "build/demo/p2/arm_p2.svg" in told.out
    assert (tmp_path / "build/demo/p2/arm_p2.svg").is_file()
    assert "$ adagen arm.urdf --floating --procs 2 --out build/demo/p2" in told.err


def test_a_robot_that_is_refused_ends_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert demo.main([str(tmp_path / "none.urdf")]) == 1
    assert "none.urdf: error: " in capsys.readouterr().err


def test_the_usual_robot_is_there() -> None:
    pytest.importorskip("pinocchio")
    assert demo.robot_file(demo.ROBOT).is_file()
    with pytest.raises(EnvironmentFault, match="has no none"):
        demo.robot_file("none")
