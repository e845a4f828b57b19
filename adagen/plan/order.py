"""In which order joints are swept, single ones and limbs side by side.

A sweep inwards takes limbs from their outermost joints on, and adds what it finds to the links that
they hang on; one outwards takes to each link what its joints need of it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from adagen.plan.abreast import Limbs
from adagen.plan.types import PlanJoint

Unit = Limbs | int
"""What is passed at once: limbs, or a single joint."""


@dataclass(frozen=True)
class Ends:
    """The near and the far link of a joint, seen from the root of its sweep."""

    near: int
    far: int


def ends_of(joints: Sequence[PlanJoint], joint: int, turned: bool = False) -> Ends:
    """Return a joint's ends; ``turned`` where the child link is the near one."""
    parent, child = joints[joint].parent, joint + 1
    return Ends(child, parent) if turned else Ends(parent, child)


def inward_order(sweep: Mapping[int, Ends], limbs: Iterable[Limbs]) -> list[Unit]:
    """Return joints swept inwards as units, in an order in which that can be done.

    Args:
        sweep: the joints, in their plan's order.
        limbs: those to be taken side by side; ones that are not in the sweep are left out.
    """
    given = Counter(ends.near for ends in sweep.values())
    return _ordered(sweep, limbs, given, {j: (e.far, e.near) for j, e in sweep.items()})


def outward_order(sweep: Mapping[int, Ends], limbs: Iterable[Limbs]) -> list[Unit]:
    """Return joints swept outwards as units likewise."""
    given = Counter(ends.far for ends in sweep.values())
    return _ordered(sweep, limbs, given, {j: (e.near, e.far) for j, e in sweep.items()})


def _ordered(
    sweep: Mapping[int, Ends],
    limbs: Iterable[Limbs],
    open_: Counter[int],
    links: Mapping[int, tuple[int, int]],
) -> list[Unit]:
    """Units whose links are complete, the earliest in the sweep first.

    ``links`` tells of each joint the link that must be complete before and the one that it adds to;
    ``open_`` how many joints add to a link.
    """
    taken = [each for each in limbs if each.rows[0][0] in sweep]
    unit_of: dict[int, Unit] = {j: each for each in taken for j in each.members()}
    waiting = list(dict.fromkeys(unit_of.get(j, j) for j in sweep))
    found: list[Unit] = []
    while waiting:
        unit = next(u for u in waiting if _ready(u, open_, links))
        waiting.remove(unit)
        found.append(unit)
        for j in _joints_in(unit):
            open_[links[j][1]] -= 1
    return found


def _joints_in(unit: Unit) -> list[int]:
    """Return the joints of a unit."""
    return [unit] if isinstance(unit, int) else list(unit.members())


def _ready(unit: Unit, open_: Counter[int], links: Mapping[int, tuple[int, int]]) -> bool:
    """Whether all that adds to the links that a unit needs is done, or in the unit itself."""
    own = Counter(links[j][1] for j in _joints_in(unit))
    return all(open_[link] == own[link] for link, _ in (links[j] for j in _joints_in(unit)))
