"""What is said of two revisions' times; nothing is timed here."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.cli.contest import Entry
from adagen.studies.bench.variants import MOST_TEXT
from benchmarks import against
from benchmarks.against import Row, Source, emitted, report, typical

ROOT = Path(__file__).resolve().parents[2]


def test_a_typical_time_leaves_noisy_turns_out_and_lies_between_ticks() -> None:
    assert typical([130, 130, 120, 120, 900, 110, 130, 120]) == 125
    assert typical([7.0]) == 7


def test_what_is_slower_is_marked_and_counted() -> None:
    rows = [
        Row("a", "P=1", 100, 102, 90, 90),
        Row("a", "P=2", 100, 104, 90, 99),
        Row("b", "P=1", 8, 4, 7, 3.5),
    ]
    text = report(rows)
    lines = text.splitlines()
    assert lines[2] == "| a | P=2 | 100 | 104 | 1.040 | 1.100 | slower |"
    assert lines[3] == "| a | P=1 | 100 | 102 | 1.020 | 1.000 |  |"
    assert lines[4] == "| b | P=1 | 8.0 | 4.0 | 0.500 | 0.500 |  |"
    assert lines[-1].startswith("3 figures: 1 take more than 1.03 x")
    assert lines[-1].endswith("ratios from 0.50 to 1.04, median 1.020.")


def test_a_checkout_emits_once_and_refusals_are_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    arm = Entry("arm7", ROOT / "generated_examples/models/arm7.urdf")
    found = emitted(ROOT, tmp_path / "kept", arm, "--procs 1")
    assert (found.file, found.refused, found.wanted) == ("arm7_p1.cpp", "", True)
    refused = emitted(ROOT, tmp_path / "kept", arm, "--procs 0")
    assert "--procs" in refused.refused and not refused.wanted
    monkeypatch.setattr("subprocess.run", None)
    assert emitted(ROOT, tmp_path / "kept", arm, "--procs 1") == found
    assert emitted(ROOT, tmp_path / "kept", arm, "--procs 0") == refused


def test_sources_are_kept_by_what_emits_them(tmp_path: Path) -> None:
    for folder in ("adagen", "templates"):
        (tmp_path / folder).mkdir()
    (tmp_path / "adagen" / "a.py").write_text("x = 1\n")
    before = against.digest(tmp_path)
    (tmp_path / "templates" / "b.hpp").write_text("")
    after = against.digest(tmp_path)
    assert before != after
    (tmp_path / "readme").write_text("nothing that is read")
    assert against.digest(tmp_path) == after


def test_long_sources_are_not_built() -> None:
    assert Source("a.cpp", "x", "").wanted
    assert not Source("a.cpp", "x" * (MOST_TEXT + 1), "").wanted
