"""The stages one after another, timed, shared by the subcommands."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from adagen.cli.console import Stages, note, progress, tell, warn
from adagen.cli.options import AUTO
from adagen.errors import InputError

if TYPE_CHECKING:
    from adagen.library import Compiled, Origin, Request
    from adagen.library.choice import Chosen
    from adagen.model import Model
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
    *("tie", "strategy", "split", "parts", "naive", "expansions", "name", "single_file"),
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


def choose_schedule(model: Model, options: argparse.Namespace, stages: Stages) -> Chosen:
    """Return the schedule of a robot under the options, and the request with all that was chosen.

    Raises:
        InputError: the profile or the schedule file is refused.
        UsageError: there is no such profile or schedule.
    """
    with (
        stages.stage("schedule"),
        progress(f"scheduling {len(model.joints)} joints", len(model.joints)),
    ):
        from adagen.library.choice import choose

        found = choose(model, request_of(options), left_open=options.procs == AUTO)
    if found.compared:
        times = ", ".join(f"{time:.2f} us on {processes}" for processes, time in found.compared)
        note(f"--procs auto: {found.request.procs} (predicted: {times}; {found.profile} profile)")
    if found.unpaid is not None:
        _warn(options, f"{found.unpaid_in_words}; use --procs 1 or auto")
    return found


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
    with _about(options.model):
        chosen = choose_schedule(model, options, stages)
    schedule, request = chosen.schedule, chosen.request
    with stages.stage("plan"), progress("planning", len(model.joints)), _about(options.model):
        from adagen.library.compiled import planned
        from adagen.library.robot import source_hash

        plan = planned(model, schedule, request, source_hash(origin_of(options, None)))
    from adagen.library.assessment import idle_in_words, loss
    from adagen.plan.still_joints import still_in_words

    _warn(options, still_in_words(model))
    if chosen.unpaid is None:
        _warn(options, idle_in_words(plan))
    if options.verbose and options.scene is not None:
        from adagen.cli.scenes import tell_savings

        with stages.stage("compare"):
            tell_savings(plan, schedule, request, options)
    with (
        stages.stage("assess"),
        progress("assessing accuracy", len(model.joints)),
        _about(options.model),
    ):
        lost = loss(plan, model, request)
        _warn(options, "" if lost is None else str(lost))
    if options.tune:
        from adagen.cli.tuning import fastest

        best = fastest(plan, request, stages)
        request = replace(request, shape=best.shape, chunk=best.chunk, compiler=best.compiler)
        chosen = replace(chosen, request=request)
    with stages.stage("emit"), progress("emitting", len(model.joints)):
        from adagen.library.compiled import emitted

        origin = origin_of(options, getattr(options, "gravity", None))
        return emitted(model, origin, chosen, plan)


def _warn(options: argparse.Namespace, text: str) -> None:
    """Warn of something about the robot, if there is anything."""
    if text:
        warn(f"{options.model}: warning: {text}")
