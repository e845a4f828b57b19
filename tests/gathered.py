"""Schedules of processes that gather at the base or the ground, distributed at random."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.constants import joints_of
from adagen.plan.gather_trees import moving_trees
from adagen.schedule import Topology, load_profile
from adagen.schedule.tree import Gathered
from adagen.search import find_schedule


def reproducible_plan(model: Model, gathered: Gathered | None = None, **options: str) -> Plan:
    """Return a reproducible plan of a robot, of one process if nothing is said.

    Args:
        model: the robot.
        gathered: where processes gather, as ``distributed`` returns it.
        options: of ``make_plan``.
    """
    scalar = options.get("scalar", "double")
    channel = options.get("channel", "auto")
    topology, profile = Topology.of(model), load_profile("default")
    owners = () if gathered is None else [p for p in gathered.owners if p is not None]
    processes = 1 + max(owners, default=0)
    nowhere = [False] * len(topology)
    schedule = find_schedule(topology, processes, profile=profile, cuttable=nowhere)
    if gathered is not None:
        schedule = replace(schedule, meeting="gather", gathered=gathered)
    how = {"scalar": scalar, "channel": channel, "runtime": options.get("runtime", "")}
    return make_plan(model, schedule, reproducible=True, **how)  # type: ignore[arg-type]


def distributed(
    model: Model, processes: int, rng: np.random.Generator, core: float = 0.3
) -> Gathered:
    """Return limbs distributed to processes that gather at the base or the ground.

    Args:
        model: the robot.
        processes: P; each gets something where there are as many limbs.
        rng: who gets what.
        core: how many of the joints that branch are left to all.
    """
    joints = joints_of(model)
    trees = moving_trees(joints)
    roots = [0 if tree.base is None else tree.base + 1 for tree in trees]
    below: list[list[int]] = [[] for _ in range(len(joints) + 1)]
    for j, joint in enumerate(joints):
        below[joint.parent].append(j)
    owners: list[int | None] = [None] * len(joints)
    bases = {tree.base for tree in trees}

    def limbs(j: int) -> Iterator[int]:
        if j in bases or (below[j + 1] and rng.random() < core):
            for k in below[j + 1]:
                yield from limbs(k)
        else:
            yield j

    def give(j: int, p: int) -> None:
        owners[j] = p
        for k in below[j + 1]:
            give(k, p)

    found = [limb for j in below[0] for limb in limbs(j)]
    for n, k in enumerate(rng.permutation(len(found))):
        give(found[k], n % processes)
    return Gathered(tuple(roots), tuple(owners))
