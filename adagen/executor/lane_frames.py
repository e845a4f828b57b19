"""Link frames chosen so that the constants of limbs in lanes have the same structure.

Each joint's axis is z of its child link's frame, so the frame may still be rotated about it.
Quarter turns round nothing. Where the constants of all lanes have zeros and ones at the same
places, the operations that these save for one limb are saved for all. Where the joints' rotations
have none in common, each link's x axis is put perpendicular to its own joint axis and the next one:
the rotation between them is then one about x and one about z, and the joint's own angle takes up
the latter (Denavit and Hartenberg 1955).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from adagen.exact import Exact, exact, identity, rotated_inertia, rounded
from adagen.plan import Plan
from adagen.plan.robot import PlanJoint, PlanLink, PlanLoop, PlanOutput, PlanWrench
from adagen.plan.simd_groups import Limbs

Array = NDArray[np.float64]
_Part = tuple[PlanJoint, PlanLink]
"""A joint and its child link."""
_TURNS = tuple(
    np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    for c, s in ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
)
_TURNABLE = ("revolute", "prismatic")
_PATTERN = 1000  # what a rotation without a common lone entry weighs, beside
_ZERO = 10  # an entry that is zero in one limb only, and one of a rotation that differs


def aligned(plan: Plan, all_limbs: Iterable[Limbs]) -> Plan:
    """Return the same plan with link frames of limbs rotated so that their rows agree best.

    Joint coordinates keep their meaning. Who is turned are all limbs but one, which has most in
    common with the others as they are.
    """
    quarters: dict[int, int] = {}
    all_limbs = tuple(all_limbs)
    for limbs in all_limbs:
        for _, turns in _quarters(plan, limbs):
            quarters.update(turns)
    plan = _turned(plan, {j: exact(_TURNS[k]) for j, k in quarters.items() if k})
    return _across_axes(plan, all_limbs)


def _across_axes(plan: Plan, all_limbs: Iterable[Limbs]) -> Plan:
    """A plan where rotations in one row, if they have no lone entry in common, are R_x R_z.

    Such a rotation has a zero where the joint's axis has its x in the parent link's frame.
    """
    turns: dict[int, Exact] = {}
    oblique: set[int] = set()
    for limbs in all_limbs:
        for near, row in pairwise(limbs.rows):
            rotations = [np.array(plan.joints[j].rotation) for j in row]
            kinds = plan.joints[near[0]].kind, plan.joints[row[0]].kind
            if kinds[0] not in _TURNABLE or kinds[1] != "revolute":
                continue
            if not set.intersection(*map(_lone, rotations)):
                oblique.update(row)
                turns.update(zip(near, map(_across, rotations), strict=True))
    plan = _turned(plan, turns)
    joints = [
        replace(joint, rotation=_without_x(joint.rotation)) if j in oblique else joint
        for j, joint in enumerate(plan.joints)
    ]
    return replace(plan, joints=tuple(joints))


def _across(rotation: Array) -> Exact:
    """The turn about z after which the third column has no first entry."""
    x, y = exact(rotation[:2, 2])
    if x == 0:
        return identity()
    length = (x * x + y * y).sqrt() * (-1 if y > 0 else 1)
    result = identity()
    result[0, 0] = result[1, 1] = -y / length
    result[1, 0], result[0, 1] = x / length, -x / length
    return result


def _without_x(rotation: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
    """A rotation whose entry of the first row and third column, zero but for rounding, is zero."""
    first, *others = rotation
    return ((*first[:2], 0.0), *others)


def unlike(plan: Plan, limbs: Limbs) -> int:
    """Return how much the constants of limbs differ in structure after the best rotations."""
    return sum(cost for cost, _ in _quarters(plan, limbs))


def _quarters(plan: Plan, limbs: Limbs) -> list[tuple[int, dict[int, int]]]:
    """The quarter turns of each limb's links, and the remaining differences from the model limb."""
    chains = list(zip(*limbs.rows, strict=True))
    parts = [tuple((plan.joints[j], plan.links[j + 1]) for j in chain) for chain in chains]
    offers = [[_best_turns(part, model) for part in parts] for model in parts]
    best = min(offers, key=lambda offer: sum(cost for cost, _ in offer))
    return [
        (cost, dict(zip(chain, turns, strict=True)))
        for chain, (cost, turns) in zip(chains, best, strict=True)
    ]


@lru_cache(maxsize=4096)  # all plans of a robot have the same limbs
def _best_turns(chain: Sequence[_Part], model: Sequence[_Part]) -> tuple[int, tuple[int, ...]]:
    """The least differences between a chain and a model, and the quarter turns that give them."""
    least: dict[int, tuple[int, tuple[int, ...]]] = {0: (0, ())}  # by the turn of the last link
    for part, other in zip(chain, model, strict=True):
        turns = range(4) if part[0].kind in _TURNABLE else range(1)
        reached: dict[int, tuple[int, tuple[int, ...]]] = {}
        for turn in turns:
            offers = [
                (cost + _difference(part, other, before, turn), (*chosen, turn))
                for before, (cost, chosen) in least.items()
            ]
            reached[turn] = min(offers, key=lambda offer: offer[0])
        least = reached
    return min(least.values(), key=lambda offer: offer[0])


