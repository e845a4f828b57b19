"""What the cost profile predicts of a schedule, and how many processes that speaks for."""

from __future__ import annotations

import argparse
import json
import math
import os
from collections.abc import Callable
from typing import TYPE_CHECKING

from adagen.cli.console import note, warn
from adagen.cli.options import AUTO, refinement
from adagen.errors import printable

if TYPE_CHECKING:
    from adagen.cost import Timeline
    from adagen.model import Model
    from adagen.plan import Plan
    from adagen.program import Program
    from adagen.schedule import CostProfile, Schedule
    from adagen.search.objective import Digits

MOST_CORES = 16
"""Processes that --procs auto considers at most."""


def scheduled(
    model: Model, options: argparse.Namespace, schedule: Callable[[int], Schedule]
) -> Schedule:
    """Return the schedule for the processes that were asked for, or for as many as pay.

    Where they were asked for and do not pay, a warning says so.

    Args:
        model: the robot.
        options: the command line; ``procs`` is set where it was left open.
        schedule: finds a schedule for a number of processes.
    """
    from adagen.search import choose_processes, predicted_time
    from adagen.search.choose import margin

    profile, shape, same = _profile(options), priced_shape(options), options.reproducible
    if options.procs == AUTO:
        found = choose_processes(
            model, profile, options.form, cores(), schedule, shape, reproducible=same
        )
        best = found[0]
        options.procs = best.processes
        times = ", ".join(
            f"{c.time:.2f} us on {c.processes}" for c in sorted(found, key=lambda c: c.processes)
        )
        note(f"--procs auto: {best.processes} (predicted: {times}; {profile.name} profile)")
        return best.schedule
    chosen = schedule(options.procs)
    if options.procs > 1 and profile.steps is not None:
        many, one = (
            predicted_time(model, each, profile, options.form, shape, reproducible=same)
            for each in (chosen, schedule(1))
        )
        if many > (1 - margin(profile)) * one:
            warn(
                f"{options.model}: warning: {options.procs} processes do not pay: "
                f"{many:.2f} us predicted, {one:.2f} us on one ({profile.name} profile); use "
                "--procs 1 or auto"
            )
            options.warned_of_fewer = True
    return chosen


def cores() -> int:
    """Return how many cores this process may use, up to what is worth a search."""
    count = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return min(count or 1, MOST_CORES)


def priced_shape(options: argparse.Namespace) -> str:
    """Return the shape that a prediction is of: what is asked for, or comes with other wishes."""
    if options.reproducible:
        return "unrolled"
    if getattr(options, "batch", False):
        return "kernels"
    if refinement(options):
        return "joints"
    return str(getattr(options, "shape", "auto"))


def program_for(plan: Plan, options: argparse.Namespace) -> Program:
    """Return the program that a plan is emitted as under the options, for one state at a time."""
    from adagen.emit.predicted import priced_program
    from adagen.search.objective import suited_shape

    shape = suited_shape(options.objective, plan, priced_shape(options))
    return priced_program(plan, shape, _profile(options))


def timeline_of(program: Program, options: argparse.Namespace) -> Timeline | None:
    """Return how an evaluation is predicted to go, if the profile can tell."""
    from adagen.cost import timeline

    profile = _profile(options)
    return None if profile.steps is None else timeline(program, profile)


def prediction(schedule: Schedule, line: Timeline | None) -> str:
    """Return in a few words what is predicted, and what is proven of it.

    Args:
        schedule: the schedule.
        line: how its program is predicted to go on a machine, where the profile tells that.
    """
    time = schedule.makespan if line is None else line.makespan
    # What is proven is of the schedules and the price that were searched.
    searched = math.isclose(time, schedule.makespan, rel_tol=1e-9)
    proof = f"; {schedule.proven}" if searched else ""
    return f"{time:.2f} us predicted ({schedule.profile} profile{proof})"


def predicted_accuracy(
    model: Model, schedule: Schedule, program: Program, options: argparse.Namespace
) -> Digits | None:
    """Return what is predicted of a schedule's digits; None where a factorization fails."""
    from adagen.plan import make_plan
    from adagen.search.objective import predicted_digits

    plan = make_plan(
        model,
        schedule,
        form=options.form,
        scalar=options.scalar,
        reproducible=options.reproducible,
    )
    try:
        return predicted_digits(options.objective, model, plan, program.shape)
    except FloatingPointError:
        return None


def accuracy_line(digits: Digits | None) -> str:
    """Return in a line what is predicted of a schedule's digits."""
    if digits is None:
        return "no digits predicted: a factorization fails"
    kept = f"{-math.log10(digits.error):.1f} digits predicted"
    if digits.joint is None:
        at = printable(digits.worst)
        return f'{kept}: no loss at joins; the largest loss is in the sweep at joint "{at}"'
    return f'{kept}: growth {digits.growth:.1e} at joint "{printable(digits.joint)}"'


def with_accuracy(text: str, digits: Digits | None) -> str:
    """Return a schedule's JSON (however deep) with a member on its accuracy before the last brace.

    Args:
        text: a JSON object that is not empty.
        digits: what is predicted; null where a factorization fails.
    """
    found = None
    if digits is not None:
        found = {
            "objective": digits.objective,
            "digits": round(-math.log10(digits.error), 2),
            "error": digits.error,
            "growth": digits.growth if math.isfinite(digits.growth) else None,
            "joint": digits.joint,
            "worst": digits.worst,
        }
    head = text.rstrip().removesuffix("}")
    return f'{head}, "accuracy": {json.dumps(found)}}}'


def _profile(options: argparse.Namespace) -> CostProfile:
    from adagen.schedule import load_profile

    return load_profile(options.profile)
