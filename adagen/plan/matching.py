"""Correspondence between the joints and links of two similar closures.

Joints may be in a different order, and so may the two links of a weld, as in mirrored legs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import islice

from adagen.model.kinds import KINDS
from adagen.plan.closure_steps import ClosureSteps, nature
from adagen.plan.split_rods import rod_halves_in, signature_of
from adagen.plan.steps import CloseLoop, Eliminate
from adagen.plan.types import Plan

MOST_TRIED = 64
"""Ways to put the joints of two closures beside each other that are tried."""


def matching(plan: Plan, lead: ClosureSteps, other: ClosureSteps) -> ClosureSteps | None:
    """Return a closure in the order of a similar one; None if it is not similar.

    Args:
        plan: the plan.
        lead: the other closure.
        other: the closure.
    """
    if len(lead.path) != len(other.path) or len(lead.loops) != len(other.loops):
        return None
    straight = relabelled(plan, lead, other, dict(zip(lead.path, other.path, strict=True)))
    if straight is not None:
        return straight
    found = (relabelled(plan, lead, other, joints) for joints in _joint_maps(plan, lead, other))
    return next((one for one in islice(found, MOST_TRIED) if one is not None), None)


def relabelled(
    plan: Plan, lead: ClosureSteps, other: ClosureSteps, joints: Mapping[int, int]
) -> ClosureSteps | None:
    """Return a closure in the order, and with the unknowns' numbers, of a similar one.

    Args:
        plan: the plan.
        lead: the other closure.
        other: the closure.
        joints: its joint for each of the other one's.

    Returns:
        None where they are not alike.
    """
    if other is lead:
        return lead if all(j == own for j, own in joints.items()) else None
    if set(joints.values()) != set(other.path) or len(lead.couplings) != len(other.couplings):
        return None
    numbers = {
        other.held[joints[j]] + k: first + k
        for j, first in lead.held.items()
        if joints[j] in other.held
        for k in range(KINDS[plan.joints[j].kind].nv)
    }
    loops, exchanged = [], set()
    for closing in lead.loops:
        like = _loop_like(plan, lead, other, closing, joints)
        if like is None or like[0].rows != closing.rows or like[0] in loops:
            return None
        loops.append(like[0])
        exchanged |= {like[0].loop} if like[1] else set()
        numbers.update((like[0].first + k, closing.first + k) for k in range(len(closing.rows)))
    couplings = []
    for coupling, like_it in zip(lead.couplings, other.couplings, strict=True):
        couplings.append(replace(like_it, unknown=coupling.unknown))
        if like_it.unknown is not None and coupling.unknown is not None:
            numbers[like_it.unknown] = coupling.unknown
    eliminate = _with_numbers(other.eliminate, lead.eliminate, numbers)
    if eliminate is None:
        return None
    found = ClosureSteps(
        other.number,
        tuple(
            replace(own, first=closing.first)
            for own, closing in zip(loops, lead.loops, strict=True)
        ),
        tuple(couplings),
        tuple(joints[j] for j in lead.path),
        {joints[j]: first for j, first in lead.held.items()},
        eliminate,
        frozenset(exchanged),
    )
    return found if _structure(plan, found) == _structure(plan, lead) else None


def _with_numbers(own: Eliminate, lead: Eliminate, numbers: Mapping[int, int]) -> Eliminate | None:
    """An elimination with other numbers; None if it then differs from the given one."""
    for name in ("moved", "rows", "followers", "singles"):
        mapped = [numbers.get(u, -1) for u in getattr(own, name)]
        if sorted(mapped) != sorted(getattr(lead, name)):
            return None
    scale_of = {numbers[u]: scale for u, scale in zip(own.rows, own.scales, strict=True)}
    return replace(
        own,
        moved=lead.moved,
        rows=lead.rows,
        scales=tuple(scale_of[u] for u in lead.rows),
        followers=lead.followers,
        singles=lead.singles,
    )


def _loop_like(
    plan: Plan,
    lead: ClosureSteps,
    other: ClosureSteps,
    closing: CloseLoop,
    joints: Mapping[int, int],
) -> tuple[CloseLoop, bool] | None:
    """A loop between the links that correspond to another's, and whether they are exchanged."""
    loop = plan.loops[closing.loop]
    ends = [_link_like(lead, other, link, joints) for link in loop.links]
    for each in other.loops:
        like = plan.loops[each.loop]
        if like.kind == loop.kind and list(like.links) == ends:
            return each, False
        if like.kind == loop.kind == "weld" and list(reversed(like.links)) == ends:
            return each, True
    return None


