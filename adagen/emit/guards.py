"""What a process refuses in shape `kernels`: states and accelerations that are not finite."""

from __future__ import annotations

from collections.abc import Iterable

from adagen.emit.words import Words
from adagen.plan.types import Process


def checks(words: Words, process: Process) -> list[str]:
    """Return the lines that refuse a state."""
    return [
        *_finite(words, "w.q", "q", process.reads, "kNotFinite"),
        *_finite(words, "w.v", "v", process.reads, "kNotFinite"),
        *_finite(words, "w.tau", "v", process.treated, "kNotFinite"),
    ]


def results(words: Words, process: Process) -> list[str]:
    """Return the lines that give the accelerations, if all went well."""
    owned = _ranges(words, "v", process.owns)
    return [
        *_finite(words, "w.answer.data()", "v", process.owns, "kOverflow"),
        *(f"give(w, {first}, {count});" for first, count in owned),
    ]


def _finite(words: Words, array: str, place: str, joints: Iterable[int], failure: str) -> list[str]:
    return [
        f"require_finite(w, {array}, {first}, {count}, &JointConstants::{place}, {failure});"
        for first, count in _ranges(words, place, joints)
    ]


def _ranges(words: Words, name: str, joints: Iterable[int]) -> list[tuple[int, int]]:
    """Ranges (start, count) of q or v that joints have, those that touch made one."""
    found: list[tuple[int, int]] = []
    for j in joints:
        joint, kind = words.plan.joints[j], words.kind(j)
        start, count = (joint.q, kind.nq) if name == "q" else (joint.v, kind.nv)
        if found and sum(found[-1]) == start:
            start, count = found[-1][0], found[-1][1] + count
            found.pop()
        found.append((start, count))
    return found
