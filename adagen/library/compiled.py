"""From a robot and a request to all emitted files."""

from __future__ import annotations

from typing import Any

from adagen.build.native_profile import profile_named
from adagen.cost import timeline
from adagen.drawing import draw
from adagen.emit import emit, program_of
from adagen.errors import InputError, UsageError
from adagen.garbage import seldom_collected
from adagen.library.assessment import shape_of
from adagen.library.choice import Chosen, choose
from adagen.library.inputs import inputs_of
from adagen.library.request import Request
from adagen.library.robot import Origin, Robot
from adagen.library.self_check import check_answer
from adagen.library.solver import Compiled
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.certificate import certified
from adagen.plan.still_joints import check_motion
from adagen.schedule import Schedule, Topology, load_profile
from adagen.urdf import model_stem


def compile(robot: Robot, procs: int = 1, **asked: Any) -> Compiled:  # noqa: A001 (what it does)
    """Compile a robot into a solver of its forward dynamics.

    Args:
        robot: as ``adagen.read`` returns it.
        procs: processes that share the robot; ``build`` takes one.
        asked: further members of ``Request``, such as ``scalar="float"`` or ``batch=True``;
            ``profile="native"`` is the shipped profile that fits this machine.

    Raises:
        InputError: the robot cannot be solved in this way.
        UsageError: an option is unknown or cannot be combined with the others.
        EnvironmentFault: there is no compiler that tells which profile fits.
    """
    if "profile" in asked:
        asked["profile"] = profile_named(asked["profile"])
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
        chosen = choose(robot.model, request)
        plan = planned(robot.model, chosen.schedule, chosen.request, robot.source_hash)
    except InputError as error:
        if error.file is None:
            raise InputError(error.message, str(robot.origin.path)) from None
        raise
    return emitted(robot.model, robot.origin, chosen, plan)


def planned(model: Model, schedule: Schedule, request: Request, source_hash: str) -> Plan:
    """Return what each process computes under a schedule.

    Raises:
        InputError: the robot cannot be treated in this form, or closed loops leave it no motion.
        UsageError: its answers cannot be certified, and are to be.
    """
    if not request.loop_forces:
        check_motion(model)
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


def emitted(model: Model, origin: Origin, chosen: Chosen, plan: Plan) -> Compiled:
    """Return all emitted files of a plan; nothing is written.

    Args:
        model: the robot.
        origin: where it comes from.
        chosen: the schedule, and the request: shape, refinement, batches, names of files.
        plan: what each process computes.

    Raises:
        UsageError: the plan cannot be emitted as it is asked for.
    """
    schedule, request = chosen.schedule, chosen.request
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
    check_answer(model, plan, program)
    line = None if profile.steps is None else timeline(program, profile)
    inputs = inputs_of(origin, request)
    return Compiled(
        model,
        origin,
        request,
        schedule,
        plan,
        program,
        line,
        files,
        inputs,
        chosen.unpaid_in_words,
    )
