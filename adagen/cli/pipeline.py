"""The stages one after another, timed, as the subcommands share them."""

from __future__ import annotations

import argparse
import math
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import Stages, progress, tell, warn
from adagen.cli.options import AUTO
from adagen.cli.predicted import scheduled
from adagen.errors import InputError

if TYPE_CHECKING:
    from adagen.library import Compiled, Origin, Request
    from adagen.model import Model
    from adagen.plan import Plan
    from adagen.schedule import Schedule
    from adagen.urdf import Reading


def read_model(
    options: argparse.Namespace, stages: Stages, gravity: Sequence[float] | None
) -> Model:
    """Return the robot that the options name, with warnings on stderr.

    Raises:
        InputError: the robot description or the scene is refused.
    """
    return read_whole(options, stages, gravity)[0]


def read_whole(
    options: argparse.Namespace, stages: Stages, gravity: Sequence[float] | None
) -> tuple[Model, Reading]:
    """Return the robot that the options name, as a scene leaves it, and what was read of it.

    Raises:
        InputError: the robot description or the scene is refused.
    """
    with (
        stages.stage("read"),
        progress(f"reading {Path(options.model).name}", _length(Path(options.model))),
    ):
        from adagen.cli.scenes import in_scene
        from adagen.library.robot import read_whole

        reading, scene = read_whole(origin_of(options, gravity))
        if scene is not None:
            return in_scene(reading, scene, options), reading
    tell(reading, options.verbose > 0)
    return reading.model, reading


def origin_of(options: argparse.Namespace, gravity: Sequence[float] | None) -> Origin:
    """Return where the robot of the options comes from, and how it is read."""
    from adagen.library import Origin

    return Origin(
        Path(options.model),
        options.floating,
        options.mimic,
        options.strict,
        None if options.scene is None else Path(options.scene),
        None if gravity is None else tuple(gravity),
        tuple(options.xacro_arg or ()),
        None if options.loops is None else Path(options.loops),
    )


def request_of(options: argparse.Namespace) -> Request:
    """Return what the options ask for; of ``--procs auto``, one process."""
    from adagen.library import Request

    given = {name: getattr(options, name) for name in _ASKED if hasattr(options, name)}
    tuned = getattr(options, "tuned", None)
    if tuned is not None:
        given |= {"shape": tuned.shape, "chunk": tuned.chunk, "compiler": tuned.compiler}
    tuned = tuned is not None or getattr(options, "tune", False)
    return Request(procs=options.procs or 1, tuned=tuned, **given)


_ASKED = (
    *(
        "form",
        "scalar",
        "channel",
        "shape",
        "refine",
        "residual",
        "batch",
        "profile",
        "schedule",
        "objective",
    ),
    *("tie", "strategy", "split", "naive", "expansions", "name", "single_file"),
    *("reproducible", "certify", "loop_forces"),
    *("runtime", "target"),
)
"""Members of a request that are options of the same name."""


_IMPORTED = 50_000
"""Characters that are read in the time in which the reader's libraries are imported."""


def _length(path: Path) -> int:
    try:
        return _IMPORTED + path.stat().st_size
    except OSError:
        return 0


def schedule_model(model: Model, options: argparse.Namespace, stages: Stages) -> Schedule:
    """Return the schedule of a robot under the options.

    Raises:
        InputError: the profile or the schedule file is refused.
        UsageError: there is no such profile or schedule.
    """
    with (
        stages.stage("schedule"),
        progress(f"scheduling {len(model.joints)} joints", len(model.joints)),
    ):
        from adagen.library.scheduling import KNOWN, given_schedule, schedule_of, searched
        from adagen.plan import as_gathered

        asked = request_of(options)
        if asked.schedule not in KNOWN:
            found = given_schedule(model, asked)
            if options.procs == AUTO:
                options.procs = found.processes
            if getattr(options, "shape", found.shape) == "auto":
                options.shape = found.shape
            return schedule_of(model, replace(asked, procs=options.procs))

        def schedule(processes: int) -> Schedule:
            return searched(model, replace(asked, procs=processes))

        return as_gathered(model, scheduled(model, options, schedule))


@contextmanager
def _about(file: str) -> Iterator[None]:
    """Name the robot's file in refusals of stages that know the robot, not where it came from."""
    try:
        yield
    except InputError as error:
        if error.file is None:
            raise InputError(error.message, file) from None
        raise


