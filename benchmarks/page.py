"""Pages of documents that hold tables: what a benchmark writes between its two marks."""

from __future__ import annotations

from pathlib import Path

_END = "<!-- end -->"


def write_between_marks(page: Path, benchmark: str, text: str) -> None:
    """Put text between a page's ``<!-- benchmarks.NAME -->`` and ``<!-- end -->``.

    Args:
        page: the document (Markdown), which has these marks.
        benchmark: NAME.
        text: what takes the place of what stands there.

    Raises:
        ValueError: the page has no such marks.
    """
    begin = f"<!-- benchmarks.{benchmark} -->"
    held = page.read_text(encoding="utf-8")
    head, tail = held[: held.index(begin)], held[held.index(_END, held.index(begin)) :]
    page.write_text(f"{head}{begin}\n{text}\n{tail}", encoding="utf-8")
