"""Values of the template for each joint: its memory, and a function for each step."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from adagen.emit.joints import articulated, fused, joins
from adagen.emit.joints.kinematics import kinematics_lines
from adagen.emit.joints.memory import Members
from adagen.emit.symbols import Symbols
from adagen.plan import steps as do
from adagen.plan.steps import Step

# Steps that are functions of a joint in emitted code, and what these are called.
VERBS: dict[type, str] = {
    do.Kinematics: "kinematics",
    do.Join: "assemble",
    do.FusedJoin: "assemble",
    do.Disassemble: "disassemble",
    do.FreeBase: "free_base",
    do.Articulate: "articulate",
    do.Propagate: "propagate",
    do.Deliver: "deliver",
    do.Accelerate: "accelerate",
    do.FreeAcceleration: "free_acceleration",
}

_LINES: dict[type, Callable[[Symbols, Any], list[str]]] = {
    do.FreeBase: articulated.free_base,
    do.Articulate: articulated.articulate,
    do.Propagate: articulated.propagate,
    do.Deliver: articulated.deliver,
    do.Accelerate: articulated.accelerate,
    do.FreeAcceleration: articulated.free_acceleration,
}


def function_of(symbols: Symbols, step: Step) -> str | None:
    """Return the name of the emitted function of a step, if it is a joint's."""
    verb = VERBS.get(type(step))
    joint = getattr(step, "joint", None)
    return None if verb is None or joint is None else f"{verb}_{symbols.joints[joint]}"


def joint_rows(symbols: Symbols) -> list[dict[str, object]]:
    """Return a row for each joint: names, memory, functions in the order of their first use."""
    plan = symbols.plan
    members = Members(symbols)
    functions: list[dict[str, dict[str, object]]] = [{} for _ in plan.joints]
    ends = {step.joint: step for step in plan.steps_of(do.Disassemble)}
    joined = {step.joint: step for step in plan.steps_of(do.Join)}
    for step in plan.steps:
        name = function_of(symbols, step)
        if name is not None:
            of_joint = functions[getattr(step, "joint", -1)]
            of_joint.setdefault(name, _function(symbols, step, name, joined, ends))
    return [
        {
            "id": f"j_{symbols.joints[j]}",
            "type": f"Joint_{symbols.joints[j]}",
            "quoted": symbols.quoted_joint(j),
            "kind": joint.kind,
            "parent_quoted": symbols.quoted_link(joint.parent),
            "child_quoted": symbols.quoted_link(j + 1),
            "members": members.lines[j],
            "functions": list(functions[j].values()),
        }
        for j, joint in enumerate(plan.joints)
    ]


def _function(
    symbols: Symbols,
    step: Step,
    name: str,
    joined: dict[int, do.Join],
    ends: dict[int, do.Disassemble],
) -> dict[str, object]:
    comment = ""
    match step:
        case do.Kinematics():
            lines = kinematics_lines(symbols, step.joint)
        case do.FusedJoin():
            comment = joins.parts(symbols, step, ends[step.joint])
            lines = fused.assembly(symbols, step)
        case do.Join():
            comment = joins.parts(symbols, step, ends[step.joint])
            lines = joins.assembly(symbols, step)
        case do.Disassemble():
            join = joined[step.joint]
            if isinstance(join, do.FusedJoin):
                lines = fused.disassembly(symbols, join, step)
            else:
                lines = joins.disassembly(symbols, join, step)
        case _:
            lines = _LINES[type(step)](symbols, step)
    return {"name": name, "comment": comment, "lines": lines}
