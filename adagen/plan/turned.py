"""Which joints loops eliminate in their own axes instead of those of the base.

In axes of the base D = s^T A s is known to a unit in the last place of A: log10(tr A / D) digits
are lost. A few configurations show tr A; at the least D is what the bare link has about the axis,
however the joints beyond turn: nothing for a link without inertia (in a wrist of three axes, which
loses the more the nearer it is to gimbal lock). Where tr A exceeds that by more than may be lost,
the joint is eliminated in its own axes, in which D is an entry of the inertia and nothing is left
along the axis; and so are the joints beyond that may come to lie along it, up to the first link
that is solid beside what hangs on it. Where processes are joined, links that are joined bare and
those at the ends of runs joined as one are told in their own axes, too.
"""

from __future__ import annotations

from collections.abc import Iterable, Set
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import KINDS
from adagen.plan.digits import generic_configuration
from adagen.plan.placement import motion_transform, placement
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Articulate, FusedJoin, LinkBias
from adagen.plan.types import FACTORS, Plan, PlanJoint, PlanLink

Array = NDArray[np.float64]
MOST = {"double": 2.0**18, "float": 2.0**10}
"""What tr A / D may be at most in axes of the base: 3e-11, or 6e-5, of D is lost then."""
SEEDS = (1, 2, 3)


@dataclass(frozen=True)
class Side:
    """What a joint sees of the links on one side of it, along its axis.

    Attributes:
        most: trace of their articulated inertia, of its rotational part (kg m^2) or its mass (kg).
        least: what the nearest link alone has along the axis, with the rotor.
    """

    most: float
    least: float


def turned_joints(plan: Plan) -> frozenset[int]:
    """Return the joints of a plan of form segment that are eliminated in their own axes."""
    steps = {
        (step.joint, step.reversed)
        for process in plan.processes
        for step in (*process.steps, *process.recovery)
        if isinstance(step, Articulate)
    }
    most = MOST[FACTORS[plan.scalar]]
    sides = _sides(plan.joints, plan.links)
    beyond: dict[int, list[tuple[int, bool]]] = {}  # by the link that feels a joint
    for j, backwards in steps:
        near = j + 1 if backwards else plan.joints[j].parent
        beyond.setdefault(near, []).append((j, backwards))
    found: set[int] = set()
    todo = [step for step in sorted(steps) if _loses(sides, step, most)]
    seen = set(todo)
    while todo:
        j, backwards = todo.pop()
        if not plan.joints[j].prescribed and plan.joints[j].kind in ("revolute", "prismatic"):
            found.add(j)
        far = plan.joints[j].parent if backwards else j + 1
        if far == 0 or _is_solid(plan.links[far], sides.get((j, backwards)), most):
            continue
        new = [step for step in beyond.get(far, ()) if step not in seen]
        seen.update(new)
        todo += new
    return frozenset(found | _told_at_cuts(plan, {j for j, _ in steps}))


def _told_at_cuts(plan: Plan, articulated: Set[int]) -> set[int]:
    """The joints above bare links that are joined, and above the ends of runs joined as one.

    What is told of such links keeps its digits in their own axes only: constants, and mobilities
    of which the run takes away the larger part.
    """
    found: set[int] = set()
    for step in (step for process in plan.processes for step in process.steps):
        if isinstance(step, LinkBias):
            found.add(step.link - 1)
        elif isinstance(step, FusedJoin):
            found.update((step.run[-1], plan.joints[step.run[0]].parent - 1))
    found.discard(-1)
    one = ("revolute", "prismatic")
    return {j for j in found if j not in articulated or plan.joints[j].kind in one}


def turned_in_loops(plan: Plan, all_limbs: Iterable[Limbs]) -> frozenset[int]:
    """Return the same where joints of limbs in one row, one in each SIMD lane, are treated alike.

    Rows among prescribed joints stay in axes of the base.
    """
    found = set(turned_joints(plan))
    for limbs in all_limbs:
        held = any(plan.joints[j].prescribed for j in limbs.members())
        for row in limbs.rows:
            if held:
                found.difference_update(row)
            elif found.intersection(row):
                found.update(row)
    return frozenset(found)