def generate(model: Model, options: argparse.Namespace, stages: Stages) -> Compiled:
    """Return all that is emitted for a robot under the options; nothing is written.

    Raises:
        InputError: the robot cannot be treated in this form.
    """
    processes = 0
    if options.batch:
        processes, options.procs = shared_by(options), 1
    with _about(options.model):
        schedule = schedule_model(model, options, stages)
    request = replace(request_of(options), procs=processes or options.procs)
    with stages.stage("plan"), progress("planning", len(model.joints)), _about(options.model):
        from adagen.library.compiled import planned
        from adagen.library.robot import source_hash

        plan = planned(model, schedule, request, source_hash(origin_of(options, None)))
    _warn_of_idle(plan, options)
    if options.verbose and options.scene is not None:
        from adagen.cli.scenes import tell_savings

        with stages.stage("compare"):
            tell_savings(plan, schedule, options)
    with stages.stage("assess"), progress("assessing accuracy", len(model.joints)):
        _warn_of_lost_digits(plan, model, request, options)
    if options.tune:
        from adagen.cli.tuning import tuned

        best = tuned(plan, options, stages)
        request = replace(request, shape=best.shape, chunk=best.chunk, compiler=best.compiler)
    with stages.stage("emit"), progress("emitting", len(model.joints)):
        from adagen.library.compiled import emitted

        origin = origin_of(options, getattr(options, "gravity", None))
        return emitted(model, origin, schedule, plan, request)


def _warn_of_idle(plan: Plan, options: argparse.Namespace) -> None:
    idle = sum(not process.owns for process in plan.processes)
    if idle and not getattr(options, "warned_of_fewer", False):
        few = len(plan.processes) - idle
        warn(
            f"{options.model}: warning: {idle} of {len(plan.processes)} processes will have"
            f" nothing to do; use --procs {few}"
        )


def shared_by(options: argparse.Namespace) -> int:
    """Return by how many processes a batch is shared: all cores for auto."""
    return int(options.procs) or len(os.sched_getaffinity(0))


def _warn_of_lost_digits(
    plan: Plan, model: Model, request: Request, options: argparse.Namespace
) -> None:
    """Warn, by the joint at fault, where the emitted code is predicted to keep few digits.

    Raises:
        InputError: it keeps none: a factorization fails already here.
    """
    from adagen.emit import TOLERANCE
    from adagen.emit.shapes import chosen_shape, shape_to_refine, why_not_own
    from adagen.library.compiled import shape_of
    from adagen.search.objective import FEW, predicted_digits
    from adagen.urdf.notes import quoted

    file, shape = options.model, shape_of(plan, request)
    if request.refinement:
        if request.residual == "wide" or why_not_own(plan, shape_to_refine(plan, shape)):
            return  # what refinement makes good, or not, the solver says itself
        shape = "unrolled"  # residuals in its own numbers leave about as much as a straight line
    if shape == "auto":
        shape = chosen_shape(plan, batch=request.batch)
    try:
        digits = predicted_digits(options.objective, model, plan, shape)
    except FloatingPointError as error:
        raise InputError(_why_it_fails(plan, model, options, str(error)), file) from None
    few = TOLERANCE[plan.scalar] if plan.form == "ada" else FEW[plan.scalar]
    if digits.error <= few:
        return
    ways = ["form segment keeps more digits"] if plan.form == "ada" else []
    if plan.form != "ada" and shape == "kernels" and plan.scalar == "double":
        ways = ["--shape unrolled or --refine 1 may keep more"]
    elif plan.form != "ada" and plan.scalar == "float":
        ways = ["--scalar double keeps nine more digits"]
    warn(
        f"{file}: warning: {max(0.0, -math.log10(digits.error)):.1f} digits are predicted; the "
        f"largest loss is at joint {quoted([digits.worst])}" + "".join(f"; {way}" for way in ways)
    )


def _why_it_fails(plan: Plan, model: Model, options: argparse.Namespace, failure: str) -> str:
    """Return why a factorization of a plan fails, and what to do."""
    from adagen.plan.cuts import cuttable_joints
    from adagen.plan.steps import Join
    from adagen.urdf.notes import quoted

    if plan.form == "ada":
        return f"form ada cannot solve this robot: {failure}; use --form segment"
    cuts = {s.joint for process in plan.processes for s in process.steps if isinstance(s, Join)}
    good = cuttable_joints(model, plan.scalar)
    bad = quoted([joint.name for j, joint in enumerate(plan.joints) if j in cuts and not good[j]])
    if options.schedule == "auto":
        return f"form segment cannot solve this robot: {failure}"
    if not bad:
        return f"--schedule {options.schedule} cannot be solved: {failure}; leave it out"
    return (
        f"--schedule {options.schedule} lets processes meet at {bad}, beside links whose inertia "
        f"is singular or too small to be joined there ({failure}): leave out --schedule, or use"
        " --procs 1"
    )
