"""Differences between existing files and expected ones, in words and diffs."""

from __future__ import annotations

import difflib
from collections.abc import Mapping

LINES = 60
"""Lines of a file's diff that are shown."""
_WIDTH = 160


def differences(found: Mapping[str, bytes], expected: Mapping[str, bytes]) -> list[str]:
    """Return as lines what is missing, stale or different; none if nothing is.

    Args:
        found: path to content, of the files that are there.
        expected: the same of those that should be.
    """
    lines = [f"missing: {name}" for name in sorted(set(expected) - set(found))]
    lines += [f"stale: {name}" for name in sorted(set(found) - set(expected))]
    for name in sorted(set(found) & set(expected)):
        if found[name] != expected[name]:
            lines += _diff(name, found[name], expected[name])
    return lines


def _diff(name: str, old: bytes, new: bytes) -> list[str]:
    """A unified diff, cut to a sensible length."""
    a, b = (data.decode(errors="backslashreplace").split("\n") for data in (old, new))
    diff = difflib.unified_diff(a, b, name, "emitted now", n=1, lineterm="")
    shown = [line[:_WIDTH] for line in diff]
    if len(shown) > LINES:
        shown = [*shown[:LINES], f"... and {len(shown) - LINES} lines more of {name}"]
    return [f"different: {name}", *shown]
