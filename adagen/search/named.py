"""Schedules without a search: fixed assembly orders, and given trees.

They go to processes as Section III-C has it, so that they compare with what the search finds.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import get_args

from adagen.errors import UsageError
from adagen.paper.bounds import Rules
from adagen.paper.successors import Space
from adagen.schedule.chains import WHOLE, Chain, Chains
from adagen.schedule.profile import TICKS, CostProfile
from adagen.schedule.search_result import Found
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Meeting, Named, Schedule, Strategy, postorder
from adagen.schedule.tree_draft import Draft
from adagen.schedule.validity import validate
from adagen.search.schedules import segment_bound


def named_schedule(
    name: Named, topology: Topology, processes: int, *, profile: CostProfile
) -> Schedule:
    """Return one of the schedules that have a name, for P processes.

    Args:
        name: ``balanced``: the assembly tree of Featherstone's divide-and-conquer algorithm (the
            paper's [2]): every partial chain is cut at the joint that leaves the two sides most
            alike in number of joints, down to single joints, whatever it costs in boundary joints.
            ``sequential``: one joint after the other from the ends to the ground, the order of
            least work on one process (II-D). ``middle-out``: the joint in the middle is the root
            of the schedule tree and the others follow outwards, so that assembly goes from all ends
            to the middle; on a serial chain the best schedule of the paper's Fig. 4.
        topology: the robot.
        processes: P, 1 to 1024. Ranges are halved, the smaller half to the root side.
        profile: what a join costs.

    Returns:
        The schedule; its bound is one that needs no search, so that its verdict is ``optimal``
        only where that happens to prove it.

    Raises:
        InputError: the robot has no joint, or costs are too large.
        UsageError: the name or the number of processes is not one of these.
    """
    if name not in _MAKERS:
        raise UsageError(f"unknown schedule '{name}': expected {', '.join(get_args(Named))}")
    if not 1 <= processes <= 1024:
        raise UsageError(f"the number of processes must be 1 to 1024, not {processes}")
    chains = Chains(topology, profile)
    draft = _MAKERS[name](chains)
    draft.assign(draft.root, (0, processes))
    return as_schedule(draft, topology, profile, name)


def as_schedule(
    draft: Draft,
    topology: Topology,
    profile: CostProfile,
    strategy: Strategy | Named,
    meeting: Meeting = "join",
) -> Schedule:
    """Return a finished tree with its price, loads and a bound that needs no search.

    Args:
        draft: descendants and process ranges of every joint.
        topology: the robot.
        profile: prices the tree.
        strategy: where it comes from.
        meeting: how its processes meet.

    Raises:
        InvalidSchedule: the tree is not a schedule of this robot.
    """
    processes = draft.ranges[draft.root][1]
    found = Found(draft, 0, 0).schedule(topology, processes, profile, "work", strategy)
    shares = any(
        len(node.children) == 2
        and node.processes[1] - node.processes[0] > 1
        and node.children[0].processes == node.children[1].processes
        for node in postorder(found.root)
    )
    # Any split is the weakest rule that such a tree may follow.
    rules = Rules(halving=False, split="free" if shares else "always")
    if profile.steps is not None:
        lower = segment_bound(topology, profile, processes)
    else:
        lower = Space(topology, profile, rules).bounds.whole(processes) / TICKS
    lower = min(found.makespan, lower)
    schedule = replace(found, lower_bound=lower, split=rules.split, meeting=meeting)
    validate(schedule, topology)
    return schedule


def _balanced(chains: Chains) -> Draft:
    draft = Draft(len(chains.original))
    stack: list[tuple[Chain, int, bool]] = [(WHOLE, -1, False)]
    while stack:
        chain, above, is_end = stack.pop()
        positions = chains.positions(chain)
        if not positions:
            continue
        middle = _middle(chains, positions)
        joint = chains.original[middle]
        draft.hang(above, joint, is_end)
        root, end = chains.split(chain, middle)
        stack += [(end, joint, True), (root, joint, False)]
    return draft


def _middle(chains: Chains, positions: list[int]) -> int:
    """Return the position whose larger side has the fewest joints, the first of equals."""
    # The joints at or below p come directly after p; those beyond a cut are not among them.
    number = {p: i for i, p in enumerate(positions)}
    stop = dict.fromkeys(positions, len(positions))
    path: list[int] = []
    for i, p in enumerate(positions):
        while path and chains.end[path[-1]] <= p:
            stop[path.pop()] = i
        path.append(p)
    total = len(positions) - 1

    def larger(p: int) -> int:
        below = stop[p] - number[p] - 1
        return max(below, total - below)

    return min(positions, key=larger)


def _sequential(chains: Chains) -> Draft:
    return _from(chains, 0)


def _middle_out(chains: Chains) -> Draft:
    middle = _middle(chains, chains.positions(WHOLE))
    return _from(chains, middle)


def _from(chains: Chains, first: int) -> Draft:
    """Return the tree that starts at a position and goes on outwards, depth first.

    Assembly is in the reverse order: every link takes in its branches one by one, and the only
    joint left around them is then the one that leads to the first.
    """
    inside = [p for p in range(len(chains.original)) if p != first]
    beyond = chains.outwards(inside, [chains.parent[first], first + 1])
    order = [*(p for p, _, _ in reversed(beyond)), first]
    draft = Draft(len(order))
    draft.root = draft.contract(chains.topology, [chains.original[p] for p in order])
    return draft


_MAKERS: dict[str, Callable[[Chains], Draft]] = {
    "balanced": _balanced,
    "sequential": _sequential,
    "middle-out": _middle_out,
}
