"""Digits that the joins of a plan lose on a robot, predicted before code is emitted.

A link that is much lighter than its neighbours loses most of its mobility when they are attached:
Phi_C = Phi - Z^T Z then subtracts nearly equal numbers. If g is the factor of mobility that is
lost, about log10(g) digits are lost, in any order of assembly.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.joins import Joined
from adagen.executor.solve import Run, SingularPoseError
from adagen.executor.trial import loss_of
from adagen.executor.trial_sweep import Sweep
from adagen.model import Inertia
from adagen.plan.clusters import is_solid
from adagen.plan.constants import inverse_inertia
from adagen.plan.digits import EPSILON, generic_configuration, generic_motion, lost_mobility
from adagen.plan.placement import configuration, joint_transform
from adagen.plan.steps import Join
from adagen.plan.types import Plan

Array = NDArray[np.float64]


LONG = 400
"""Joints of a plan beyond which one configuration is enough."""


@dataclass(frozen=True)
class Growth:
    """Loss of digits in assembly.

    Attributes:
        error: predicted relative forward error, eps times the sum of g over the joints.
        joint: the joint with the largest g.
        largest: that g.
    """

    error: float
    joint: int
    largest: float


def predicted_growth(plan: Plan) -> Growth:
    """Return the growth of a plan's joins, the larger of two generic configurations.

    One configuration is enough where there are no joins, which shows whether the plan can be
    solved, and for long chains: in those of 500 and 1000 joints two differ by a seventh.

    g_i is the largest generalised eigenvalue of (M_i with bare links, M_i as assembled), where
    M_i = N_i (Phi_Ai + Phi_Bi) N_i^T; eps times the sum of g predicts the error.

    Raises:
        FloatingPointError: a factorization fails already here; the message names the joint.
    """
    joins = any(plan.steps_of(Join))
    if not joins and _surely_solved(plan):
        return _none(plan)
    seeds = (1, 2) if joins and len(plan.joints) <= LONG else (1,)
    try:
        return _growth(plan, seeds)
    except SingularPoseError:  # in one of them: what is then done otherwise is no join
        return max((_growth(plan, (seed,)) for seed in seeds), key=lambda growth: growth.error)


def growth_and_loss(plan: Plan) -> tuple[Growth, float] | None:
    """Return the growth of a long plan's joins and what carrying it out loses, from one run.

    In one generic configuration, with velocities and torques; the plan's answer is compared with a
    sweep in higher precision, without passive torques and outer forces. It takes a third of the
    time of the growth and of refinement after each other.

    Returns:
        Growth, and relative error in the plan's scalar; None where the sweep knows another robot,
        or a mobility is singular.

    Raises:
        FloatingPointError: a factorization fails already here; the message names the joint.
    """
    slaved = any(joint.mimic for joint in plan.joints)
    if plan.form != "segment" or plan.closed or plan.wanted or slaved:
        return None
    q = generic_configuration(plan.joints, 1)
    v, tau = generic_motion(plan.nv, 1)
    v *= not plan.at_rest
    bare = replace(plan.without_passive_torques(), scalar="double")
    outer = np.zeros(6 * len(plan.wrenches))
    run = Run(bare, {"q": q, "v": v, "tau": np.append(tau, outer)}, once=True)
    try:
        run.check(digits=False)
    except SingularPoseError:
        return None
    found = run.accelerations()[: plan.nv]
    loss = loss_of(bare, (q[None], v[None], tau[None]), found[None]).error
    return _growth_in(plan, run, 0, q), loss * EPSILON[plan.scalar] / EPSILON["double"]


def _none(plan: Plan) -> Growth:
    return Growth(EPSILON[plan.scalar], 0, 1.0)


def _surely_solved(plan: Plan) -> bool:
    """Whether a process sweeps a tree alone, with pivots well above rounding.

    That is found much sooner than the plan is carried out.
    """
    working = [process for process in plan.processes if process.steps]
    slaved = any(joint.mimic for joint in plan.joints)
    if len(working) > 1 or plan.form != "segment" or plan.closed or slaved:
        return False
    q, zero = generic_configuration(plan.joints, 1)[None], np.zeros((1, plan.nv))
    sweep = Sweep(plan, np.float64, None, (q, zero, zero))
    with np.errstate(all="ignore"):
        found = sweep.solved()
    return not sweep.refused.any() and bool(np.isfinite(found).all())


def _growth(plan: Plan, seeds: Sequence[int]) -> Growth:
    """Return the largest growth in configurations, which are carried out at once."""
    q = np.stack([generic_configuration(plan.joints, seed) for seed in seeds], axis=-1)
    zero = np.zeros((plan.nv + 6 * len(plan.wrenches), len(seeds)))
    run = Run(plan, {"q": q, "v": zero, "tau": zero}, once=True)
    try:
        run.check(digits=False)
    except SingularPoseError:
        if len(seeds) > 1:
            raise
    found = [_growth_in(plan, run, s, q[:, s]) for s in range(len(seeds))]
    return max(found, key=lambda growth: growth.error)


def _growth_in(plan: Plan, run: Run, s: int, q: Array) -> Growth:
    """Return the growth in configuration q, the one of number s that was carried out."""
    transforms = _transforms(plan, q)
    values: dict[int, float] = {}
    for p, process in enumerate(plan.processes):

        def of(expressions: Any, p: int = p) -> Array:
            found = run.of(p, expressions)
            return found[..., s] if found.ndim > np.ndim(expressions) else found

        for step in process.steps_of(Join):
            joined: Joined = run.machines[p].memory["join", step.joint]
            values[step.joint] = _lost(plan, of, joined, transforms)
    if not values:
        return _none(plan)
    worst = max(values, key=lambda joint: (values[joint], -joint))
    return Growth(EPSILON[plan.scalar] * sum(values.values()), worst, values[worst])


def _transforms(plan: Plan, q: Array) -> list[Array]:
    """X of every joint, shape (6, 6)."""
    joints = plan.joints
    return [joint_transform(joint, configuration(joints, joint, q)) for joint in joints]


def _lost(
    plan: Plan, of: Callable[[Any], Array], joined: Joined, transforms: Sequence[Array]
) -> float:
    frame = joined.frame
    y = np.eye(6) if frame.turn is None else of(frame.turn)
    x = y
    for j in reversed(frame.run):
        x = x @ transforms[j]
    bare = np.zeros((6, 6))
    for row, entry in frame.give.items():
        (bare[row, row],) = of([entry])
    ends = ((plan.joints[frame.run[0]].parent, x), (frame.run[-1] + 1, y))
    for number, transform in ends:
        if number > 0:
            own = _bare_mobility(plan, number)
            if own is None or not frame.constrained:
                return 1.0
            bare = bare + transform @ own @ transform.T
    at = np.ix_(frame.constrained, frame.constrained)
    try:
        return lost_mobility(bare[at], of(joined.phi[at]))
    except np.linalg.LinAlgError:
        return np.inf


def _bare_mobility(plan: Plan, number: int) -> NDArray[np.float64] | None:
    """A link's mobility; None if it is singular and the link is joined with others at once."""
    link = plan.links[number]
    inertia = Inertia(link.mass, np.array(link.com), np.array(link.tensor))
    places = [plan.joints[j].translation for j in plan.children[number]]
    return inverse_inertia(inertia, link.name)[1] if is_solid(inertia, places) else None
