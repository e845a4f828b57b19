"""Iterative refinement in shape joints: the steps of a plan repeated for biases alone."""

from __future__ import annotations

from dataclasses import replace

from adagen.emit.joints.articulated import far_acceleration, of_link
from adagen.emit.joints.fused import reassembly
from adagen.emit.joints.joins import bias_updates
from adagen.emit.joints.steps import step_lines
from adagen.emit.symbols import Symbols
from adagen.plan import steps as do
from adagen.plan.order import ends_of
from adagen.plan.steps import Step
from adagen.plan.types import Process

_VERBS: dict[type, str] = {
    do.Join: "reassemble",
    do.FusedJoin: "reassemble",
    do.Articulate: "rearticulate",
    do.Propagate: "repropagate",
}


def add_corrections(symbols: Symbols, rows: list[dict[str, object]]) -> None:
    """Add the functions of a correction to each joint's row."""
    for process in symbols.plan.processes:
        for step in process.steps:
            verb = _VERBS.get(type(step))
            if verb is None:
                continue
            joint = getattr(step, "joint", -1)
            functions = rows[joint]["functions"]
            assert isinstance(functions, list)
            name = f"{verb}_{symbols.joints[joint]}"
            functions.append({"name": name, "comment": "", "lines": _function(symbols, step)})


def _function(symbols: Symbols, step: Step) -> list[str]:
    lines = [f"auto& i = {symbols.memory(getattr(step, 'joint', -1))};"]
    match step:
        case do.FusedJoin():
            lines += reassembly(symbols, step)
        case do.Join():
            b_a = "w.ground" if step.a_bias is None else symbols.bias(step.a_bias)
            lines.append(f"rejoin(i.joined, i.X * {b_a}, {symbols.bias(step.b_bias)});")
            lines += bias_updates(symbols, step)
        case do.Articulate():
            lines += _rearticulate(symbols, step)
        case do.Propagate():
            near = "w.ground" if step.near_bias is None else symbols.bias(step.near_bias)
            lines += far_acceleration(step, near, symbols.bias(step.bias))
    return lines


def _rearticulate(symbols: Symbols, step: do.Articulate) -> list[str]:
    near, far = ends_of(symbols.plan.joints, step.joint, step.reversed)
    bias = f"{of_link(symbols, step.joint, far)}.pA"
    if step.reversed:
        bias, sigma = f"wrench_in_child(i.X, {bias})", "-1"
    else:
        sigma = "1"
    call = f"rearticulate(i.body, {sigma}, {bias})"
    if near == 0:
        return [f"{call};"]
    passed = call if step.reversed else f"i.X.transposed_times({call})"
    return [f"{of_link(symbols, step.joint, near)}.pA += {passed};"]


def _correction(symbols: Symbols, process: Process, step: Step) -> list[str]:
    """The lines of a step in a correction; ``symbols`` has messages without blocks."""
    verb = _VERBS.get(type(step))
    if verb is not None:
        return [f"{verb}_{symbols.joints[getattr(step, 'joint', -1)]}(w);"]
    match step:
        case do.Kinematics():
            return []
        case do.LinkBias():
            rho = f"{symbols.bare_block(step.link)} * w.refinement.rho[{step.link}]"
            return [f"{symbols.link_memory(step.link)}.b = first_column({rho});"]
        case do.StartLink():
            rho = f"-w.refinement.rho[{step.link}]"
            return [f"{symbols.link_memory(step.link)}.pA = first_column({rho});"]
        case do.InvertRoot():
            product = f"{symbols.block(step.block)} * {symbols.link_memory(step.link)}.pA"
            return [f"{symbols.bias(step.bias)} = -({product});"]
        case _:
            return step_lines(symbols, process, step)


def corrections(symbols: Symbols) -> list[list[str]]:
    """Return the lines of a correction for each process: no messages with blocks in them."""
    plan = symbols.plan
    without_blocks = replace(plan, messages=tuple(replace(m, blocks=()) for m in plan.messages))
    brief = replace(symbols, program=replace(symbols.program, plan=without_blocks))
    return [
        [line for step in process.steps for line in _correction(brief, process, step)]
        for process in plan.processes
    ]
