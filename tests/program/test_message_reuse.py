"""Slots of messages are free when they are written again, whoever is how fast."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as some

from adagen.plan.messages import Message
from adagen.plan.steps import Receive, Send, Step
from adagen.program import ProgramError, check
from adagen.program.message_reuse import SLOTS, overwritten
from adagen.program.types import Operation
from tests.program.test_check import example

Exchanges = list[list[Operation]]


def exchange(step: Step) -> Operation:
    return Operation(does="", block=None, method="step", steps=(step,), stage=0)


def exchanges_of(
    ways: Sequence[tuple[int, int]], processes: int
) -> tuple[list[Message], Exchanges]:
    """Messages between pairs of processes, sent and received one after the other."""
    operations: Exchanges = [[] for _ in range(processes)]
    for number, (source, target) in enumerate(ways):
        operations[source].append(exchange(Send(number)))
        operations[target].append(exchange(Receive(number)))
    return [Message(source, target, "assembly", 0) for source, target in ways], operations


def reached_while_one_stands(
    messages: Sequence[Message], operations: Sequence[Sequence[Operation]], number: int
) -> bool:
    """Whether a message is sent a third time while its target still looks at the first.

    Played through: the target stops once it has received it, everybody else goes on for as long as
    they have what they wait for.
    """
    source, target = messages[number].source, messages[number].target
    at = [0] * len(operations)
    counts = {("sent", k): 0 for k in range(len(messages))}
    counts |= {("received", k): 0 for k in range(len(messages))}
    moved = True
    while moved:
        moved = False
        for p, own in enumerate(operations):
            if p == target and counts["received", number] == 1:
                continue
            if not own or at[p] >= (SLOTS + 1) * len(own):
                continue
            (step,) = own[at[p] % len(own)].steps
            assert isinstance(step, Receive | Send)
            if isinstance(step, Send):
                counts["sent", step.message] += 1
            elif counts["sent", step.message] > counts["received", step.message]:
                counts["received", step.message] += 1
            else:
                continue
            at[p] += 1
            moved = True
    assert at[source] > 0
    return counts["sent", number] > SLOTS


@given(some.data())
def test_it_finds_what_the_fastest_processes_would_overwrite(data: some.DataObject) -> None:
    processes = data.draw(some.integers(2, 5))
    process = some.integers(0, processes - 1)
    pair = some.tuples(process, process).filter(lambda ends: ends[0] != ends[1])
    ways = data.draw(some.lists(pair, min_size=1, max_size=9))
    messages, operations = exchanges_of(ways, processes)
    expected = [
        number
        for number in range(len(messages))
        if reached_while_one_stands(messages, operations, number)
    ]
    assert overwritten(messages, operations) == expected


@pytest.mark.parametrize(
    ("ways", "expected"),
    [
        ([(0, 1)], [0]),  # nobody answers
        ([(0, 1), (1, 0)], []),
        ([(0, 1), (0, 1), (1, 0)], []),
        ([(0, 1), (1, 2), (2, 0)], []),  # answered through another
        ([(0, 1), (2, 0), (1, 2)], []),  # an evaluation later
        ([(0, 1), (3, 0), (2, 3), (1, 2)], [0, 1, 2, 3]),  # two evaluations later: too late
    ],
)
def test_answers_may_take_a_way_round(ways: list[tuple[int, int]], expected: list[int]) -> None:
    assert overwritten(*exchanges_of(ways, 4)) == expected


def test_a_program_whose_processes_are_not_answered_is_refused() -> None:
    program = example()
    first, second = program.processes
    (answer,) = (k for k, message in enumerate(program.plan.messages) if message.source == 0)
    until = next(k for k, o in enumerate(second.operations) if Receive(answer) in o.steps)
    silent = replace(
        program,
        plan=replace(program.plan, wanted=program.plan.processes[0].owns),
        processes=(
            replace(
                first, operations=tuple(o for o in first.operations if Send(answer) not in o.steps)
            ),
            replace(second, operations=second.operations[:until]),
        ),
    )
    with pytest.raises(ProgramError, match="may be overwritten before it was read"):
        check(silent)
