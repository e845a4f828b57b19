"""Rods split in two halves by a weld, one half on a ball joint.

One half hangs on a ball joint, or on three hinges that make up one, and a weld fixes it to the
other half. The half then is a part of the other link, and the centre of the ball stays in its
place. So the half's body is added to the other link, only the three position rows of the weld are
left, and the rotation of the ball joint is found at the end. The answer is the same, with six
unknowns less.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from adagen.model.kinds import KINDS
from adagen.plan.closure_steps import ClosureSteps
from adagen.plan.steps import CloseLoop, Eliminate
from adagen.plan.types import Plan

PLACES = 3
"""Rows of a weld that are of places; as many others are of turns."""


@dataclass(frozen=True)
class RodHalf:
    """A rod half on a ball joint, which a weld fixes to the other half.

    Attributes:
        closing: states the weld's rows.
        side: which of the weld's two links it is, 0 or 1.
        joints: those of its ball, outwards: one ball joint, or three hinges.
        carrier: the other link.
        turns: unknown forces of the rows of turns.
        freedoms: unknown accelerations of the ball.
        eliminate: how the closure's unknowns are eliminated.
    """

    closing: CloseLoop
    side: int
    joints: tuple[int, ...]
    carrier: int
    turns: tuple[int, ...]
    freedoms: tuple[int, ...]
    eliminate: Eliminate

    @property
    def link(self) -> int:
        """The link itself."""
        return self.joints[-1] + 1


def rod_halves_in(plan: Plan, one: ClosureSteps) -> tuple[RodHalf, ...]:
    """Return the rod halves of a closure; none where constraint forces are requested.

    Args:
        plan: the plan.
        one: what a process does for the closure.
    """
    asked = plan.weighed or plan.loop_forces or plan.slaved or plan.outputs
    if asked or plan.form != "segment" or len(one.held) < len(one.path):
        return ()
    found: list[RodHalf] = []
    links: set[int] = set()
    for closing in one.loops:
        for side in (0, 1):
            half = _rod_half(plan, one, closing, side)
            if half and links.isdisjoint((half.link, half.carrier)):
                found.append(half)
                links.update((half.link, half.carrier))
                break
    return tuple(found)


def _rod_half(plan: Plan, one: ClosureSteps, closing: CloseLoop, side: int) -> RodHalf | None:
    """The rod half at a weld's first or second link, if it is one."""
    loop, how = one.loop(plan, closing.loop), one.eliminate
    if loop.kind != "weld" or len(closing.rows) < 2 * PLACES:
        return None
    link, carrier = loop.links[side], loop.links[1 - side]
    if any(loop.translations[side]) or carrier - 1 not in one.held or link - 1 not in one.held:
        return None
    joints = _ball(plan, link)
    if not joints or not set(joints).issubset(one.held) or carrier - 1 in joints:
        return None
    if not _nothing_else(plan, joints, closing.loop):
        return None
    freedoms = tuple(one.held[j] + k for j in joints for k in range(KINDS[plan.joints[j].kind].nv))
    turns = tuple(closing.first + k for k in range(PLACES, 2 * PLACES))
    if not (set(freedoms).issubset(how.moved) and set(turns).issubset(how.rows)):
        return None
    return RodHalf(closing, side, joints, carrier, turns, freedoms, how)


def _ball(plan: Plan, link: int) -> tuple[int, ...]:
    """The joints of a ball joint at a link's origin: a spherical joint, or three hinges."""
    found: list[int] = []
    while link > 0 and len(found) < PLACES:
        joint = plan.joints[link - 1]
        if joint.kind == "spherical" and not found:
            return (link - 1,)
        if joint.kind != "revolute":
            return ()
        found.insert(0, link - 1)
        if len(found) < PLACES and any(joint.translation):
            return ()
        link = joint.parent
    return tuple(found) if len(found) == PLACES else ()


def _nothing_else(plan: Plan, joints: tuple[int, ...], weld: int) -> bool:
    """Whether only torques of some joints and one weld act on the links beyond them."""
    links = {j + 1 for j in joints}
    own = [plan.joints[j] for j in joints]
    if any(joint.prescribed or joint.rotor_inertia or joint.lent for joint in own):
        return False
    others = [loop for k, loop in enumerate(plan.loops) if k != weld]
    if any(not links.isdisjoint(loop.links) for loop in others):
        return False
    tied = {j for coupling in plan.couplings for j, _ in coupling.terms}
    if not tied.isdisjoint(joints) or any(wrench.link in links for wrench in plan.wrenches):
        return False
    beyond = [set(plan.children[j + 1]) for j in joints]
    if beyond != [*({j} for j in joints[1:]), set()]:
        return False
    return all(_without_mass(plan, j + 1) for j in joints[:-1])


def _without_mass(plan: Plan, link: int) -> bool:
    own = plan.links[link]
    inertial = (own.mass, *own.com, *(x for row in own.tensor for x in row))
    return not any(inertial) and plan.entry_of_parameter("mass", link) is None


def signature_of(halves: Collection[RodHalf], one: ClosureSteps) -> tuple[object, ...]:
    """Return the rod halves of a closure in a form that does not depend on their numbers."""
    place = {j: k for k, j in enumerate(one.path)}
    return tuple(
        (one.loops.index(own.closing), own.side, tuple(place[j] for j in own.joints))
        for own in halves
    )
