"""Messages in shape kernels, and coupling torques of slaved joints, as C++ lines."""

from __future__ import annotations

from dataclasses import replace

from adagen.emit.entries import entries_of, ranges
from adagen.emit.processes import block_calls, describe_message, in_a_row
from adagen.emit.symbols import Symbols
from adagen.plan.steps import Receive, Send
from adagen.plan.types import Message, Process
from adagen.program import Operation


def exchanged(symbols: Symbols, operation: Operation) -> tuple[int, Message]:
    """Return the message that an operation sends or receives, its number first."""
    (step,) = operation.steps
    assert isinstance(step, Send | Receive)
    return step.message, symbols.plan.messages[step.message]


def sent(symbols: Symbols, operation: Operation) -> list[str]:
    """Return the lines that send a message."""
    number, message = exchanged(symbols, operation)
    return [
        f"{{  // to process {message.target}: {describe_message(symbols, message)}",
        f"  Number* to = channel.outgoing({number}, w.status);",
        *in_a_row(
            "to",
            [
                *(f"put_placement<{j}>(to, w)" for j in message.placements),
                *block_calls(symbols, message, "put", "to"),
                *(f"put(to, {item})" for item in _items(symbols, message)),
                *(f"put(to, w.bodies[{link}])" for link in message.inertias),
            ],
        ),
        f"  channel.send({number}, w.status);",
        "}",
    ]


def received(symbols: Symbols, operation: Operation) -> list[str]:
    """Return the lines that receive a message."""
    number, message = exchanged(symbols, operation)
    taken = zip(message.inertias, operation.first, strict=True)
    return [
        f"{{  // from process {message.source}: {describe_message(symbols, message)}",
        f"  const Number* from = channel.receive({number}, w.status);",
        *in_a_row(
            "from",
            [
                *(f"get_placement<{j}>(from, w)" for j in message.placements),
                *(f"get_responses(from, w, {symbols.plan.joints[j].v})" for j in message.joints),
                *block_calls(symbols, message, "get", "from"),
                *(f"get(from, {item})" for item in _items(symbols, replace(message, joints=()))),
                *(f"{'get' if one else 'add'}(from, w.bodies[{k}])" for k, one in taken),
            ],
        ),
        "}",
    ]


def solved_coupling(symbols: Symbols) -> list[str]:
    """Return the lines that solve for the coupling torques of slaved joints."""
    plan = symbols.plan
    rows = []
    for k, slaved in enumerate(plan.slaved):
        mimic = plan.joints[slaved].mimic
        assert mimic is not None  # that is what slaved means
        own, source = _responses(symbols, slaved), _responses(symbols, mimic[0])
        rows.append(f"  coupling_row(rows[{k}], {own}, {source}, {mimic[1]!r});")
    return [
        "{",
        "  std::array<Responses, kSlavedCount> rows;",
        *rows,
        f"  solve_coupling(w, {plan.slaved[0]}, rows, w.coupling);",
        "}",
    ]


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
