"""Joints that loops compute in the axes of their own links, to keep digits.

In base axes D = s^T A s is known to a unit in the last place of A: log10(tr A / D) digits are lost.
Where that is too much, the joint is computed in its own axes, in which D is an entry of the
inertia and the projected inertia is exactly zero along the axis. So are the joints beyond it that
may become parallel to it, up to the first link whose own inertia resists this motion.

tr A / D is computed in a few configurations. Joints that lose too much there (slender spinning
tools) are always computed in their own axes. The least D over all configurations is that of the
bare link about the axis: zero for a point mass on the axis (in a wrist of three axes, the nearer
to gimbal lock the more is lost). Joints that lose too much only there are computed in their own
axes only in such poses: emitted loops test D, and repeat the sweep of the run. Three kinds of
joints are always computed in their own axes: those of massless links (ball joints made of three
axes), those of runs that are joined as one and may lose too much, and, on joined processes, the
links at the ends of such runs and bare links that are joined.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence, Set
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import KINDS
from adagen.plan.digits import generic_configuration
from adagen.plan.order import ends_of
from adagen.plan.placement import joint_transform, spatial_inertia
from adagen.plan.robot import PlanJoint, PlanLink
from adagen.plan.steps import Articulate, FusedJoin, LinkBias
from adagen.plan.types import Plan

Array = NDArray[np.float64]
MOST = {"double": 2.0**18, "float": 2.0**12}
"""What tr A / D may be at most in axes of the base: 3e-11, or 2e-4, of D is lost then."""
STOOD = {"double": 2.0**38, "float": 2.0**9}
"""What tr A / D may be at most where nothing is lost by it: loops in axes of the base take a
thousand times that for a pivot without digits."""
ENOUGH = 2.0**8
"""Beyond which tr A / D loops repeat a sweep that may come to lose more than that."""
SEEDS = (1, 2, 3)
"""Of the configurations: an odd number of them, so that one is in the middle. (np.median would
import numpy.ma, in every process that plans.)"""
_SMALLEST = 1e-200
"""The value used for D where it is nothing, so that tr A / D is a number."""


@dataclass(frozen=True)
class Side:
    """The links on one side of a joint as they act along its axis.

    Attributes:
        most: trace of their articulated inertia, of its rotational part (kg m^2) or its mass (kg).
        least: what the nearest link alone has along the axis, with the rotor.
        usual: median of trace / D of a few configurations.
    """

    most: float
    least: float
    usual: float


@dataclass(frozen=True)
class OwnAxes:
    """Joints that are computed in their own axes.

    Attributes:
        always: in all poses.
        if_lost: others, where axes of the base lose digits.
    """

    always: frozenset[int]
    if_lost: frozenset[int]


@lru_cache(maxsize=16)  # of one plan it is asked for each grouping of limbs
def joints_in_own_axes(plan: Plan) -> OwnAxes:
    """Return the joints of a plan of form segment that are computed in their own axes."""
    steps = _articulated(plan)
    worst, usual = _losing(plan, steps)
    sides = _sides(plan.joints, plan.links, plan.scalar)
    usual |= {step for step in worst if sides[step].usual > ENOUGH}
    fused = any(plan.steps_of(FusedJoin))
    for j, backwards in worst:  # mobilities of fused runs take away most of what is passed to them
        far = ends_of(plan.joints, j, backwards).far
        if fused or not plan.links[far].mass:
            usual.add((j, backwards))
    always = _with_joints_beyond(plan, steps, usual) | _beside_bare_links(
        plan, {j for j, _ in steps}
    )
    return OwnAxes(always, _with_joints_beyond(plan, steps, worst) - always)


@lru_cache(maxsize=16)  # of one plan it is asked by each process, for each grouping of limbs
def losing_joints(plan: Plan) -> frozenset[int]:
    """Return the joints that may lose too many digits, with those beyond them.

    There what is small beside other entries of an inertia has to keep its own digits.
    """
    steps = _articulated(plan)
    worst, usual = _losing(plan, steps)
    return _with_joints_beyond(plan, steps, worst | usual)


def balls_lose(plan: Plan) -> bool:
    """Whether a ball joint's link is so slender that loops lose too many digits.

    Ball joints are eliminated in axes of the base, where the least of a body's principal inertias
    is known to a unit in the last place of its trace.
    """
    most = MOST[plan.scalar]
    for j, joint in enumerate(plan.joints):
        if joint.kind == "spherical" and not joint.prescribed:
            about = spatial_inertia(plan.links[j + 1])[:3, :3]
            if most * float(np.linalg.eigvalsh(about)[0]) < float(np.trace(about)):
                return True
    return False


def _losing(
    plan: Plan, steps: Iterable[tuple[int, bool]]
) -> tuple[set[tuple[int, bool]], set[tuple[int, bool]]]:
    """Joints that may lose too many digits in some pose, and those that usually do."""
    most, sides = MOST[plan.scalar], _sides(plan.joints, plan.links, plan.scalar)
    seen = {step: sides[step] for step in steps if step in sides}
    worst = {step for step, side in seen.items() if side.most > most * side.least}
    return worst, {step for step, side in seen.items() if side.usual > most}


def _with_joints_beyond(
    plan: Plan, steps: Iterable[tuple[int, bool]], losing: Set[tuple[int, bool]]
) -> frozenset[int]:
    """The joints that lose digits, and those beyond that may become parallel to them."""
    most = MOST[plan.scalar]
    sides = _sides(plan.joints, plan.links, plan.scalar)
    beyond: dict[int, list[tuple[int, bool]]] = {}  # by the link that feels a joint
    for j, backwards in steps:
        beyond.setdefault(ends_of(plan.joints, j, backwards).near, []).append((j, backwards))
    found: set[int] = set()
    todo = sorted(losing)
    seen = set(todo)
    while todo:
        j, backwards = todo.pop()
        if not plan.joints[j].prescribed and plan.joints[j].kind in ("revolute", "prismatic"):
            found.add(j)
        far = ends_of(plan.joints, j, backwards).far
        if far == 0 or _is_solid(plan.links[far], sides.get((j, backwards)), most):
            continue
        new = [step for step in beyond.get(far, ()) if step not in seen]
        seen.update(new)
        todo += new
    return frozenset(found)


def _beside_bare_links(plan: Plan, articulated: Set[int]) -> set[int]:
    """The joints before bare links that are joined, and before the ends of fused runs.

    Values of such links keep their digits in the links' own axes only: constants, and mobilities
    of which the run takes away the larger part.
    """
    found: set[int] = set()
    found.update(step.link - 1 for step in plan.steps_of(LinkBias))
    for step in plan.steps_of(FusedJoin):
        found.update((step.run[-1], plan.joints[step.run[0]].parent - 1))
    found.discard(-1)
    one = ("revolute", "prismatic")
    return {j for j in found if j not in articulated or plan.joints[j].kind in one}


def own_axes_of_units(
    plan: Plan, rows: Iterable[Sequence[int]], units: Iterable[frozenset[int]]
) -> OwnAxes:
    """Return the same for joints that loops sweep together.

    What a unit hands to another is in axes of the base unless the joints at both ends are
    always turned: so they are where the one beyond may come to lie along an axis that loses.

    Args:
        plan: the plan.
        rows: joints that are treated alike, one in each SIMD lane. Rows that hold a joint of
            prescribed motion stay in axes of the base, as do the rows beside them.
        units: the joints of each run, and of limbs side by side, that is swept at once.
    """
    found = joints_in_own_axes(plan)
    if not (found.always or found.if_lost):
        return found
    always, if_lost = set(found.always), set(found.if_lost)
    swept = list(units)
    held = {j for unit in swept if any(plan.joints[j].prescribed for j in unit) for j in unit}
    alike = [set(row) for row in rows]
    if if_lost:
        pairs = _pairs(plan, found.always | found.if_lost)
        apart = [pair for pair in pairs if not any(unit.issuperset(pair) for unit in swept)]
        always.update(*apart)
        while new := {c for j, c in pairs if j in always and c not in always}:
            always |= new
    for row in alike:
        for joints in (always, if_lost):
            if row & held:
                joints -= row
            elif row & joints:
                joints |= row
    return OwnAxes(frozenset(always), frozenset(if_lost - always))


@lru_cache(maxsize=16)
def _pairs(plan: Plan, joints: frozenset[int]) -> list[tuple[int, int]]:
    """Pairs of joints and joints beyond them that may become parallel."""
    most = MOST[plan.scalar]
    sides = _sides(plan.joints, plan.links, plan.scalar)
    steps = _articulated(plan)
    found = []
    for j, backwards in steps:
        far = ends_of(plan.joints, j, backwards).far
        if j not in joints or far == 0:
            continue
        if _is_solid(plan.links[far], sides.get((j, backwards)), most):
            continue
        found += [
            (j, c)
            for c, other in steps
            if c in joints and ends_of(plan.joints, c, other).near == far
        ]
    return found


def _articulated(plan: Plan) -> list[tuple[int, bool]]:
    """Joints that are eliminated, and whether backwards."""
    return sorted(
        {(step.joint, step.reversed) for step in plan.all_steps if isinstance(step, Articulate)}
    )


def _is_solid(link: PlanLink, side: Side | None, most: float) -> bool:
    """Whether a link resists every axis enough that no joint beyond matters."""
    least = float(np.linalg.eigvalsh(np.array(link.tensor))[0])
    return side is not None and least * most >= side.most


@lru_cache(maxsize=4)  # plans of one robot that a search tries share their joints and links
def _sides(
    joints: tuple[PlanJoint, ...], links: tuple[PlanLink, ...], scalar: str
) -> dict[tuple[int, bool], Side]:
    """The inertia that each one-freedom joint moves, outwards (False) and inwards (True)."""
    bears = STOOD[scalar]
    bare = [spatial_inertia(link) for link in links]
    flat = _flat(joints)
    transforms = [_transforms(joints, j) for j in range(len(joints))]
    found: dict[tuple[int, bool], Side] = {}

    def look(j: int, backwards: bool, inertia: Array, own: Array) -> Array:
        """Record a joint's inertia in its child's frame, and return its projection."""
        kind, free = KINDS[joints[j].kind], list(KINDS[joints[j].kind].free)
        if joints[j].prescribed:
            return inertia
        rotor = joints[j].rotor_inertia
        u = inertia[:, :, free]
        d = inertia[:, free][:, :, free] + rotor * np.eye(len(free))
        if kind.nv == 1:
            half = slice(0, 3) if free[0] < 3 else slice(3, 6)
            trace = np.trace(inertia[:, half, half], axis1=1, axis2=2) + rotor
            stood = bool((trace <= bears * d[:, 0, 0]).all())
            if flat[j] and stood and not backwards:  # what is about other axes stays apart, exactly
                trace = rigid[j + 1][:, free[0], free[0]] + rotor
            least = float(own[:, free[0], free[0]].min()) + rotor
            usual = np.sort(trace / np.maximum(d[:, 0, 0], _SMALLEST))[len(SEEDS) // 2]
            found[j, backwards] = Side(float(trace.max()), least, float(usual))
        rest: Array = inertia - u @ _inverse(d) @ u.transpose(0, 2, 1)
        return rest

    passed: list[Any] = [None] * len(joints)
    whole = [np.broadcast_to(inertia, (len(SEEDS), 6, 6)) for inertia in bare]
    rigid = list(whole)  # before what joints beyond take away
    for j in reversed(range(len(joints))):
        x = transforms[j]
        own = np.broadcast_to(bare[j + 1], whole[j + 1].shape)
        passed[j] = x.transpose(0, 2, 1) @ look(j, False, whole[j + 1], own) @ x
        if joints[j].parent > 0:
            whole[joints[j].parent] = whole[joints[j].parent] + passed[j]
            moved = x.transpose(0, 2, 1) @ whole[j + 1] @ x
            rigid[joints[j].parent] = rigid[joints[j].parent] + moved
    for j, joint in enumerate(joints):  # the ground's side, without what the joint itself carries
        if joint.parent == 0:
            continue
        back = np.linalg.inv(transforms[j])
        seen = back.transpose(0, 2, 1) @ (whole[joint.parent] - passed[j]) @ back
        own = back.transpose(0, 2, 1) @ bare[joint.parent] @ back
        whole[j + 1] = whole[j + 1] + look(j, True, seen, own)
    return found


def _inverse(d: Array) -> NDArray[Any]:
    """Pseudoinverses of symmetric matrices, shape (configurations, freedoms, freedoms)."""
    if d.shape[1] == 1:
        return np.divide(1.0, d, out=np.zeros_like(d), where=d != 0)
    return np.linalg.pinv(d, hermitian=True)


def _flat(joints: tuple[PlanJoint, ...]) -> list[bool]:
    """Whether a hinge and all joints beyond it rotate about one axis of the base's frame.

    In axes of the base D is an entry of the inertia then, and what is about other axes is neither
    added to it nor taken from it. Only slides and turns about that axis may be before it.
    """
    axes: list[int | None] = []  # that links turn about, -1: about none; None: about several
    turns: list[Array] = []
    for joint in joints:
        before = None if joint.parent == 0 else axes[joint.parent - 1]
        turn = np.array(joint.rotation)
        turn = turn if joint.parent == 0 else turns[joint.parent - 1] @ turn
        own = np.flatnonzero(turn[:, 2])
        axis: int | None = None
        if joint.parent == 0 and joint.kind == "floating":
            axis, turn = -1, np.eye(3)  # its own frame is that of the base
        elif joint.parent > 0 and before is None:
            axis = None
        elif joint.kind == "prismatic":
            axis = -1 if before is None else before
        elif joint.kind == "revolute" and len(own) == 1 and before in (None, -1, own[0]):
            axis = int(own[0])
        axes.append(axis)
        turns.append(turn)
    flat = [a is not None and one.kind == "revolute" for a, one in zip(axes, joints, strict=True)]
    for j in reversed(range(len(joints))):
        near = joints[j].parent - 1
        if near >= 0 and not (flat[j] and axes[near] == axes[j]):
            flat[near] = False
    return flat


def _transforms(joints: tuple[PlanJoint, ...], j: int) -> Array:
    """X of a joint in each configuration, shape (configurations, 6, 6)."""
    own = (generic_configuration((joints[j],), seed * (j + 1)) for seed in SEEDS)
    return np.array([joint_transform(joints[j], q) for q in own])
