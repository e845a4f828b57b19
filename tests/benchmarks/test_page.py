"""What is written by hand in a page stays when a benchmark writes its tables."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.page import write_between_marks


def test_only_what_is_between_the_markers_is_replaced(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("# Head\n<!-- benchmarks.x -->\nold\n<!-- end -->\nremark\n")
    write_between_marks(page, "x", "new\ntable")
    expected = "# Head\n<!-- benchmarks.x -->\nnew\ntable\n<!-- end -->\nremark\n"
    assert page.read_text() == expected


@pytest.mark.parametrize("text", ["", "<!-- benchmarks.x -->\n", "<!-- end -->\n"])
def test_a_page_without_markers_is_left_alone(tmp_path: Path, text: str) -> None:
    page = tmp_path / "page.md"
    page.write_text(text)
    with pytest.raises(ValueError, match="not found"):
        write_between_marks(page, "x", "new")
    assert page.read_text() == text
