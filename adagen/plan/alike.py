"""Closures that are alike: all that is done for them can be done side by side, one in each lane.

Two legs with the same linkage, four feet on the ground: their joints hang on each other in the same
way, their loops are of the same kinds between links that correspond, and what follows from what is
chosen alike. Numbers may differ.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass

from adagen.plan.robot import PlanJoint
from adagen.plan.simd_groups import KINDS, Limbs
from adagen.plan.steps import CarryRows, CloseCoupling, CloseLoop, Eliminate, HoldBack, Step
from adagen.plan.types import Plan


@dataclass(frozen=True)
class ClosureSteps:
    """What a process does inwards for one of its closures.

    Attributes:
        number: of the closure.
        loops: states their rows.
        couplings: likewise.
        path: its joints, ascending.
        held: those of them whose accelerations are held back, with their first unknowns.
        eliminate: how its unknowns are eliminated.
    """

    number: int
    loops: tuple[CloseLoop, ...]
    couplings: tuple[CloseCoupling, ...]
    path: tuple[int, ...]
    held: dict[int, int]
    eliminate: Eliminate


def closures_in(steps: Iterable[Step]) -> dict[int, ClosureSteps]:
    """Return the closures that steps eliminate, by number."""
    by_number: dict[int, list[Step]] = {}
    for step in steps:
        if isinstance(step, CloseLoop | CloseCoupling | HoldBack | CarryRows | Eliminate):
            by_number.setdefault(step.closure, []).append(step)
    found = {}
    for number, own in by_number.items():
        held = {s.joint: s.first for s in own if isinstance(s, HoldBack)}
        carried = {s.joint for s in own if isinstance(s, CarryRows)}
        for eliminate in own:
            if isinstance(eliminate, Eliminate):
                found[number] = ClosureSteps(
                    number,
                    tuple(s for s in own if isinstance(s, CloseLoop)),
                    tuple(s for s in own if isinstance(s, CloseCoupling)),
                    tuple(sorted(carried.union(held))),
                    held,
                    eliminate,
                )
    return found


def is_rigid(plan: Plan, j: int, held: Collection[int]) -> bool:
    """Return whether all beyond a joint is held back, and so is passed as if it were rigid."""
    return all(c in held and is_rigid(plan, c, held) for c in plan.children[j + 1])


def nature(joint: PlanJoint) -> tuple[object, ...]:
    """Return what joints of a row have in common, whatever the numbers are."""
    effects = (joint.damping, joint.friction, joint.stiffness, joint.rotor_inertia + joint.lent)
    return (joint.kind, joint.prescribed, *map(bool, effects))


def structure(plan: Plan, one: ClosureSteps) -> tuple[object, ...]:
    """Return what closures have in common that can be computed side by side."""
    joints, top = plan.joints, one.eliminate.link
    place = {j: k for k, j in enumerate(one.path)}

    def link(number: int) -> tuple[str, int]:
        if number - 1 in place:
            return "own", place[number - 1]
        # What the ground holds is seen from it: by way of all that is inwards from the top.
        return ("top", 0) if number == top and not one.eliminate.grounded else ("other", number)

    loops = []
    for closing in one.loops:
        loop = plan.loops[closing.loop]
        ends = link(loop.link1), link(loop.link2)
        loops.append((loop.kind, ends, closing.rows, closing.first, bool(loop.turn2)))
    couplings = [
        (tuple(place[j] for j, _ in plan.couplings[c.coupling].terms), c.unknown)
        for c in one.couplings
    ]
    how = one.eliminate
    return (
        tuple((nature(joints[j]), link(joints[j].parent), one.held.get(j)) for j in one.path),
        tuple(loops),
        tuple(couplings),
        (how.moved, how.rows, how.followers, how.singles, how.limit, how.recovers, how.grounded),
    )


def alike_closures(
    plan: Plan, steps: Iterable[Step], counts: Iterable[int]
) -> list[tuple[ClosureSteps, ...]]:
    """Return closures of a process that may go side by side.

    Args:
        plan: the plan.
        steps: those of one of its processes.
        counts: how many may go together.
    """
    found: list[tuple[ClosureSteps, ...]] = []
    pools: dict[object, list[ClosureSteps]] = {}
    for one in closures_in(steps).values():
        if _fits(plan, one):
            pools.setdefault(structure(plan, one), []).append(one)
    for pool in pools.values():
        while pool:
            apart: list[ClosureSteps] = []
            for one in pool:
                if not any(_beyond(plan, one, other) for other in apart):
                    apart.append(one)
            apart.sort(key=lambda one: one.path)
            taken = apart[: max((n for n in counts if n <= len(apart)), default=1)]
            if len(taken) > 1:
                found.append(tuple(taken))
            pool = [one for one in pool if one not in taken]
    return found


def _fits(plan: Plan, one: ClosureSteps) -> bool:
    """Whether all joints of a closure are of kinds that are treated side by side."""
    joints = [plan.joints[j] for j in one.path]
    return all(joint.kind in KINDS and not joint.prescribed for joint in joints)


def _beyond(plan: Plan, one: ClosureSteps, other: ClosureSteps) -> bool:
    """Whether one of two closures hangs on a joint of the other."""
    above, below = plan.paths([one.path[0]]), plan.paths([other.path[0]])
    return not above.isdisjoint(other.path) or not below.isdisjoint(one.path)


def limbs_of(plan: Plan, together: Sequence[ClosureSteps]) -> list[Limbs]:
    """Return the joints of closures that go side by side, chain by chain."""
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
    """Return the closures that limbs take side by side, one for each lane, by the first's number.

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
        row = rows.get(one.path[0], ())
        lanes = tuple(of_joint[j] for j in row if j in of_joint)
        paths = list(zip(*(lane.path for lane in lanes), strict=False))
        whole = len(lanes) == len(row) and len({len(lane.path) for lane in lanes}) == 1
        if (
            len(row) > 1
            and whole
            and all(rows.get(path[0]) == path for path in paths)
            and len({structure(plan, lane) for lane in lanes}) == 1
        ):
            found[one.number] = lanes
    return found
