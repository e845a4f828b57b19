"""Similar closures, which are computed side by side, one in each SIMD lane.

Two legs with the same linkage, four feet on the ground: their trees of joints, the kinds of their
loops and the choice of independent accelerations are the same. Numbers may differ.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from adagen.plan.closure_steps import ClosureSteps, closures_in
from adagen.plan.matching import matching, relabelled
from adagen.plan.simd_groups import KINDS, Limbs
from adagen.plan.steps import Step
from adagen.plan.types import Plan


def similar_closures(
    plan: Plan, steps: Iterable[Step], counts: Iterable[int]
) -> list[tuple[ClosureSteps, ...]]:
    """Return closures of a process that can be computed side by side.

    Args:
        plan: the plan.
        steps: those of one of its processes.
        counts: how many may go together.
    """
    found: list[tuple[ClosureSteps, ...]] = []
    pools: list[list[ClosureSteps]] = []
    for one in closures_in(steps).values():
        if _fits(plan, one):
            matched = ((pool, matching(plan, pool[0], one)) for pool in pools)
            pool, own = next((each for each in matched if each[1] is not None), (None, None))
            if pool is None or own is None:
                pools.append([one])
            else:
                pool.append(own)
    for pool in pools:
        while pool:
            apart: list[ClosureSteps] = []
            for one in pool:
                if not any(_beyond(plan, one, other) for other in apart):
                    apart.append(one)
            apart.sort(key=lambda one: sorted(one.path))
            taken = apart[: max((n for n in counts if n <= len(apart)), default=1)]
            if len(taken) > 1:
                found.append(tuple(taken))
            pool = [one for one in pool if one not in taken]
    return found


def _fits(plan: Plan, one: ClosureSteps) -> bool:
    """Whether all joints of a closure are of kinds that can be in lanes."""
    joints = [plan.joints[j] for j in one.path]
    return all(joint.kind in KINDS and not joint.prescribed for joint in joints)


def _beyond(plan: Plan, one: ClosureSteps, other: ClosureSteps) -> bool:
    """Whether one of two closures is beyond a joint of the other."""
    above, below = plan.paths([one.path[0]]), plan.paths([other.path[0]])
    return not above.isdisjoint(other.path) or not below.isdisjoint(one.path)


def limbs_of(plan: Plan, together: Sequence[ClosureSteps]) -> list[Limbs]:
    """Return the joints of closures side by side, chain by chain."""
    first = together[0].path
    chains: list[list[int]] = []  # places in the path
    for place, j in enumerate(first):
        parent = plan.joints[j].parent - 1
        ending = (chain for chain in chains if first[chain[-1]] == parent)
        chain = next(ending, None)
        if chain is None:
            chains.append([place])
        else:
            chain.append(place)
    return [
        Limbs(tuple(tuple(one.path[place] for one in together) for place in chain))
        for chain in chains
    ]


def side_by_side(
    plan: Plan, steps: Iterable[Step], all_limbs: Iterable[Limbs]
) -> dict[int, tuple[ClosureSteps, ...]]:
    """Return the closures in limbs side by side, one for each lane, by the first's number.

    Closures whose joints are in lanes, and that are not alike for all that, are left out.

    Args:
        plan: the plan.
        steps: those of one of its processes.
        all_limbs: which joints share code.
    """
    closures = closures_in(steps)
    of_joint = {j: one for one in closures.values() for j in one.path}
    rows = {row[0]: row for limbs in all_limbs for row in limbs.rows}
    found = {}
    for one in closures.values():
        own = [rows.get(j, ()) for j in one.path]
        count = len(own[0])
        if count < 2 or any(len(row) != count for row in own):
            continue
        lanes = []
        for k in range(count):
            other = of_joint.get(own[0][k])
            joints = dict(zip(one.path, (row[k] for row in own), strict=True))
            lane = None if other is None else relabelled(plan, one, other, joints)
            if lane is not None:
                lanes.append(lane)
        if len(lanes) == count:
            found[one.number] = tuple(lanes)
    return found
