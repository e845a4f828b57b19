"""What a step of a plan is made of, in the coefficients of a cost profile."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby

from adagen.emit.runs import Run, pays_columns, units_of_sweep
from adagen.emit.shapes import SHAPES
from adagen.model.kinds import KINDS
from adagen.plan.abreast import Limbs, inward_order, limbs_abreast
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


Lanes = Mapping[int, Limbs | Run]
"""What a joint of shape kernels is passed with: limbs side by side, or a run on its way inwards."""

_SWEPT = (Kinematics, Articulate, Accelerate)
_SIDE_BY_SIDE: dict[type, str] = {
    Kinematics: "kinematics",
    Articulate: "articulate",
    Accelerate: "accelerate",
}
_NUMBERS = {2: "two", 4: "four"}


def lanes_of(plan: Plan, process: Process, shape: str = "auto") -> Lanes:
    """Return which joints a process passes in lanes; none where the shape does not do that."""
    if shape not in ("auto", "kernels") or SHAPES["kernels"].why_not(plan) is not None:
        return {}
    limbs = limbs_abreast(plan, process)
    passed: dict[int, Limbs | Run] = {j: each for each in limbs for j in each.members()}
    for kind, steps in groupby(process.steps, type):
        if kind is Articulate:
            for run in units_of_sweep(plan.joints, list(steps), limbs, inward_order):  # type: ignore[arg-type]
                if isinstance(run, Run):
                    passed.update(dict.fromkeys(range(run.first, run.last + 1), run))
    return passed


def _row_features(step: Step, kind: str, limbs: Limbs) -> Features:
    """Of one joint of a row: the row's features, shared out."""
    number = _NUMBERS[limbs.count]
    found = {f"{_SIDE_BY_SIDE[type(step)]}_{number}.{kind}": 1 / limbs.count}
    if isinstance(step, Articulate):
        found[f"limbs.{number}"] = 1 / (limbs.count * len(limbs.rows))
    return found


def _run_features(step: Articulate, joints: Sequence[PlanJoint], run: Run) -> Features:
    """Of one joint of a run, with its share of the way into the run and out of it."""
    found = features(step, joints)
    if joints[step.joint].prescribed:  # no loop
        return found
    if pays_columns(joints, run):
        found = {f"articulate_columns.{joints[step.joint].kind}": 1}
        if step.reversed:
            found["articulate.reversed"] = 1
    return {**found, "articulate.run": 1 / (run.last - run.first + 1)}


def work_features(
    steps: Iterable[Step], joints: Sequence[PlanJoint], lanes: Lanes | None = None
) -> Features:
    """Return what steps of one process, done without a message between them, are made of.

    This is the one place where steps are added up: of what is predicted and of what is fitted to
    measured times.

    Args:
        steps: some steps of a process, in order.
        joints: the plan's joints.
        lanes: those that are passed in lanes.
    """
    total: Features = {}
    for step in steps:
        found = features(step, joints)
        if lanes and isinstance(step, _SWEPT) and step.joint in lanes:
            passed = lanes[step.joint]
            if isinstance(passed, Limbs):
                found = _row_features(step, joints[step.joint].kind, passed)
            elif isinstance(step, Articulate):
                found = _run_features(step, joints, passed)
        for name, count in found.items():
            total[name] = total.get(name, 0) + count
    return total


def work_time(
    steps: Iterable[Step],
    joints: Sequence[PlanJoint],
    costs: StepCosts,
    slaved: int = 0,
    lanes: Lanes | None = None,
) -> float:
    """Return what steps of one process take together on a core of speed 1, microseconds.

    Args:
        steps: some steps of a process, in order, without a message between them.
        joints: the plan's joints.
        costs: the machine's coefficients.
        slaved: number of slaved joints, each of which adds a right-hand side to every step.
        lanes: joints that are passed in lanes.
    """
    return costs.total(work_features(steps, joints, lanes)) * (1 + slaved * costs["slaved.column"])


def step_time(step: Step, joints: Sequence[PlanJoint], costs: StepCosts, slaved: int = 0) -> float:
    """Return what a step takes by itself on a core of speed 1, microseconds; see ``work_time``."""
    return work_time((step,), joints, costs, slaved)