def _difference(part: _Part, other: _Part, before: int, turn: int) -> int:
    """Differences of a joint and its link from others, with rotations before and after."""
    (rotation, zeros, lone), model = _structure(part, before, turn), _structure(other, 0, 0)
    unlike = _PATTERN * (bool(model[2]) and not model[2] & lone)
    apart = np.count_nonzero(zeros != model[1]), np.count_nonzero(rotation != model[0])
    return unlike + _ZERO * int(apart[0]) + int(apart[1])


@lru_cache(maxsize=8192)
def _structure(
    part: _Part, before: int, turn: int
) -> tuple[Array, NDArray[np.bool_], set[tuple[int, int, float]]]:
    """A joint's rotation, the zeros of all constants, and the rotation's lone entries.

    The links before and after the joint are turned.
    """
    near, own = _TURNS[before].T, _TURNS[turn]
    joint, link = part
    rotation = near @ np.array(joint.rotation) @ own
    numbers = [
        rotation.ravel(),
        near @ np.array(joint.translation),
        own.T @ np.array(link.com),
        (own.T @ np.array(link.tensor) @ own).ravel(),
    ]
    return rotation, np.concatenate(numbers) == 0, _lone(rotation)


def _lone(rotation: Array) -> set[tuple[int, int, float]]:
    """Entries that are 1 or -1 to the bit, alone in their row and column."""
    return {
        (m, c, float(rotation[m, c]))
        for m in range(3)
        for c in range(3)
        if abs(rotation[m, c]) == 1
        and np.count_nonzero(rotation[m]) == np.count_nonzero(rotation[:, c]) == 1
    }


def _turned(plan: Plan, turns: Mapping[int, Exact]) -> Plan:
    """A plan with the frames of some joints' child links rotated, each number rounded once."""
    if not turns:
        return plan
    links = {j + 1: turn for j, turn in turns.items()}
    return replace(
        plan,
        links=tuple(
            _link(link, links[k]) if k in links else link for k, link in enumerate(plan.links)
        ),
        joints=tuple(_joint(joint, j, links) for j, joint in enumerate(plan.joints)),
        wrenches=tuple(_placed(wrench, links) for wrench in plan.wrenches),
        loops=tuple(_loop(loop, links) for loop in plan.loops),
        outputs=tuple(_placed(output, links) for output in plan.outputs),
        parameters=tuple(
            replace(
                parameter,
                turn=_rows(links[parameter.link].T.dot(exact(parameter.turn or identity()))),
            )
            if parameter.link in links and parameter.what == "center"
            else parameter
            for parameter in plan.parameters
        ),
    )


_Placed = TypeVar("_Placed", PlanWrench, PlanOutput)


def _placed(item: _Placed, links: Mapping[int, Exact]) -> _Placed:
    """A loop, output or wrench with its frame on a rotated link."""
    if item.link not in links:
        return item
    turn = links[item.link].T
    return replace(
        item,
        rotation=_rows(turn.dot(exact(item.rotation))),
        translation=_vector(turn.dot(exact(item.translation))),
    )


def _joint(joint: PlanJoint, j: int, links: Mapping[int, Exact]) -> PlanJoint:
    if joint.parent not in links and j + 1 not in links:
        return joint
    near, own = links.get(joint.parent, identity()), links.get(j + 1, identity())
    return replace(
        joint,
        rotation=_rows(near.T.dot(exact(joint.rotation)).dot(own)),
        translation=_vector(near.T.dot(exact(joint.translation))),
    )


def _loop(loop: PlanLoop, links: Mapping[int, Exact]) -> PlanLoop:
    turns = [links.get(link, identity()).T for link in loop.links]
    rotations = [_rows(x.dot(exact(y))) for x, y in zip(turns, loop.rotations, strict=True)]
    places = [_vector(x.dot(exact(y))) for x, y in zip(turns, loop.translations, strict=True)]
    return replace(
        loop,
        rotation1=rotations[0],
        translation1=places[0],
        rotation2=rotations[1],
        translation2=places[1],
    )


def _link(link: PlanLink, turn: Exact) -> PlanLink:
    """A link whose frame is rotated; it is no handle, so its mobility is not needed."""
    return replace(
        link,
        com=_vector(turn.T.dot(exact(link.com))),
        tensor=_rows(rotated_inertia(turn.T, exact(link.tensor))),
        tensor_inverse=(),
        phi=(),
    )


def _rows(matrix: Exact) -> tuple[tuple[float, ...], ...]:
    return tuple(map(tuple, rounded(matrix).tolist()))


def _vector(vector: Exact) -> tuple[float, ...]:
    return tuple(rounded(vector).tolist())
