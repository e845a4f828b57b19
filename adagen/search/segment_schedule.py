"""Schedules for form `segment` under measured costs, with their proven bounds."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

import numpy as np
from numpy.typing import NDArray

from adagen.paper.budget import Budget, OutOfBudget
from adagen.schedule.chains import WHOLE
from adagen.schedule.profile import TICKS, CostProfile
from adagen.schedule.search_result import Found
from adagen.schedule.segment_costs import SegmentCosts
from adagen.schedule.sweeps import Sweeps
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Schedule, Tie
from adagen.schedule.tree_prices import segment_time
from adagen.search.segment_bounds import SegmentBounds
from adagen.search.segment_pareto import Label, State, draft_of
from adagen.search.segment_search import SegmentSearch

_BEAMS = ((1, 1), (4, 1), (16, 1), (4, 2), (8, 4))
"""Of each first guess: options followed at each state, and how unequal divisions may be."""


def segment_bound(topology: Topology, profile: CostProfile, processes: int) -> float:
    """Return a lower bound that needs no search on the time of any schedule, microseconds."""
    costs = SegmentCosts(topology, profile)
    everywhere = np.ones(len(topology), dtype=np.bool_)
    bounds = SegmentBounds(costs, everywhere, costs.costs.speeds(processes))
    return bounds.least(WHOLE, processes) / TICKS


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
    found = find_segments(costs, processes, at, expansions, deadline)
    return found.schedule(topology, processes, profile, tie)


def find_segments(
    costs: SegmentCosts,
    processes: int,
    cuttable: NDArray[np.bool_],
    expansions: int,
    deadline: float | None,
) -> Found:
    """Return the best schedule found and what is proven.

    Args:
        costs: prices of the robot's chains and cuts.
        processes: P.
        cuttable: per position, whether two processes may meet there.
        expansions: states that may be expanded in all.
        deadline: on the monotonic clock; None for none.
    """
    speeds = costs.costs.speeds(processes)
    bounds = SegmentBounds(costs, cuttable, speeds)
    search = SegmentSearch(costs, bounds, speeds, Budget(expansions, deadline))
    alone = Sweeps(*segment_time(costs, WHOLE, 0, speeds[0]), 0)
    best = Label(alone, State(WHOLE, 0, processes))
    spent = 0
    for width, uneven in _BEAMS:
        budget = Budget(max(64, expansions // 4), deadline)
        beam = SegmentSearch(costs, bounds, speeds, budget, width, uneven)
        with suppress(OutOfBudget):
            beam.solve(best.time.total)
        spent += beam.budget.expanded
        best = beam.best or best
        if 2 * spent > expansions:
            break
    search.tighten(best.time.total)
    draft = draft_of(search.best or best, costs.chains)
    lower = search.lower
    if processes > 2 and min(speeds) < max(speeds):
        # On three or more cores of unequal speed the search has missed a schedule (0.2 % faster,
        # tests/search/test_segments.py): what is proven is the bound that needs no search.
        lower = min(lower, bounds.least(WHOLE, processes))
    return Found(draft, lower, spent + search.budget.expanded)
