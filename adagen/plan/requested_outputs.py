"""Requested results of a plan: accelerations of some joints, and outputs beside accelerations.

A plan has the steps of all accelerations. Loops sweep outwards only as far as something is
requested; straight lines contain only numbers that are needed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence, Set

from adagen.errors import UsageError
from adagen.model import INVERSE_INERTIA, LINK_ACCELERATION, REACTION_FORCE, Model
from adagen.plan import steps as do
from adagen.plan.order import ends_of
from adagen.plan.robot import PlanOutput
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Step
from adagen.plan.types import Plan, Process
from adagen.schedule import Schedule, postorder


def refuse_outputs(model: Model, form: str) -> None:
    """Refuse outputs that a robot, or a form of the algorithm, cannot have.

    Raises:
        UsageError: it has some.
    """
    if not model.outputs:
        return
    if form != "segment":
        raise UsageError(f"form {form} computes accelerations only: leave out [outputs] or --form")
    tied = "closed loops" if model.closed else "slaved joints"
    for output in model.outputs:
        if output.what == LINK_ACCELERATION:
            continue
        if model.closed or any(joint.mimic for joint in model.joints):
            raise UsageError(
                f"the {output.what} at '{output.name}' is not computed for robots with {tied}: "
                "leave it out of [outputs]"
            )


def refuse_sharing(outputs: Sequence[PlanOutput], schedule: Schedule) -> None:
    """Refuse outputs on several processes.

    Raises:
        UsageError: more than one process has something to do.
    """
    gathered = schedule.gathered
    joined = (node.processes[0] for node in postorder(schedule.root))
    at_work = set(joined if gathered is None else gathered.owners) - {None}
    if outputs and len(at_work) > 1:
        raise UsageError(
            "[outputs] of a scene are computed by one process: leave out --schedule, or say"
            " --procs 1"
        )


def handles_of(model: Model) -> frozenset[int]:
    """Return the links whose inverse inertia is requested."""
    return frozenset(o.link for o in model.outputs if o.what == INVERSE_INERTIA)


def with_outputs(
    processes: Sequence[Process], outputs: Sequence[PlanOutput]
) -> tuple[Process, ...]:
    """Return the processes with steps for the outputs, on the first one."""
    if not outputs:
        return tuple(processes)
    more = tuple(do.GiveOutput(k) for k in range(len(outputs)))
    first, *others = processes
    return (first.changed(lambda steps: (*steps, *more)), *others)


def needed_outwards(
    plan: Plan, steps: Sequence[Step], limbs: Iterable[Limbs] = ()
) -> frozenset[int]:
    """Return the joints that the outward sweep needs: requested ones and those on their paths.

    Args:
        plan: the plan.
        steps: of one of its processes.
        limbs: those that are passed side by side, all or none of each group.
    """
    groups = [set(each.members()) for each in limbs]
    needed, found = _led_to(plan, steps, set()), frozenset[int]()
    while needed != found:
        found = needed
        more = {j for group in groups if group & needed for j in group}
        needed = _led_to(plan, steps, more)
    return needed


def _led_to(plan: Plan, steps: Sequence[Step], more: Set[int]) -> frozenset[int]:
    """The requested joints, further ones, and those on their paths."""
    every = frozenset(range(len(plan.joints)))
    if not plan.wanted:
        return every
    needed = {j for j in every if plan.wants(j)} | more
    needed |= {o.link - 1 for o in plan.outputs if o.what == REACTION_FORCE}
    links = {o.link for o in plan.outputs if o.what == LINK_ACCELERATION}
    for step in reversed(steps):
        match step:
            case do.Accelerate(j, backwards):
                ends = ends_of(plan.joints, j, backwards)
                if j in needed or ends.far in links:
                    needed.add(j)
                    links.add(ends.near)
            case do.FreeAcceleration(j):
                if j in needed:
                    links.add(j + 1)
            case do.Send(number):
                needed.update(plan.messages[number].joints)
            case do.LoadRoot():
                links.add(step.link)
            case do.ApplyCoupling() | do.Release() | do.AccelerateHeld():
                return every  # what is tied needs all that it is tied to
    return frozenset(needed)
