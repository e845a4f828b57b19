"""The paper's search: from a topology and costs by Eq. (11) to a schedule."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import dataclass, replace
from time import monotonic
from typing import get_args

from adagen.errors import UsageError
from adagen.paper.astar import AStar
from adagen.paper.beam import incumbent
from adagen.paper.bounds import Rules
from adagen.paper.branch_and_bound import ExactSearch
from adagen.paper.budget import Budget, OutOfBudget
from adagen.paper.restricted import joined_between_processes, restricted_draft
from adagen.paper.successors import Space
from adagen.paper.tie_break import LeastWork, walk
from adagen.schedule.chains import WHOLE
from adagen.schedule.profile import CostProfile
from adagen.schedule.search_result import Found
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Schedule, Split, Strategy, Tie
from adagen.schedule.tree_draft import Draft

MOST_PROCESSES = 1024
EXPANSIONS = 5_000
"""Default limit on expansions: the same answer on every machine, within seconds."""


@dataclass(frozen=True)
class Request:
    """What is asked of a strategy; ``deadline`` is on the monotonic clock."""

    space: Space
    processes: int
    tie: Tie
    improved: bool
    expansions: int
    deadline: float | None


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
    cuttable: Sequence[bool] | None = None,
) -> Schedule:
    """Return a schedule of the robot for P processes that minimises the makespan.

    Ranges are halved where P is a power of two (III-C) and divided in any way otherwise.

    Args:
        topology: the robot.
        processes: P, 1 to 1024.
        profile: costs of joins by Eq. (11); its costs of steps are ignored.
        tie: among equally long schedules, ``work``: the least total work; ``lex``: the smallest
            sequence of joints, slots filled level by level, root side first (as in Table I; with P
            not a power of two, of pairs of joint and processes of its root side). A chain on one
            process is always in the order of III-D.
        strategy: ``exact``: branch and bound over partial chains; ``astar``: A* over sequences
            with an admissible estimate; ``paper``: A* with the paper's estimate, which is not
            admissible, so the schedule may be longer than the best.
        improved: for A*, the improved NextNodes() instead of the naive one.
        split: ``always``: two descendants divide their range (III-C); ``free``: they may share
            it, one after the other; ``any``: also, ranges are divided in any way (both ``exact``).
        expansions: states or nodes the search may expand; the answer depends on nothing else.
        time_budget: seconds, None for no limit; if it ends the search, results are not repeatable.
        cuttable: for each joint whether two processes may meet there. If the best schedule has
            others, a beam search over the allowed cuts replaces it; the bound stays.

    Returns:
        The schedule; its verdict is ``optimal`` only where that is proven.

    Raises:
        InputError: the robot has no joint, or costs are too large.
        UsageError: an argument is out of range.
    """
    check_request(processes, tie, strategy, split, expansions, time_budget)
    deadline = None if time_budget is None else monotonic() + time_budget
    if profile.steps is not None:
        profile = replace(profile.joins_only(), name=f"Eq. (11) of the {profile.name}")
    space = Space(topology, profile, rules := Rules.of(processes, split))
    searched = processes if rules.halving else rules.useful(processes, len(topology))
    request = Request(space, searched, tie, improved, expansions, deadline)
    found = _found(request, strategy)
    _give_all(found.draft, searched, processes)
    schedule = found.schedule(topology, processes, profile, tie, strategy, split)
    if cuttable is None or all(cuttable[j] for j in joined_between_processes(schedule.root)):
        return schedule
    found = _restricted(request, found, cuttable)
    _give_all(found.draft, searched, processes)
    return found.schedule(topology, processes, profile, tie, strategy, split)


def _restricted(request: Request, found: Found, cuttable: Sequence[bool]) -> Found:
    """The best schedule of a beam search over the allowed cuts, with the bound over all cuts."""
    space = request.space
    draft, spent = restricted_draft(
        space.topology, request.processes, space.profile, space.rules, cuttable, request.expansions
    )
    return Found(draft, found.lower, found.expanded + spent)


def _found(request: Request, strategy: Strategy) -> Found:
    if request.processes == 1:
        return _one(request)
    return _exact(request) if strategy == "exact" else _astar(request, strategy)


def check_request(
    processes: int,
    tie: str,
    strategy: str,
    split: str,
    expansions: int,
    time_budget: float | None = None,
) -> None:
    """Refuse what no search can be asked; the arguments are those of :func:`find_schedule`.

    Raises:
        UsageError: an argument is out of range.
    """
    if not 1 <= processes <= MOST_PROCESSES:
        raise UsageError(f"the number of processes must be 1 to {MOST_PROCESSES}, not {processes}")
    strategies = tuple(name for name in get_args(Strategy) if name != "file")
    for value, known, what in (
        (tie, get_args(Tie), "tie-break"),
        (strategy, strategies, "strategy"),
        (split, get_args(Split), "way to split"),
    ):
        if value not in known:
            raise UsageError(f"unknown {what} '{value}': expected {', '.join(known)}")
    if split != "always" and strategy != "exact":
        raise UsageError(f"splitting '{split}' needs the strategy 'exact': A* follows the paper")
    if expansions < 0 or (time_budget is not None and not time_budget >= 0):
        raise UsageError("a search budget must not be negative")


def _give_all(draft: Draft, searched: int, processes: int) -> None:
    """Leave processes that are of no use idle at the end of the last range."""
    if searched < processes:
        draft.ranges = [(a, processes if b == searched else b) for a, b in draft.ranges]


def _one(request: Request) -> Found:
    space = request.space
    draft = Draft(len(space.topology))
    draft.root = draft.contract(space.topology, space.single.order(WHOLE))
    draft.assign(draft.root, (0, 1))
    return Found(draft, space.single.work(WHOLE), 0, True)


def _guesses(request: Request) -> int:
    """Return how many states the beams may expand for a first schedule."""
    return max(64, min(1000, 10 * request.expansions))


def _half(deadline: float | None) -> float | None:
    """Return the moment when half of the time that is left will have gone by."""
    return None if deadline is None else (monotonic() + deadline) / 2


def _exact(request: Request) -> Found:
    """Return what branch and bound finds; a beam's schedule where the budget runs out."""
    space, processes = request.space, request.processes
    lower = space.bounds.whole(processes)
    known, draft = incumbent(space, processes, lower, _guesses(request), _half(request.deadline))
    if not space.rules.halving:
        known, draft = min((known, draft), _halved(request), key=lambda pair: pair[0])

    search = ExactSearch(space, Budget(request.expansions, request.deadline))
    optimum = search.tighten(processes, known)
    if optimum is None:
        return Found(draft, search.lower, search.budget.expanded, False)
    expanded = search.budget.expanded
    best, proven = _preferred(request, search, optimum)
    if best is None:
        best = draft if known == optimum else None
    if best is None:
        search.budget = Budget(1 << 40)
        best = walk(space, search, processes, optimum, lexicographic=False)
    return Found(best, optimum, expanded, proven)


