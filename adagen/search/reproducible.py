"""Schedules of reproducible programs: shares of the straight line of one process.

Processes gather at the base or the ground (adagen/plan/serial.py), where limbs are distributed to
them (adagen/search/distribution.py). Each of these layouts is priced as the straight lines that
it makes, beside one process that does everything.
"""

from __future__ import annotations

from adagen.executor.line import line_of
from adagen.model import Model
from adagen.plan import can_gather, make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.gather_trees import moving_trees
from adagen.plan.serial import serial_plan
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.search.distribution import cheapest_of, joint_weights, layouts_at
from adagen.search.schedules import find_schedule


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
    alone = _alone(model, processes, profile)
    if processes == 1 or profile.steps is None or not can_gather(model):
        return alone
    plan = make_plan(model, alone, scalar=scalar, reproducible=True)
    trees = moving_trees(plan.joints)
    roots = [0 if tree.base is None else tree.base + 1 for tree in trees]
    line = line_of(serial_plan(plan))
    weights = joint_weights(line.plan.processes[0], line.machine)
    layouts = layouts_at(plan.joints, roots, weights, processes)
    return cheapest_of(model, alone, layouts, profile, scalar=scalar, reproducible=True)


def _alone(model: Model, processes: int, profile: CostProfile) -> Schedule:
    """The schedule in which one of the processes does everything."""
    seen = fold_of(model, "segment")
    whole = seen.topology if len(seen.topology) else Topology.of(model)
    nowhere = [False] * len(whole)
    found = find_schedule(whole, processes, profile=profile, cuttable=nowhere)
    return seen.unfold(found, profile) if len(seen.topology) else found
