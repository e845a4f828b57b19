"""From a schedule to a plan: the steps of each process, frozen and serialisable."""

from __future__ import annotations

from dataclasses import replace

from adagen.errors import UsageError
from adagen.model import Model
from adagen.model.fuse import runs_of, settled
from adagen.plan.ada import AdaPlanner
from adagen.plan.artificial_inertia import with_artificial_inertia, with_artificial_rotors
from adagen.plan.closed_ada import ClosedAdaPlanner
from adagen.plan.closed_segment import ClosedPlanner
from adagen.plan.closures import closures_of
from adagen.plan.clusters import ClusterPlanner, clusters_of
from adagen.plan.constants import (
    couplings_of,
    joints_of,
    links_of,
    loops_of,
    outputs_of,
    wrenches_of,
)
from adagen.plan.exchange import ExchangePlanner
from adagen.plan.gather import GatherPlanner
from adagen.plan.grounded_closures import grounded_closures_of
from adagen.plan.parameters import parameters_of, refuse_inverted
from adagen.plan.requested_outputs import handles_of, refuse_outputs, refuse_sharing, with_outputs
from adagen.plan.robot import PlanParameter, slaved_joint
from adagen.plan.segment import SegmentPlanner
from adagen.plan.separate_trees import closures_between_trees
from adagen.plan.serialise import plan_from_json, plan_to_json
from adagen.plan.shared_line import check_reproducible
from adagen.plan.steps import LinkBias
from adagen.plan.types import SCALARS, THREADS, Plan
from adagen.plan.weld_points import with_points
from adagen.schedule import Schedule, Topology, gathered_line, postorder, schedule_line

FORMS: dict[str, type[AdaPlanner]] = {"segment": SegmentPlanner, "ada": AdaPlanner}
CHANNELS = ("auto", "window", "message", THREADS)
MEETINGS = ("auto", "join", "gather", "exchange")

__all__ = [
    "CHANNELS",
    "FORMS",
    "MEETINGS",
    "SCALARS",
    "Plan",
    "as_gathered",
    "can_gather",
    "make_plan",
    "plan_from_json",
    "plan_to_json",
    "planner_of",
]


def make_plan(
    model: Model,
    schedule: Schedule,
    *,
    form: str = "segment",
    scalar: str = "double",
    channel: str = "auto",
    source_hash: str = "",
    meeting: str = "auto",
    reproducible: bool = False,
    runtime: str = "",
    loop_forces: bool = False,
) -> Plan:
    """Return the plan of a schedule: the steps of each process.

    Args:
        model: the robot.
        schedule: a schedule of its joints.
        form: form of the algorithm, one of ``FORMS``.
        scalar: one of ``SCALARS``.
        channel: how processes exchange, one of ``CHANNELS``.
        source_hash: hash of the robot description, for the emitted header.
        meeting: how segments meet, one of ``MEETINGS``: joined at the cuts by Eq. (3)-(10), by
            one side ("join") or by both ("exchange"), or gathered at a small core, in one
            exchange; "auto": as the schedule says.
        reproducible: whether answers are the same to the last bit on any number of processes.
        runtime: what can be set at run time (see ``parameters_of``).
        loop_forces: whether forces of loops and couplings are given behind the accelerations.

    Raises:
        InputError: a link's inertia cannot be inverted where the form needs it.
        UsageError: an unknown form, scalar, channel or run-time parameter, or a schedule that is
            not reproducible.
    """
    _check_words(form, scalar, channel, meeting)
    if loop_forces:
        _check_forces(model)
    parameters = parameters_of(model, runtime)
    refuse_outputs(model, form)
    planner = planner_of(model, schedule, form, meeting)
    plan = _plan(model, schedule, planner, parameters, loop_forces=loop_forces)
    plan = replace(
        plan,
        source_hash=source_hash,
        form=form,
        scalar=scalar,
        channel=channel,
        reproducible=reproducible,
    )
    if reproducible:
        gathers = isinstance(planner, GatherPlanner | ClosedPlanner)
        check_reproducible(plan, planner.gathered() if gathers else None)
        if isinstance(planner, ClosedPlanner) and plan.several:
            plan = replace(plan, line=planner.line())
    return plan


