"""What limbs take for moving as one body with a link whose acceleration is another than theirs.

Processes that share a bound of errors find the accelerations of links that they share each by
itself. By the difference the limbs of such a link move as one body, joints as they are.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import fsum  # as sum is rounded differently by Python before 3.12, and this is emitted

from adagen.model.kinds import KINDS
from adagen.plan.steps import Articulate, HoldMobility, Send, Step
from adagen.plan.types import Plan

LONGEST = 8
"""Vectors on a path that the squares of its joints' offsets bound a distance by. They are that many
times too large where limbs are coiled up; of longer ones distances are found at run time."""


@dataclass(frozen=True)
class Spread:
    """Energy bounds of a link's limbs for a different acceleration of the link, joints as they are.

    Of a difference of its angular acceleration x and of its linear one y, at most
    turning |x|^2 + sliding |y|^2, kg m^2 and kg.

    Attributes:
        turning: the constant part.
        along: entries of q that are distances, and what their squares are multiplied by; these come
            to turning.
        sliding: the constant part.
        distances: links, ascending, and what the squares of their distances from the link are
            multiplied by; these come to turning.
        hears: whether limbs of other processes come to it, as these tell.
    """

    turning: float
    along: tuple[tuple[int, float], ...]
    sliding: float
    distances: tuple[tuple[int, float], ...] = ()
    hears: bool = False


def spread(plan: Plan, joints: Iterable[int], link: int) -> Spread:
    """Return the energy bounds for joints that are limbs of a link, and that a process sweeps."""
    order, longest = _limbs(plan, joints, link)
    return _by_offsets(plan, order, longest) if longest <= LONGEST else _by_distances(plan, order)


def spread_beyond(plan: Plan, steps: Iterable[Step], link: int) -> Spread:
    """Return those for everything beyond a held link, from the steps of process 0."""
    steps = list(steps)
    order, longest = _limbs(plan, beyond_held(plan, steps), link)
    if longest <= LONGEST:
        return _by_offsets(plan, order, longest)
    own = {step.joint for step in steps if isinstance(step, Articulate)}
    return _by_distances(plan, [j for j in order if j in own], hears=True)


def _limbs(plan: Plan, joints: Iterable[int], link: int) -> tuple[list[int], int]:
    """The joints beyond a link among some, and how many vectors a link's centre there is a sum of.

    Parents come before their children.
    """
    depth, order = {link: 0}, []
    for j in sorted(joints):
        if plan.joints[j].parent in depth:
            depth[j + 1] = depth[plan.joints[j].parent] + 1
            order.append(j)
    return order, max(depth.values()) + 1


def _by_offsets(plan: Plan, order: list[int], longest: int) -> Spread:
    """Bounds by the offsets of joints.

    A link at p with its centre of mass at p + c takes m |y + x cross (p + c)|^2 and its rotation,
    and the n vectors that p + c is a sum of are no longer together than n times their squares.
    """
    mass = {j + 1: plan.links[j + 1].mass for j in order}
    turning, along = 0.0, []
    for j in reversed(order):
        joint = plan.joints[j]
        if joint.parent in mass:
            mass[joint.parent] += mass[j + 1]
        turning += _own_turning(plan, j + 1, longest)
        slides = sum(place >= 3 for place in KINDS[joint.kind].free)
        fixed = 2 * longest * mass[j + 1] * (2 if slides else 1)
        turning += fixed * fsum(x * x for x in joint.translation)
        along += [(joint.q + k, fixed) for k in range(slides)]
    return Spread(turning, tuple(along), 2 * fsum(plan.links[j + 1].mass for j in order))


def _by_distances(plan: Plan, order: list[int], *, hears: bool = False) -> Spread:
    """Bounds by the distances d of links.

    What takes at most K |x|^2 + M |y|^2 of its own acceleration takes at most (K + 2 M d^2) |x|^2 +
    2 M |y|^2 of that of a body that it is a part of, at a distance d from there.
    """
    turning = fsum(_own_turning(plan, j + 1, 1) for j in order)
    masses = [(j + 1, 4 * plan.links[j + 1].mass) for j in order]
    return Spread(turning, (), fsum(mass for _, mass in masses), tuple(masses), hears)


def _own_turning(plan: Plan, link: int, count: int) -> float:
    """What a link takes for turning about a place, but for its distance; ``count``: of vectors."""
    own = plan.links[link]
    inertia = fsum(own.tensor[k][k] for k in range(3))
    return inertia + 2 * count * own.mass * fsum(x * x for x in own.com)


def beyond_held(plan: Plan, steps: Iterable[Step]) -> list[int]:
    """Return the joints beyond a process's path from the ground to a link, ascending.

    That is a link that is held, or the root, whose mobility it tells others of.
    """
    near: set[int] = set()
    for step in steps:
        if isinstance(step, HoldMobility | Send):
            break
        if isinstance(step, Articulate):
            near.add(step.joint)
    return [j for j in range(len(plan.joints)) if j not in near]
