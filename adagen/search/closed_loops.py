"""Schedules of robots with closed loops: owners of limbs and closures.

Each closure belongs to one process (adagen/plan/closed_segment.py). Limbs around the base, or
around the middle of a long path, are distributed. Each of these layouts is priced as its straight
lines, and compared with one process that computes everything.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from adagen.executor import simulate
from adagen.model import Model
from adagen.plan import can_gather, make_plan
from adagen.plan.closures import Closure, closures_of
from adagen.plan.gather_trees import Tree, moving_trees
from adagen.plan.grounded_closures import grounded_closures_of
from adagen.plan.separate_trees import closures_between_trees
from adagen.plan.types import Plan
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.tree import Gathered
from adagen.search.schedules import find_schedule
from adagen.search.straight_layouts import cheapest_of, joint_weights, layouts_at, whole_trees

_SHARES = (0.46, 0.38, 0.31)
"""Parts of a tree's arithmetic that may be beyond its root, where that is in the middle."""


def closed_schedule(
    model: Model, processes: int, profile: CostProfile, scalar: str = "double", **search: Any
) -> Schedule:
    """Return the layout of least time of a robot with closed loops.

    Args:
        model: the robot.
        processes: P.
        profile: the costs; where it prices joins alone, one process does everything.
        scalar: "double" or "float".
        search: further arguments of ``find_schedule``.

    Raises:
        InputError: the loops are refused.
        UsageError: P is out of range.
    """
    topology = Topology.of(model)
    search["cuttable"] = [False] * len(topology)
    alone = find_schedule(topology, processes, profile=profile.joins_only(), **search)
    if processes == 1 or profile.steps is None or not can_gather(model):
        return alone
    plan = make_plan(model, alone, scalar=scalar)
    layouts, weights = _layouts(model, plan, processes)
    return cheapest_of(
        alone, layouts, weights, profile, lambda schedule: make_plan(model, schedule, scalar=scalar)
    )


def _layouts(
    model: Model, plan: Plan, processes: int
) -> tuple[Iterator[Gathered], Sequence[float]]:
    """Return layouts around bases, and around the middle of the heaviest tree; joints' weights."""
    (simulated, *_) = simulate(plan)
    weights = joint_weights(plan.processes[0], simulated.machine)
    return _around_roots(model, plan, processes, weights), weights


def _around_roots(
    model: Model, plan: Plan, processes: int, weights: Sequence[float]
) -> Iterator[Gathered]:
    closures = grounded_closures_of(model) or closures_between_trees(model) or closures_of(model)
    trees = moving_trees(plan.joints)
    if any(closure.apart for closure in closures):
        yield from whole_trees(plan.joints, trees, weights, processes)
        return
    together = [closure.path for closure in closures]
    roots = [tree.own_root for tree in trees]
    heavy = max(range(len(trees)), key=lambda k: (sum(weights[j] for j in trees[k].joints), -k))
    for link in dict.fromkeys((roots[heavy], *_middles(plan, trees[heavy], weights, closures))):
        around = [*roots[:heavy], link, *roots[heavy + 1 :]]
        yield from layouts_at(plan.joints, around, weights, processes, together)


def _middles(
    plan: Plan, tree: Tree, weights: Sequence[float], closures: Sequence[Closure]
) -> Iterator[int]:
    """Yield links on both sides of which there is about as much to be done.

    Who has what is beyond takes kinematics of the way there, too, so that it has fewer joints.
    """
    beyond = dict.fromkeys((0, *tree.links), 0.0)
    for j in sorted({*tree.joints, *([] if tree.base is None else [tree.base])}, reverse=True):
        beyond[j + 1] += weights[j]
        beyond[plan.joints[j].parent] += beyond[j + 1]
    inside = {j + 1 for closure in closures for j in closure.path}
    links = [link for link in tree.links if link not in inside]
    for share in _SHARES if links else ():
        yield min(links, key=lambda link: (abs(beyond[link] - share * beyond[0]), link))
