"""Benchmarks of hard states go on with what their records have."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks import adversary, certificates
from benchmarks.hard import Asked
from benchmarks.page import Record


def test_what_is_recorded_is_not_solved_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    wrong = {"robot": "x", "way": {}, "state": 3, "error": float("inf")}
    ways = {"kernels": {"answered": 7, "refused": 1, "warned": False, "wrong": [wrong]}}
    record = tmp_path / "record.jsonl"
    rows = [{"seed": 1, "states": 8, "robot": k, "found": ways} for k in range(2)]
    record.write_text("".join(json.dumps(row) + "\n" for row in rows))
    words = ["adversary", "--robots", "2", "--states", "8", "--record", str(record)]
    monkeypatch.setattr("sys.argv", words)
    adversary.main()
    out, err = capsys.readouterr()
    assert "| kernels | 2 | 14 | 2 | 0 | 2, on 2 robots |" in out
    assert "16 evaluations, 2 wrong in silence." in out
    assert "1 wrong, silent, the worst inf in state 3" in err
    assert len(record.read_text().splitlines()) == 2


def test_bounds_that_are_recorded_are_not_measured_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    ways = {"kernels": {"errors": [1e-15, 4e-13], "bounds": [2e-14, 1e-13], "refused": 1}}
    record, asked = tmp_path / "record.jsonl", Asked(robots=2, states=3, seed=1)
    for k in range(2):
        assert Record(record).of(asked.key(k), lambda: ways) == ways
    words = ["certificates", "errors", "--robots", "2", "--states", "3", "--record", str(record)]
    monkeypatch.setattr("sys.argv", words)
    certificates.main()
    out = capsys.readouterr().out
    assert "| kernels | slender tools | 2 | 1 | 4e-13 | 1e-13 | 10 | 4.00 | 1 |" in out
    assert "4 evaluations, 2 bounds exceeded by more than 3." in out
