"""From a robot and a request to all emitted files."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from adagen.atomic_files import write_files
from adagen.cost import Timeline, timeline
from adagen.drawing import draw
from adagen.emit import emit, program_of
from adagen.emit.runtime import FOLDER
from adagen.errors import InputError, UsageError
from adagen.garbage import seldom_collected
from adagen.library.command import command_of, refuse_another, with_command
from adagen.library.inputs import Input, head_lines, inputs_of, with_inputs
from adagen.library.request import Request
from adagen.library.robot import Origin, Robot
from adagen.library.scheduling import given_schedule, schedule_of
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.certificate import certified
from adagen.program import Program
from adagen.schedule import Schedule, Topology, load_profile
from adagen.search.objective import Digits, predicted_digits, suited_shape
from adagen.urdf import model_stem

if TYPE_CHECKING:
    from adagen.build import Toolchain
    from adagen.library.solver import Solver


@dataclass(frozen=True, eq=False)
class Compiled:
    """The generated solver of a robot, as text, with its schedule and prediction.

    Two are equal if the same request has made the same files of the same description: all of what
    they are is in these, in the plan (robot, schedule, steps) and in the source. A pickle is equal
    to its original.

    Attributes:
        model: the robot.
        origin: where it comes from.
        request: the options, with the shape that a given schedule asks for.
        schedule: which process computes what.
        plan: what each process computes.
        program: what runs, operation by operation.
        timeline: the predicted course of an evaluation; None if the profile or a batch leaves it
            open.
        files: file name to text: source, header, plan, drawing, Makefile, CMakeLists.txt, ...
        inputs: what it was made from beside the robot, such as scene and cost profile.
    """

    model: Model
    origin: Origin
    request: Request
    schedule: Schedule
    plan: Plan
    program: Program
    timeline: Timeline | None
    files: dict[str, str] = field(repr=False)
    inputs: tuple[Input, ...] = field(default=(), repr=False)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Compiled):
            return NotImplemented
        return self is other or (
            (self.request, self.origin, self.inputs, self.files)
            == (other.request, other.origin, other.inputs, other.files)
        )

    def __hash__(self) -> int:
        return hash((self.request, self.source))

    @property
    def stem(self) -> str:
        """NAME_pP, the name of the files without their endings."""
        return next(name for name in self.files if name.endswith(".cpp")).removesuffix(".cpp")

    @property
    def source(self) -> str:
        """The C++ source."""
        return self.files[f"{self.stem}.cpp"]

    @property
    def header(self) -> str:
        """The C header."""
        return self.files[f"{self.stem}.h"]

    @property
    def predicted(self) -> float | None:
        """Predicted time of an evaluation, microseconds; None if there is no prediction."""
        return None if self.timeline is None else self.timeline.makespan

    @property
    def digits(self) -> float | None:
        """Predicted number of right decimal digits; None if a factorisation fails."""
        return None if self._digits is None else -math.log10(self._digits.error)

    @property
    def hard_digits(self) -> float | None:
        """The same in hard poses, where axes are nearly parallel, as far as they are answered.

        None also where that is not tried: with closed loops, and in form ada.
        """
        hard = None if self._digits is None else self._digits.hard
        return None if hard is None else -math.log10(hard)

    @cached_property
    def _digits(self) -> Digits | None:
        objective, shape = self.request.objective, self.program.shape
        try:
            return predicted_digits(objective, self.model, self.plan, shape)
        except FloatingPointError:
            return None

    def in_folder(self, folder: str | os.PathLike[str]) -> dict[str, str]:
        """Return the files as they are written into a folder.

        The head of the source has the command that makes them, with paths relative to the folder,
        and the hashes of scene and profile; the plan has their texts, too.
        """
        command = command_of(self.origin, self.request, Path(folder))
        plan = f"{self.stem}.plan.json"
        return {
            **self.files,
            f"{self.stem}.cpp": with_command(self.source, command, head_lines(self.inputs)),
            plan: with_inputs(self.files[plan], command, self.inputs),
        }

    def write(self, folder: str | os.PathLike[str]) -> list[Path]:
        """Write the files, all or none, and return their paths; files that are up to date stay.

        Of the runtime's headers the path of their folder is returned.

        Raises:
            UsageError: an existing file was not written by adagen, or is of another robot.
            EnvironmentFault: writing failed.
        """
        files = self.in_folder(folder)
        source = f"{self.stem}.cpp"
        refuse_another(Path(folder, source), files[source])
        write_files(Path(folder), files)
        names = {FOLDER if name.startswith(f"{FOLDER}/") else name for name in files}
        return [Path(folder, name) for name in sorted(names)]

    def build(self, toolchain: Toolchain | None = None) -> Solver:
        """Return the solver, built now or found in the cache.

        Args:
            toolchain: what to build with; by default what ``adagen env`` prints.

        Raises:
            UsageError: the solver is for several MPI processes.
            EnvironmentFault: the compiler failed, or is missing.
        """
        from adagen.library.solver import built

        return built(self, toolchain)


def compile(robot: Robot, procs: int = 1, **asked: Any) -> Compiled:  # noqa: A001 (what it does)
    """Compile a robot into a solver of its forward dynamics.

    Args:
        robot: as ``adagen.read`` returns it.
        procs: processes that share the robot; ``build`` takes one.
        asked: further members of ``Request``, such as ``scalar="float"`` or ``batch=True``.

    Raises:
        InputError: the robot cannot be solved in this way.
        UsageError: an option is unknown or cannot be combined with the others.
    """
    try:
        request = Request(procs=procs, **asked)
    except TypeError as error:
        raise UsageError(f"compile: {error}".replace("Request.__init__() ", "")) from None
    with seldom_collected():
        return compiled(robot, request)


def compiled(robot: Robot, request: Request) -> Compiled:
    """Return the solver of a robot for a request.

    Raises:
        InputError: the robot cannot be solved in this way.
        UsageError: what is asked for cannot be had.
    """
    try:
        if request.shape == "auto" and _given(request):
            request = replace(request, shape=given_schedule(robot.model, request).shape)
        schedule = schedule_of(robot.model, request)
        plan = planned(robot.model, schedule, request, robot.source_hash)
    except InputError as error:
        if error.file is None:
            raise InputError(error.message, str(robot.origin.path)) from None
        raise
    return emitted(robot.model, robot.origin, schedule, plan, request)


def _given(request: Request) -> bool:
    from adagen.library.scheduling import KNOWN

    return request.schedule not in KNOWN


def planned(model: Model, schedule: Schedule, request: Request, source_hash: str) -> Plan:
    """Return what each process computes under a schedule.

    Raises:
        InputError: the robot cannot be treated in this form.
        UsageError: its answers cannot be certified, and are to be.
    """
    plan = make_plan(
        model,
        schedule,
        form=request.form,
        scalar=request.scalar,
        channel=request.channel,
        source_hash=source_hash,
        reproducible=request.reproducible,
        runtime=request.runtime,
        loop_forces=request.loop_forces,
    )
    if request.certify:
        plan = certified(plan)
    return plan.for_batches if request.batch else plan


def shape_of(plan: Plan, request: Request) -> str:
    """Return the shape of a request, "auto" for the fastest."""
    if request.batch or request.refinement:
        return request.shape
    return suited_shape(request.objective, plan, request.shape)


def emitted(
    model: Model, origin: Origin, schedule: Schedule, plan: Plan, request: Request
) -> Compiled:
    """Return all emitted files of a plan; nothing is written.

    Args:
        model: the robot.
        origin: where it comes from.
        schedule: which process computes what.
        plan: what each process computes.
        request: shape, refinement, batches, and names of files.

    Raises:
        UsageError: the plan cannot be emitted as it is asked for.
    """
    profile = load_profile(request.profile)
    shape = shape_of(plan, request)
    program = program_of(
        plan,
        shape,
        request.refine,
        residual=request.residual,
        batch=request.batch,
        profile=profile,
    )
    priced = not request.batch and profile.steps is not None
    files = emit(
        plan,
        name=model_stem(origin.path) if request.name is None else request.name,
        svg=draw(schedule, Topology.of(model), program, profile, model.name),
        shape=shape,
        refine=request.refine,
        residual=request.residual,
        batch=request.procs if request.batch else 0,
        chunk=request.chunk,
        compiler=request.compiler,
        profile=profile,
        single_file=request.single_file,
        target=request.target,
    )
    line = timeline(program, profile) if priced else None
    inputs = inputs_of(origin, request)
    return Compiled(model, origin, request, schedule, plan, program, line, files, inputs)
