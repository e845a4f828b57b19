"""What processes of shape kernels send each other, and the torques that hold slaved joints."""

from __future__ import annotations

from dataclasses import replace

from adagen.emit.entries import entries_of, ranges
from adagen.emit.processes import describe_message, in_a_row
from adagen.emit.words import Words
from adagen.plan.steps import Receive, Send
from adagen.plan.types import Message, Process
from adagen.program import Operation


def exchanged(words: Words, operation: Operation) -> tuple[int, Message]:
    """Return the message that an operation sends or takes, its number first."""
    (step,) = operation.steps
    assert isinstance(step, Send | Receive)
    return step.message, words.plan.messages[step.message]


def sent(words: Words, operation: Operation) -> list[str]:
    """Return the lines that send a message."""
    number, message = exchanged(words, operation)
    return [
        f"{{  // to process {message.target}: {describe_message(words, message)}",
        f"  Number* to = channel.outgoing({number}, w.status);",
        *in_a_row(
            "to",
            [
                *(f"put(to, {item})" for item in _items(words, message)),
                *(f"put(to, w.bodies[{link}])" for link in message.inertias),
            ],
        ),
        f"  channel.send({number}, w.status);",
        "}",
    ]


def received(words: Words, operation: Operation) -> list[str]:
    """Return the lines that take a message."""
    number, message = exchanged(words, operation)
    taken = zip(message.inertias, operation.first, strict=True)
    return [
        f"{{  // from process {message.source}: {describe_message(words, message)}",
        f"  const Number* from = channel.receive({number}, w.status);",
        *in_a_row(
            "from",
            [
                *(f"get_responses(from, w, {words.plan.joints[j].v})" for j in message.joints),
                *(f"get(from, {item})" for item in _items(words, replace(message, joints=()))),
                *(f"{'get' if one else 'add'}(from, w.bodies[{k}])" for k, one in taken),
            ],
        ),
        "}",
    ]


def solved_coupling(words: Words) -> list[str]:
    """Return the lines that find the torques that hold slaved joints in step."""
    plan = words.plan
    rows = []
    for k, slaved in enumerate(plan.slaved):
        mimic = plan.joints[slaved].mimic
        assert mimic is not None  # that is what slaved means
        own, source = _responses(words, slaved), _responses(words, mimic[0])
        rows.append(f"  coupling_row(rows[{k}], {own}, {source}, {mimic[1]!r});")
    return [
        "{",
        "  std::array<Responses, kSlavedCount> rows;",
        *rows,
        f"  solve_coupling(w, {plan.slaved[0]}, rows, w.coupling);",
        "}",
    ]


def applied_coupling(words: Words, process: Process) -> list[str]:
    """Return the lines that add what these torques do to a process's own accelerations."""
    own = ranges(entries_of(words, "v", process.owns))
    return [f"apply_coupling(w, {first}, {count});" for first, count in own]


def _responses(words: Words, joint: int) -> str:
    return f"responses_of(w, {words.plan.joints[joint].v})"


def _items(words: Words, message: Message) -> list[str]:
    if message.sweep == "torques":
        return ["w.coupling"]
    return [
        *(_responses(words, joint) for joint in message.joints),
        *(words.passage(passage) for passage in message.passages),
        *(words.block(block) for block in message.blocks),
        *(words.bias(bias) for bias in message.biases),
        *(words.force(force) for force in message.forces),
    ]
