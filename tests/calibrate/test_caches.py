"""What is told of a core's caches."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.calibrate.caches import instruction_cache, second_cache


def _caches(folder: Path, *caches: tuple[str, str, str]) -> Path:
    for k, found in enumerate(caches):
        (folder / f"index{k}").mkdir()
        for name, text in zip(("level", "type", "size"), found, strict=True):
            (folder / f"index{k}" / name).write_text(f"{text}\n", encoding="ascii")
    return folder


def test_they_are_those_next_to_the_core(tmp_path: Path) -> None:
    found = _caches(
        tmp_path, ("1", "Data", "48K"), ("1", "Instruction", "32K"), ("2", "Unified", "2048K")
    )
    assert instruction_cache(found) == 32768
    assert second_cache(found) == 2 << 20


def test_one_cache_may_be_for_both(tmp_path: Path) -> None:
    assert instruction_cache(_caches(tmp_path, ("1", "Unified", "1M"))) == 1 << 20


@pytest.mark.parametrize("size", ["", "0K", "many", "-3K", "64KB"])
def test_what_is_not_told_is_not_made_up(tmp_path: Path, size: str) -> None:
    found = _caches(tmp_path, ("1", "Instruction", size), ("2", "Unified", size))
    assert instruction_cache(found) is None
    assert second_cache(found) is None
    assert second_cache(tmp_path / "nowhere") is None
    assert instruction_cache(tmp_path / "nowhere") is None
