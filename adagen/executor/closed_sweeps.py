"""Order of the sweeps of a robot with closed loops, with rows of joints and closures in SIMD lanes.

A row of joints, or closures side by side, wait for everything that any of them waits for. Inwards,
a joint waits for all joints and closures that end at its far link, and a closure for its joints.
Outwards, a joint waits for its near link and its closure, and a closure for its top.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from heapq import heapify, heappop, heappush

from adagen.plan import Plan
from adagen.plan.closure_steps import ClosureSteps
from adagen.plan.order import ends_of
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Eliminate, Release, Step

_Unit = tuple[str, int]
"""What is done at once: a joint or row by its first joint, or closures by the first one."""


def closed_sweep(
    plan: Plan,
    steps: Sequence[tuple[int, Step]],
    closures: Mapping[int, ClosureSteps],
    lead_of: Mapping[int, int],
    all_limbs: Iterable[Limbs],
    *,
    inwards: bool,
) -> list[int]:
    """Return the order of the steps of a sweep, by their indices.

    Args:
        plan: the plan.
        steps: of one sweep, inwards or outwards, with their places.
        closures: the process's closures, by number.
        lead_of: of closures that go side by side, the number of the first.
        all_limbs: which joints share code.
        inwards: whether it is the inward one.

    Raises:
        ValueError: they wait for each other.
    """
    rows = [row for limbs in all_limbs for row in limbs.rows]
    first = {j: row[0] for row in rows for j in row}

    def of_joint(j: int) -> _Unit:
        return "joint", first.get(j, j)

    def of_closure(number: int) -> _Unit:
        return "closure", lead_of.get(number, number)

    units: dict[_Unit, list[tuple[int, Step, int]]] = {}
    hangs_on: set[tuple[_Unit, _Unit]] = set()  # outer, inner
    beyond: dict[int, _Unit] = {}  # the joint or row by which a link is reached from the root
    at_link: list[tuple[_Unit, int]] = []  # what hangs on a link
    for place, step in steps:
        if isinstance(step, Eliminate | Release):
            unit, member = of_closure(step.closure), step.closure
            hangs_on.update((of_joint(j), unit) for j in closures[step.closure].path)
            at_link.append((unit, step.link))
        else:
            member = step.joint  # type: ignore[union-attr]
            unit = of_joint(member)
            ends = ends_of(plan.joints, member, getattr(step, "reversed", False))
            beyond[ends.far] = unit
            at_link.append((unit, ends.near))
        units.setdefault(unit, []).append((place, step, member))
    hangs_on.update((unit, beyond[link]) for unit, link in at_link if link in beyond)
    for unit, lanes in (
        *((of_joint(row[0]), set(row)) for row in rows),
        *((of_closure(k), {n for n, lead in lead_of.items() if lead == k}) for k in lead_of),
    ):
        if unit in units and lanes - {member for _, _, member in units[unit]}:
            raise ValueError("lanes are in different sweeps")
    pairs = hangs_on if inwards else {(inner, outer) for outer, inner in hangs_on}
    order = _ordered({unit: own[0][0] for unit, own in units.items()}, pairs)
    return [place for unit in order for place, _, member in units[unit] if member == unit[1]]


def _ordered(units: Mapping[_Unit, int], pairs: Iterable[tuple[_Unit, _Unit]]) -> list[_Unit]:
    """Units in an order that satisfies all dependencies, otherwise by index.

    Args:
        units: with the places that they would have.
        pairs: what is waited for, and what waits for it; others than these units are there.
    """
    waiting = dict.fromkeys(units, 0)
    followers: dict[_Unit, list[_Unit]] = {}
    for before, after in pairs:
        if before in units and after in units:
            waiting[after] += 1
            followers.setdefault(before, []).append(after)
    ready = [(place, unit) for unit, place in units.items() if not waiting[unit]]
    heapify(ready)
    found: list[_Unit] = []
    while ready:
        _, unit = heappop(ready)
        found.append(unit)
        for after in followers.get(unit, ()):
            waiting[after] -= 1
            if not waiting[after]:
                heappush(ready, (units[after], after))
    if len(found) < len(units):
        raise ValueError("lanes wait for each other")
    return found
