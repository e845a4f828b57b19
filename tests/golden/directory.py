"""Comparing a folder with what it should hold, and making it hold that."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from pathlib import Path

from adagen.library import comparison

HINT = "if this change is meant: make golden (or pytest tests/golden --update-golden), then review"


def held(folder: Path, kept: Collection[str] = ()) -> dict[str, bytes]:
    """Return the files below a folder, path to content, without what is kept."""
    paths = [path for path in sorted(folder.rglob("*")) if path.is_file()]
    names = {path.relative_to(folder).as_posix(): path for path in paths}
    return {name: path.read_bytes() for name, path in names.items() if name not in kept}


def differences(folder: Path, expected: Mapping[str, bytes], kept: Collection[str] = ()) -> str:
    """Return what is different in words and as unified diffs cut to a sensible length, or ""."""
    lines = comparison.differences(held(folder, kept), expected)
    return "\n".join([*lines, HINT]) if lines else ""


def update(folder: Path, expected: Mapping[str, bytes], kept: Collection[str] = ()) -> None:
    """Write what is missing or different, and remove what is stale."""
    found = held(folder, kept)
    for name in sorted(set(found) - set(expected)):
        (folder / name).unlink()
    for name, data in expected.items():
        if found.get(name) != data:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(data)
    for path in sorted(folder.rglob("*"), reverse=True):
        if path.is_dir() and not any(path.iterdir()):
            path.rmdir()
