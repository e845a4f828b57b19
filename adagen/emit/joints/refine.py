"""Iterative refinement in shape joints: the steps of a plan again, for biases alone."""

from __future__ import annotations

from dataclasses import replace

from adagen.emit.joints.articulated import ends, far_acceleration, of_link
from adagen.emit.joints.fused import reassembly
from adagen.emit.joints.joins import bias_updates
from adagen.emit.joints.steps import step_lines
from adagen.emit.words import Words
from adagen.plan.steps import (
    Articulate,
    FusedJoin,
    InvertRoot,
    Join,
    Kinematics,
    LinkBias,
    Propagate,
    StartLink,
    Step,
)
from adagen.plan.types import Process

_VERBS: dict[type, str] = {
    Join: "reassemble",
    FusedJoin: "reassemble",
    Articulate: "rearticulate",
    Propagate: "repropagate",
}


def add_corrections(words: Words, rows: list[dict[str, object]]) -> None:
    """Give each joint's row the functions that a correction takes, behind its others."""
    for process in words.plan.processes:
        for step in process.steps:
            verb = _VERBS.get(type(step))
            if verb is None:
                continue
            joint = getattr(step, "joint", -1)
            functions = rows[joint]["functions"]
            assert isinstance(functions, list)
            name = f"{verb}_{words.joints[joint]}"
            functions.append({"name": name, "comment": "", "lines": _function(words, step)})


def _function(words: Words, step: Step) -> list[str]:
    lines = [f"auto& i = {words.memory(getattr(step, 'joint', -1))};"]
    match step:
        case FusedJoin():
            lines += reassembly(words, step)
        case Join():
            b_a = "w.ground" if step.a_bias is None else words.bias(step.a_bias)
            lines.append(f"rejoin(i.joined, i.X * {b_a}, {words.bias(step.b_bias)});")
            lines += bias_updates(words, step)
        case Articulate():
            lines += _rearticulate(words, step)
        case Propagate():
            near = "w.ground" if step.near_bias is None else words.bias(step.near_bias)
            lines += far_acceleration(step, near, words.bias(step.bias))
    return lines


def _rearticulate(words: Words, step: Articulate) -> list[str]:
    near, far = ends(words, step)
    bias = f"{of_link(words, step.joint, far)}.pA"
    if step.reversed:
        bias, sigma = f"wrench_in_child(i.X, {bias})", "-1"
    else:
        sigma = "1"
    call = f"rearticulate(i.body, {sigma}, {bias})"
    if near == 0:
        return [f"{call};"]
    passed = call if step.reversed else f"i.X.transposed_times({call})"
    return [f"{of_link(words, step.joint, near)}.pA += {passed};"]


def _correction(words: Words, process: Process, step: Step) -> list[str]:
    """The lines that do a step of a correction; ``words`` has messages without blocks."""
    verb = _VERBS.get(type(step))
    if verb is not None:
        return [f"{verb}_{words.joints[getattr(step, 'joint', -1)]}(w);"]
    match step:
        case Kinematics():
            return []
        case LinkBias():
            rho = f"{words.bare_block(step.link)} * w.refinement.rho[{step.link}]"
            return [f"{words.link_memory(step.link)}.b = first_column({rho});"]
        case StartLink():
            rho = f"-w.refinement.rho[{step.link}]"
            return [f"{words.link_memory(step.link)}.pA = first_column({rho});"]
        case InvertRoot():
            product = f"{words.block(step.block)} * {words.link_memory(step.link)}.pA"
            return [f"{words.bias(step.bias)}.noalias() = -{product};"]
        case _:
            return step_lines(words, process, step)


def corrections(words: Words) -> list[list[str]]:
    """Return the lines of a correction for each process: no messages with blocks in them."""
    plan = words.plan
    without_blocks = replace(plan, messages=tuple(replace(m, blocks=()) for m in plan.messages))
    brief = replace(words, program=replace(words.program, plan=without_blocks))
    return [
        [line for step in process.steps for line in _correction(brief, process, step)]
        for process in plan.processes
    ]
