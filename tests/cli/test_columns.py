"""What commands print for people fits 80 columns, for real robots with long names.

Left out are lines that are to be read by programs, or as a whole: JSON, and warnings and errors
with their file and line.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from adagen.calibrate import profile_text
from adagen.calibrate.run import Calibration
from adagen.cli import bench, calibrate, chart, main
from adagen.schedule import load_profile
from adagen.studies.bench.record import read_record
from adagen.studies.chart import read_chart
from tests.real import real_robot
from tests.search.test_several_hosts import LAN, with_network

ROOT = Path(__file__).resolve().parents[2]
LONG = "allegro_hand_description/urdf/allegro_right_hand.urdf"
LARGE = "talos_data/robots/talos_full_v2.urdf"
ARM = "talos_data/robots/talos_left_arm.urdf"
MODELS = ROOT / "generated_examples" / "models"

Captured = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def eighty(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.chdir(tmp_path)


def too_long(capsys: Captured) -> list[str]:
    out, err = capsys.readouterr()
    told = [line for line in err.splitlines() if "warning:" not in line and "error:" not in line]
    assert out or told
    return [line for line in (*out.splitlines(), *told) if len(line) > 80]


@pytest.mark.parametrize(
    ("robot", "words"),
    [
        (LARGE, ["info", "ROBOT", "-v"]),
        (LONG, ["info", "ROBOT"]),
        (LONG, ["schedule", "ROBOT", "--procs", "1", "-v"]),
        (LONG, ["schedule", "ROBOT", "--procs", "3"]),
        (ARM, ["schedule", "ROBOT", "--procs", "2", "--profile", "paper"]),
        (ARM, ["schedule", "ROBOT", "--hosts", "hosts", "--profile", "lan.toml"]),
        (LONG, ["ROBOT", "--out", "out", "-v"]),
        (LONG, ["ROBOT", "--out", "out", "--batch", "--scalar", "float"]),
        (ARM, ["report", "ROBOT", "--out", "out", "-v"]),
    ],
    ids=lambda part: " ".join(part[:2]) if isinstance(part, list) else Path(part).stem,
)
def test_of_a_robot(robot: str, words: list[str], capsys: Captured) -> None:
    Path("robot.urdf").write_bytes(real_robot(robot).read_bytes())
    Path("hosts").write_text("one slots=2\ntwo slots=2\n")
    Path("lan.toml").write_text(profile_text(with_network(LAN), "a test"))
    assert main(["robot.urdf" if word == "ROBOT" else word for word in words]) == 0
    assert too_long(capsys) == []


def test_of_other_commands(capsys: Captured) -> None:
    assert main(["stability", "--quick", "--case", "1"]) == 0
    assert main([str(MODELS / "arm7.urdf"), "--out", "out"]) == 0
    assert main(["verify", "out", "-v"]) == 0
    assert too_long(capsys) == []


def records() -> dict[str, Callable[[], None]]:
    pictures = ROOT / "docs" / "records" / "pictures"
    found = Calibration(
        load_profile("default"), {"joint, in its own axes": [0.1, -0.2]},
        [("talos_full_v2_with_long_name, kernels, 2 processes", 12.5, 11.5)], True, True,
    )  # fmt: skip
    return {
        "bench": lambda: bench._show(read_record(ROOT / "benchmarks" / "bench.json")),
        "calibrate": lambda: calibrate._show(found),
        **{
            path.stem: lambda path=path: chart._show(read_chart(path))  # type: ignore[misc]
            for path in sorted(pictures.glob("chart_*.json"))
            if not path.stem.startswith("chart_motion_")
        },
    }


@pytest.mark.parametrize("name", records())
def test_of_records(name: str, capsys: Captured) -> None:
    records()[name]()
    assert too_long(capsys) == []
