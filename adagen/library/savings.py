"""What a scene saves, and its effect on accuracy."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from adagen.emit.shapes import chosen_shape
from adagen.errors import InputError
from adagen.executor import straight_line
from adagen.library.request import Request
from adagen.library.simplified import simplifications
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.operations import operations
from adagen.scene import Reduction
from adagen.scene.report import Cost, accurate, differs, saved
from adagen.schedule import CostProfile, Schedule, load_profile
from adagen.search import best_schedule, predicted_time
from adagen.search.objective import predicted_digits
from adagen.urdf.mobility import weakest


def accuracy(plan: Plan, whole: Plan | None, reduction: Reduction, request: Request) -> list[str]:
    """Return lines about the accuracy of a scene: digits, and errors where it does not hold.

    Args:
        plan: of what is left.
        whole: of the whole robot, or None.
        reduction: what the scene leaves.
        request: how both are compiled.
    """

    def digits(model: Model, of: Plan) -> float:
        try:
            found = predicted_digits(request.objective, model, of, chosen_shape(of)).error
        except FloatingPointError:
            return 0.0
        return max(0.0, -math.log10(found)) if found > 0 else 17.0

    before = None if whole is None else digits(reduction.full, whole)
    lines = [accurate(digits(reduction.model, plan), before)]
    return [*lines, *map(differs, simplifications(reduction))]


def predicted_savings(
    plan: Plan, schedule: Schedule, reduction: Reduction, request: Request
) -> tuple[str, Plan | None]:
    """Return a line about what a scene leaves and saves, and the plan of the whole robot.

    Args:
        plan: of what is left.
        schedule: of what is left.
        reduction: what the scene leaves.
        request: how both are compiled.
    """
    profile = load_profile(request.profile)
    time = _time(reduction.model, plan, schedule, profile)
    whole = _whole(reduction, schedule.processes, request, profile)
    if whole is None:
        (own,) = counted([plan])
        return saved(reduction, None, Cost(own, time)), None
    before, after = counted([whole[0], plan])
    full = Cost(before, _time(reduction.full, *whole, profile))
    return saved(reduction, full, Cost(after, time)), whole[0]


def counted(plans: Sequence[Plan]) -> list[int]:
    """Return the operations of plans: of their straight lines, where all are emitted so.

    These fold what is zero in every state, of a robot at rest above all; an operation in lanes
    counts as one. Otherwise it is that of the algorithm's steps.
    """
    if any(chosen_shape(plan) != "unrolled" for plan in plans):
        return list(map(operations, plans))
    lines = [[line.operations for line in straight_line(plan)] for plan in plans]
    return [sum(own.multiply + own.add + own.divide for own in line) for line in lines]


def _whole(
    reduction: Reduction, processes: int, request: Request, profile: CostProfile
) -> tuple[Plan, Schedule] | None:
    """Return the plan of the whole robot on as many processes; None where it has no answer."""
    full = reduction.full
    held = full.closed or any(joint.mimic for joint in full.joints)
    if not full.joints or (weakest(full).singular and not held):
        return None
    if request.form == "ada":
        profile = profile.joins_only()
    try:
        asked = request.form, request.scalar
        schedule = best_schedule(
            full, processes, profile, *asked, in_parts=request.may_part(len(full.joints))
        )
        plan = make_plan(full, schedule, form=request.form, scalar=request.scalar)
    except InputError:
        return None
    return plan, schedule


def _time(model: Model, plan: Plan, schedule: Schedule, profile: CostProfile) -> float:
    time = schedule.makespan
    if profile.steps is not None:
        time = predicted_time(model, schedule, profile, plan.form, scalar=plan.scalar)
    return float(np.round(time, 6))
