"""Points at which welds are formulated: on the axes of adjacent joints.

A weld holds at every point of the two links. Rows at the centre of a ball joint, or on the axis of
a hinge, have no entries for that joint, so the system for the dependent accelerations is block
triangular (adagen/graph/block_triangular.py). A weld stays at its given point if its kept rows
(adagen/plan/independent_coordinates.py) would lose information: if the weld locks a hinge, its
position rows must not be taken on the axis of that hinge, where they do not depend on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from adagen.exact import exact, rounded
from adagen.model import Model
from adagen.model.kinds import KINDS
from adagen.plan.closures import Choice, Closure, closures_of, sampled
from adagen.plan.constants import joints_of, loops_of
from adagen.plan.grounded_closures import grounded_closures_of
from adagen.plan.independent_coordinates import VANISHING
from adagen.plan.loop_groups import freedoms_of, rows_of
from adagen.plan.robot import PlanJoint, PlanLoop

Array = NDArray[np.float64]


def with_points(model: Model) -> tuple[PlanLoop, ...]:
    """Return a robot's loops, welds moved to the end with most dependent freedoms."""
    joints, loops = joints_of(model), loops_of(model)
    found, rows = list(loops), sampled(model)[1] if loops else np.zeros(0)
    ways = (*closures_of(model), *grounded_closures_of(model))
    for closure in closures_of(model):
        moved = set(closure.choices[0].moved)
        for k in closure.loops:
            loop = loops[k]
            if loop.kind == "weld":
                counts = [len(moved.intersection(_turned(joints, link))) for link in loop.links]
                if any(counts):
                    side = counts.index(max(counts))
                    elsewhere = _rows_at_origin(rows, rows_of(model)[k], loop, side)
                    if all(_as_regular(model, one, rows, elsewhere) for one in ways):
                        found[k], rows = _at_origin(loop, side), elsewhere
                        if all(_kept_whole(one, rows_of(model)[k]) for one in ways):
                            found[k] = _along_axes(found[k], side)
    return tuple(found)


def _kept_whole(closure: Closure, own: range) -> bool:
    """Whether a closure keeps all rows of a weld, or none: their axes are then arbitrary."""
    kept = (set(choice.rows).intersection(own) for choice in closure.choices)
    return own[0] not in closure.rows or all(len(rows) == len(own) for rows in kept)


def _along_axes(loop: PlanLoop, side: int) -> PlanLoop:
    """A weld whose rows are along the axes of its first or second link, where these rotate less."""
    turns = [exact(rotation) for rotation in loop.rotations]
    own = exact(np.eye(3)), turns[1 - side].dot(turns[side].T)
    one, two = (_rows(rounded(own[int(k != side)])) for k in (0, 1))
    return replace(loop, rotation1=one, rotation2=two)


def _rows(turn: Array) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(row) for row in turn.tolist())


def _rows_at_origin(samples: Array, own: range, loop: PlanLoop, side: int) -> Array:
    """Return J with a weld's rows as they are in the origin of one of its links.

    A point that is d away in the frame's axes moves by d x w less, w the rows of turns.

    Args:
        samples: J at closed states, shape (S, rows, nv).
        own: the weld's rows: three of places, three of turns.
        loop: the weld, as it is looked at in them.
        side: 0 for its first link, 1 for its second.
    """
    turn, place = loop.rotations[side], loop.translations[side]
    x, y, z = -(np.asarray(place) @ np.asarray(turn))
    result = samples.copy()
    across = np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
    result[:, own[:3]] += np.einsum("ij,sjk->sik", across, samples[:, own[3:]])
    return result


def _as_regular(model: Model, closure: Closure, given: Array, other: Array) -> bool:
    """Whether the kept rows are independent wherever they were for the given loops."""
    path = freedoms_of(model, closure.path)
    return all(
        bool((_regular(choice, path, other) >= _regular(choice, path, given)).all())
        for choice in closure.choices
        if choice.rows
    )


def _regular(choice: Choice, path: Sequence[int], samples: Array) -> NDArray[np.bool_]:
    """Whether the rows of a choice are independent in each state, shape (S,)."""
    rows = samples[:, list(choice.rows)][:, :, list(choice.moved or path)]
    scaled = rows * np.array(choice.scales)[:, None]
    least: NDArray[np.bool_] = np.linalg.svd(scaled, compute_uv=False)[:, -1] > VANISHING
    return least


def _turned(joints: Sequence[PlanJoint], link: int) -> list[int]:
    """Freedoms of the joints that rotate a link about its origin, as entries of v."""
    found: list[int] = []
    while link > 0:
        joint = joints[link - 1]
        kind = KINDS[joint.kind]
        if any(row >= 3 for row in kind.free):
            break
        found += range(joint.v, joint.v + kind.nv)
        if any(joint.translation):
            break
        link = joint.parent
    return found


def _at_origin(loop: PlanLoop, side: int) -> PlanLoop:
    """A weld formulated at the origin of its first or its second link."""
    turns = [exact(rotation) for rotation in loop.rotations]
    places = [exact(loop.translation1), exact(loop.translation2)]
    other = 1 - side
    place = places[other] - turns[other].dot(turns[side].T.dot(places[side]))
    moved = [(0.0, 0.0, 0.0), tuple(float(x) for x in rounded(place))]
    one, two = (moved[int(k != side)] for k in (0, 1))
    return replace(loop, translation1=one, translation2=two)