def _plan(
    model: Model,
    schedule: Schedule,
    planner: AdaPlanner,
    parameters: tuple[PlanParameter, ...],
    *,
    loop_forces: bool,
) -> Plan:
    """The plan that a planner makes, without the options of its code."""
    planner.asked = handles_of(model)
    outputs = outputs_of(model)
    refuse_sharing(outputs, schedule)
    processes, messages = planner.plan()
    processes = with_outputs(processes, outputs)
    if planner.fusions.fused:
        model = settled(model, planner.fusions.fused)
    bare = {step.link for p in processes for step in p.steps if isinstance(step, LinkBias)}
    refuse_inverted(parameters, bare)
    return Plan(
        name=model.name,
        source_hash="",
        form="segment",
        scalar="double",
        channel="auto",
        schedule=_line(planner, schedule, Topology.of(model)),
        floating=model.floating,
        gravity=tuple(float(g) + 0.0 for g in model.gravity),
        links=links_of(model, bare),
        joints=planner.joints,
        slaved=tuple(j for j, joint in enumerate(planner.joints) if joint.mimic is not None),
        processes=processes,
        messages=messages,
        wrenches=wrenches_of(model),
        loops=loops_of(model) if loop_forces else with_points(model),
        couplings=couplings_of(model),
        parameters=parameters,
        loop_forces=loop_forces,
        tied_rows=planner.tied_rows(),
        wanted=model.wanted,
        outputs=outputs,
        at_rest=model.at_rest,
    )


def _check_words(form: str, scalar: str, channel: str, meeting: str) -> None:
    """Refuse unknown values of options."""
    for word, known, what in (
        (form, tuple(FORMS), "form"),
        (scalar, SCALARS, "scalar"),
        (channel, CHANNELS, "channel"),
        (meeting, MEETINGS, "meeting"),
    ):
        if word not in known:
            raise UsageError(f'unknown {what} "{word}"; known: {", ".join(known)}')


def _line(planner: AdaPlanner, schedule: Schedule, topology: Topology) -> str:
    """Return a schedule in one line: the paper's tree, or the owners where processes gather."""
    gathered = planner.gathered()
    if gathered is not None:
        return gathered_line(gathered, topology)
    return schedule_line(schedule, topology)


def as_gathered(model: Model, schedule: Schedule) -> Schedule:
    """Return a schedule with the layout of its gathering processes; others unchanged."""
    if schedule.meeting != "gather" or schedule.gathered is not None:
        return schedule
    return replace(schedule, gathered=GatherPlanner(joints_of(model), schedule).gathered())


def can_gather(model: Model) -> bool:
    """Return whether processes may meet by gathering, or exchange pair by pair."""
    return slaved_joint(joints_of(model)) is None


def planner_of(model: Model, schedule: Schedule, form: str, meeting: str = "auto") -> AdaPlanner:
    """Return the planner that builds the processes of a plan.

    Args:
        model: the robot.
        schedule: a schedule of its joints.
        form: one of ``FORMS``.
        meeting: one of ``MEETINGS``.
    """
    if model.closed and form == "ada":
        runs = runs_of(with_artificial_inertia(model))
        return ClosedAdaPlanner(
            with_artificial_rotors(joints_of(model), model),
            schedule,
            runs,
            clusters_of(with_artificial_inertia(model), runs),
            closures_of(model),
            loops_of(model),
            couplings_of(model),
        )
    joints, runs = joints_of(model), runs_of(model)
    if model.closed:
        if schedule.gathered is None:  # its tree stands for nothing where there is
            _check_closed(schedule)
        return ClosedPlanner(
            joints,
            schedule,
            closures_of(model),
            grounded_closures_of(model),
            closures_between_trees(model),
            loops_of(model),
            couplings_of(model),
        )
    clusters = clusters_of(model, runs) if form == "ada" else {}
    if clusters:
        return ClusterPlanner(joints, schedule, runs, clusters)
    how = schedule.meeting if meeting == "auto" else meeting
    if form == "segment" and how == "exchange":
        return ExchangePlanner(joints, schedule, runs)
    if form == "segment" and how == "gather":
        if (reason := slaved_joint(joints)) is not None:
            raise UsageError(f"processes cannot gather: {reason}")
        return GatherPlanner(joints, schedule)
    return FORMS[form](joints, schedule, runs)


def _check_forces(model: Model) -> None:
    """Refuse forces of loops if the robot has none, or mimic joints."""
    if not model.closed:
        raise UsageError("the robot has no loops and couplings: leave --loop-forces out")
    if any(joint.mimic is not None for joint in model.joints):
        raise UsageError(
            "--loop-forces does not support mimic joints: write these as couplings, or leave "
            "--loop-forces out"
        )


def _check_closed(schedule: Schedule) -> None:
    """Refuse schedules that cut robots with closed loops."""
    if len({node.processes[0] for node in postorder(schedule.root)}) > 1:
        raise UsageError("a robot with closed loops is solved by one process: leave --schedule out")
