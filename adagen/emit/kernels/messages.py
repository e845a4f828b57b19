"""Messages in shape kernels, and coupling torques of slaved joints, as C++ lines."""

from __future__ import annotations

from dataclasses import replace

from adagen.emit.messages import (
    block_calls,
    coupling_lines,
    in_a_row,
    receive_lines,
    send_lines,
)
from adagen.emit.processes import entries_of, ranges
from adagen.emit.symbols import Symbols
from adagen.plan.messages import Message
from adagen.plan.steps import Receive, Send
from adagen.plan.types import Process
from adagen.program import Operation


def exchanged(symbols: Symbols, operation: Operation) -> tuple[int, Message]:
    """Return the message that an operation sends or receives, its number first."""
    (step,) = operation.steps
    assert isinstance(step, Send | Receive)
    return step.message, symbols.plan.messages[step.message]


def sent(symbols: Symbols, operation: Operation) -> list[str]:
    """Return the lines that send a message."""
    number, message = exchanged(symbols, operation)
    calls = [
        *(f"put_placement<{j}>(to, w)" for j in message.placements),
        *block_calls(symbols, message, "put", "to"),
        *(f"put(to, {item})" for item in _items(symbols, message)),
        *(f"put(to, w.bodies[{link}])" for link in message.inertias),
    ]
    return send_lines(symbols, number, in_a_row("to", calls))


def received(symbols: Symbols, operation: Operation) -> list[str]:
    """Return the lines that receive a message."""
    number, message = exchanged(symbols, operation)
    taken = zip(message.inertias, operation.first, strict=True)
    calls = [
        *(f"get_placement<{j}>(from, w)" for j in message.placements),
        *(f"get_responses(from, w, {symbols.plan.joints[j].v})" for j in message.joints),
        *block_calls(symbols, message, "get", "from"),
        *(f"get(from, {item})" for item in _items(symbols, replace(message, joints=()))),
        *(f"{'get' if one else 'add'}(from, w.bodies[{k}])" for k, one in taken),
    ]
    return receive_lines(symbols, number, in_a_row("from", calls))


def solved_coupling(symbols: Symbols) -> list[str]:
    """Return the lines that solve for the coupling torques of slaved joints."""
    rows = "std::array<Responses, kSlavedCount>"
    return coupling_lines(symbols, rows, lambda joint: _responses(symbols, joint))


def applied_coupling(symbols: Symbols, process: Process) -> list[str]:
    """Return the lines that add the effect of coupling torques to a process's accelerations."""
    own = ranges(entries_of(symbols, "v", process.owns))
    return [f"apply_coupling(w, {first}, {count});" for first, count in own]


def _responses(symbols: Symbols, joint: int) -> str:
    return f"responses_of(w, {symbols.plan.joints[joint].v})"


def _items(symbols: Symbols, message: Message) -> list[str]:
    if message.sweep == "torques":
        return ["w.coupling"]
    return [
        *(_responses(symbols, joint) for joint in message.joints),
        *(symbols.passage(passage) for passage in message.passages),
        *(symbols.bias(bias) for bias in message.biases),
        *(symbols.force(force) for force in message.forces),
    ]
