"""A schedule from a topology and a cost profile, by the search that suits the profile."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

import numpy as np
from numpy.typing import NDArray

from adagen import paper
from adagen.paper.budget import Budget, OutOfBudget
from adagen.paper.search import EXPANSIONS, check_request
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.chains import WHOLE
from adagen.schedule.profile import TICKS
from adagen.schedule.search_result import Found
from adagen.schedule.segment_costs import SegmentCosts
from adagen.schedule.sweeps import Sweeps
from adagen.schedule.tree import Split, Strategy, Tie
from adagen.schedule.tree_prices import segment_time
from adagen.search.segment_bounds import SegmentBounds
from adagen.search.segment_pareto import Label, State, draft_of
from adagen.search.segment_search import SegmentSearch

_BEAMS = ((1, 1), (4, 1), (16, 1), (4, 2), (8, 4))
"""Of each first guess: options followed at each state, and how unequal divisions may be."""


def find_schedule(
    topology: Topology,
    processes: int,
    *,
    profile: CostProfile,
    tie: Tie = "work",
    strategy: Strategy = "exact",
    improved: bool = True,
    split: Split = "always",
    expansions: int = EXPANSIONS,
    cuttable: Sequence[bool] | None = None,
) -> Schedule:
    """Return a schedule of the robot for P processes that are joined at cuts.

    Where the profile has costs of steps, segments are searched by them (segment_search.py): ranges
    of up to four processes are divided in any way, larger ones in halves, and a chain may leave
    processes idle where they do not pay. A*, shared ranges, and profiles of joins alone follow the
    paper (adagen/paper/search.py).

    Args:
        topology: the robot.
        processes: P, 1 to 1024.
        profile: the costs.
        tie: among schedules that are equally long; see :func:`adagen.paper.search.find_schedule`,
            as for all that follows.
        strategy: ``exact``, ``astar`` or ``paper``; the last two price joints by Eq. (11).
        improved: for A*, the improved NextNodes().
        split: ``always``, ``free`` or ``any``; the last two price joints by Eq. (11).
        expansions: states or nodes the search may expand.
        cuttable: for each joint whether two processes may meet there.

    Raises:
        InputError: the robot has no joint, or costs are too large.
        UsageError: an argument is out of range.
    """
    if profile.steps is not None and strategy == "exact" and split == "always":
        check_request(processes, tie, strategy, split, expansions)
        costs = SegmentCosts(topology, profile)
        allowed = [True] * len(topology) if cuttable is None else list(cuttable)
        at = np.array([allowed[j] for j in costs.chains.original], dtype=np.bool_)
        found = find_segments(costs, processes, at, expansions)
        return found.schedule(topology, processes, profile, tie)
    return paper.find_schedule(
        topology,
        processes,
        profile=profile,
        tie=tie,
        strategy=strategy,
        improved=improved,
        split=split,
        expansions=expansions,
        cuttable=cuttable,
    )


def segment_bound(topology: Topology, profile: CostProfile, processes: int) -> float:
    """Return a lower bound that needs no search on the time of any schedule, microseconds."""
    costs = SegmentCosts(topology, profile)
    everywhere = np.ones(len(topology), dtype=np.bool_)
    bounds = SegmentBounds(costs, everywhere, costs.costs.speeds(processes))
    return bounds.least(WHOLE, processes) / TICKS


def find_segments(
    costs: SegmentCosts,
    processes: int,
    cuttable: NDArray[np.bool_],
    expansions: int,
) -> Found:
    """Return the best schedule found and what is proven.

    Args:
        costs: prices of the robot's chains and cuts.
        processes: P.
        cuttable: per position, whether two processes may meet there.
        expansions: states that may be expanded in all.
    """
    speeds = costs.costs.speeds(processes)
    bounds = SegmentBounds(costs, cuttable, speeds)
    search = SegmentSearch(costs, bounds, speeds, Budget(expansions))
    alone = Sweeps(*segment_time(costs, WHOLE, 0, speeds[0]), 0)
    best = Label(alone, State(WHOLE, 0, processes))
    spent = 0
    for width, uneven in _BEAMS:
        budget = Budget(max(64, expansions // 4))
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
