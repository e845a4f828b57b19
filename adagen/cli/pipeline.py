"""The stages one after another, timed, as the subcommands share them."""

from __future__ import annotations

import argparse
import hashlib
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

from adagen.cli.console import Stages, progress, tell, warn
from adagen.cli.options import AUTO, refinement
from adagen.cli.predicted import priced_shape, scheduled
from adagen.errors import InputError, UsageError

if TYPE_CHECKING:
    from adagen.cost import Timeline
    from adagen.model import Model
    from adagen.plan import Plan
    from adagen.program import Program
    from adagen.schedule import CostProfile, Schedule, Topology
    from adagen.urdf import Reading


@dataclass(frozen=True)
class Generated:
    """What one run of the compiler made.

    Attributes:
        schedule: the schedule.
        plan: the plan.
        program: what is emitted.
        timeline: how an evaluation is predicted to go; None where the profile or a batch leaves
            that open.
        files: file name to text: source, plan, drawing and Makefile.
        processes: how many run it; they share the robot, or the states of a batch.
        compiler: what the MPI wrapper is to call; "" for its own choice.
    """

    schedule: Schedule
    plan: Plan
    program: Program
    timeline: Timeline | None
    files: dict[str, str]
    processes: int
    compiler: str = ""

    @property
    def source(self) -> tuple[str, str]:
        """File name and text of the C++ source."""
        return next((name, text) for name, text in self.files.items() if name.endswith(".cpp"))


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
    with stages.stage("read"), progress(f"reading {Path(options.model).name}"):
        if options.scene is not None:
            from adagen.cli.scenes import read_in_scene

            return read_in_scene(options, gravity)
        from adagen.urdf import read_robot

        reading = read_robot(
            options.model,
            floating=options.floating,
            mimic=options.mimic,
            gravity=gravity,
            strict=options.strict,
            held=False,
        )
    tell(reading, options.verbose > 0)
    return reading.model, reading


def schedule_model(model: Model, options: argparse.Namespace, stages: Stages) -> Schedule:
    """Return the schedule of a robot under the options.

    Raises:
        InputError: the profile or the schedule file is refused.
        UsageError: there is no such profile or schedule.
    """
    with stages.stage("schedule"), progress(f"scheduling {len(model.joints)} joints"):
        from adagen.plan import as_gathered
        from adagen.schedule import Topology, load_profile
        from adagen.schedule.tree import Named
        from adagen.search.objective import schedule_for

        profile = load_profile(options.profile)
        joins = profile.joins_only() if options.form == "ada" else profile
        if options.schedule not in ("auto", *get_args(Named)):
            found = _read_schedule(options, Topology.of(model), joins)
            if getattr(options, "shape", found.shape) == "auto":
                options.shape = found.shape
            return as_gathered(model, found)

        def schedule(processes: int) -> Schedule:
            if options.schedule != "auto":
                return _named_schedule(model, options, processes, joins)
            return schedule_for(
                options.objective,
                model,
                processes,
                profile,
                options.form,
                options.scalar,
                tie=options.tie,
                strategy=options.strategy,
                split=options.split,
                improved=not options.naive,
                gather=_may_gather(options),
                shape=priced_shape(options),
                **({} if options.expansions is None else {"expansions": options.expansions}),
            )

        return as_gathered(model, scheduled(model, options, schedule))


def _named_schedule(
    model: Model, options: argparse.Namespace, processes: int, profile: CostProfile
) -> Schedule:
    """Return the schedule of the name that the user gave.

    Raises:
        InputError: the robot has no joint at which anything could be joined.
    """
    from adagen.plan.clusters import fold_of
    from adagen.search import named_schedule

    seen = fold_of(model, options.form)
    if not len(seen.topology):
        raise InputError(
            f"form {options.form} treats all links of this robot as one, as their inertias cannot"
            f" be inverted: there is no order of joints for --schedule {options.schedule}; leave it"
            " out"
        )
    found = named_schedule(options.schedule, seen.topology, processes, profile=profile)
    return seen.unfold(found, profile)


def _read_schedule(
    options: argparse.Namespace, topology: Topology, profile: CostProfile
) -> Schedule:
    """Return the schedule in the file that the user gave."""
    from adagen.schedule.tree import Named
    from adagen.search import schedule_from_json

    try:
        text = Path(options.schedule).read_text(encoding="utf-8")
    except FileNotFoundError:
        known = ", ".join(("auto", *get_args(Named)))
        raise UsageError(
            f"--schedule: '{options.schedule}' is no file and none of {known}"
        ) from None
    except OSError as error:
        raise InputError(f"cannot read it: {error.strerror}", options.schedule) from None
    except ValueError:
        raise InputError("not UTF-8 text", options.schedule) from None
    schedule = schedule_from_json(text, topology, profile, options.schedule)
    if options.procs == AUTO:
        options.procs = schedule.processes
    if schedule.processes != options.procs:
        raise InputError(
            f"this schedule is for {schedule.processes} processes, not {options.procs}; "
            f"say --procs {schedule.processes}",
            options.schedule,
        )
    return schedule


def draw(schedule: Schedule, model: Model, program: Program, profile: CostProfile) -> str:
    """Return a program drawn as SVG."""
    from adagen.drawing import draw
    from adagen.schedule import Topology

    return draw(schedule, Topology.of(model), program, profile, model.name)


@contextmanager
def _about(file: str) -> Iterator[None]:
    """Name the robot's file in refusals of stages that know the robot, not where it came from."""
    try:
        yield
    except InputError as error:
        if error.file is None:
            raise InputError(error.message, file) from None
        raise


