"""Iterative refinement as C++ lines: the steps of a plan again, for biases alone."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from adagen.emit.joints.articulated import ends, far_acceleration, of_link
from adagen.emit.joints.fused import reassembly
from adagen.emit.joints.joins import bias_updates
from adagen.emit.processes import step_lines
from adagen.emit.words import Words
from adagen.errors import UsageError
from adagen.model.kinds import KINDS
from adagen.plan.refine import exchanges, handed_on, joints_at, links_of_process, moving, paths_of
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
from adagen.plan.types import Plan, Process

MOST_STEPS = 9
MIXED_STEPS = 2
"""Steps of a mixed solver, at least: two leave rounding on most robots, and one is no certainty."""
_VERBS: dict[type, str] = {
    Join: "reassemble",
    FusedJoin: "reassemble",
    Articulate: "rearticulate",
    Propagate: "repropagate",
}


def refinement_steps(asked: int | None, scalar: str) -> int:
    """Return how many steps of refinement a solver takes; ``asked``: None where nobody said.

    Raises:
        UsageError: the number is out of range, or too small for the scalar.
    """
    if asked is None:
        return MIXED_STEPS if scalar == "mixed" else 0
    if not 0 <= asked <= MOST_STEPS:
        raise UsageError(f"steps of refinement must be 0 to {MOST_STEPS}, not {asked}")
    if scalar == "mixed" and asked < MIXED_STEPS:
        raise UsageError(
            "scalar mixed is float that is refined: the first correction is as large as the error"
            " of a float, and only a second one can show what is left; say --refine"
            f" {MIXED_STEPS} or more"
        )
    return asked


def checked_shape(refine: int, shape: str) -> str:
    """Return the shape in which so many steps of refinement are emitted.

    Raises:
        UsageError: the shape has no refinement.
    """
    if refine and shape not in ("auto", "joints"):
        raise UsageError(f"shape {shape} has no refinement; say --shape joints")
    return "joints" if refine else shape


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
            b_a = words.ground if step.a_bias is None else words.bias(step.a_bias)
            lines.append(f"rejoin(i.joined, i.X * {b_a}, {words.bias(step.b_bias)});")
            lines += bias_updates(words, step)
        case Articulate():
            lines += _rearticulate(words, step)
        case Propagate():
            near = words.ground if step.near_bias is None else words.bias(step.near_bias)
            lines += far_acceleration(step, near, words.bias(step.bias), "")
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
    handed = call if step.reversed else f"i.X.transposed_times({call})"
    return [f"{of_link(words, step.joint, near)}.pA += {handed};"]


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


def refinement_values(words: Words) -> dict[str, object]:
    """Return what the template says of the refinement; nothing where there is none."""
    if not words.refine:
        return {}
    plan = words.plan
    without_blocks = replace(plan, messages=tuple(replace(m, blocks=()) for m in plan.messages))
    brief = replace(words, program=replace(words.program, plan=without_blocks))
    return {
        "corrections": [
            [line for step in process.steps for line in _correction(brief, process, step)]
            for process in plan.processes
        ],
        "refined": [_tables(plan, process) for process in plan.processes],
        "exchanges": [
            {
                "source": exchange.source,
                "target": exchange.target,
                "entries": _entries(plan, exchange.accelerations),
                "forces": list(exchange.forces),
            }
            for exchange in exchanges(plan)
        ],
        "sharing": _sharing(plan),
    }


def _tables(plan: Plan, process: Process) -> list[list[int]]:
    """The tables of a RefinedProcess in the order of its members."""
    path, at = paths_of(plan, process), joints_at(plan, process)
    slaved = sorted(set(plan.slaved).intersection({*path, *process.owns}))
    runs = handed_on(process)
    inner = [j for j, _ in runs]
    return [
        _entries(plan, process.owns),
        _entries(plan, moving(plan, process)),
        [j for j in process.owns if j not in inner],
        list(path),
        list(at),
        list(links_of_process(process)),
        slaved,
        inner,
        [beyond for _, beyond in runs],
    ]


def _entries(plan: Plan, joints: Iterable[int]) -> list[int]:
    return [plan.joints[j].v + k for j in joints for k in range(KINDS[plan.joints[j].kind].nv)]


def _sharing(plan: Plan) -> list[int]:
    return [p for p, process in enumerate(plan.processes) if p > 0 and process.owns]


def refinement_messages(words: Words) -> list[dict[str, object]]:
    """Return the messages of the refinement, which come behind all others."""
    if not words.refine:
        return []
    plan = words.plan
    rows: list[dict[str, object]] = [
        {
            "source": exchange.source,
            "target": exchange.target,
            "size": len(_entries(plan, exchange.accelerations)) + 6 * len(exchange.forces),
            "comment": "step of refinement",
        }
        for exchange in exchanges(plan)
    ]
    sharing = _sharing(plan)
    rows += [{"source": p, "target": 0, "size": 3, "comment": "energies"} for p in sharing]
    return rows + [
        {"source": 0, "target": p, "size": 2, "comment": "size of the correction"} for p in sharing
    ]
