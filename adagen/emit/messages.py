"""Messages in emitted code: what they hold, in words and numbers, and the lines around them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from adagen.emit.symbols import Symbols
from adagen.executor import simulate
from adagen.plan.messages import CERTIFICATE, ENERGIES, Message
from adagen.program.lower import LOOPS
from adagen.program.runs import own_axes_in_loops


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


def send_lines(symbols: Symbols, number: int, lines: Iterable[str]) -> list[str]:
    """Return the lines that send a message, those in it that put its numbers to ``to``."""
    message, puts = symbols.plan.messages[number], list(lines)
    place = "Number* to = " if puts else ""  # a message of no numbers only says that it is there
    return [
        f"{{  // to process {message.target}: {describe_message(symbols, message)}",
        f"  {place}channel.outgoing({number}, w.status);",
        *puts,
        f"  channel.send({number}, w.status);",
        "}",
    ]


def receive_lines(symbols: Symbols, number: int, lines: Iterable[str]) -> list[str]:
    """Return the lines that receive a message, those in it that get its numbers from ``from``."""
    message, gets = symbols.plan.messages[number], list(lines)
    place = "const Number* from = " if gets else ""
    return [
        f"{{  // from process {message.source}: {describe_message(symbols, message)}",
        f"  {place}channel.receive({number}, w.status);",
        *gets,
        "}",
    ]


def coupling_lines(symbols: Symbols, rows: str, responses: Callable[[int], str]) -> list[str]:
    """Return the lines that solve for the coupling torques of slaved joints.

    Args:
        symbols: the plan's names.
        rows: C++ type of all rows.
        responses: returns the accelerations of a joint, for each right-hand side.
    """
    return [
        "{",
        f"  {rows} rows;",
        *(
            f"  coupling_row(rows[{k}], {responses(slaved)}, {responses(source)}, {multiplier!r});"
            for k, (slaved, source, multiplier) in enumerate(symbols.plan.following)
        ),
        f"  solve_coupling(w, {symbols.plan.slaved[0]}, rows, w.coupling);",
        "}",
    ]
