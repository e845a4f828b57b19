"""The demonstration, on a robot that is built quickly."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import adagen
from adagen.cli import demo
from adagen.errors import EnvironmentFault
from tests.cli.robots import write_arm
from tests.golden.make_models import MODELS
from tests.slow import slow


def test_it_generates_builds_runs_and_sums_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    model = write_arm(tmp_path / "arm.urdf", joints=4)
    monkeypatch.chdir(tmp_path)
    assert demo.main([str(model)]) == 0
    told = capsys.readouterr()
    rows = [line.split() for line in told.out.splitlines()]
    (one,) = [row for row in rows if row[:2] == ["arm", "1"]]
    (two,) = [row for row in rows if row[:2] == ["arm", "2"]]
    assert "arm: a second process does not pay; adagen leaves all work to one" in told.out
    for row in (one, two):
        median, least, most, speedup, residual = (float(word) for word in row[2:7])
        assert 0 < least <= median <= most
        assert speedup > 0
        assert residual < 1e-9
        assert row[7] == "right"
    assert "build/demo/arm/p2/arm_p2.svg" in told.out
    assert (tmp_path / "build/demo/arm/p2/arm_p2.svg").is_file()
    assert (
        "$ adagen arm.urdf --floating --procs 2 --profile native --out build/demo/arm/p2"
        in told.err
    )


@pytest.mark.parametrize(("profile", "ratio"), [("xeon", 0.75), slow("default", 0.85)])
def test_two_processes_pay_for_the_snake(profile: str, ratio: float) -> None:
    snake = adagen.read(MODELS / "snake100.urdf", floating=True)
    one, two = (adagen.compile(snake, procs=procs, profile=profile) for procs in (1, 2))
    assert one.predicted is not None
    assert two.predicted is not None
    assert two.predicted < ratio * one.predicted
    assert all(two.program.processes)


def test_a_line_for_each_robot_says_what_the_second_process_brings(
    capsys: pytest.CaptureFixture[str],
) -> None:
    def report(processes: int, median: float, channel: str) -> dict[str, Any]:
        times = {"median_ns": median, "min_ns": median, "p99_ns": median}
        check = {"residual_max": 1e-15, "ok": True}
        head = {"processes": processes, "channel": channel}
        return head | {"time": {"in_place": times}, "check": check}

    demo.summarise({"snake": [report(1, 4000.0, "none"), report(2, 2500.0, "window")]})
    assert "snake: two processes are 1.60 times as fast as one" in capsys.readouterr().out


def test_a_robot_that_is_refused_ends_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert demo.main([str(tmp_path / "none.urdf")]) == 1
    assert "none.urdf: error: " in capsys.readouterr().err


def test_the_usual_robots_are_there() -> None:
    pytest.importorskip("pinocchio")
    assert demo.robot_file(demo.HUMANOID).is_file()
    assert (MODELS.parents[1] / demo.SNAKE).is_file()
    with pytest.raises(EnvironmentFault, match="has no none"):
        demo.robot_file("none")
