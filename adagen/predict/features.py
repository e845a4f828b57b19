"""What a step of a plan is made of, in the coefficients of a cost profile."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from adagen.emit.runs import Run, pays_columns, units_of_sweep
from adagen.emit.segments import segments_of
from adagen.emit.shapes import SHAPES
from adagen.model.kinds import KINDS
from adagen.plan.abreast import Limbs, limbs_abreast
from adagen.plan.order import inward_order
from adagen.plan.responses import responses
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
from adagen.plan.types import Plan, PlanJoint, Process
from adagen.schedule.costs import PRESCRIBED, StepCosts, block_rows

Features = dict[str, float]
"""How often each coefficient counts; names as in ``adagen.schedule.costs.NAMES``.
"""

_PLAIN: dict[type, str] = {
    LinkBias: "link.bias",
    StartLink: "link.start",
    InvertRoot: "root.invert",
    SolveRoot: "root.solve",
    SolveMobility: "root.solve",
    HoldMobility: "root.invert",
    LoadRoot: "deliver.load",
    AccelerateRoot: "root.accelerate",
    FreeBase: "free.base",
    FreeAcceleration: "free.acceleration",
    Load: "deliver.load",
    SolveCoupling: "slaved.solve",
    ApplyCoupling: "slaved.apply",
}


def features(step: Step, joints: Sequence[PlanJoint]) -> Features:
    """Return what a step is made of; nothing for a message.

    Args:
        step: a step of a plan.
        joints: the plan's joints.
    """
    if isinstance(step, Send | Receive | StartEmpty):
        return {}
    plain = _PLAIN.get(type(step))
    if plain is not None:
        return {plain: 1}
    joint = joints[step.joint]  # type: ignore[union-attr]
    kind = PRESCRIBED if joint.prescribed else joint.kind
    match step:
        case Kinematics():
            return {f"kinematics.{joint.kind}": 1}
        case FusedJoin():
            freedoms = sum(KINDS[joints[j].kind].nv for j in step.run)
            own = _join(step, "spherical" if freedoms < 6 else "floating")
            return {**own, "kinematics.revolute": len(step.run)}
        case Join():
            return _join(step, kind)
        case Disassemble():
            return {f"disassemble.{kind}": 1, "disassemble.coupling": len(step.forces)}
        case Articulate():
            grounded = not step.reversed and joint.parent == 0
            if grounded and joint.prescribed:  # nothing is handed to the ground
                return {}
            return _turned("articulate", "ground" if grounded else kind, step.reversed)
        case Propagate():
            first = "ground" if step.near is None else kind
            found = _turned("propagate", first, step.reversed)
            return {**found, "propagate.spread": len(step.spreads)}
        case Deliver():
            return _turned("deliver", kind, step.reversed)
        case Accelerate():
            return _turned("accelerate", kind, step.reversed)
    raise AssertionError(f"unknown step {step}")


def _join(step: Join, kind: str) -> Features:
    grounded = step.a is None and kind != "floating"
    on_a = sum(coupling.side == "A" for coupling in step.couplings)
    across = sum(block.across for block in step.blocks)
    rows = block_rows(kind)
    return {
        f"join.{'ground' if grounded else kind}": 1,
        "join.coupling_a": on_a,
        "join.coupling_b": len(step.couplings) - on_a,
        "join.block": rows * (len(step.blocks) - across),
        "join.across": rows * across,
    }


def _turned(group: str, key: str, turned: bool) -> Features:
    return {f"{group}.{key}": 1, **({f"{group}.reversed": 1} if turned else {})}


@dataclass(frozen=True)
class Together:
    """What joints are passed with in shape kernels; those that are passed by themselves are not in.

    Attributes:
        limbs: limbs side by side.
        inward: the run that a joint is passed inwards with.
        outward: the run that it is passed outwards with in segments.
        responding: joints of runs whose mobility is asked for at the last link only.
        columns: runs that are taken by columns.
    """

    limbs: Mapping[int, Limbs]
    inward: Mapping[int, Run]
    outward: Mapping[int, Run]
    responding: Container[int]
    columns: Container[Run] = ()


_NUMBERS = {2: "two", 4: "four"}
SIDE_BY_SIDE: dict[type, str] = {
    Kinematics: "kinematics",
    Articulate: "articulate",
    Accelerate: "accelerate",
}
"""Steps that limbs take side by side, and the groups that price them."""


def passed_together(plan: Plan, shape: str = "auto") -> list[Together]:
    """Return what each process passes its joints with; nothing where the shape does not do that."""
    if shape not in ("auto", "kernels") or SHAPES["kernels"].why_not(plan) is not None:
        return [Together({}, {}, {}, ()) for _ in plan.processes]
    limbs = [limbs_abreast(plan, process) for process in plan.processes]
    outward = _by_joint(segments_of(plan, limbs))
    found = []
    for process, own in zip(plan.processes, limbs, strict=True):
        inward = list(_inward(plan, process, own))
        found.append(
            Together(
                {j: each for each in own for j in each.members()},
                _by_joint(inward),
                outward,
                _responding(plan, process),
                frozenset(run for run in inward if pays_columns(plan.joints, run)),
            )
        )
    return found


def _by_joint(own: Iterable[Run]) -> dict[int, Run]:
    return {j: run for run in own for j in range(run.first, run.last + 1)}


def _inward(plan: Plan, process: Process, limbs: Sequence[Limbs]) -> Iterator[Run]:
    for kind, steps in groupby(process.steps, type):
        if kind is Articulate:
            for run in units_of_sweep(plan.joints, list(steps), limbs, inward_order):  # type: ignore[arg-type]
                if isinstance(run, Run):
                    yield run


def _responding(plan: Plan, process: Process) -> set[int]:
    return {
        step.joint
        for kind, steps in groupby(process.steps, type)
        if kind is Propagate
        for run in responses(plan, process, list(steps))  # type: ignore[arg-type]
        if len(run) > 1
        for step in run
    }


def _shared_features(
    step: Step, joints: Sequence[PlanJoint], together: Together
) -> Features | None:
    """Of a joint that is passed with others, with its share of what they take once."""
    if not isinstance(step, Kinematics | Articulate | Accelerate | Propagate):
        return None
    j, kind = step.joint, joints[step.joint].kind
    if isinstance(step, Propagate):
        return {f"propagate_run.{kind}": 1} if j in together.responding else None
    if j in together.limbs:
        return _row_features(step, kind, together.limbs[j])
    if isinstance(step, Articulate) and j in together.inward:
        return _run_features(step, joints, together)
    if isinstance(step, Kinematics) and j in together.outward:
        return {
            f"kinematics_segments.{kind}": 1,
            "kinematics_segments.run": 1 / together.outward[j].length,
        }
    return None


def _row_features(step: Step, kind: str, limbs: Limbs) -> Features:
    """Of one joint of a row: the row's features, shared out."""
    number = _NUMBERS[limbs.lanes]
    found = {f"{SIDE_BY_SIDE[type(step)]}_{number}.{kind}": 1 / limbs.count}
    if isinstance(step, Articulate):
        found[f"limbs.{number}"] = 1 / (limbs.count * len(limbs.rows))
    return found


