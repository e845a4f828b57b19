"""Values for the templates about processes: their joints, messages and comments."""

from __future__ import annotations

from collections.abc import Sequence

from adagen.emit import forces
from adagen.emit.entries import Range, entries_of, given_entries, ranges, read_joints
from adagen.emit.stages import stage_lines
from adagen.emit.symbols import Symbols
from adagen.executor import simulate
from adagen.plan.stages import stages
from adagen.plan.steps import LinkBias, StartLink
from adagen.plan.types import CERTIFICATE, ENERGIES, Message, Process
from adagen.program.lower import LOOPS
from adagen.program.own_axes import own_axes_in_loops

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


def describe_message(symbols: Symbols, message: Message) -> str:
    """Return the contents of a message, in a few words."""
    if message.sweep == ENERGIES:
        return "sizes of corrections"
    if message.sweep == CERTIFICATE:
        return "its share of the certificate"
    if message.joint is None:
        what = "accelerations" if message.sweep == "slaved" else "torques"
        return f"{what} of slaved joints"
    if message_size(symbols, message) == 0:
        return "an evaluation begins"
    if message.inertias:
        links = ", ".join(symbols.quoted_link(link) for link in message.inertias)
        return f"I^A and p^A at {links}"
    if message.passages:
        spans = (symbols.span(own.first, own.last) for own in message.passages)
        return f"motion of the last link of {', '.join(spans)}"
    if message.sides:
        bases = ", ".join(symbols.quoted_joint(side.joints[0]) for side in message.sides)
        return f"loop rows of the trees at {bases}"
    what = "assembled" if message.sweep == "assembly" else "forces on"
    return f"{what}: chain of {symbols.quoted_joint(message.joint)}"


def in_a_row(place: str, calls: Sequence[str]) -> list[str]:
    """Return lines of calls, each of which starts where the one before returned."""
    return [f"  {place} = {call};" for call in calls[:-1]] + [f"  {call};" for call in calls[-1:]]


def block_calls(symbols: Symbols, message: Message, verb: str, place: str) -> list[str]:
    """Return the calls that put the blocks of a message there, or get them."""
    alike = ("" if block.row != block.column else "_symmetric" for block in message.blocks)
    named = zip(alike, map(symbols.block, message.blocks), strict=True)
    return [f"{verb}{symmetric}({place}, {block})" for symmetric, block in named]


def message_size(symbols: Symbols, message: Message) -> int:
    """Return the numbers in a message, at least one."""
    if symbols.plan.reproducible:
        source = simulate(symbols.plan, symbols.program.slots.limbs)[message.source]
        return max(1, len(source.machine.sent[symbols.plan.messages.index(message)]))
    whole = message.joint is None  # of slaved joints: all right-hand sides together
    columns = symbols.plan.right_hand_sides if whole else symbols.columns
    return message.numbers(columns, symbols.plan.joints) + _beside_placements(symbols, message)


def _beside_placements(symbols: Symbols, message: Message) -> int:
    """Return what loops send of joints beside 12 numbers each (templates/.../passages.hpp).

    Where a link's mobility is in its own axes and that of the next one is not, both the turn of the
    joint between them and its axes are needed.
    """
    plan, program = symbols.plan, symbols.program
    if not message.placements or program.shape != LOOPS:
        return 0
    own = own_axes_in_loops(plan, program.slots.limbs, program.batch).always
    return sum(6 for j in message.placements if j not in own and plan.joints[j].parent - 1 in own)


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
