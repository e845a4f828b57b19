"""Schedules whose processes gather at a small core.

The most promising layouts (layouts.py) are played through, which tells what their weights do not:
what lies side by side. It is gone on with as long as that brings faster ones.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from adagen.emit.shapes import SHAPES
from adagen.model import Model
from adagen.plan import make_plan
from adagen.predict.layouts import Layout, Layouts
from adagen.predict.simulate import predict
from adagen.schedule import CostProfile, Schedule

PATIENCE = 18
"""Layouts that are played through after one that was the fastest."""


def limb_schedules(
    model: Model,
    processes: int,
    profile: CostProfile,
    pattern: Schedule,
    cuttable: Sequence[bool],
) -> Iterator[Schedule]:
    """Return schedules that gather, each with the time that it takes when it is played through.

    Args:
        model: a robot on one joint on the ground, floating or not, which may be rooted anywhere; or
            one on several, where the root is the ground itself.
        processes: P, 2 or more.
        profile: a profile with costs of steps.
        pattern: a schedule whose facts (tie, split and so on) they take over.
        cuttable: for each joint whether mobilities may meet there without losing digits. Only a
            root with the ground beyond it shows a mobility; elsewhere inertias are added.
    """
    used = processes
    while used > 1:  # half of them may be faster than all
        search = Layouts(model, used, profile)
        roots = [0, *(j + 1 for j in range(len(model.joints)) if search.floats or cuttable[j])]
        promising = sorted(search.layouts(roots), key=lambda layout: layout.time)
        schedules = (search.schedule(layout, pattern) for layout in _unlike(search, promising))
        yield from _while_faster(gathering(model, schedules, profile))
        used = (used + 1) // 2


def _while_faster(schedules: Iterable[Schedule]) -> Iterator[Schedule]:
    """Yield schedules as long as faster ones turn up."""
    least, waited = math.inf, 0
    for schedule in schedules:
        yield schedule
        waited = 0 if schedule.makespan < least else waited + 1
        least = min(least, schedule.makespan)
        if waited == PATIENCE:
            return


def _unlike(search: Layouts, layouts: Iterable[Layout]) -> Iterator[Layout]:
    """Yield the layouts in which processes own other joints than in those before."""
    seen: set[tuple[int | None, ...]] = set()
    for layout in layouts:
        owners = search.owners(layout)
        if owners not in seen:
            seen.add(owners)
            yield layout


def gathering(
    model: Model, schedules: Iterable[Schedule], profile: CostProfile
) -> Iterator[Schedule]:
    """Yield schedules as ones whose processes gather, timed by playing them through.

    What is proven of them: nothing is faster than all work shared out evenly.
    """
    evenly: dict[int, float] = {}
    for schedule in schedules:
        gathered = replace(schedule, meeting="gather")
        plan = make_plan(model, gathered)
        if SHAPES["kernels"].why_not(plan) is not None:  # no other shape gathers
            continue
        time = predict(plan, profile).makespan
        if schedule.processes not in evenly:
            evenly[schedule.processes] = Layouts(model, schedule.processes, profile).evenly()
        lower = min(time, evenly[schedule.processes])
        yield replace(gathered, makespan=time, lower_bound=lower)
