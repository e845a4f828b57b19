"""Comparing a folder with what it should hold, and making it hold that."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Mapping
from pathlib import Path

HINT = "if this change is meant: make golden (or pytest tests/golden --update-golden), then review"
LINES = 60
WIDTH = 160


def held(folder: Path, kept: Collection[str] = ()) -> dict[str, bytes]:
    """Return the files below a folder, path to content, without what is kept."""
    paths = [path for path in sorted(folder.rglob("*")) if path.is_file()]
    names = {path.relative_to(folder).as_posix(): path for path in paths}
    return {name: path.read_bytes() for name, path in names.items() if name not in kept}


def differences(folder: Path, expected: Mapping[str, bytes], kept: Collection[str] = ()) -> str:
    """Return what is different in words and as unified diffs cut to a sensible length, or ""."""
    found = held(folder, kept)
    lines = [f"missing: {name}" for name in sorted(set(expected) - set(found))]
    lines += [f"stale: {name}" for name in sorted(set(found) - set(expected))]
    for name in sorted(set(found) & set(expected)):
        if found[name] != expected[name]:
            lines += _diff(name, found[name], expected[name])
    return "\n".join([*lines, HINT]) if lines else ""


def _diff(name: str, old: bytes, new: bytes) -> list[str]:
    a, b = (data.decode(errors="backslashreplace").split("\n") for data in (old, new))
    diff = difflib.unified_diff(a, b, name, "emitted now", n=1, lineterm="")
    shown = [line[:WIDTH] for line in diff]
    if len(shown) > LINES:
        shown = [*shown[:LINES], f"... and {len(shown) - LINES} lines more of {name}"]
    return [f"different: {name}", *shown]


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
