"""Random schedules, so that measurements cover more than a search would choose."""

from __future__ import annotations

import random

from adagen.paper.one_process import SingleProcess
from adagen.schedule.chains import WHOLE, Chain, Chains
from adagen.schedule.profile import CostProfile
from adagen.schedule.sweeps import loads_of, makespan_of
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Node, Schedule
from adagen.schedule.tree_draft import Draft


def random_schedule(
    topology: Topology,
    processes: int,
    profile: CostProfile,
    seed: int,
    *,
    share: float = 0.0,
    mixed: bool = False,
    shared: bool = False,
) -> Schedule:
    """Return a schedule cut at random joints, with halved ranges as in Section III-C.

    Args:
        topology: the robot.
        processes: P.
        profile: what to price its nodes with.
        seed: the same one gives the same schedule.
        share: the least part of a chain's joints that a cut leaves on either side, or as nearly
            as its joints allow; 0 for any cut.
        mixed: whether one process assembles its joints in random order; otherwise in the order
            of least work.
        shared: whether both sides of the root get all processes, one side after the other, so that
            a process has several chains and some of them several handles.
    """
    rng = random.Random(seed)  # noqa: S311 (not for secrets)
    chains = Chains(topology, profile)
    single = SingleProcess(chains)
    draft = Draft(len(topology))

    def build(chain: Chain, ranks: tuple[int, int], share_range: bool = False) -> int:
        """Schedule a chain; return its topmost joint, -1 for a bare link."""
        positions = chains.positions(chain)
        if not positions:
            return -1
        if ranks[1] - ranks[0] == 1 or len(positions) < 3:
            order = [chains.original[p] for p in positions] if mixed else single.order(chain)
            if mixed:
                rng.shuffle(order)
            top = draft.contract(topology, order)
            draft.assign(top, ranks)
            return top
        position = _cut(chains, chain, positions, share, rng)
        root, end = chains.split(chain, position)
        joint = chains.original[position]
        middle = ranks[0] + (ranks[1] - ranks[0]) // 2
        both = all(chains.positions(side) for side in (root, end)) and not share_range
        draft.root_child[joint] = build(root, (ranks[0], middle) if both else ranks)
        draft.end_child[joint] = build(end, (middle, ranks[1]) if both else ranks)
        draft.ranges[joint] = ranks
        return joint

    draft.root = build(WHOLE, (0, processes), shared)
    root = draft.finish(topology, profile)
    return _as_given(root, processes, profile)


def _as_given(root: Node, processes: int, profile: CostProfile) -> Schedule:
    return Schedule(
        root=root,
        processes=processes,
        makespan=makespan_of(root),
        lower_bound=0.0,
        profile=profile.name,
        tie="work",
        tie_proven=False,
        strategy="file",
        split="always",
        expanded=0,
        loads=loads_of(root, processes),
    )


def _cut(
    chains: Chains, chain: Chain, positions: list[int], share: float, rng: random.Random
) -> int:
    """Return the position to cut at."""
    smaller = []
    for p in positions:
        root, end = chains.split(chain, p)
        smaller.append(min(len(chains.positions(side)) for side in (root, end)))
    least = min(max(1.0, share * len(positions)), max(smaller))
    return rng.choice([p for p, size in zip(positions, smaller, strict=True) if size >= least])
