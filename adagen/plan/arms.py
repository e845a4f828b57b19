"""Similar arms of a closure: chains of its joints that are computed side by side.

The rods of a parallel ankle, the legs of a Stewart platform: chains that start at one link, whose
loops are of the same kinds and end at one other link. Their joints affect each other only through
these two links. Numbers may differ.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

from adagen.model.kinds import KINDS as FREEDOMS
from adagen.plan.closure_steps import ClosureSteps, closures_in, nature
from adagen.plan.simd_groups import KINDS, Limbs
from adagen.plan.similar_closures import side_by_side
from adagen.plan.steps import CloseLoop, Step
from adagen.plan.types import Plan

WideUnknown = tuple[int, ...]
"""Unknowns of a closure that are treated as one, lane by lane."""


@dataclass(frozen=True)
class Arms:
    """Arms of one closure that share code, one in each lane.

    Attributes:
        closure: its number.
        limbs: their joints.
        loops: that close them, those that are treated as one together.
        freedoms: unknown accelerations.
        forces: unknown forces of rows.
    """

    closure: int
    limbs: Limbs
    loops: tuple[tuple[CloseLoop, ...], ...]
    freedoms: tuple[WideUnknown, ...]
    forces: tuple[WideUnknown, ...]


def arms_of(plan: Plan, one: ClosureSteps, counts: Iterable[int]) -> list[Limbs]:
    """Return arms of a closure that can be computed side by side.

    Args:
        plan: the plan.
        one: what a process does for the closure.
        counts: how many may go together.
    """
    pools: dict[object, list[tuple[int, ...]]] = {}
    for ends in _chains(plan, one):
        shape = _shape(plan, one, ends)
        if shape is not None:
            pools.setdefault(shape, []).append(ends)
    most, found = sorted(counts), []
    for pool in pools.values():
        while (taken := max((n for n in most if n <= len(pool)), default=0)) > 1:
            found.append(Limbs(tuple(zip(*pool[:taken], strict=True))))
            pool = pool[taken:]
    return found


def arms_in(plan: Plan, one: ClosureSteps, all_limbs: Iterable[Limbs]) -> list[Arms]:
    """Return the arms of a closure that are in limbs side by side, without dissimilar ones."""
    found = []
    for limbs in all_limbs:
        chains = list(zip(*limbs.rows, strict=True))
        if not set(limbs.members()).issubset(one.path):
            continue
        shapes = {_shape(plan, one, chain) for chain in chains}
        if len(shapes) > 1 or None in shapes:
            continue
        loops = tuple(zip(*(_loops_at(plan, one, chain) for chain in chains), strict=True))
        freedoms = [
            tuple(one.held[j] + k for j in row)
            for row in limbs.rows
            for k in range(FREEDOMS[plan.joints[row[0]].kind].nv)
        ]
        forces = [
            tuple(closing.first + k for closing in wide_unknown)
            for wide_unknown in loops
            for k in range(len(wide_unknown[0].rows))
        ]
        found.append(Arms(one.number, limbs, loops, tuple(freedoms), tuple(forces)))
    return found


def _chains(plan: Plan, one: ClosureSteps) -> list[tuple[int, ...]]:
    """The ends of a closure's tree: its joints inwards from each outermost one, up to a branch."""
    beyond: dict[int, list[int]] = {}
    for j in one.path:
        beyond.setdefault(plan.joints[j].parent - 1, []).append(j)
    found = []
    for j in one.path:
        if j in beyond:
            continue
        chain = [j]
        while (near := plan.joints[chain[0]].parent - 1) in one.path and len(beyond[near]) == 1:
            chain.insert(0, near)
        found.append(tuple(chain))
    return found


def _loops_at(plan: Plan, one: ClosureSteps, chain: Sequence[int]) -> list[CloseLoop]:
    """The loops at links of a chain."""
    links = {j + 1 for j in chain}
    ends = ((c, plan.loops[c.loop]) for c in one.loops)
    return [closing for closing, loop in ends if not links.isdisjoint(loop.links)]


def _shape(plan: Plan, one: ClosureSteps, chain: Sequence[int]) -> tuple[object, ...] | None:
    """The structure that arms must share to be computed side by side; None where they cannot."""
    joints, how = [plan.joints[j] for j in chain], one.eliminate
    if not set(chain).issubset(one.held) or len(one.held) < len(one.path):
        return None
    if not how.moved:  # by an orthogonal basis of all, arms have no parts of their own
        return None
    if any(joint.kind not in KINDS or joint.prescribed for joint in joints):
        return None
    if any(
        not {j for j, _ in plan.couplings[c.coupling].terms}.isdisjoint(chain)
        for c in one.couplings
    ):
        return None
    place = {j + 1: k for k, j in enumerate(chain)}
    loops = []
    for closing in _loops_at(plan, one, chain):
        loop = plan.loops[closing.loop]
        ends = [(place.get(link), None if link in place else link) for link in loop.links]
        if all(link in place for link in loop.links):
            return None
        forces = range(closing.first, closing.first + len(closing.rows))
        kept = tuple((force in how.rows, force in how.followers) for force in forces)
        loops.append((loop.kind, tuple(ends), closing.rows, kept, bool(loop.turn2)))
    numbers = (range(one.held[j], one.held[j] + FREEDOMS[plan.joints[j].kind].nv) for j in chain)
    moved = tuple(number in how.moved for own in numbers for number in own)
    return (tuple(map(nature, joints)), joints[0].parent, tuple(loops), moved)


def arms_among(
    plan: Plan, closures: Iterable[ClosureSteps], all_limbs: Iterable[Limbs]
) -> dict[int, list[Arms]]:
    """Return the arms in limbs side by side, by closure; closures without any are left out."""
    limbs = tuple(all_limbs)
    found = {one.number: arms_in(plan, one, limbs) for one in closures}
    return {number: arms for number, arms in found.items() if arms}


def without_unlike(plan: Plan, steps: Sequence[Step], all_limbs: Iterable[Limbs]) -> list[Limbs]:
    """Return limbs without those that contain joints of dissimilar closures.

    Rows of what the ground holds are seen from it, so that the way there is not in lanes either.
    Closures that were in lanes there no longer are, and are left out in turn.
    """
    closures, limbs = closures_in(steps), list(all_limbs)
    while True:
        apart = _joints_apart(plan, steps, closures, limbs)
        found: list[Limbs] = []
        for each in limbs:
            rows = [row for row in each.rows if apart.isdisjoint(row)]
            if len(rows) == len(each.rows):
                found.append(each)
            else:  # what is left need no longer be one chain
                found += [Limbs((row,)) for row in rows]
        if found == limbs:
            return found
        limbs = found


def _joints_apart(
    plan: Plan,
    steps: Sequence[Step],
    closures: Mapping[int, ClosureSteps],
    limbs: Sequence[Limbs],
) -> set[int]:
    """Joints of closures that are in no lanes, and what they are seen by."""
    together = side_by_side(plan, steps, limbs)
    lanes = {lane.number for row in together.values() for lane in row}
    arms = chain.from_iterable(arms_among(plan, closures.values(), limbs).values())
    in_lanes = {j for each in arms for j in each.limbs.members()}
    apart: set[int] = set()
    for one in closures.values():
        if one.number not in lanes:
            apart.update(plan.paths(one.path) if one.eliminate.grounded else one.path)
    return apart - in_lanes
