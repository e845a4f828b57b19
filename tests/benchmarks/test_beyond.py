"""Predictions beyond one machine, and the check by what was measured."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from adagen.studies.bench.contest import Rules
from adagen.studies.bench.scale_record import Scale, ScaleRow
from adagen.studies.records import write_record
from benchmarks import beyond
from benchmarks.critical_path import KINDS
from tests.studies.bench.test_record import MACHINE

MARKS = "".join(
    f"<!-- benchmarks.beyond.{name} -->\n<!-- end -->\n"
    for name in ("times", "limits", "batches", "check")
)


def test_tables_of_small_chains_and_a_record(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(beyond, "BATCHES", (4,))
    one = ScaleRow("adagen", "x", 64, 1, "clock", 9e3, 8e3, 0.0, 4e3, 8e3)
    two = replace(one, processes=2, least=4.4e3, predicted=2.5e3, scaled=4e3, meeting="gather")
    record, page = tmp_path / "scale.json", tmp_path / "page.md"
    write_record(Scale(MACHINE, Rules(), "default", (one, two)), record)
    page.write_text(MARKS)
    words = ["--joints", "64", "--processes", "2", "4", "64"]
    assert beyond.main([*words, "--check", str(record), "--write", str(page)]) == 0
    text = page.read_text()
    times, limits, batches, check = text.split("<!-- end -->")[:4]
    assert "chain of 64, us" in times and "| 4 |" in times and "| 64 |" not in times
    rows = [line.split("|")[1:-1] for line in limits.splitlines() if line.startswith("| 64")]
    assert [int(cells[1]) for cells in rows] == [2, 4]
    for cells in rows:
        shares = [float(cell.strip(" %")) for cell in cells[2 : 2 + len(KINDS)]]
        assert sum(shares) == pytest.approx(100, abs=len(KINDS) / 2)
    assert "| 1024 |" in batches
    assert "| 4.40 | 2.50 | +76% | 4.00 | +10% | 45.0% | 50.0% |" in check


def test_a_profile_without_steps_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        beyond.main(["--profile", "paper"])
    assert "has no costs of steps" in capsys.readouterr().err
    assert beyond.main(["--hosts", "none.toml"]) == 1
