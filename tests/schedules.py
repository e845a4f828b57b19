"""Schedules for tests: any assembly order, any split of the processes, optimal or not."""

from __future__ import annotations

import numpy as np

from adagen.model import Model
from adagen.schedule import Node, Schedule, Topology, validate


def random_schedule(model: Model, processes: int, rng: np.random.Generator) -> Schedule:
    """Return a random schedule tree with random splits of the processes."""

    def build(joints: frozenset[int], first: int, last: int) -> Node | None:
        if not joints:
            return None
        cut = int(rng.choice(sorted(joints)))
        end = {cut}
        for j in sorted(joints):
            if j > cut and model.joints[j].parent - 1 in end:
                end.add(j)
        end.discard(cut)
        root = joints - end - {cut}
        if root and end and last - first > 1:
            middle = int(rng.integers(first + 1, last))
            sides = build(root, first, middle), build(frozenset(end), middle, last)
        else:
            sides = build(root, first, last), build(frozenset(end), first, last)
        links = {link for j in joints for link in (model.joints[j].parent, j + 1)}
        boundary = sum(
            j not in joints and bool({joint.parent, j + 1} & links)
            for j, joint in enumerate(model.joints)
        )
        return Node(cut, (first, last), *sides, cost=0.0, boundary=boundary)

    root = build(frozenset(range(len(model.joints))), 0, processes)
    assert root is not None
    return wrapped(root, model, processes)


def wrapped(root: Node, model: Model, processes: int) -> Schedule:
    """Return a schedule around a tree, its predictions left blank."""
    schedule = Schedule(
        root=root,
        processes=processes,
        makespan=0.0,
        lower_bound=0.0,
        profile="paper",
        tie="work",
        tie_proven=False,
        strategy="file",
        split="free",
        expanded=0,
        loads=(0.0,) * processes,
    )
    validate(schedule, Topology.of(model))
    return schedule
