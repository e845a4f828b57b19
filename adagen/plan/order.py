"""Order of joints in a sweep, single joints and limbs side by side.

An inward sweep takes limbs from their outermost joints on, and adds the results to the links that
they are attached to. An outward sweep takes a link's data before that of its joints.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from heapq import heappop, heappush
from typing import NamedTuple

from adagen.plan.robot import PlanJoint
from adagen.plan.simd_groups import Limbs

Unit = Limbs | int
"""What is passed at once: limbs, or a single joint."""


class Ends(NamedTuple):
    """The near and the far link of a joint, seen from the root of its sweep."""

    near: int
    far: int


def ends_of(joints: Sequence[PlanJoint], joint: int, backwards: bool = False) -> Ends:
    """Return a joint's ends; ``backwards`` where the child link is the near one."""
    parent, child = joints[joint].parent, joint + 1
    return Ends(child, parent) if backwards else Ends(parent, child)


def inward_order(sweep: Mapping[int, Ends], limbs: Iterable[Limbs]) -> list[Unit]:
    """Return joints of an inward sweep as units, in a possible order.

    Args:
        sweep: the joints, in their plan's order.
        limbs: those to be computed side by side; ones that are not in the sweep are left out.

    Raises:
        ValueError: limbs wait for each other.
    """
    links = tuple([(ends.far, ends.near) for ends in sweep.values()])
    return list(_ordered(tuple(sweep), links, tuple(limbs)))


def outward_order(sweep: Mapping[int, Ends], limbs: Iterable[Limbs]) -> list[Unit]:
    """Return joints of an outward sweep as units, in a possible order.

    Raises:
        ValueError: limbs wait for each other.
    """
    links = tuple([(ends.near, ends.far) for ends in sweep.values()])
    return list(_ordered(tuple(sweep), links, tuple(limbs)))


@lru_cache(maxsize=64)  # a sweep's order is asked for several times where its program is priced
def _ordered(
    sweep: tuple[int, ...], ends: tuple[tuple[int, int], ...], limbs: tuple[Limbs, ...]
) -> tuple[Unit, ...]:
    """Units whose links are complete, the earliest in the sweep first.

    Args:
        sweep: the joints.
        ends: of each joint the link that must be complete before, and the one that it adds to.
        limbs: those to be computed side by side, if they are in the sweep.

    Raises:
        ValueError: limbs wait for each other.
    """
    links = dict(zip(sweep, ends, strict=True))
    open_ = Counter([link for _, link in ends])  # how many joints add to a link
    units, members = _units(sweep, [each for each in limbs if each.rows[0][0] in links])
    needing: dict[int, list[int]] = {}  # by link, the places of the units that wait for it
    waiting: list[int] = []  # for how many joints of other units each unit waits
    for place, joints in enumerate(members):
        own = [links[j] for j in joints]
        needed = {link for link, _ in own}
        for link in needed:
            needing.setdefault(link, []).append(place)
        within = sum(link in needed for _, link in own)
        waiting.append(sum(open_.get(link, 0) for link in needed) - within)
    ready = [place for place, count in enumerate(waiting) if not count]
    found: list[Unit] = []
    while ready:
        next_ = heappop(ready)
        found.append(units[next_])
        for j in members[next_]:
            for place in needing.get(links[j][1], ()):
                waiting[place] -= 1
                if not waiting[place]:
                    heappush(ready, place)
    if len(found) < len(units):
        raise ValueError("limbs wait for each other")
    return tuple(found)


def _units(sweep: Iterable[int], limbs: Sequence[Limbs]) -> tuple[list[Unit], list[Sequence[int]]]:
    """Return joints as units, in their order, and the joints of each."""
    number_of = {j: number for number, each in enumerate(limbs) for j in each.members()}
    units: list[Unit] = []
    members: list[Sequence[int]] = []
    seen: set[int] = set()
    for j in sweep:
        number = number_of.get(j)
        if number is None:
            units.append(j)
            members.append((j,))
        elif number not in seen:
            seen.add(number)
            units.append(limbs[number])
            members.append(list(limbs[number].members()))
    return units, members
