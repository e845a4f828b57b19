"""The schedule that the tool takes by itself: searched by what suits the form."""

from __future__ import annotations

from itertools import chain
from typing import Any

from adagen.model import Model
from adagen.plan import can_gather, make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.constants import joints_of
from adagen.plan.cuts import cuttable_joints
from adagen.plan.gather import GatherPlanner
from adagen.predict.limbs import gathering, limb_schedules
from adagen.predict.simulate import predict
from adagen.schedule import CostProfile, Schedule, Topology, find_schedule


def best_schedule(
    model: Model,
    processes: int,
    profile: CostProfile,
    form: str = "segment",
    scalar: str = "double",
    limit: float | None = None,
    gather: bool = True,
    **search: Any,
) -> Schedule:
    """Return a schedule for a form of the algorithm.

    Form `ada` is searched by Eq. (11), form `segment` by the costs of steps where the profile has
    them, at joints alone where cuts lose no digits.

    Args:
        model: the robot.
        processes: P.
        profile: the costs.
        form: of the algorithm.
        scalar: "double", "float" or "mixed".
        limit: largest growth g at a cut of form `segment`, instead of what suits the scalar.
        gather: whether processes may gather at a core instead of being joined.
        search: further arguments of ``find_schedule``.

    Raises:
        InputError: the robot has no joint, or costs are too large.
        UsageError: an argument is out of range.
    """
    topology = Topology.of(model)
    if form == "ada":
        profile = profile.joins_only()
    if form == "segment" and processes == 1:
        return find_schedule(topology, 1, profile=profile, **search)
    seen = fold_of(model, form)
    if not len(seen.topology):  # all one cluster
        search["cuttable"] = [False] * len(topology)
        return find_schedule(topology, processes, profile=profile, **search)
    if form == "ada":
        found = find_schedule(seen.topology, processes, profile=profile, **search)
        return seen.unfold(found, profile)
    cuttable = cuttable_joints(model, scalar, seen.joints, limit)
    found = find_schedule(seen.topology, processes, profile=profile, cuttable=cuttable, **search)
    best = seen.unfold(found, profile)
    if profile.steps is None:
        return best
    if gather and can_gather(model):
        best = _or_gathered(model, best, profile, scalar)
    never = [False] * len(seen.topology)
    alone = find_schedule(seen.topology, processes, profile=profile, cuttable=never, **search)
    return _or_alone(model, best, seen.unfold(alone, profile), profile)


PREDICTIONS_ERR = 0.1
"""By what share predicted times of one process and of several may err beside each other."""


def _or_alone(model: Model, best: Schedule, alone: Schedule, profile: CostProfile) -> Schedule:
    """Return a schedule, or that of one process which leaves the others idle if it is faster.

    The search does not know what lanes and columns save a process that has long runs and many
    limbs. Processes that are asked for are used where predictions cannot tell.
    """
    if best.root == alone.root and best.meeting == alone.meeting:
        return best
    times = [predict(make_plan(model, each), profile).makespan for each in (best, alone)]
    return alone if times[1] < (1 - PREDICTIONS_ERR) * times[0] else best


def _or_gathered(model: Model, found: Schedule, profile: CostProfile, scalar: str) -> Schedule:
    """Return a schedule, or one whose processes gather if that is faster when played through."""
    best, least = found, predict(make_plan(model, found), profile).makespan
    cuttable = cuttable_joints(model, scalar)
    candidates = limb_schedules(model, found.processes, profile, found, cuttable)
    if GatherPlanner(joints_of(model), found).suits():
        candidates = chain(gathering(model, [found], profile), candidates)
    for schedule in candidates:
        if schedule.makespan < least:
            best, least = schedule, schedule.makespan
    return best
