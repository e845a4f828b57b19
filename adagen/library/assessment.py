"""Predicted time of a schedule, and predicted digits of its program."""

from __future__ import annotations

import math
from dataclasses import dataclass

from adagen.cost import Timeline, timeline
from adagen.emit import TOLERANCE
from adagen.emit.shapes import chosen_shape, priced_program, shape_to_refine, why_not_own
from adagen.errors import InputError
from adagen.library.request import Request
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.cuts import cuttable_joints
from adagen.plan.steps import Join
from adagen.program import Program
from adagen.schedule import Schedule, load_profile
from adagen.search.objective import FEW, Digits, predicted_digits, suited_shape
from adagen.urdf.notes import quoted


@dataclass(frozen=True)
class Assessed:
    """Predictions for a schedule, for one state at a time.

    Attributes:
        schedule: which process computes what.
        program: what runs.
        timeline: how that is predicted to go; None where the profile cannot tell.
        digits: what is predicted of its digits; None where a factorization fails.
    """

    schedule: Schedule
    program: Program
    timeline: Timeline | None
    digits: Digits | None


@dataclass(frozen=True)
class Loss:
    """A prediction of few digits.

    Attributes:
        digits: right decimal digits, 0 or more.
        joint: where the largest loss is.
        ways: what keeps more, in words of the command line.
        hard: whether that is so in hard poses only.
    """

    digits: float
    joint: str
    ways: tuple[str, ...]
    hard: bool

    def __str__(self) -> str:
        return (
            f"{self.digits:.1f} digits are predicted"
            f"{' where axes are nearly parallel' * self.hard}; the largest loss is at joint "
            f"{quoted([self.joint])}" + "".join(f"; {way}" for way in self.ways)
        )


def shape_of(plan: Plan, request: Request) -> str:
    """Return the shape of a request, "auto" for the fastest."""
    if request.batch or request.refinement:
        return request.shape
    return suited_shape(request.objective, plan, request.shape, load_profile(request.profile))


def assessed(model: Model, schedule: Schedule, request: Request) -> Assessed:
    """Return the predictions for a schedule.

    Raises:
        InputError: the robot cannot be treated in the form asked for.
    """
    plan = make_plan(
        model,
        schedule,
        form=request.form,
        scalar=request.scalar,
        reproducible=request.reproducible,
    )
    profile = load_profile(request.profile)
    shape = suited_shape(request.objective, plan, request.priced_shape, profile)
    program = priced_program(plan, shape, profile)
    try:
        digits = predicted_digits(request.objective, model, plan, program.shape)
    except FloatingPointError:
        digits = None
    line = None if profile.steps is None else timeline(program, profile)
    return Assessed(schedule, program, line, digits)


def idle_in_words(plan: Plan) -> str:
    """Return what is to be said of processes that do nothing; empty where all do something."""
    idle = sum(not process.owns for process in plan.processes)
    if not idle:
        return ""
    many = len(plan.processes)
    return f"{idle} of {many} processes will have nothing to do; use --procs {many - idle}"


def loss(plan: Plan, model: Model, request: Request) -> Loss | None:
    """Return the loss if the emitted code is predicted to keep few digits; else None.

    Raises:
        InputError: it keeps none: a factorization fails already here.
    """
    shape = shape_of(plan, request)
    if request.refinement:
        if request.residual == "wide" or why_not_own(plan, shape_to_refine(plan, shape)):
            return None  # what refinement makes good, or not, the solver says itself
        shape = "unrolled"  # residuals in its own numbers leave about as much as a straight line
    if shape == "auto":
        shape = chosen_shape(plan, batch=request.batch)
    try:
        digits = predicted_digits(request.objective, model, plan, shape)
    except FloatingPointError as error:
        raise InputError(_why_it_fails(plan, model, request, str(error))) from None
    few = TOLERANCE[plan.scalar] if plan.form == "ada" else FEW[plan.scalar]
    hard = digits.error <= few
    lost, joint = (digits.anywhere, digits.hardest) if hard else (digits.error, digits.worst)
    if lost <= few:
        return None
    ways = ["form segment keeps more digits"] if plan.form == "ada" else []
    if plan.form != "ada" and shape == "kernels" and plan.scalar == "double":
        ways = ["--shape unrolled or --refine 1 may keep more"]
    elif plan.form != "ada" and plan.scalar == "float":
        ways = ["--scalar double keeps nine more digits"]
    return Loss(max(0.0, -math.log10(lost)), joint, tuple(ways), hard)


def _why_it_fails(plan: Plan, model: Model, request: Request, failure: str) -> str:
    """Return why a factorization of a plan fails, and what to do."""
    if plan.form == "ada":
        return f"form ada cannot solve this robot: {failure}; use --form segment"
    cuts = {step.joint for step in plan.steps_of(Join)}
    good = cuttable_joints(model, plan.scalar)
    bad = quoted([joint.name for j, joint in enumerate(plan.joints) if j in cuts and not good[j]])
    if request.schedule == "auto":
        return f"form segment cannot solve this robot: {failure}"
    if not bad:
        return f"--schedule {request.schedule} cannot be solved: {failure}; leave it out"
    return (
        f"--schedule {request.schedule} lets processes meet at {bad}, beside links whose inertia "
        f"is singular or too small to be joined there ({failure}): leave out --schedule, or use"
        " --procs 1"
    )
