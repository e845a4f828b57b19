"""Tests of a process: states and accelerations that are not finite are refused.

A process that sends nothing tests its inputs only if an acceleration or a pivot fails its test; it
tests beforehand the inputs on which none of them depends. A process that sends must not send a NaN.
"""

from __future__ import annotations

from collections.abc import Iterable

from adagen.emit.processes import entries_of, given_entries, ranges, read_joints
from adagen.emit.symbols import Symbols
from adagen.plan.edges import is_base
from adagen.plan.steps import Receive, Send
from adagen.plan.types import Process


def talks(process: Process) -> bool:
    """Return whether a process sends or receives."""
    return any(process.steps_of(Send, Receive))


def checks(symbols: Symbols, process: Process) -> list[str]:
    """Return the lines of shape kernels that test a state before anything is computed.

    Where a floating base is matters to nothing.
    """
    if talks(process):
        return _state(symbols, process)
    bases = [symbols.plan.joints[j].q for j in process.reads if is_base(symbols.plan.joints[j])]
    return _finite("w.q", [k for q in bases for k in range(q, q + 3)], "q", "kNotFinite")


def results(symbols: Symbols, process: Process) -> list[str]:
    """Return the lines of shape kernels that output accelerations, if there was no failure."""
    entries = given_entries(symbols, process)
    overflow = _finite("w.answer.data()", entries, "v", "kOverflow")
    gives = [f"give(w, {first}, {count});" for first, count in ranges(entries)]
    if talks(process) or not gives:
        return [*overflow, *gives]
    amiss = " || ".join(f"!went_well(w, {first}, {count})" for first, count in ranges(entries))
    looked_at = ", ".join(map(_braced, (*_read(symbols, process), entries)))
    return [f"if ({amiss}) find_fault(w, {looked_at});", *gives]


def corrections(symbols: Symbols, process: Process) -> list[str]:
    """Return the lines of shape kernels that output a correction, if there was no failure."""
    entries = entries_of(symbols, "v", process.owns)
    overflow = _finite("w.answer.data()", entries, "v", "kOverflow")
    return [*overflow, *(f"give(w, {first}, {count});" for first, count in ranges(entries))]


def _state(symbols: Symbols, process: Process) -> list[str]:
    q, v, tau = _read(symbols, process)
    return [
        *_finite("w.q", q, "q", "kNotFinite"),
        *_finite("w.v", v, "v", "kNotFinite"),
        *_finite("w.tau", tau, "v", "kNotFinite"),
    ]


def _read(symbols: Symbols, process: Process) -> tuple[list[int], list[int], list[int]]:
    """Entries of q, v and tau that a process reads."""
    read = read_joints(symbols, process)
    tau = entries_of(symbols, "v", process.treated)
    return entries_of(symbols, "q", read), entries_of(symbols, "v", read), tau


def _braced(entries: Iterable[int]) -> str:
    return f"{{{', '.join(f'{{{first}, {count}}}' for first, count in ranges(entries))}}}"


def _finite(array: str, entries: Iterable[int], place: str, failure: str) -> list[str]:
    return [
        f"require_finite(w, {array}, {first}, {count}, &JointConstants::{place}, {failure});"
        for first, count in ranges(entries)
    ]