def _halved(request: Request) -> tuple[int, Draft]:
    """Return a schedule for the largest power of two of processes, the others left idle.

    Halving is one way to divide among many, and far quicker to search.
    """
    fewer = 1 << (request.processes.bit_length() - 1)
    rules = Rules.of(fewer, request.space.rules.split)
    space = Space(request.space.topology, request.space.profile, rules)
    lower = space.bounds.whole(fewer)
    budget = max(64, request.expansions // 4)
    known, draft = incumbent(space, fewer, lower, _guesses(request), _half(request.deadline))
    search = ExactSearch(space, Budget(budget, _half(request.deadline)))
    optimum = search.tighten(fewer, known)
    if optimum is not None and optimum < known:
        search.budget = Budget(1 << 40)
        known, draft = optimum, walk(space, search, fewer, optimum, lexicographic=False)
    _give_all(draft, fewer, request.processes)
    return known, draft


def _preferred(request: Request, search: ExactSearch, optimum: int) -> tuple[Draft | None, bool]:
    """Return the schedule that the tie-break prefers, if it is found within another budget."""
    # What is proven does not hang on it: no more than half of the time that is left.
    search.budget = Budget(request.expansions, _half(request.deadline))
    # With shared ranges the time left to one side depends on how the other one is filled: the
    # choice is then made for the second side's best time alone.
    proven = request.space.rules.split == "always"
    try:
        if request.tie == "lex":
            return walk(request.space, search, request.processes, optimum, True), proven
        least = LeastWork(request.space, search, search.budget)
        return least.draft(request.processes, optimum), proven
    except OutOfBudget:
        logging.getLogger(__name__).debug("the tie-break was given up")
        return None, False


def _astar(request: Request, strategy: Strategy) -> Found:
    space, processes = request.space, request.processes
    lower = space.bounds.whole(processes)

    search = AStar(
        space,
        "paper" if strategy == "paper" else "admissible",
        request.improved,
        request.tie,
        Budget(request.expansions, request.deadline),
    )
    goal = search.search(processes)
    lower = max(lower, search.lower)
    if goal is None:
        _, draft = incumbent(space, processes, lower, _guesses(request), None)
        return Found(draft, lower, search.budget.expanded, False)
    # A naive sequence is not in the canonical order of slots, so that its smallest is another one.
    proven = strategy == "astar" and (request.improved or request.tie == "work")
    return Found(search.draft(goal), lower, search.budget.expanded, proven)
