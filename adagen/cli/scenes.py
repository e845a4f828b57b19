"""A robot read as a scene wants it, and what the scene saved."""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from adagen.cli.console import note, progress, tell, warn
from adagen.errors import EnvironmentFault, InputError
from adagen.scene import Reduction, apply_scene
from adagen.scene.report import Cost, measured, removed, saved
from adagen.scene.types import Scene

if TYPE_CHECKING:
    from adagen.model import Model
    from adagen.plan import Plan
    from adagen.schedule import CostProfile, Schedule
    from adagen.urdf import Reading


def in_scene(reading: Reading, scene: Scene, options: argparse.Namespace) -> Model:
    """Return a robot reduced to what a scene needs; what it leaves out is printed.

    The reduction is kept as ``options.reduction`` for later messages.

    Raises:
        InputError: the scene does not fit the robot.
    """
    from adagen.urdf import check_reduced

    tell(reading, options.verbose > 0)
    reduction = apply_scene(reading.model, scene)
    for warning in check_reduced(reading, reduction.model):
        warn(warning)
    if options.verbose:
        for line in removed(reduction):
            note(line)
    options.reduction = reduction
    return reduction.model


def tell_savings(plan: Plan, schedule: Schedule, options: argparse.Namespace) -> None:
    """Print what is left of the robot and what that saves, as predicted and as measured here."""
    if options.reduction.all_left:
        note("scene: it leaves out nothing of the robot")
        return
    line, whole = predicted_savings(plan, schedule, options)
    note(line)
    for line in accuracy(plan, whole, options):
        note(line)
    if whole is not None:
        _tell_measured(whole, plan)


def accuracy(plan: Plan, whole: Plan | None, options: argparse.Namespace) -> list[str]:
    """Return lines on what a scene costs in accuracy: digits, and where it does not hold."""
    from adagen.emit.shapes import chosen_shape
    from adagen.library.simplified import simplifications
    from adagen.scene.report import accurate, differs
    from adagen.search.objective import predicted_digits

    reduction: Reduction = options.reduction

    def digits(model: Model, of: Plan) -> float:
        try:
            found = predicted_digits(options.objective, model, of, chosen_shape(of)).error
        except FloatingPointError:
            return 0.0
        return max(0.0, -math.log10(found)) if found > 0 else 17.0

    before = None if whole is None else digits(reduction.full, whole)
    lines = [accurate(digits(reduction.model, plan), before)]
    return [*lines, *map(differs, simplifications(reduction))]


def predicted_savings(
    plan: Plan, schedule: Schedule, options: argparse.Namespace
) -> tuple[str, Plan | None]:
    """Return a line on what a scene leaves and saves, and how the whole robot would be solved.

    Args:
        plan: of what is left.
        schedule: of what is left.
        options: the command line, with the reduction.
    """
    from adagen.schedule import load_profile

    profile = load_profile(options.profile)
    reduction: Reduction = options.reduction
    time = _time(reduction.model, plan, schedule, profile)
    whole = _whole(reduction, schedule.processes, options, profile)
    if whole is None:
        (own,) = counted([plan])
        return saved(reduction, None, Cost(own, time)), None
    before, after = counted([whole[0], plan])
    full = Cost(before, _time(reduction.full, *whole, profile))
    return saved(reduction, full, Cost(after, time)), whole[0]


def counted(plans: Sequence[Plan]) -> list[int]:
    """Return the arithmetic of plans: of their straight lines, where all are emitted so.

    These fold what is zero in every state, of a robot at rest above all; an operation in lanes
    counts as one. Otherwise it is that of the algorithm's steps.
    """
    from adagen.emit.shapes import chosen_shape
    from adagen.executor import straight_line
    from adagen.plan.operations import operations

    if any(chosen_shape(plan) != "unrolled" for plan in plans):
        return list(map(operations, plans))
    lines = [[line.operations for line in straight_line(plan)] for plan in plans]
    return [sum(own.multiply + own.add + own.divide for own in line) for line in lines]


def _tell_measured(whole: Plan, plan: Plan) -> None:
    """Build and time both, in turns; where that cannot be done, say why."""
    from adagen.build import find_toolchain
    from adagen.calibrate.measure import Program

    try:
        with progress("building and timing the robot with and without the scene"):
            toolchain = find_toolchain()
            programs = [Program(each, toolchain) for each in (whole, plan)]
            rounds = [[p.measure(repeat=_REPEAT).time for p in programs] for _ in range(_ROUNDS)]
    except EnvironmentFault as fault:
        note(f"scene: not measured: {fault}")
        return
    before, after = (min(times) for times in zip(*rounds, strict=True))
    note(measured(before, after))


_ROUNDS, _REPEAT = 5, 20  # evaluations of each of 64 random states


def _whole(
    reduction: Reduction, processes: int, options: argparse.Namespace, profile: CostProfile
) -> tuple[Plan, Schedule] | None:
    """Return how the whole robot is solved by as many processes; None where it has no answer."""
    from adagen.plan import make_plan
    from adagen.search import best_schedule
    from adagen.urdf.mobility import weakest

    full = reduction.full
    held = full.closed or any(joint.mimic for joint in full.joints)
    if not full.joints or (weakest(full).singular and not held):
        return None
    if options.form == "ada":
        profile = profile.joins_only()
    try:
        schedule = best_schedule(full, processes, profile, options.form, options.scalar)
        plan = make_plan(full, schedule, form=options.form, scalar=options.scalar)
    except InputError:
        return None
    return plan, schedule


def _time(model: Model, plan: Plan, schedule: Schedule, profile: CostProfile) -> float:
    from adagen.search import predicted_time

    time = schedule.makespan
    if profile.steps is not None:
        time = predicted_time(model, schedule, profile, plan.form)
    return float(np.round(time, 6))
