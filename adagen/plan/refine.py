"""Messages for iterative refinement (the refinement itself: adagen/executor/refine.py).

Each link's residual is computed by the process that brought the link into its chain. It needs the
accelerations of all joints on the path to the ground, and the forces of all joints at the link.
Those of other processes come in one message from each of them before each residual.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

from adagen.errors import UsageError
from adagen.plan import steps as do
from adagen.plan.messages import ENERGIES, Message
from adagen.plan.steps import Step
from adagen.plan.types import Plan, Process


@dataclass(frozen=True)
class Exchange:
    """The message between two processes about the last refinement step.

    Attributes:
        source: sending process.
        target: receiving process.
        accelerations: joints whose accelerations are in it.
        forces: joints whose forces are in it, 6 numbers each.
    """

    source: int
    target: int
    accelerations: tuple[int, ...]
    forces: tuple[int, ...]


def links_of_process(process: Process) -> tuple[int, ...]:
    """Return the links whose residual a process computes, ascending."""
    steps = process.steps_of(do.LinkBias, do.StartLink)
    return tuple(sorted(step.link for step in steps))


def handed_on(process: Process) -> tuple[tuple[int, int], ...]:
    """Return each joint with a massless far link in a fused run, and the next joint.

    Such a link hands on what it gets, so that the outer joint's force tells the inner one's.
    Outer joints come first.
    """
    runs = (step.run for step in process.steps_of(do.FusedJoin))
    return tuple(pair for run in runs for pair in reversed(list(pairwise(run))))


def joints_around(plan: Plan, process: Process) -> tuple[int, ...]:
    """Return the joints at these links and in their runs, ascending; some belong to others."""
    links = set(links_of_process(process))
    at = {j for j, joint in enumerate(plan.joints) if joint.parent in links or j + 1 in links}
    return tuple(sorted(at.union(*handed_on(process))))


def paths_of(plan: Plan, process: Process) -> tuple[int, ...]:
    """Return the joints between these links and the ground, ascending."""
    return tuple(sorted(plan.paths(link - 1 for link in links_of_process(process))))


def corrected(plan: Plan, count: int) -> Plan:
    """Return a plan whose processes correct each answer by residuals in the solver's own precision.

    Where processes share a closure, none knows all that moves its rows: each has it all by itself.
    """
    if plan.closed:
        shared = any(message.sides for message in plan.messages)
        return _corrected_lines(plan.held_back() if shared else plan, count)
    processes = tuple(
        replace(process, steps=(*process.steps, do.Refine(count))) if process.steps else process
        for process in plan.processes
    )
    return replace(plan, processes=processes)


def _corrected_lines(plan: Plan, count: int) -> Plan:
    """The plan with its steps repeated for each correction, and their messages."""
    once = plan.messages
    messages = list(once)
    for _ in range(count):
        messages += [replace(message, repeats=n) for n, message in enumerate(once)]
    others = [p for p, process in enumerate(plan.processes) if p and process.steps]
    first = len(messages)
    messages += [Message(p, 0, ENERGIES, None) for p in others]
    messages += [Message(0, p, ENERGIES, None) for p in others]
    ends: dict[int, tuple[Step, ...]] = {0: ()}
    for k, p in enumerate(others):
        ends[0] += (do.Receive(first + k),)
        ends[p] = (do.Send(first + k), do.Receive(first + len(others) + k))
    ends[0] += tuple(do.Send(first + len(others) + k) for k in range(len(others)))
    processes = tuple(
        replace(
            process,
            steps=_again(process.steps, count, len(once), ends.get(p, ())),
            recovery=_again(process.recovery, count, 0, ()),
            others=tuple(_again(steps, count, 0, ()) for steps in process.others),
        )
        for p, process in enumerate(plan.processes)
    )
    return replace(plan, processes=processes, messages=tuple(messages))


def _again(
    steps: tuple[Step, ...], count: int, messages: int, ends: tuple[Step, ...]
) -> tuple[Step, ...]:
    """Steps, and their repetitions for each correction.

    Args:
        steps: of a process; none where it has nothing to do.
        count: of corrections.
        messages: how many there are in an answer.
        ends: what tells how large corrections are.
    """
    if not steps:
        return ()
    found: list[Step] = list(steps)
    for k in range(count):
        first = 0
        for place, step in enumerate(steps):
            if isinstance(step, do.Send | do.Receive):
                found += [do.Correct(k, first, place)] if first < place or not first else []
                found.append(replace(step, message=step.message + (k + 1) * messages))
                first = place + 1
        found += [do.Correct(k, first, len(steps))] if first < len(steps) else []
    return (*found, do.Refine(count), *ends)


def why_not_in_lines(plan: Plan) -> str | None:
    """Return why a robot with closed loops cannot be corrected, None where it can."""
    if plan.slaved:
        return (
            f'joint "{plan.joints[plan.slaved[0]].name}" is slaved to another: that is not refined'
        )
    if plan.wanted or plan.outputs:
        return "the scene requests other results than all accelerations: that is not refined"
    if plan.form == "ada" and plan.several:
        return "closed loops are refined in form ada on one process alone"
    if plan.lent:
        name = plan.joints[plan.lent[0][0]].name
        return f'only loops resist the motion of joint "{name}": that is not refined'
    for joint in plan.joints if plan.form == "ada" else ():
        if joint.prescribed or joint.rotor_inertia:
            return (
                f'joint "{joint.name}" has a rotor or a prescribed motion: that is not refined in '
                "form ada"
            )
    return None


def refinable(plan: Plan) -> Plan:
    """Return the plan with the joints that refinement reads added to its processes.

    Raises:
        UsageError: it has torques, inertias or motions at joints that residuals do not know of.
    """
    for joint in plan.joints:
        passive = (joint.damping, joint.friction, joint.stiffness, joint.rotor_inertia)
        if any(passive) or joint.prescribed:
            raise UsageError(
                f'joint "{joint.name}" has damping, friction, a spring, a rotor or a prescribed'
                " motion: that cannot be refined; leave --refine out"
            )
    if plan.slaved and any(map(handed_on, plan.processes)):
        raise UsageError(
            "joints fused over massless links cannot be refined beside slaved joints; use form"
            " segment or leave --refine out"
        )
    if plan.wanted or plan.outputs:
        raise UsageError(
            "refinement needs all accelerations: leave out --refine, or accelerations and"
            " [outputs] of the scene"
        )
    if plan.wrenches:
        raise UsageError("outer forces cannot be refined; leave --refine out")
    processes = tuple(
        replace(process, reads=tuple(sorted({*process.reads, *joints_around(plan, process)})))
        for process in plan.processes
    )
    return replace(plan, processes=processes)


def exchanges(plan: Plan) -> tuple[Exchange, ...]:
    """Return the messages of a refinement step, in the order of sources and targets."""
    found = []
    for p, source in enumerate(plan.processes):
        for t, target in enumerate(plan.processes):
            accelerations = tuple(sorted(set(moving(plan, target)).intersection(source.owns)))
            forces = tuple(sorted(set(joints_around(plan, target)).intersection(source.owns)))
            if p != t and (accelerations or forces):
                found.append(Exchange(p, t, accelerations, forces))
    return tuple(found)


def moving(plan: Plan, process: Process) -> tuple[int, ...]:
    """Return the joints whose accelerations a process sums up, ascending.

    They are those on its paths and its own, or the sources of these where they are slaved.
    """
    joints = {*paths_of(plan, process), *process.owns}
    return tuple(sorted(set(map(plan.source_of, joints))))
