"""Schedules of reproducible programs: shares of the straight line of one process.

Processes gather at the base or the ground (adagen/plan/serial.py). Limbs there are dealt out to
them, the heaviest first, each to who has least; then the heaviest limb is opened: its joints up to
where it branches become part of the core, which every process computes, and its branches are dealt
out in its place. Each of these layouts is priced as the straight lines that it makes, beside one
process that does everything.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from adagen.cost import timeline
from adagen.emit.predicted import priced_program
from adagen.executor.line import line_of
from adagen.model import Model
from adagen.plan import can_gather, make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.gather_trees import moving_trees
from adagen.plan.serial import serial_plan
from adagen.plan.types import Plan
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.tree import Gathered
from adagen.search.schedules import find_schedule

_OPENED = 6
"""Limbs that are opened one after the other."""


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
    tried = [_played(model, alone, profile, scalar)]
    for gathered in dict.fromkeys(_layouts(plan, processes)):
        found = replace(alone, meeting="gather", gathered=gathered)
        tried.append(_played(model, found, profile, scalar))
    best = min(tried, key=lambda schedule: schedule.makespan)
    # Whoever exchanges anything waits for a message.
    costs = profile.steps
    fastest = max(costs.speed(p) for p in range(processes))
    exchange = costs["unrolled.evaluation"] / fastest + costs.channel("auto").latency
    return replace(
        best,
        lower_bound=min(best.makespan, exchange),
        families=("alone", "gathered"),
        candidates=len(tried),
    )


def _alone(model: Model, processes: int, profile: CostProfile) -> Schedule:
    """The schedule in which one of the processes does everything."""
    seen = fold_of(model, "segment")
    whole = seen.topology if len(seen.topology) else Topology.of(model)
    nowhere = [False] * len(whole)
    found = find_schedule(whole, processes, profile=profile, cuttable=nowhere)
    return seen.unfold(found, profile) if len(seen.topology) else found


def _played(model: Model, schedule: Schedule, profile: CostProfile, scalar: str) -> Schedule:
    """A schedule with the time that its program is predicted to take."""
    plan = make_plan(model, schedule, scalar=scalar, reproducible=True)
    line = timeline(priced_program(plan, "unrolled", profile), profile)
    loads = tuple(line.busy(p) for p in range(len(plan.processes)))
    return replace(schedule, makespan=line.makespan, lower_bound=0.0, loads=loads)


def _layouts(plan: Plan, processes: int) -> Iterator[Gathered]:
    """Yield layouts on as many processes and on two, from the limbs at the base on inwards."""
    below = plan.children
    trees = moving_trees(plan.joints)
    roots = [0 if tree.base is None else tree.base + 1 for tree in trees]
    limbs = [
        j
        for tree, root in zip(trees, roots, strict=True)
        for j in tree.joints
        if plan.joints[j].parent == root
    ]
    weights = _weights(plan)
    members = {j: _beyond(below, j) for j in range(len(plan.joints))}
    weight = {j: sum(weights[i] for i in own) for j, own in members.items()}
    for _ in range(_OPENED if limbs else 0):
        for count in dict.fromkeys((2, min(processes, len(limbs)))):
            if 2 <= count <= min(processes, len(limbs)):
                shares = _dealt(limbs, weight, count)
                owners: list[int | None] = [None] * len(plan.joints)
                for p, share in enumerate(shares):
                    for j in share:
                        for i in members[j]:
                            owners[i] = p
                yield Gathered(tuple(roots), tuple(owners))
        heavy = max(limbs, key=lambda j: weight[j])
        end = heavy
        while len(below[end + 1]) == 1:
            end = below[end + 1][0]
        if not below[end + 1]:
            return  # nothing branches there
        limbs = [*(j for j in limbs if j != heavy), *below[end + 1]]


def _dealt(limbs: Sequence[int], weight: dict[int, float], count: int) -> list[list[int]]:
    """Limbs dealt out: the heaviest first, each to who has least."""
    shares: list[list[int]] = [[] for _ in range(count)]
    loads = [0.0] * count
    for j in sorted(limbs, key=lambda j: (-weight[j], j)):
        p = min(range(count), key=lambda p: (loads[p], p))
        shares[p].append(j)
        loads[p] += weight[j]
    return shares


def _beyond(below: Sequence[Sequence[int]], j: int) -> list[int]:
    """A joint and all beyond it."""
    found = [j]
    for i in found:
        found += below[i + 1]
    return found


def _weights(plan: Plan) -> list[float]:
    """Numbers that the line of one process computes for each joint."""
    line = line_of(serial_plan(plan))
    (process,) = line.plan.processes
    found = [0.0] * len(plan.joints)
    rows = line.machine.rows
    for node in line.nodes:
        step = process.steps[node.mark]
        joint = getattr(step, "joint", getattr(step, "link", 1) - 1)
        own = rows.own(joint)
        for j in own:
            found[j] += node.width / len(own)
    return found
