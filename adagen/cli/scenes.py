"""Reads a robot with a scene, and reports what the scene saves."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from adagen.cli.console import note, progress, tell, warn
from adagen.errors import EnvironmentFault
from adagen.scene import Reduction, apply_scene
from adagen.scene.report import measured, removed
from adagen.scene.types import Scene

if TYPE_CHECKING:
    from adagen.library import Request
    from adagen.model import Model
    from adagen.plan import Plan
    from adagen.schedule import Schedule
    from adagen.urdf import Reading


def in_scene(reading: Reading, scene: Scene, options: argparse.Namespace) -> Model:
    """Return a robot reduced to the needs of a scene, and print what was removed.

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


def tell_savings(
    plan: Plan, schedule: Schedule, request: Request, options: argparse.Namespace
) -> None:
    """Print the remaining robot and its savings, predicted and measured here."""
    from adagen.calibrate.measure import least_times
    from adagen.library.savings import accuracy, predicted_savings

    reduction: Reduction = options.reduction
    if reduction.all_left:
        note("scene: it leaves out nothing of the robot")
        return
    line, whole = predicted_savings(plan, schedule, reduction, request)
    note(line)
    for line in accuracy(plan, whole, reduction, request):
        note(line)
    if whole is None:
        return
    try:
        with progress("building and timing the robot with and without the scene"):
            before, after = least_times([whole, plan])
    except EnvironmentFault as fault:
        note(f"scene: not measured: {fault}")
        return
    note(measured(before, after))