def _link_like(
    lead: ClosureSteps, other: ClosureSteps, link: int, joints: Mapping[int, int]
) -> int | None:
    """The link of a closure that corresponds to another's; None if that is not known yet."""
    if link - 1 in lead.path:
        return joints[link - 1] + 1 if link - 1 in joints else None
    at_top = link == lead.eliminate.link and not lead.eliminate.grounded
    return other.eliminate.link if at_top else link


def _joint_maps(plan: Plan, lead: ClosureSteps, other: ClosureSteps) -> Iterator[dict[int, int]]:
    """Yield maps from one closure's joints to the other's that preserve tree and loops."""
    labels = _labels(plan, lead), _labels(plan, other)

    def parent(j: int) -> int:
        return plan.joints[j].parent

    def extend(joints: dict[int, int], place: int) -> Iterator[dict[int, int]]:
        if place == len(lead.path):
            yield dict(joints)
            return
        j = lead.path[place]
        near = _link_like(lead, other, parent(j), joints)
        for each in other.path:
            fits = labels[0][j] == labels[1][each] and parent(each) == near
            if fits and each not in joints.values():
                joints[j] = each
                if all(_may_be(plan, lead, other, closing, joints) for closing in lead.loops):
                    yield from extend(joints, place + 1)
                del joints[j]

    return extend({}, 0)


def _may_be(
    plan: Plan,
    lead: ClosureSteps,
    other: ClosureSteps,
    closing: CloseLoop,
    joints: Mapping[int, int],
) -> bool:
    """Whether a loop has a counterpart, or may have once more joints are known."""
    loop = plan.loops[closing.loop]
    ends = [_link_like(lead, other, link, joints) for link in loop.links]
    return None in ends or _loop_like(plan, lead, other, closing, joints) is not None


def _labels(plan: Plan, one: ClosureSteps) -> dict[int, object]:
    """Properties that corresponding joints share: their own, and those of the joints beyond."""
    moved, found = set(one.eliminate.moved), dict[int, object]()
    for j in reversed(one.path):
        joint = plan.joints[j]
        first = one.held.get(j)
        count = KINDS[joint.kind].nv
        follows = None if first is None else tuple(first + k in moved for k in range(count))
        beyond = sorted(repr(found[c]) for c in plan.children[j + 1] if c in found)
        ends = [plan.loops[c.loop] for c in one.loops]
        at = sorted(loop.kind for loop in ends if j + 1 in loop.links)
        found[j] = (nature(joint), follows, tuple(at), tuple(beyond))
    return found


def _structure(plan: Plan, one: ClosureSteps) -> tuple[object, ...]:
    """The structure that closures must share to be computed side by side."""
    joints, top = plan.joints, one.eliminate.link
    place = {j: k for k, j in enumerate(one.path)}

    def link(number: int) -> tuple[str, int]:
        if number - 1 in place:
            return "own", place[number - 1]
        # What the ground holds is seen from it: by way of all that is inwards from the top.
        return ("top", 0) if number == top and not one.eliminate.grounded else ("other", number)

    loops = []
    for closing in one.loops:
        loop = one.loop(plan, closing.loop)
        ends = tuple(map(link, loop.links))
        loops.append((loop.kind, ends, closing.rows, closing.first, bool(loop.turn2)))
    couplings = [
        (tuple(place[j] for j, _ in plan.couplings[c.coupling].terms), c.unknown)
        for c in one.couplings
    ]
    how = one.eliminate
    return (
        top > 0,  # nothing is handed on to the ground
        tuple((nature(joints[j]), link(joints[j].parent), one.held.get(j)) for j in one.path),
        tuple(loops),
        signature_of(rod_halves_in(plan, one), one),
        tuple(couplings),
        (how.moved, how.rows, how.followers, how.singles, how.limit, how.recovers, how.grounded),
    )
