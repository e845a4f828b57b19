"""A program as JSON: one operation a line, joints and links by their names."""

from __future__ import annotations

import json
from typing import Any

from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Append, Arrive, Receive, Send, Traverse
from adagen.plan.types import Plan
from adagen.program.runs import Run
from adagen.program.summary import lanes, meeting
from adagen.program.types import Links, Operation, Program

FORMAT = 1


def program_to_json(program: Program) -> str:
    """Return a program as JSON, with its operations, messages, owners and slots.

    The constants that it works with are the plan's (``adagen.plan.plan_to_json``).
    """
    plan = program.plan
    parts = {
        "format": FORMAT,
        "robot": plan.name,
        "form": plan.form,
        "shape": program.shape,
        "batch": program.batch,
        "meeting": meeting(program),
        "lanes": [_limbs(plan, limbs) | {"process": p} for p, limbs in lanes(program)],
        "slots": list(program.slots.slots),
    }
    lines = [f'"{name}": {json.dumps(value)}' for name, value in parts.items()]
    lines.append(f'"messages": {_lines([_message(plan, k) for k in range(len(plan.messages))])}')
    lines.append(f'"processes": [\n{_processes(program)}\n]')
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _processes(program: Program) -> str:
    plan = program.plan
    rows = []
    for process, own in zip(plan.processes, program.processes, strict=True):
        joints = {
            name: [plan.joints[j].name for j in getattr(process, name)]
            for name in ("owns", "shares")
        }
        parts = [f'"{name}": {json.dumps(value)}' for name, value in joints.items()]
        for name in ("operations", "recovery"):
            operations = getattr(own, name)
            if operations or name == "operations":
                described = [operation_to_dict(plan, operation) for operation in operations]
                parts.append(f'"{name}": {_lines(described)}')
        if own.others:
            each = (_lines([operation_to_dict(plan, one) for one in own]) for own in own.others)
            parts.append(f'"others": [{", ".join(each)}]')
        rows.append("{" + ", ".join(parts) + "}")
    return ",\n".join(rows)


def _lines(rows: list[dict[str, Any]]) -> str:
    return "[" + ",".join("\n  " + json.dumps(row) for row in rows) + "]"


def operation_to_dict(plan: Plan, operation: Operation) -> dict[str, Any]:
    """Return an operation as plain data."""
    described: dict[str, Any] = {"does": operation.does, "method": operation.method}
    match operation.block:
        case Limbs() as limbs:
            described |= _limbs(plan, limbs)
        case Run() as run:
            names = [plan.joints[j].name for j in dict.fromkeys((run.first, run.last))]
            described["joints"] = names
            if run.reversed:
                described["reversed"] = True
        case Links() as links if operation.does == "angles":
            described["joints"] = [plan.joints[j].name for j in links.numbers]
        case Links() as links:
            described["links"] = [plan.links[k].name for k in links.numbers]
        case None:
            described |= _of_step(plan, operation)
    if operation.first:
        described["first"] = list(operation.first)
    return described


def _limbs(plan: Plan, limbs: Limbs) -> dict[str, Any]:
    chains = zip(*limbs.rows, strict=True)
    return {"lanes": limbs.lanes, "limbs": [[plan.joints[j].name for j in c] for c in chains]}


def _of_step(plan: Plan, operation: Operation) -> dict[str, Any]:
    (step,) = operation.steps
    if isinstance(step, Send | Receive):
        return {"message": step.message}
    described: dict[str, Any] = {}
    if hasattr(step, "joint"):
        described["joints"] = [plan.joints[step.joint].name]
    if hasattr(step, "link"):
        described["links"] = [plan.links[step.link].name]
    if isinstance(step, Traverse | Append | Arrive):
        described["joints"] = [plan.joints[j].name for j in (step.passage.first, step.passage.last)]
    if getattr(step, "reversed", False):
        described["reversed"] = True
    return described


def _message(plan: Plan, number: int) -> dict[str, Any]:
    message = plan.messages[number]
    passages = [[plan.joints[j].name for j in (p.first, p.last)] for p in message.passages]
    placed = [plan.joints[j].name for j in message.placements]
    sides = [[plan.joints[j].name for j in side.joints] for side in message.sides]
    return {
        "from": message.source,
        "to": message.target,
        "numbers": message.numbers(plan.right_hand_sides, plan.joints),
        "mobilities": [[plan.links[b.row].name, plan.links[b.column].name] for b in message.blocks],
        "accelerations": [plan.links[b.handle].name for b in message.biases],
        "forces": [plan.links[f.handle].name for f in message.forces],
        "inertias": [plan.links[k].name for k in message.inertias],
        "joints": [plan.joints[j].name for j in message.joints],
        **({"passages": passages} if passages else {}),
        **({"placements": placed} if placed else {}),
        **({"sides": sides} if sides else {}),
    }
