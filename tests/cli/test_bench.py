"""``adagen bench``: what it prints and writes, and how it refuses."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from adagen.cli import main
from adagen.cli.contest import Entry, contest, measure
from adagen.errors import UsageError
from adagen.studies.bench.contest import Rules
from adagen.studies.bench.record import read_record
from adagen.studies.bench.scale_record import read_scale
from tests.cli.robots import write_arm

ONE = ("--variant", "--procs 1", "--rounds", "2", "--peers", "none")


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    return write_arm(tmp_path / "arm.urdf")


def test_times_errors_and_predictions_of_an_arm(
    arm: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["bench", str(arm), *ONE, "--json", "--out", str(tmp_path / "out")]) == 0
    said = json.loads(capsys.readouterr().out)
    (model,) = said["models"]
    (row,) = model["rows"]
    assert (model["name"], model["dofs"], row["team"]) == ("arm", 3, "adagen")
    assert 0 < row["least"] <= row["median"] and len(row["turns"]) == 2
    assert row["forward_error"] < 1e-12 and row["residual"] < 1e-12
    assert row["predicted"] > 0
    assert read_record(tmp_path / "out" / "bench.json").models[0].rows[0].median == row["median"]
    assert "### arm: 3 degrees of freedom" in (tmp_path / "out" / "bench.md").read_text()
    assert main(["bench", str(arm), *ONE]) == 0
    assert "adagen P=1" in capsys.readouterr().out


def test_what_adagen_cannot_do_is_named_and_the_rest_goes_on(arm: Path) -> None:
    variants = ("--procs 1", "--procs 1 --shape cubist", "--procs 1000", "--procs auto")
    found = measure(Entry("arm", arm), Rules(rounds=1, repeat=1), variants, ())
    assert len(found.rows) == 1
    assert "cubist" in found.absent["adagen --procs 1 --shape cubist"]
    assert "1000 processes: at most" in found.absent["adagen --procs 1000"]
    assert "adagen --procs auto" in found.absent


def test_an_entry_has_variants_of_its_own_and_leaves_out_peers(arm: Path) -> None:
    entry = Entry("arm", arm, without={"mujoco": "it is slow"}, variants=("--procs 1",))
    found = measure(entry, Rules(rounds=1, repeat=1), ("--procs 1 --shape cubist",), ("mujoco",))
    assert [row.team for row in found.rows] == ["adagen"]
    assert found.absent == {"mujoco": "it is slow"}


def test_more_processes_than_cores_are_timed_by_their_stretches(arm: Path) -> None:
    allowed = os.sched_getaffinity(0)
    try:
        os.sched_setaffinity(0, {min(allowed)})  # what is started here inherits it
        found = measure(Entry("arm", arm), Rules(rounds=1, repeat=1), ("--procs 2",), ())
    finally:
        os.sched_setaffinity(0, allowed)
    assert [row.what for row in found.rows] == ["stretches", "stretches_through_root"]
    assert all(row.played and 0 < row.least <= row.median for row in found.rows)
    assert found.timed("adagen", processes=2) is found.rows[0]


def test_sources_that_compile_for_minutes_are_left_out(
    arm: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("adagen.studies.bench.variants.MOST_TEXT", 1000)
    with pytest.raises(UsageError, match="take minutes to compile"):
        measure(Entry("arm", arm), Rules(rounds=1, repeat=1), ("--procs 1",), ())


def test_robots_measured_before_are_kept(arm: Path) -> None:
    rules = Rules(rounds=1, repeat=1)
    one = [Entry("arm", arm)]
    first = contest(one, rules, ("--procs 1",), ())
    heard = []
    again = contest(
        [*one, Entry("other", arm)],
        rules,
        ("--procs 1",),
        (),
        done=lambda record: heard.append(len(record.models)),
        before=first.models,
    )
    assert again.models[0] is first.models[0] and heard == [1, 2]


def test_a_robot_that_cannot_be_measured_may_be_left_out(
    arm: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    entries = [Entry("ghost", tmp_path / "ghost.urdf"), Entry("arm", arm)]
    rules = Rules(rounds=1, repeat=1)
    record = contest(entries, rules, ("--procs 1",), (), keep_going=True)
    assert [model.name for model in record.models] == ["arm"]
    assert "ghost is left out: " in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "status", "complaint"),
    [
        (["--peers", "drake"], 2, "'drake' is none of pinocchio, casadi, mujoco"),
        (["--rounds", "0"], 2, "must be a whole number from 1 to 1000"),
        (["--variant", "--procs 1 --shape cubist", "--peers", "none"], 2, "cubist"),
        (["--profile", "none-such", *ONE], 2, "no cost profile"),
        (["--joints", "8"], 2, "--joints is for --scale"),
        (["--scale", "--floating"], 2, "--scale takes no --floating"),
        (["--scale", "--joints", "8,x"], 2, "must be a whole number from 2"),
        (["--scale", "--processes", "65"], 2, "must be a whole number from 1 to 64"),
        (["--scale", "--resume"], 2, "--out DIR says where"),
        (["--scale", "--peers", "mujoco"], 2, "compares with pinocchio alone"),
        (["--scale", "--profile", "paper"], 2, "needs a profile with costs of steps"),
        (["--scale", "--hosts", "none.toml"], 1, "cannot read the levels"),
        (["other.urdf", "--scale"], 2, "one MODEL at most"),
    ],
)
def test_refusals(
    words: list[str],
    status: int,
    complaint: str,
    arm: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["bench", str(arm), *words]) == status
    assert complaint in capsys.readouterr().err


def test_how_far_chains_scale(
    arm: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    out = tmp_path / "out"
    words = ("--joints", "4", "--processes", "1,2", "--quick", "--peers", "none")
    assert main(["bench", "--scale", str(arm), *words, "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert "   predicted   " in said  # heads are whole
    assert "batches of arm" in said and max(map(len, said.splitlines())) <= 80
    scale = read_scale(out / "scale.json")
    assert (scale.joints, scale.processes, scale.robot) == ((4,), (1, 2), "arm")
    assert {row.source for row in scale.batches} == {"clock", "predicted"}
    assert "Batches of arm" in (out / "scale.md").read_text()
    more = ("--joints", "4,6", *words[2:], "--out", str(out), "--resume")
    assert main(["bench", "--scale", str(arm), *more]) == 0
    again = read_scale(out / "scale.json")
    assert again.joints == (4, 6)
    assert [row for row in again.rows if row.joints != 6] == list(scale.rows)
    assert main(["bench", "--scale", str(arm), *more, "--profile", "xeon"]) == 2
    assert "was measured with the profile default" in capsys.readouterr().err


def test_a_robot_or_chains_must_be_named(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "--quick"]) == 2
    assert "required: MODEL" in capsys.readouterr().err


def test_a_robot_that_is_not_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", str(tmp_path / "none.urdf"), *ONE]) == 1
    assert "none.urdf" in capsys.readouterr().err


@pytest.mark.slow
def test_the_projects_own_set_in_short(tmp_path: Path) -> None:
    """Two robots with whichever peers are installed."""
    pytest.importorskip("matplotlib")
    from benchmarks import bench

    assert bench.main(["--quick", "--out", str(tmp_path)]) == 0
    record = read_record(tmp_path / "bench.json")
    assert "human40" in {model.name for model in record.models}
    for model in record.models:
        assert all(row.forward_error < 1e-6 for row in model.rows if row.scalar == "double")
    assert {path.suffix for path in tmp_path.iterdir()} == {".json", ".md", ".svg", ".png"}
