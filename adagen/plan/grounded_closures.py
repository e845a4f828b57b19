"""Closures that include the ground, eliminated at the first link beyond which joints can follow.

For a foot on the ground, or a chain pinned at both ends, the loop's rows depend on the joints
between the ground and some link only through the acceleration a of that link, the top. If the
joints beyond it can follow, z = G y + A a + g, the closure is eliminated at this top, and above it
there is a tree. Two feet are two small closures then, not one of the whole robot.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from adagen.model import Model
from adagen.model.paths import path_to_ground
from adagen.plan.closures import (
    MOST_HELD,
    Closure,
    closure_of,
    closures_of,
    depths_of,
    inertias_of,
    sampled,
    sampled_rows,
    with_choices,
)
from adagen.plan.independent_coordinates import LARGE, expected, largest, offers_of, uncovered
from adagen.plan.loop_groups import LoopGroup, connected, loop_paths

Array = NDArray[np.float64]

POOR = 0.04
"""The part of closed states in which what follows may be found poorly, and all is done again; more
where it is as often so without ending early."""
BESIDE = 6
"""Freedoms inwards from the top that stand for its acceleration."""


@lru_cache(maxsize=4)
def grounded_closures_of(model: Model) -> tuple[Closure, ...]:
    """Return a robot's closures, those with the ground eliminated as early as possible.

    None where no loop reaches the ground, or none can end before it.

    Raises:
        InputError: as ``closures_of``.
    """
    if not any(0 in loop.links for loop in model.loops):
        return ()
    _, samples = sampled(model)
    tied = loop_paths(model)
    left = list(range(len(tied)))
    found: list[tuple[LoopGroup, Closure]] = []
    poor = _poor_parts(model, samples)
    for k in sorted(_grounded(model), key=lambda k: (-len(tied[k][1]), k)):
        if k in left and (one := _earliest(model, tied, left, k, samples, poor[k])):
            found.append(one)
            left = [other for other in left if other not in one[0].members]
    if not found:
        return ()
    rest = [(one, with_choices(model, one, samples)) for one in connected(model, tied, left)]
    every = sorted((*found, *rest), key=lambda pair: (-pair[0].top, pair[0].members))
    return tuple(closure for _, closure in every)


def _poor_parts(model: Model, samples: Array) -> dict[int, float]:
    """For each loop, the share of closed states in which its elimination may be poor."""
    found = {}
    for one, closure in zip(connected(model, loop_paths(model)), closures_of(model), strict=True):
        first, poor = closure.choices[0], POOR
        if len(closure.choices) > 1:
            rows = sampled_rows(model, one, samples)
            moved = tuple(rows.columns.index(c) for c in first.moved)
            offer = moved, tuple(rows.rows.index(r) for r in first.rows)
            losses = largest(offer, rows.own)
            poor = max(poor, float((losses > LARGE).mean()))
        found.update(dict.fromkeys(one.members, poor))
    return found


def _grounded(model: Model) -> list[int]:
    """Loops between a link and the ground."""
    return [k for k, loop in enumerate(model.loops) if 0 in loop.links]


def _earliest(
    model: Model,
    tied: Sequence[tuple[int, set[int]]],
    left: Sequence[int],
    k: int,
    samples: Array,
    poor: float,
) -> tuple[LoopGroup, Closure] | None:
    """The smallest closure of a loop to the ground that can be eliminated early."""
    loop = model.loops[k]
    way = path_to_ground(model.joints, loop.link1 or loop.link2)
    tried: set[LoopGroup] = set()
    for count in range(1, len(way)):
        one = _within(model, tied, left, k, way[:count])
        if one is None or one in tried:
            continue
        tried.add(one)
        if sum(model.joints[j].kind.nv for j in one.path) > MOST_HELD:
            return None
        if (closure := _ending_early(model, one, samples, poor)) is not None:
            return one, closure
    return None


def _within(
    model: Model,
    tied: Sequence[tuple[int, set[int]]],
    left: Sequence[int],
    k: int,
    joints: Sequence[int],
) -> LoopGroup | None:
    """The loops connected with a loop beyond the nearest of some joints; None if not closed.

    Rows of all of them depend on joints beyond the top, and on its acceleration: a loop between two
    limbs that are each on the ground depends on the joints of both.
    """
    top = model.joints[joints[-1]].parent
    inwards = set(path_to_ground(model.joints, top))
    members, path = {k}, set(joints)
    while True:
        touched = [m for m in left if m not in members and tied[m][1] & path]
        if not touched:
            break
        for m in touched:
            beyond = {j for j in tied[m][1] if top in _links_above(model, j)}
            if not tied[m][1] - beyond <= (set() if tied[m][0] else inwards):
                return None
            members.add(m)
            path |= beyond
    return LoopGroup(top, tuple(sorted(members)), tuple(sorted(path)))


def _links_above(model: Model, joint: int) -> list[int]:
    """Links on the path from a joint to the ground."""
    return [model.joints[j].parent for j in path_to_ground(model.joints, joint + 1)]


def _ending_early(model: Model, one: LoopGroup, samples: Array, poor: float) -> Closure | None:
    """A closure whose rows the joints beyond its top can satisfy in most poses."""
    rows = sampled_rows(model, one, samples)
    inwards = [
        model.v_start[j] + i
        for j in path_to_ground(model.joints, one.top)
        for i in range(model.joints[j].kind.nv)
    ]
    columns = [*rows.columns, *inwards]
    matrices = rows.values[:, :, columns]
    counted = range(len(rows.columns) + BESIDE)
    offers = [
        offer for offer in offers_of(rows.own, depths_of(model, one.path), whole=True) if offer[0]
    ]
    pattern = np.abs(matrices[:, :, : len(counted)]).max(axis=0) > 0.0
    losses = [largest(offer, matrices, counted) for offer in offers]
    light = uncovered(offers, rows.own, inertias_of(model, rows.columns))
    fine = [k for k in light if float((losses[k] > LARGE).mean()) <= poor]
    if not fine:
        return None
    best = min(fine, key=lambda k: expected(offers[k], pattern, losses[k]))
    return closure_of(model, one, rows.rows, [rows.choice(*offers[best])], whole=True)
