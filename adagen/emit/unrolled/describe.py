"""What a step does, in a line of comment."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from adagen.emit.words import Words
from adagen.plan.steps import (
    Accelerate,
    AccelerateRoot,
    ApplyCoupling,
    Articulate,
    Deliver,
    Disassemble,
    FreeAcceleration,
    FreeBase,
    FusedJoin,
    HoldMobility,
    InvertRoot,
    Join,
    Kinematics,
    LinkBias,
    Load,
    LoadRoot,
    Propagate,
    Receive,
    Send,
    SolveCoupling,
    SolveMobility,
    SolveRoot,
    StartEmpty,
    StartLink,
    Step,
)

_OF_JOINT: dict[type, str] = {
    Kinematics: "placement, velocity and reference acceleration of its link",
    FreeBase: "its torque on the base",
    Articulate: "articulated-body inertia and bias force through it",
    Propagate: "mobility and acceleration beyond it",
    Deliver: "handle forces through it",
    Accelerate: "its acceleration, and that of the link beyond",
    FreeAcceleration: "acceleration of the base",
    Join: "assembly: its two sides become one chain",
    FusedJoin: "assembly of the run that it ends: its two sides become one chain",
    Disassemble: "disassembly: its acceleration and force",
}
_OF_JOINTS: dict[type, str] = {
    Kinematics: "placement, velocity and reference acceleration of their links",
    Articulate: "articulated-body inertia and bias force through them",
    Accelerate: "their accelerations, and those of the links beyond",
}
_OF_LINK: dict[type, str] = {
    LinkBias: "acceleration where nothing acts on it",
    StartLink: "force that the reference field takes",
    InvertRoot: "mobility from its articulated-body inertia",
    StartEmpty: "nothing: it is another process's to add",
    SolveMobility: "acceleration from its mobility and its articulated-body inertia",
    HoldMobility: "what holds it, taken for a body",
    SolveRoot: "acceleration from its articulated-body inertia",
    Load: "handle forces on it",
    LoadRoot: "force that its acceleration takes",
    AccelerateRoot: "acceleration under the handle forces",
}
_OTHER: dict[type, str] = {
    Send: "message sent",
    Receive: "message received",
    SolveCoupling: "torques that keep slaved joints in step",
    ApplyCoupling: "accelerations under these torques",
}


def describe_step(words: Words, step: Step, row: Callable[[int], Sequence[int]]) -> str:
    """Return what a step does and to which joints or links, in one line of ASCII.

    Args:
        words: the plan's names.
        step: the step.
        row: the joints that are treated as one with a joint.
    """
    kind = type(step)
    if kind in _OTHER:
        return _OTHER[kind]
    if kind in _OF_LINK:
        link = getattr(step, "link", 0)
        links = [j + 1 for j in row(link - 1)]
        names = ", ".join(f"{k} {words.quoted_link(k)}" for k in links)
        return f"link{'s' * (len(links) > 1)} {names}: {_OF_LINK[kind]}"
    joints = row(getattr(step, "joint", 0))
    names = ", ".join(f"{j} {words.quoted_joint(j)}" for j in joints)
    if len(joints) > 1:
        return f"joints {names}: {_OF_JOINTS[kind]}"
    return f"joint {names}: {_OF_JOINT[kind]}"
