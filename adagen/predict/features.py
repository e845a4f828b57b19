"""What joints weigh in layouts, before it is known what lies side by side (layouts.py)."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass

from adagen.cost.features import Features, step_features
from adagen.plan.abreast import Limbs
from adagen.plan.steps import Accelerate, Articulate, Kinematics, Propagate, Step
from adagen.plan.types import PlanJoint
from adagen.program.runs import Run, pays_columns, runs
from adagen.program.segments import pays_segments
from adagen.schedule.costs import StepCosts


@dataclass(frozen=True)
class Together:
    """What joints are passed with in shape kernels; those that are passed by themselves are not in.

    Attributes:
        limbs: limbs side by side.
        inward: the run that a joint is passed inwards with.
        outward: the run that it is passed outwards with in segments.
        responding: joints of runs whose mobility is asked for at the last link only.
    """

    limbs: Mapping[int, Limbs]
    inward: Mapping[int, Run]
    outward: Mapping[int, Run]
    responding: Container[int]


_NUMBERS = {2: "two", 4: "four"}
SIDE_BY_SIDE: dict[type, str] = {
    Kinematics: "kinematics",
    Articulate: "articulate",
    Accelerate: "accelerate",
}
"""Steps that limbs take side by side, and the groups that price them."""


def in_runs(joints: Sequence[PlanJoint]) -> Together:
    """Return what joints are passed with where nothing lies side by side."""
    found = runs(joints, range(len(joints)))
    outward = (run for run in found if pays_segments(joints, run, "double"))
    return Together({}, _by_joint(found), _by_joint(outward), ())


def _by_joint(own: Iterable[Run]) -> dict[int, Run]:
    return {j: run for run in own for j in range(run.first, run.last + 1)}


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
        return _run_features(step, joints, together.inward[j])
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


def _run_features(step: Articulate, joints: Sequence[PlanJoint], run: Run) -> Features:
    """Of one joint of a run, with its share of the way into the run and out of it."""
    found = step_features(step, joints)
    if pays_columns(joints, run):
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
            found = step_features(step, joints)
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