def _run_features(step: Articulate, joints: Sequence[PlanJoint], together: Together) -> Features:
    """Of one joint of a run, with its share of the way into the run and out of it."""
    found, run = features(step, joints), together.inward[step.joint]
    if run in together.columns:
        found = {f"articulate_columns.{joints[step.joint].kind}": 1}
        if step.reversed:
            found["articulate.reversed"] = 1
    return {**found, "articulate.run": 1 / run.length}


def work_features(
    steps: Iterable[Step], joints: Sequence[PlanJoint], together: Together | None = None
) -> Features:
    """Return what steps of one process, done without a message between them, are made of.

    This is the one place where steps are added up: of what is predicted and of what is fitted to
    measured times.

    Args:
        steps: some steps of a process, in order.
        joints: the plan's joints.
        together: what joints are passed with.
    """
    total: Features = {}
    for step in steps:
        found = _shared_features(step, joints, together) if together else None
        if found is None:
            found = features(step, joints)
        for name, count in found.items():
            total[name] = total.get(name, 0) + count
    return total


def work_time(
    steps: Iterable[Step],
    joints: Sequence[PlanJoint],
    costs: StepCosts,
    slaved: int = 0,
    together: Together | None = None,
) -> float:
    """Return what steps of one process take together on a core of speed 1, microseconds.

    Args:
        steps: some steps of a process, in order, without a message between them.
        joints: the plan's joints.
        costs: the machine's coefficients.
        slaved: number of slaved joints, each of which adds a right-hand side to every step.
        together: what joints are passed with.
    """
    return costs.total(work_features(steps, joints, together)) * (
        1 + slaved * costs["slaved.column"]
    )


def step_time(step: Step, joints: Sequence[PlanJoint], costs: StepCosts, slaved: int = 0) -> float:
    """Return what a step takes by itself on a core of speed 1, microseconds; see ``work_time``."""
    return work_time((step,), joints, costs, slaved)
