"""A schedule from a topology and a cost profile, by the search that suits the profile."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from time import monotonic

from adagen import paper
from adagen.paper.budget import Progress
from adagen.paper.search import EXPANSIONS, check_request
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.tree import Split, Strategy, Tie
from adagen.search.segment_schedule import segment_schedule


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
    time_budget: float | None = None,
    progress: Callable[[Progress], None] | None = None,
    cuttable: Sequence[bool] | None = None,
) -> Schedule:
    """Return a schedule of the robot for P processes that are joined at cuts.

    Where the profile has costs of steps, segments are searched by them (segment_search.py); A*,
    shared ranges, and profiles of joins alone follow the paper (adagen/paper/search.py).

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
        time_budget: seconds after which the search ends too; None for no such limit.
        progress: called now and then with what is known.
        cuttable: for each joint whether two processes may meet there.

    Raises:
        InputError: the robot has no joint, or costs are too large.
        UsageError: an argument is out of range.
    """
    if profile.steps is not None and strategy == "exact" and split == "always":
        check_request(processes, tie, strategy, split, expansions, time_budget)
        deadline = None if time_budget is None else monotonic() + time_budget
        return segment_schedule(
            topology, processes, profile, tie, cuttable, expansions=expansions, deadline=deadline
        )
    return paper.find_schedule(
        topology,
        processes,
        profile=profile,
        tie=tie,
        strategy=strategy,
        improved=improved,
        split=split,
        expansions=expansions,
        time_budget=time_budget,
        progress=progress,
        cuttable=cuttable,
    )
