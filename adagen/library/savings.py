"""What a scene saves, its effect on accuracy, and errors where what it simplifies does not hold."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from adagen.emit.shapes import chosen_shape
from adagen.errors import AdagenError, InputError
from adagen.executor import straight_line
from adagen.library.request import Request
from adagen.model import Model, Passive
from adagen.plan import Plan, make_plan
from adagen.plan.operations import operations
from adagen.reference import forward_dynamics
from adagen.scene import Reduction
from adagen.scene.report import Cost, Simplification, accurate, differs, saved
from adagen.schedule import CostProfile, Schedule, load_profile, step_costs
from adagen.search import best_schedule, predicted_time
from adagen.search.objective import predicted_digits
from adagen.states import random_states
from adagen.urdf.mobility import weakest


def accuracy(plan: Plan, whole: Plan | None, reduction: Reduction, request: Request) -> list[str]:
    """Return lines about the accuracy of a scene: digits, and errors where it does not hold.

    Args:
        plan: of what is left.
        whole: of the whole robot, or None.
        reduction: what the scene leaves.
        request: how both are compiled.
    """

    def digits(model: Model, of: Plan) -> float:
        try:
            found = predicted_digits(request.objective, model, of, chosen_shape(of)).error
        except FloatingPointError:
            return 0.0
        return max(0.0, -math.log10(found)) if found > 0 else 17.0

    before = None if whole is None else digits(reduction.full, whole)
    lines = [accurate(digits(reduction.model, plan), before)]
    return [*lines, *map(differs, simplifications(reduction))]


def predicted_savings(
    plan: Plan, schedule: Schedule, reduction: Reduction, request: Request
) -> tuple[str, Plan | None]:
    """Return a line about what a scene leaves and saves, and the plan of the whole robot.

    Args:
        plan: of what is left.
        schedule: of what is left.
        reduction: what the scene leaves.
        request: how both are compiled.
    """
    profile = load_profile(request.profile)
    time = _time(reduction.model, plan, schedule, profile)
    whole = _whole(reduction, schedule.processes, request, profile)
    if whole is None:
        (own,) = counted([plan])
        return saved(reduction, None, Cost(own, time)), None
    before, after = counted([whole[0], plan])
    full = Cost(before, _time(reduction.full, *whole, profile))
    return saved(reduction, full, Cost(after, time)), whole[0]


def counted(plans: Sequence[Plan]) -> list[int]:
    """Return the operations of plans: of their straight lines, where all are emitted so.

    These fold what is zero in every state, of a robot at rest above all; an operation in lanes
    counts as one. Otherwise it is that of the algorithm's steps.
    """
    if any(chosen_shape(plan) != "unrolled" for plan in plans):
        return list(map(operations, plans))
    lines = [[line.operations for line in straight_line(plan)] for plan in plans]
    return [sum(own.multiply + own.add + own.divide for own in line) for line in lines]


def _whole(
    reduction: Reduction, processes: int, request: Request, profile: CostProfile
) -> tuple[Plan, Schedule] | None:
    """Return the plan of the whole robot on as many processes; None where it has no answer."""
    full = reduction.full
    held = full.closed or any(joint.mimic for joint in full.joints)
    if not full.joints or (weakest(full).singular and not held):
        return None
    if request.form == "ada":
        profile = profile.joins_only()
    try:
        asked = request.form, request.scalar
        in_parts = request.may_part(len(full.joints), step_costs(profile))
        schedule = best_schedule(full, processes, profile, *asked, in_parts=in_parts)
        plan = make_plan(full, schedule, form=request.form, scalar=request.scalar)
    except InputError:
        return None
    return plan, schedule


def _time(model: Model, plan: Plan, schedule: Schedule, profile: CostProfile) -> float:
    time = schedule.makespan
    if profile.steps is not None:
        time = predicted_time(model, schedule, profile, plan.form, scalar=plan.scalar)
    return float(np.round(time, 6))


Array = NDArray[np.float64]
STATES = 16
MANY = 100
"""Joints beyond which nothing is compared: that would take seconds."""


def simplifications(reduction: Reduction) -> Iterator[Simplification]:
    """Yield the errors of locking joints, omitting gravity and zero velocities, one by one.

    Random states of the whole robot are solved with and without, in double precision by composite
    rigid bodies. Robots with loops, slaved joints or prescribed motions are not compared.
    """
    full, model = _bare(reduction.full), _bare(reduction.model)
    tied = full.closed or any(j.mimic or j.prescribed for j in (*full.joints, *model.joints))
    if tied or len(full.joints) > MANY or not model.joints:
        return
    if reduction.locked and not reduction.dropped:
        with suppress(AdagenError):  # the whole robot has no accelerations
            yield _of(
                "the locked joints are held where they are",
                "they move freely and without torque",
                _unlocked(full, replace(model, gravity=full.gravity), reduction),
            )
    if not model.gravity.any() and full.gravity.any():
        drawn = random_states(model, STATES, 1)
        weighed = replace(model, gravity=full.gravity)
        pairs = [
            (forward_dynamics(model, *state), forward_dynamics(weighed, *state))
            for state in drawn.each
        ]
        yield _of("there is no gravity", "there is", pairs)
    if model.at_rest:
        drawn = random_states(replace(model, at_rest=False), STATES, 1)
        pairs = [
            (forward_dynamics(model, q, 0 * v, tau), forward_dynamics(model, q, v, tau))
            for q, v, tau in drawn.each
        ]
        yield _of("velocities are zero", "they are up to 1 rad/s and 1 m/s", pairs)


def _bare(model: Model) -> Model:
    """The robot without passive effects and outer forces, which are no simplifications."""
    joints = tuple(replace(joint, passive=Passive()) for joint in model.joints)
    return replace(model, joints=joints, wrenches=())


def _unlocked(full: Model, model: Model, reduction: Reduction) -> list[tuple[Array, Array]]:
    """Accelerations of the remaining joints, with the others locked and free."""
    drawn = random_states(full, STATES, 1)
    names = {joint.name: j for j, joint in enumerate(full.joints)}
    left = [names[joint.name] for joint in model.joints]
    in_q = _entries(full, left, "q")
    in_v = _entries(full, left, "v")
    pairs = []
    for q, v, tau in drawn.each:
        for name, at in reduction.locked.items():
            own = _entries(full, [names[name]], "v")
            q[_entries(full, [names[name]], "q")], v[own], tau[own] = at, 0.0, 0.0
        held = forward_dynamics(model, q[in_q], v[in_v], tau[in_v])
        pairs.append((held, forward_dynamics(full, q, v, tau)[in_v]))
    return pairs


def _entries(model: Model, joints: list[int], vector: str) -> list[int]:
    """Entries of joints in q, or in v."""
    starts = model.q_start if vector == "q" else model.v_start
    counts = [getattr(model.joints[j].kind, "nq" if vector == "q" else "nv") for j in joints]
    return [starts[j] + k for j, count in zip(joints, counts, strict=True) for k in range(count)]


def _of(holds: str, else_: str, pairs: list[tuple[Array, Array]]) -> Simplification:
    sizes = [(float(np.linalg.norm(a - b)), float(np.linalg.norm(b))) for a, b in pairs]
    apart = [off / max(size, 1e-300) for off, size in sizes]
    return Simplification(holds, else_, len(pairs), float(np.median(apart)), float(max(apart)))
