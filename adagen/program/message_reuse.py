"""Proof that no message is written while its target may still read the one before.

Processes of one host exchange through shared memory: a message has two slots, which successive
evaluations use in turn, and nobody asks whether a slot is free. So a process that sends a message
must have heard from its target since the target received that message two evaluations before, from
the target itself or through others. Otherwise a fast process could overtake a slow one, and the
slow one would compute with numbers of another state.

What processes have heard is told by vector clocks (Fidge; Mattern): each counts its own sends and
receives, and a message carries all counts that its source knows.
"""

from __future__ import annotations

from collections.abc import Sequence

from adagen.plan.messages import Message
from adagen.plan.steps import Receive, Send
from adagen.plan.turns import by_turns
from adagen.program.types import Operation

SLOTS = 2
"""Slots of a message, used in turn."""


def overwritten(
    messages: Sequence[Message], operations: Sequence[Sequence[Operation]]
) -> list[int]:
    """Return the messages whose slots may be written before they have been read, in order.

    Args:
        messages: of the plan, by number.
        operations: those of each process, which do not wait for each other for ever.
    """
    exchanges = [
        [step for operation in own for step in operation.steps if isinstance(step, Receive | Send)]
        for own in operations
    ]
    clocks = [[0] * len(exchanges) for _ in exchanges]
    sent: dict[tuple[int, int], list[int]] = {}  # what is known by a message of an evaluation
    received: dict[tuple[int, int], int] = {}  # when its target had it, by the target's own clock
    found: set[int] = set()

    def is_done(p: int, evaluation: int, step: Receive | Send) -> bool:
        """Do one exchange, unless its message is not there yet."""
        clock, key = clocks[p], (evaluation, step.message)
        if isinstance(step, Receive):
            if key not in sent:
                return False
            clock[:] = map(max, clock, sent[key])
        clock[p] += 1
        if isinstance(step, Receive):
            received[key] = clock[p]
            return True
        last = received.get((evaluation - SLOTS, step.message))
        # The target reads a message before its next exchange: that one must be known.
        known = clock[messages[step.message].target]
        if evaluation >= SLOTS and (last is None or known <= last):
            found.add(step.message)
        sent[key] = list(clock)
        return True

    ahead = [[(n, step) for n in range(SLOTS + 1) for step in steps] for steps in exchanges]
    by_turns(dict(enumerate(map(len, ahead))), lambda p, k: is_done(p, *ahead[p][k]))
    return sorted(found)