def generate(model: Model, options: argparse.Namespace, stages: Stages) -> Generated:
    """Return all that is emitted for a robot under the options; nothing is written.

    Raises:
        InputError: the robot cannot be treated in this form.
    """
    batch = 0
    if options.batch:
        batch, options.procs = shared_by(options), 1
    with _about(options.model):
        schedule = schedule_model(model, options, stages)
    with stages.stage("plan"), progress("planning"), _about(options.model):
        from adagen.plan import make_plan

        plan = make_plan(
            model,
            schedule,
            form=options.form,
            scalar=options.scalar,
            channel=options.channel,
            source_hash=source_hash(Path(options.model)),
        )
    _warn_of_idle(plan, options)
    if options.verbose and options.scene is not None:
        from adagen.cli.scenes import tell_savings

        with stages.stage("compare"):
            tell_savings(plan, schedule, options)
    with stages.stage("assess"):
        _warn_of_lost_digits(plan, model, options)
    chosen = _shape(plan, options, stages)
    program, line = _programmed(plan, options, chosen["shape"])
    with stages.stage("emit"), progress("emitting"):
        from adagen.emit import emit
        from adagen.schedule import load_profile

        name = Path(options.model).stem if options.name is None else options.name
        profile = load_profile(options.profile)
        files = emit(
            plan,
            name=name,
            svg=draw(schedule, model, program, profile),
            refine=options.refine,
            batch=batch,
            profile=profile,
            **chosen,
        )
    processes = batch or options.procs
    return Generated(schedule, plan, program, line, files, processes, chosen.get("compiler", ""))


def _programmed(
    plan: Plan, options: argparse.Namespace, shape: str
) -> tuple[Program, Timeline | None]:
    """Return what is emitted of a plan, and how an evaluation is predicted to go."""
    from adagen.cli.predicted import timeline_of
    from adagen.emit import program_of
    from adagen.schedule import load_profile

    profile = load_profile(options.profile)
    program = program_of(plan, shape, options.refine, batch=options.batch, profile=profile)
    return program, None if options.batch else timeline_of(program, options)


def _shape(plan: Plan, options: argparse.Namespace, stages: Stages) -> dict[str, Any]:
    """Return what ``emit`` is told of shape and compiler: as asked for, or found by trying."""
    if not options.tune:
        return {"shape": options.shape}
    from adagen.cli.tuning import tuned

    best = tuned(plan, options, stages)
    return {"shape": best.shape, "chunk": best.chunk, "compiler": best.compiler}


def _warn_of_idle(plan: Plan, options: argparse.Namespace) -> None:
    idle = sum(not process.owns for process in plan.processes)
    if idle and not getattr(options, "told_to_use_fewer", False):
        few = len(plan.processes) - idle
        warn(
            f"{options.model}: warning: {idle} of {len(plan.processes)} processes will have"
            f" nothing to do; say --procs {few}"
        )


def shared_by(options: argparse.Namespace) -> int:
    """Return by how many processes a batch is shared: all cores for auto."""
    return int(options.procs) or len(os.sched_getaffinity(0))


def _may_gather(options: argparse.Namespace) -> bool:
    """Return whether processes may gather: shape kernels alone knows how to.

    Who asks for a strategy or a split asks for the paper's way to meet.
    """
    if options.strategy != "exact" or options.split != "always":
        return False
    shape = getattr(options, "shape", "auto")
    whole = refinement(options) or getattr(options, "tune", False)
    return shape in ("auto", "kernels") and not whole


def _warn_of_lost_digits(plan: Plan, model: Model, options: argparse.Namespace) -> None:
    """Warn where the emitted code will keep fewer digits than its own check asks for.

    Raises:
        InputError: it keeps none: a factorization fails already here.
    """
    from adagen.emit import TOLERANCE
    from adagen.executor.growth import predicted_growth

    file = options.model
    try:
        growth = predicted_growth(plan)
    except FloatingPointError as error:
        raise InputError(_why_it_fails(plan, model, options, str(error)), file) from None
    # In form segment, cuts beside light links are not made in the first place; what refinement
    # makes good, a mixed solver says itself.
    if plan.form == "ada" and plan.scalar != "mixed" and growth.error > TOLERANCE[plan.scalar]:
        warn(
            f"{file}: warning: relative errors of about {growth.error:.0e} are to be expected: a "
            f'link at joint "{plan.joints[growth.joint].name}" is much lighter than its neighbours;'
            " form segment keeps more digits"
        )


def _why_it_fails(plan: Plan, model: Model, options: argparse.Namespace, failure: str) -> str:
    """Return why a factorization of a plan fails, and what to do."""
    from adagen.plan.cuts import cuttable_joints
    from adagen.plan.steps import Join
    from adagen.urdf.notes import quoted

    if plan.form == "ada":
        return f"form ada cannot solve this robot: {failure}; say --form segment"
    cuts = {s.joint for process in plan.processes for s in process.steps if isinstance(s, Join)}
    good = cuttable_joints(model, plan.scalar)
    bad = quoted([joint.name for j, joint in enumerate(plan.joints) if j in cuts and not good[j]])
    if options.schedule == "auto":
        return f"form segment cannot solve this robot: {failure}"
    if not bad:
        return f"--schedule {options.schedule} cannot be solved: {failure}; leave it out"
    return (
        f"--schedule {options.schedule} lets processes meet at {bad}, beside links whose inertia "
        f"is singular or too small to be joined there ({failure}): leave out --schedule, or say"
        " --procs 1"
    )


def source_hash(path: Path) -> str:
    """Return the SHA-256 of a robot description, in hexadecimal.

    Raises:
        InputError: it cannot be read.
    """
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        raise InputError(f"cannot read it: {error.strerror}", str(path)) from None
