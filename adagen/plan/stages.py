"""Stages of a process's work: successive steps of one kind, between which time is measured.

Predictions, traces, calibrations and drawings are all given stage by stage, so that they can be
compared.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby
from operator import attrgetter

from adagen.plan.steps import Receive, Send
from adagen.plan.steps.names import What
from adagen.plan.types import Process


@dataclass(frozen=True)
class Stage:
    """Steps ``first`` .. ``last - 1`` of a process.

    Attributes:
        what: sort of work; ``send`` and ``receive`` hold one step.
        first: index of the first step.
        last: one past the index of the last step.
        joint: the joint that the first sweep ends with or the second one begins with, for people;
            None for messages.
        message: number of the message sent or received; None for work.
    """

    what: What
    first: int
    last: int
    joint: int | None
    message: int | None


def stages(process: Process) -> tuple[Stage, ...]:
    """Return the stages of a process in order."""
    found: list[Stage] = []
    first = 0
    for what, group in groupby(process.steps, attrgetter("stage")):
        steps = list(group)
        last = first + len(steps)
        if what in ("send", "receive"):
            found += [
                Stage(what, k, k + 1, None, step.message)
                for k, step in enumerate(steps, start=first)
                if isinstance(step, Send | Receive)
            ]
        else:
            ways = steps if what == "disassembly" else reversed(steps)
            joints = (getattr(step, "joint", None) for step in ways)
            joint = next((j for j in joints if j is not None), None)
            found.append(Stage(what, first, last, joint, None))
        first = last
    return tuple(found)
