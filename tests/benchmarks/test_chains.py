"""Long chains: the record goes on where it was left, and the page gets tables and a picture."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.studies.bench.scale_record import read_scale
from benchmarks import chains


@pytest.mark.slow
def test_the_page_gets_tables_and_a_picture(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("matplotlib")
    record, page = tmp_path / "kept" / "scale.json", tmp_path / "page.md"
    monkeypatch.setattr(chains, "RECORD", record)
    monkeypatch.setattr(chains, "MOST_SHARED", 8)
    page.write_text("<!-- benchmarks.chains -->\n<!-- end -->\n")
    words = ["--processes", "2", "--rounds", "1", "--repeat", "1"]
    assert chains.main([*words, "--joints", "8"]) == 0
    first = read_scale(record)
    words += ["--joints", "8", "16", "--resume", "--write", str(page)]
    assert chains.main(words) == 0
    both = read_scale(record)
    assert both.rows[: len(first.rows)] == first.rows
    assert [row.processes for row in both.rows if row.joints == 16] == [1]  # too long to share
    text = page.read_text()
    assert "![scale_joints](pictures/scale_joints.svg)" in text and "| 16 |" in text
    assert 'id="adagen P=1"' in (tmp_path / "pictures" / "scale_joints.svg").read_text()
