"""Processes in emitted code: joints, entries of vectors, stages with time stamps, comments."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Literal

from adagen.emit import forces
from adagen.emit.symbols import Symbols
from adagen.plan.stages import stages
from adagen.plan.steps import GiveOutput, LinkBias, StartLink
from adagen.plan.types import Process
from adagen.program import Operation
from adagen.program.runs import spans

_NAMED = 6  # joints that a summary names before it only counts


def process_rows(symbols: Symbols) -> list[dict[str, object]]:
    """Return the values of the template for each process."""
    return [
        {
            "index": p,
            "summary": _summary(symbols, process),
            "stages": stage_lines(process),
            "stage_count": len(stages(process)),
            "ranges": [own for table in _tables(symbols, process) for own in table],
            "info": _info(p, _tables(symbols, process), len(stages(process))),
        }
        for p, process in enumerate(symbols.plan.processes)
    ]


def _summary(symbols: Symbols, process: Process) -> str:
    if not process.owns:
        return "has nothing to do"
    names = [symbols.quoted_joint(j) for j in process.owns[:_NAMED]]
    more = ", ..." if len(process.owns) > _NAMED else ""
    shared = len(process.shares)
    core = f"; {shared} more that every process computes for itself" if shared else ""
    passing = len(process.reads) - len(process.owns) - shared
    path = f"; kinematics of {passing} more on the way to the ground" if passing else ""
    if process.spares:
        path = "; all of them in a singular pose"
    own = f"{len(process.owns)} of {len(symbols.plan.joints)} joints: {', '.join(names)}{more}"
    return f"{own}{core}{path}"


def _tables(symbols: Symbols, process: Process) -> list[list[Range]]:
    """What a process reads of q and v (a slaved joint's from its source), its own entries, and tau.

    Each as ranges (first, count).
    """
    read = read_joints(symbols, process)
    q, v = entries_of(symbols, "q", read), entries_of(symbols, "v", read)
    own = [*given_entries(symbols, process), *symbols.plan.force_entries(process)]
    torques = entries_of(symbols, "v", (*process.owns, *process.shares, *process.spares))
    links = {step.link for step in process.steps_of(LinkBias, StartLink)}
    torques += forces.pushed_entries(symbols, links)
    return [ranges(entries) for entries in (q, v, own, torques)]


def _info(p: int, tables: list[list[Range]], stage_count: int) -> str:
    """Where the ranges of each table are among all those of a process, and where its stages are."""
    if not any(tables) and not stage_count:
        return ""
    first, parts = 0, []
    for table in tables:
        place = f"kRanges_{p}.data(){f' + {first}' * (first > 0)}" if table else "nullptr"
        parts.append(f"{{{len(table)}, {place}}}")
        first += len(table)
    if stage_count:
        parts.append(f"{{{stage_count}, kStages_{p}.data()}}")
    return ", ".join(parts)


def table_sizes(symbols: Symbols, process: Process) -> tuple[int, int]:
    """Return the numbers that process 0 sends it of the state, and that it sends back."""
    q, v, own, torques = (sum(n for _, n in table) for table in _tables(symbols, process))
    return q + v + torques, own


_WIDTH = 100  # of lines of stages


def stage_lines(process: Process) -> list[str]:
    """Return the stages for the template, a few on a line; -1 stands for none."""
    lines = [""]
    for stage in stages(process):
        numbers = (-1 if number is None else number for number in (stage.joint, stage.message))
        entry = f'{{"{stage.what}", {", ".join(map(str, numbers))}}}, '
        if len(lines[-1]) + len(entry) > _WIDTH:
            lines.append("")
        lines[-1] += entry
    lines[-1] = lines[-1].removesuffix(", ")
    return [line.rstrip() for line in lines if line]


def stamped(
    process: Process,
    operations: Sequence[Operation],
    lines_of: Callable[[Operation], list[str]],
) -> list[str]:
    """Return the lines of all operations with a time stamp after each stage."""
    lines: list[str] = []
    place = 0
    for number in range(len(stages(process))):
        while place < len(operations) and operations[place].stage == number:
            lines += lines_of(operations[place])
            place += 1
        lines.append(f"stamp({number + 1});")
    return lines


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
