"""The stages of a process's work: runs of steps of one sort, between which time is taken.

What is predicted, traced, calibrated and drawn is told stage by stage, so that figures of all four
can be laid side by side.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from adagen.plan.steps import (
    Accelerate,
    AccelerateRoot,
    ApplyCoupling,
    Deliver,
    Disassemble,
    FreeAcceleration,
    Join,
    Kinematics,
    Load,
    LoadRoot,
    Receive,
    Send,
    SolveCoupling,
    SolveMobility,
    Step,
)
from adagen.plan.types import Process

What = Literal["kinematics", "assembly", "disassembly", "slaved", "send", "receive"]

_DOWN = (
    Disassemble,
    SolveMobility,
    Load,
    LoadRoot,
    Deliver,
    AccelerateRoot,
    Accelerate,
    FreeAcceleration,
)


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
    for k, step in enumerate(process.steps):
        what = _what(step)
        message = step.message if isinstance(step, Send | Receive) else None
        joint = getattr(step, "joint", None)
        if message is None and found and found[-1].what == what:
            before = found.pop()
            if joint is None or (what == "disassembly" and before.joint is not None):
                joint = before.joint
            found.append(Stage(what, before.first, k + 1, joint, None))
        else:
            found.append(Stage(what, k, k + 1, joint, message))
    return tuple(found)


def _what(step: Step) -> What:
    match step:
        case Kinematics():
            return "kinematics"
        case Send():
            return "send"
        case Receive():
            return "receive"
        case SolveCoupling() | ApplyCoupling():
            return "slaved"
        case Join():
            return "assembly"
    return "disassembly" if isinstance(step, _DOWN) else "assembly"
