"""Index ranges of joints in q and v, and the joints that a process reads."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from adagen.emit.symbols import Symbols
from adagen.plan.steps import GiveOutput
from adagen.plan.types import Process
from adagen.program.runs import spans

Range = tuple[int, int]
"""The first of some entries, and how many."""


def ranges(entries: Iterable[int]) -> list[Range]:
    """Return entries as ranges, adjacent ones merged."""
    return [(first, last - first + 1) for first, last in spans(entries)]


def entries_of(symbols: Symbols, vector: Literal["q", "v"], joints: Iterable[int]) -> list[int]:
    """Return the entries of joints in q, or in v (and tau and qdd)."""
    found: list[int] = []
    for j in joints:
        joint, kind = symbols.plan.joints[j], symbols.kind(j)
        first, count = (joint.q, kind.nq) if vector == "q" else (joint.v, kind.nv)
        found += range(first, first + count)
    return found


def given_entries(symbols: Symbols, process: Process) -> list[int]:
    """Return the entries of qdd that a process gives."""
    plan = symbols.plan
    found = entries_of(symbols, "v", (j for j in process.owns if plan.wants(j)))
    if any(process.steps_of(GiveOutput)):
        found += range(plan.nv, plan.entry_of_output(len(plan.outputs)))
    return found


def read_joints(symbols: Symbols, process: Process) -> list[int]:
    """Return the joints whose q and v a process reads: instead of a slaved one its source."""
    return sorted(set(map(symbols.plan.source_of, process.reads)))
