"""What a process refuses in shape `kernels`: states and accelerations that are not finite."""

from __future__ import annotations

from collections.abc import Iterable

from adagen.emit.words import Words
from adagen.plan.edges import is_base
from adagen.plan.steps import Receive, Send
from adagen.plan.types import Process


def checks(words: Words, process: Process) -> list[str]:
    """Return the lines that refuse a state before anything is done with it.

    A process that sends nothing looks only at what its accelerations do not depend on. The rest
    spoils an acceleration or a pivot, which are looked at in any case: see ``results``.
    """
    if talks(process):
        return _state(words, process)
    bases = [j for j in process.reads if is_base(words.plan.joints[j])]
    return [
        f"require_finite(w, w.q, {words.plan.joints[j].q}, 3, &JointConstants::q, kNotFinite);"
        for j in bases
    ]


def results(words: Words, process: Process) -> list[str]:
    """Return the lines that give the accelerations, if all went well."""
    owned = _ranges(words, "v", process.owns)
    overflow = _finite(words, "w.answer.data()", "v", process.owns, "kOverflow")
    gives = [f"give(w, {first}, {count});" for first, count in owned]
    if talks(process):
        return [*overflow, *gives]
    if not owned:
        return []
    amiss = " || ".join(f"!went_well(w, {first}, {count})" for first, count in owned)
    return [
        f"if ({amiss}) {{  // first of all for the state's sake",
        "  const int found = std::exchange(w.status, kFine);",
        *(f"  {line}" for line in _state(words, process)),
        "  Channel::fail(w.status, found);",
        *(f"  {line}" for line in overflow),
        "}",
        *gives,
    ]


def talks(process: Process) -> bool:
    """Return whether a process sends or receives."""
    return any(isinstance(step, Send | Receive) for step in process.steps)


def _state(words: Words, process: Process) -> list[str]:
    return [
        *_finite(words, "w.q", "q", process.reads, "kNotFinite"),
        *_finite(words, "w.v", "v", process.reads, "kNotFinite"),
        *_finite(words, "w.tau", "v", process.treated, "kNotFinite"),
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
