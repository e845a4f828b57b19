"""Schedules for form `segment` under measured costs, with what is proven about them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from adagen.schedule.budget import Budget, OutOfBudget
from adagen.schedule.chains import WHOLE
from adagen.schedule.draft import Draft
from adagen.schedule.profile import TICKS, CostProfile
from adagen.schedule.segment_search import FOREVER, SegmentSearch
from adagen.schedule.segments import SegmentCosts
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Schedule, Tie, loads_of, makespan_of


def segment_bound(topology: Topology, profile: CostProfile, processes: int) -> float:
    """Return a lower bound that needs no search on the time of any schedule, microseconds."""
    costs = SegmentCosts(topology, profile)
    everywhere = np.ones(len(topology), dtype=np.bool_)
    bounds = [SegmentSearch(costs, everywhere, Budget(0)).rough(WHOLE, p) for p in (1, processes)]
    return min(bounds) / TICKS


def segment_schedule(
    topology: Topology,
    processes: int,
    profile: CostProfile,
    tie: Tie,
    cuttable: Sequence[bool] | None,
    *,
    expansions: int,
    deadline: float | None,
) -> Schedule:
    """Return a schedule for form `segment` under measured costs; see ``find_schedule``.

    Ranges of up to four processes are divided in any way, larger ones in halves; a chain may leave
    processes idle where they do not pay.

    Raises:
        InputError: the robot has no joint, or costs are too large.
    """
    costs = SegmentCosts(topology, profile)
    allowed = [True] * len(topology) if cuttable is None else list(cuttable)
    at = np.array([allowed[j] for j in costs.chains.original], dtype=np.bool_)
    draft, lower, expanded = find_segments(costs, processes, at, expansions, deadline)
    root = draft.finish(topology, profile)
    makespan = makespan_of(root)
    proven = min(lower / TICKS, makespan)
    return Schedule(
        root=root,
        processes=processes,
        makespan=makespan,
        verdict="optimal" if proven >= makespan else "gap",
        gap=makespan / proven - 1.0,
        lower_bound=proven,
        profile=profile.name,
        tie=tie,
        tie_proven=False,
        strategy="exact",
        split="always",
        expanded=expanded,
        loads=loads_of(root, processes),
    )


def find_segments(
    costs: SegmentCosts,
    processes: int,
    cuttable: NDArray[np.bool_],
    expansions: int,
    deadline: float | None,
) -> tuple[Draft, int, int]:
    """Return the best schedule found, a proven lower bound in ticks and the states expanded.

    Args:
        costs: prices of the robot's chains and cuts.
        processes: P.
        cuttable: per position, whether two processes may meet there.
        expansions: states that may be expanded in all.
        deadline: on the monotonic clock; None for none.
    """
    best, draft, spent = FOREVER, None, 0
    for width in (1, 4, 16):
        beam = SegmentSearch(costs, cuttable, Budget(1 << 40, deadline), width)
        try:
            time = beam.time(WHOLE, processes)
        except OutOfBudget:
            break
        spent += beam.budget.expanded
        if time < best:
            best, draft = time, beam.draft(processes)
        if spent > expansions:
            break
    search = SegmentSearch(costs, cuttable, Budget(expansions, deadline))
    if draft is None:  # no time at all: one process
        best, draft = search.costs.price(WHOLE).total, search.draft(processes)
    optimum = search.tighten(processes, best)
    if optimum is not None and optimum < best:
        draft = search.draft(processes)
    return draft, search.lower, spent + search.budget.expanded