def _loses(sides: dict[tuple[int, bool], Side], step: tuple[int, bool], most: float) -> bool:
    side = sides.get(step)
    return side is not None and side.most > most * side.least


def _is_solid(link: PlanLink, side: Side | None, most: float) -> bool:
    """Whether a link has inertia enough about every axis that no other joint beyond matters."""
    least = float(np.linalg.eigvalsh(np.array(link.tensor))[0])
    return side is not None and least * most >= side.most


@lru_cache(maxsize=4)  # plans of one robot that a search tries share their joints and links
def _sides(
    joints: tuple[PlanJoint, ...], links: tuple[PlanLink, ...]
) -> dict[tuple[int, bool], Side]:
    """What each joint with one freedom sees, outwards (False) and towards the ground (True)."""
    bare = [_spatial_inertia(link) for link in links]
    transforms = [_transforms(joints, j) for j in range(len(joints))]
    found: dict[tuple[int, bool], Side] = {}

    def look(j: int, backwards: bool, inertia: Array, own: Array) -> Array:
        """Take note of what a joint sees, in its child's frame; what it hands on of that."""
        kind, free = KINDS[joints[j].kind], list(KINDS[joints[j].kind].free)
        if joints[j].prescribed:
            return inertia
        rotor = joints[j].rotor_inertia
        if kind.nv == 1:
            half = slice(0, 3) if free[0] < 3 else slice(3, 6)
            trace = np.trace(inertia[:, half, half], axis1=1, axis2=2) + rotor
            least = float(own[:, free[0], free[0]].min()) + rotor
            found[j, backwards] = Side(float(trace.max()), least)
        u = inertia[:, :, free]
        d = inertia[:, free][:, :, free] + rotor * np.eye(len(free))
        return inertia - u @ np.linalg.pinv(d, hermitian=True) @ u.transpose(0, 2, 1)

    handed: list[Any] = [None] * len(joints)
    whole = [np.broadcast_to(inertia, (len(SEEDS), 6, 6)) for inertia in bare]
    for j in reversed(range(len(joints))):
        x = transforms[j]
        own = np.broadcast_to(bare[j + 1], whole[j + 1].shape)
        handed[j] = x.transpose(0, 2, 1) @ look(j, False, whole[j + 1], own) @ x
        if joints[j].parent > 0:
            whole[joints[j].parent] = whole[joints[j].parent] + handed[j]
    for j, joint in enumerate(joints):  # the ground's side, without what the joint itself carries
        if joint.parent == 0:
            continue
        back = np.linalg.inv(transforms[j])
        told = back.transpose(0, 2, 1) @ (whole[joint.parent] - handed[j]) @ back
        own = back.transpose(0, 2, 1) @ bare[joint.parent] @ back
        whole[j + 1] = whole[j + 1] + look(j, True, told, own)
    return found


def _transforms(joints: tuple[PlanJoint, ...], j: int) -> Array:
    """X of a joint in each configuration, shape (configurations, 6, 6)."""
    joint = joints[j]
    own = []
    for seed in SEEDS:
        q = generic_configuration((joint,), seed * (j + 1))
        turn, shift = placement(KINDS[joint.kind], q)
        base = np.array(joint.rotation)
        origin = np.array(joint.translation) + base @ shift
        own.append(motion_transform((base @ turn).T, origin))
    return np.array(own)


def _spatial_inertia(link: PlanLink) -> Array:
    """A link's inertia about its origin, shape (6, 6), [angular; linear]."""
    c = np.array(link.com)
    cross = np.array([[0.0, -c[2], c[1]], [c[2], 0.0, -c[0]], [-c[1], c[0], 0.0]])
    inertia = np.zeros((6, 6))
    inertia[:3, :3] = np.array(link.tensor) - link.mass * cross @ cross
    inertia[:3, 3:], inertia[3:, :3] = link.mass * cross, -link.mass * cross
    inertia[3:, 3:] = link.mass * np.eye(3)
    return inertia
