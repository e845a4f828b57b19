"""Values for the templates about processes: their joints, messages and comments."""

from __future__ import annotations

from adagen.emit import forces
from adagen.emit.entries import Range, entries_of, given_entries, ranges, read_joints
from adagen.emit.stages import stage_lines
from adagen.emit.symbols import Symbols
from adagen.plan.stages import stages
from adagen.plan.steps import LinkBias, StartLink
from adagen.plan.types import Process

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
