"""Limbs side by side: joints of a process that are computed together, one in each SIMD lane.

Independent limbs, such as two arms and two legs, are computed together as far as their joints are
of the same kinds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import groupby
from typing import TypeVar

from adagen.model.paths import last_beyond
from adagen.plan import steps as do
from adagen.plan.robot import PlanJoint
from adagen.plan.stages import Stage, stages
from adagen.plan.steps import Step
from adagen.plan.types import Plan, Process

KINDS = frozenset({"revolute", "prismatic", "spherical"})
"""Kinds of joints that are treated side by side."""


COUNTS = (2, 3, 4)
"""How many limbs can be computed at once. Three leave one of four lanes idle."""


OFFERED = (COUNTS, (2, 4), (2, 3), (2,))
"""What may be computed at once in the groupings that are compared by their price: where four go
together, two pairs may be less, or three beside a single one."""

Saving = Callable[[Sequence[str], int], float]
"""What so many limbs of joints of some kinds take less together than alone."""


@dataclass(frozen=True)
class Limbs:
    """Chains of joints, each on the link of the one before, whose k-th joints are of one kind.

    Attributes:
        rows: the limbs' k-th joints, those next to the base first.
    """

    rows: tuple[tuple[int, ...], ...]

    @property
    def count(self) -> int:
        """How many limbs."""
        return len(self.rows[0])

    @property
    def lanes(self) -> int:
        """Number of their lanes."""
        return 2 if self.count == 2 else 4

    @property
    def idle(self) -> int:
        """How many of the lanes are idle; they come first."""
        return self.lanes - self.count

    def members(self) -> Iterator[int]:
        """Yield the joints in memory order: row by row."""
        for row in self.rows:
            yield from row


@lru_cache(maxsize=16)  # of one plan it is asked for each process
def placed_links(plan: Plan) -> frozenset[int]:
    """Return the links whose own inertia is set up before sweeps.

    These are the links at which several processes' inertias are gathered, and those whose mobility
    is inverted to an inertia.
    """
    gathered = {link for message in plan.messages for link in message.inertias}
    held = (step.link for step in plan.steps_of(do.HoldMobility, do.SolveMobility))
    return frozenset(gathered).union(held)


def simd_groups(
    plan: Plan, process: Process, saved: Saving, counts: Iterable[int] = COUNTS
) -> list[Limbs]:
    """Return limbs that a process may compute side by side.

    Those that save most are chosen first, as long as their sweeps can be brought into an order.

    Args:
        plan: of form "segment".
        process: one of its processes.
        saved: what limbs save; only those that save something are grouped.
        counts: how many may be computed at once.
    """
    (found,) = simd_groupings(plan, process, saved, [counts])
    return found


def simd_groupings(
    plan: Plan, process: Process, saved: Saving, offered: Iterable[Iterable[int]] = OFFERED
) -> list[list[Limbs]]:
    """Return the same for each of some counts."""
    joints, last, pools = plan.joints, last_beyond(plan.joints), _chains(plan, process)

    @cache  # first of all the same ones are offered for all counts
    def offers(chains: Chains) -> list[_Offer]:
        return _offers(joints, chains, last, saved)

    return [_groups(pools, last, offers, frozenset(counts)) for counts in offered]


def nearly_fewest(process: Process, offers: Iterable[tuple[Limbs, ...]]) -> list[tuple[Limbs, ...]]:
    """Return the groupings of a process with nearly the fewest rows to compute.

    To count them takes far less than to price a grouping, and the others are hardly ever faster.
    """
    left = {
        own: len(process.owns) - sum(len(limbs.rows) * (limbs.count - 1) for limbs in own)
        for own in offers
    }
    fewest = min(left.values())
    most = max(_TIMES * fewest, fewest + _MORE)
    return [own for own, joints in left.items() if joints <= most]


_TIMES, _MORE = 1.25, 5
"""Joints that a grouping may leave and still be priced: so many times the fewest, or some more."""


Chains = tuple[tuple[int, ...], ...]
"""Chains of joints that may share lanes."""
_Offer = tuple[float, int, Chains]
"""What limbs save, their rows, and the chains that they are the ends of."""


def _groups(
    pools: Iterable[list[list[int]]],
    last: Sequence[int],
    offers: Callable[[Chains], Iterable[_Offer]],
    counts: frozenset[int],
) -> list[Limbs]:
    """The limbs, chosen one group after the other: those that save most beside those chosen."""
    found: list[Limbs] = []
    for pool in pools:
        chains = tuple(map(tuple, pool))
        while True:
            every = (
                Limbs(tuple(zip(*sorted(c[-rows:] for c in together), strict=True)))
                for _, rows, together in offers(chains)
                if len(together) in counts
            )
            best = next((limbs for limbs in every if _follows(limbs, found, last)), None)
            if best is None:
                break
            found.append(best)
            taken = set(best.members())  # what is left of a longer chain may be taken later
            left = (tuple(j for j in chain if j not in taken) for chain in chains)
            chains = tuple(chain for chain in left if chain)
    return found


def more_alike(
    plan: Plan, process: Process, found: Iterable[Limbs], unlike: Callable[[Limbs], float]
) -> list[Limbs]:
    """Return limbs, some exchanged for unused chains if that makes them more similar.

    Args:
        plan: of form "segment".
        process: one of its processes.
        found: the limbs that it takes side by side.
        unlike: how unlike each other limbs are.
    """
    last, result = last_beyond(plan.joints), list(found)
    for pool in _chains(plan, process):
        for k in range(len(result)):
            while result[k].rows[-1][0] in {j for c in pool for j in c}:
                others = result[:k] + result[k + 1 :]
                offers = [
                    offer
                    for offer in _exchanged(plan.joints, pool, result, result[k], last)
                    if unlike(offer) < unlike(result[k]) and _in_order([*others, offer], last)
                ]
                if not offers:
                    break
                result[k] = min(offers, key=unlike)
    return result


def _exchanged(
    joints: Sequence[PlanJoint],
    pool: Iterable[Sequence[int]],
    found: Iterable[Limbs],
    limbs: Limbs,
    last: Sequence[int],
) -> Iterator[Limbs]:
    """Yield limbs with one of them exchanged for the end of an unused chain."""
    taken = {j for each in found for j in each.members()}
    own = list(zip(*limbs.rows, strict=True))
    kinds = [joints[j].kind for j in own[0]]
    for chain in pool:
        end = tuple(chain[-len(kinds) :])
        if [joints[j].kind for j in end] != kinds or not taken.isdisjoint(end):
            continue
        for k in range(len(own)):
            rest = own[:k] + own[k + 1 :]
            if not any(_one_beyond_other(end[0], other[0], last) for other in rest):
                yield Limbs(tuple(zip(*sorted([*rest, end]), strict=True)))


def _chains(plan: Plan, process: Process) -> list[list[list[int]]]:
    """All joints that fit, as longest chains; those that may share lanes."""
    fit = _fit(plan, process)
    pools: dict[object, list[list[int]]] = {}
    for chain in longest_chains(plan.joints, fit):
        pools.setdefault(fit[chain[0]], []).append(chain)
    return list(pools.values())


def longest_chains(joints: Sequence[PlanJoint], fit: Mapping[int, object]) -> list[list[int]]:
    """Return joints as longest chains, each joint on the link of the one before.

    Args:
        joints: the plan's joints.
        fit: those that are in chains, ascending; only what is equal goes into one.
    """
    height = dict.fromkeys(fit, 1)
    beyond: dict[int, int] = {}  # the next joint outwards in a joint's chain
    for j in reversed(list(fit)):
        near = joints[j].parent - 1
        if near in fit and fit[near] == fit[j] and height[near] <= height[j]:
            height[near], beyond[near] = height[j] + 1, j
    chains = []
    for j in fit:
        if beyond.get(joints[j].parent - 1) != j:
            chain = [j]
            while chain[-1] in beyond:
                chain.append(beyond[chain[-1]])
            chains.append(chain)
    return chains


def _offers(
    joints: Sequence[PlanJoint], chains: Chains, last: Sequence[int], saved: Saving
) -> list[_Offer]:
    """Limbs that save something, those that save most first."""
    offers: list[_Offer] = []
    kinds = [tuple(joints[j].kind for j in reversed(c)) for c in chains]  # outermost first
    distinct = list(dict.fromkeys(kinds))
    for pattern in sorted(distinct, key=len, reverse=True):
        common = {own: _common(pattern, own) for own in distinct}
        pairs = zip((common[own] for own in kinds), chains, strict=True)
        alike = sorted((pair for pair in pairs if pair[0]), key=lambda pair: -pair[0])
        for most, start in alike[:_STARTS]:
            together, rows = [start], most
            for length, chain in alike:
                least = min(rows, length)
                if _meets_any(chain[-least], together, least, last):
                    continue
                together.append(chain)
                rows, count = least, len(together)
                if count in COUNTS and (gain := saved(pattern[:rows], count)) > 0:
                    offers.append((gain, rows, tuple(together)))
                if count == max(COUNTS):
                    break
    offers.sort(key=lambda offer: -offer[0])
    return offers


def _meets_any(end: int, chains: Iterable[Sequence[int]], rows: int, last: Sequence[int]) -> bool:
    """Whether a joint is beyond or before the joint of a chain with which it would share a row.

    Written without calls: it is asked some ten thousand times for each grouping of a large robot.
    """
    beyond = last[end]
    for chain in chains:
        other = chain[-rows]
        if other <= end <= last[other] or end <= other <= beyond:
            return True
    return False


def _follows(limbs: Limbs, taken: Sequence[Limbs], last: Sequence[int]) -> bool:
    """Whether limbs can be in an order with others."""
    hangs = any(_hang_on(limbs, other, last) for other in taken)
    bears = hangs and any(_hang_on(other, limbs, last) for other in taken)
    return not bears or _in_order([*taken, limbs], last)


_STARTS = 4  # chains that limbs to go together are looked for beside


def _common(one: Sequence[str], other: Sequence[str]) -> int:
    """Number of common kinds of two sequences from their start on."""
    count = 0
    for a, b in zip(one, other, strict=False):
        if a != b:
            break
        count += 1
    return count


def _one_beyond_other(one: int, other: int, last: Sequence[int]) -> bool:
    return _beyond(one, other, last) or _beyond(other, one, last)


def _beyond(joint: int, other: int, last: Sequence[int]) -> bool:
    """Whether a joint is another one or beyond it."""
    return other <= joint <= last[other]


def _in_order(all_limbs: Sequence[Limbs], last: Sequence[int]) -> bool:
    """Whether limbs can be ordered so that each comes after those that it depends on."""
    waiting = list(all_limbs)
    while waiting:
        free = [limbs for limbs in waiting if not any(_hang_on(o, limbs, last) for o in waiting)]
        if not free:
            return False
        waiting = [limbs for limbs in waiting if limbs not in free]
    return True


def _hang_on(some: Limbs, others: Limbs, last: Sequence[int]) -> bool:
    """Whether one of some limbs is beyond one of the others."""
    if some is others:
        return False
    starts = others.rows[0]  # what hangs on a joint of a limb hangs on its first one
    for i in some.rows[0]:
        for j in starts:
            if j <= i <= last[j]:
                return True
    return False


def _fit(plan: Plan, process: Process) -> dict[int, tuple[int, ...]]:
    """Joints that may be in lanes, with the rows of steps in which they are computed.

    They are the process's own, passed once, away from the sweep's root, and their links are bare.
    No mobility, no force at a handle and no rows of loops go through them: those go joint by
    joint, or closure by closure (adagen/plan/similar_closures.py).
    """
    parts = stages(process)
    sweeps = [
        _row_of(process, parts, do.Kinematics),
        _row_of(process, parts, do.Articulate),
        _row_of(process, parts, do.Accelerate),
    ]
    turned = {s.joint for s in process.steps_of(do.Articulate, do.Accelerate) if s.reversed}
    # Closures go side by side as a whole.
    apart = do.Propagate, do.Deliver, do.HoldBack, do.CarryRows
    between = {s.joint for s in process.steps if isinstance(s, apart)}
    bare = {step.link for step in process.steps_of(do.StartLink)} - placed_links(plan)
    return {
        j: tuple(sweep[j] for sweep in sweeps)
        for j in process.owns
        if fits_beside(plan.joints[j])
        and j + 1 in bare
        and j not in turned | between
        and all(j in sweep for sweep in sweeps)
    }


def fits_beside(joint: PlanJoint) -> bool:
    """Whether a joint is of a kind that can be in lanes.

    Where its motion is prescribed, it may have one freedom, and be beside joints that move freely.
    """
    return joint.kind in KINDS and not (joint.prescribed and joint.kind == "spherical")


_Sweep = TypeVar("_Sweep", do.Kinematics, do.Articulate, do.Accelerate)


def _row_of(process: Process, parts: Iterable[Stage], kind: type[_Sweep]) -> dict[int, int]:
    """The row of steps of a kind, in their order within a stage, that a joint is in."""
    found: dict[int, int] = {}
    for stage in parts:
        steps = process.steps[stage.first : stage.last]
        for k, (of_kind, group) in enumerate(groupby(steps, sweep_of)):
            if issubclass(of_kind, kind):
                joints = [step.joint for step in group if isinstance(step, kind)]
                found.update(dict.fromkeys(joints, stage.first * len(process.steps) + k))
    return found


_SWEEPS: dict[type, type] = {
    **dict.fromkeys((do.HoldBack, do.CarryRows, do.Eliminate), do.Articulate),
    **dict.fromkeys((do.Release, do.AccelerateHeld), do.Accelerate),
}


def sweep_of(step: Step) -> type:
    """Return the sweep of a step: steps of one sweep may be reordered."""
    return _SWEEPS.get(type(step), type(step))
