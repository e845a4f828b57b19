"""Schedules of processes that gather at the base or the ground, where limbs are distributed.

Two kinds of programs need that: reproducible ones, which share the straight line of one process
(adagen/plan/shared_line.py), and certified ones, whose bounds are swept towards the base
(adagen/plan/certificate.py). Each layout (straight_layouts.py) is priced as what it makes is
emitted, beside one process that does everything.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain

from adagen.executor.line import line_of
from adagen.model import Model
from adagen.plan import can_gather, make_plan
from adagen.plan.certificate import certified
from adagen.plan.closures import closures_of
from adagen.plan.clusters import fold_of
from adagen.plan.gather import trees_of
from adagen.plan.gather_trees import moving_trees
from adagen.plan.grounded_closures import grounded_closures_of
from adagen.plan.robot import PlanJoint
from adagen.plan.shared_line import serial_plan
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.tree import Gathered
from adagen.search.best import in_parts_alone
from adagen.search.schedules import find_schedule
from adagen.search.straight_layouts import cheapest_of, joint_weights, layouts_at


def reproducible_schedule(
    model: Model, processes: int, profile: CostProfile, scalar: str = "double"
) -> Schedule:
    """Return the layout of least time among those whose answers are those of one process.

    Args:
        model: the robot.
        processes: P.
        profile: the costs; where it prices joins alone, one process does everything.
        scalar: "double" or "float".

    Raises:
        InputError: the robot has no joint.
        UsageError: P is out of range.
    """
    alone = alone_schedule(model, processes, profile)
    if not _may_share(model, processes, profile):
        return alone
    layouts, weights = _layouts(model, alone, scalar)
    return cheapest_of(
        alone,
        layouts,
        weights,
        profile,
        lambda schedule: make_plan(model, schedule, scalar=scalar, reproducible=True),
    )


def certified_schedule(
    model: Model,
    processes: int,
    profile: CostProfile,
    scalar: str,
    shape: str,
    plain: Schedule | None = None,
    *,
    in_parts: bool = False,
) -> Schedule:
    """Return the layout of least time among those whose processes bound errors together.

    Args:
        model: the robot.
        processes: P.
        profile: the costs; where it prices joins alone, one process does everything.
        scalar: "double" or "float".
        shape: of the code, "auto" for that of least price.
        plain: the best schedule of processes that bound no errors and sweep nothing in parts:
            where they gather is tried, too, and bounds of errors take time besides.
        in_parts: whether a long chain of one process may be in parts, one in each SIMD lane.

    Raises:
        InputError: the robot has no joint.
        UsageError: P is out of range, or the robot cannot be certified at all.
    """
    alone = alone_schedule(model, processes, profile)
    plan = certified(make_plan(model, alone, scalar=scalar))  # or it is refused for all layouts
    if plan.closed or not _may_share(model, processes, profile):
        return alone
    layouts, weights = certified_layouts(model, plan.joints, alone, scalar)
    if in_parts:
        alone = in_parts_alone(model, alone, profile, scalar, shape)
    if plain is not None and plain.gathered is not None:
        # Each process passes the joints that it hangs on: certificates look at their motions.
        elsewhere = replace(plain.gathered, told=False)
        layouts = chain(layouts, [_led(plan.joints, elsewhere)])
    return cheapest_of(
        alone,
        layouts,
        weights,
        profile,
        lambda schedule: certified(make_plan(model, schedule, scalar=scalar)),
        shape,
        lower=0.0 if plain is None else plain.lower_bound,
    )


def certified_layouts(
    model: Model, joints: Sequence[PlanJoint], alone: Schedule, scalar: str = "double"
) -> tuple[Iterator[Gathered], Sequence[float]]:
    """Return layouts in which process 0 adds up the links that processes share.

    Args:
        model: the robot.
        joints: its plan's.
        alone: the schedule in which one process does everything.
        scalar: "double" or "float".

    Returns:
        The layouts, and the weights of joints by which they are shared out.
    """
    layouts, weights = _layouts(model, alone, scalar)
    return (_led(joints, gathered) for gathered in layouts), weights


def alone_schedule(model: Model, processes: int, profile: CostProfile) -> Schedule:
    """Return the schedule in which one of the processes does everything."""
    seen = fold_of(model, "segment")
    whole = seen.topology if len(seen.topology) else Topology.of(model)
    nowhere = [False] * len(whole)
    found = find_schedule(whole, processes, profile=profile, cuttable=nowhere)
    return seen.unfold(found, profile) if len(seen.topology) else found


def _may_share(model: Model, processes: int, profile: CostProfile) -> bool:
    return processes > 1 and profile.steps is not None and can_gather(model)


def _layouts(
    model: Model, alone: Schedule, scalar: str
) -> tuple[Iterator[Gathered], Sequence[float]]:
    """Return how limbs of the base may be distributed among the processes, and joints' weights."""
    plan = make_plan(model, alone, scalar=scalar, reproducible=True)
    trees = moving_trees(plan.joints)
    roots = [tree.own_root for tree in trees]
    line = line_of(serial_plan(plan))
    weights = joint_weights(line.plan.processes[0], line.machine)
    closures = (grounded_closures_of(model) or closures_of(model)) if model.closed else ()
    together = [closure.path for closure in closures]
    return layouts_at(plan.joints, roots, weights, alone.processes, together), weights


def _led(joints: Sequence[PlanJoint], gathered: Gathered) -> Gathered:
    """The same layout with process 0 where the links that processes share are added up."""
    shared = [tree for tree in trees_of(joints, gathered) if len(tree.participants) > 1]
    if not shared:
        return gathered
    tree = shared[0]
    first = tree.core_owner if tree.grounded is None else tree.grounded
    other = {first: 0, 0: first}
    owners = (None if p is None else other.get(p, p) for p in gathered.owners)
    return replace(gathered, owners=tuple(owners))
