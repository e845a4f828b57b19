"""Schedules for time, for accuracy, or for both, with predicted digits.

In form `segment` digits go where processes meet: g, the growth at a cut, says how many. Cuts above
a limit are not made, so that the search moves them to other joints. In form `ada` every joint is
joined, in one order or another; there the orders known by name compete with the searched one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any, get_args

import numpy as np

from adagen.emit.shapes import offered
from adagen.errors import UsageError
from adagen.executor.join_digits import Growth, growth_and_loss, predicted_growth
from adagen.executor.refine import interpret_refined
from adagen.executor.trial import MANY, Trial, carried_out, tried, tried_closed, tried_hard
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.cuts import cuttable_joints
from adagen.plan.digits import EPSILON, generic_configuration, generic_motion
from adagen.plan.own_axes import joints_in_own_axes
from adagen.plan.steps import Join
from adagen.schedule import CostProfile, Schedule
from adagen.schedule.tree import Named
from adagen.search.best import best_schedule
from adagen.search.named import named_schedule

OBJECTIVES = ("time", "accuracy", "both")
LIMITS = (1e1, 1e2, 1e3, 1e4, 1e5)
"""Growths that objective `accuracy` lets pass at a cut, one after the other."""
HARDLY_SINGULAR = {"double": 1e12, "float": 1e5}
"""Growth that objective `time` lets pass: factorizations still succeed."""
_ALIKE = 2.0
"""Up to this ratio of predicted errors two shapes are equally accurate."""
FEW = {"double": 1e-7, "float": 1e-2}
"""Predicted errors that a warning tells: a decade below wrong ones, as predictions may be off by
that (a chain of far masses, cut in two: 3e-7 predicted, 2e-6 found)."""
_TRIALS, _TRIED = 6, 800
"""Generic states in which a plan is carried out, and joints of all of them together, about: a long
chain has all sorts of poses in one state."""
_WORSE = 3.0
"""How much more than in the worst of so many generic states joins may lose in others."""
_IN_BASE_AXES = 12.0
"""How much more loops may lose than the executor, where processes share the robot: they carry the
mobility of what holds the ground in axes of the base, the executor in those of links."""
_BETTER = 0.5  # of the predicted error, for a slower schedule to be chosen


@dataclass(frozen=True)
class Digits:
    """Predicted digits of a schedule.

    Attributes:
        objective: it was searched for.
        error: predicted relative error, 1 where no digit is.
        growth: the largest growth g where chains are joined.
        joint: where that is; None where nothing is joined.
        worst: the joint at which most is lost.
        hard: predicted relative error in hard states, where axes are nearly parallel, as far as
            they are answered, at least ``error``, which is of ordinary ones; None: not tried.
        hardest: the joint at which most is lost there.
    """

    objective: str
    error: float
    growth: float
    joint: str | None
    worst: str
    hard: float | None
    hardest: str

    @property
    def anywhere(self) -> float:
        """The largest predicted error that is known."""
        return self.error if self.hard is None else self.hard


def schedule_for(
    objective: str,
    model: Model,
    processes: int,
    profile: CostProfile,
    form: str = "segment",
    scalar: str = "double",
    **search: Any,
) -> Schedule:
    """Return the schedule that suits an objective, one of ``OBJECTIVES``.

    `time` makes every cut that can be factorized at all; `both`, the default, none at which more
    than a few digits are lost; `accuracy` takes what loses least on as many processes.

    Args:
        objective: what counts.
        model: the robot.
        processes: P.
        profile: the costs.
        form: of the algorithm.
        scalar: "double" or "float".
        search: further arguments of ``find_schedule``.

    Raises:
        InputError: as ``best_schedule``.
        UsageError: as ``best_schedule``.
    """
    if objective == "accuracy":  # joins inside a process lose digits, too
        search["in_parts"] = False

    def best(limit: float | None) -> Schedule:
        return best_schedule(model, processes, profile, form, scalar, limit, **search)

    found = best(None)
    if objective == "time":
        lenient = HARDLY_SINGULAR[scalar]
        if form != "segment" or not _allows_more(model, scalar, lenient):
            return found
        return _faster(best(lenient), found)
    if objective == "both" or (form == "segment" and processes == 1):
        return found
    others = _orders(model, found, profile) if form == "ada" else map(best, LIMITS)
    return _most_accurate(model, found, others, form, scalar)


def _allows_more(model: Model, scalar: str, limit: float) -> bool:
    """Whether processes may be joined at more joints if growth up to a limit is let pass."""
    members = fold_of(model, "segment").joints
    return cuttable_joints(model, scalar, members, limit) != cuttable_joints(model, scalar, members)


def _faster(found: Schedule, stricter: Schedule) -> Schedule:
    """The faster of two schedules, the second of which was searched among fewer.

    Not all straight lines are searched: the fewer may hold one that the others were not tried for.
    """
    if found.makespan <= stricter.makespan:
        return found
    return replace(stricter, lower_bound=min(found.lower_bound, stricter.makespan))


def predicted_digits(objective: str, model: Model, plan: Plan, shape: str = "kernels") -> Digits:
    """Return the predicted digits of a plan.

    The error is what sweeping the robot loses in a trial as the shape does it; where processes
    share it also what the growth of joins predicts, or what carrying out the plan in generic states
    is found to lose: g knows nothing of what inverting I^A costs. The largest counts. Hard states
    are tried of form segment without closed loops; what joins lose in them is not.

    Args:
        objective: what the schedule was searched for.
        model: the robot.
        plan: its plan.
        shape: of the code, "kernels", "unrolled" or "joints".

    Raises:
        FloatingPointError: a factorization fails already here; the message names the joint.
    """
    if plan.closed:
        trial = tried_closed(model, plan)
        error = min(1.0, max(trial.error, EPSILON[plan.scalar]))
        worst = model.joints[trial.joint].name
        return Digits(objective, error, 1.0, None, worst, None, worst)
    shared = sum(bool(process.owns) for process in plan.processes) > 1
    growth, lost = _joins(plan, shared)
    joined = growth.largest > 1.0
    name = model.joints[growth.joint].name if joined else None
    trial = Trial(growth.error, growth.joint)
    if joined or shared or plan.form != "segment":  # mobilities are joined, or hold the ground
        lost = _tried(plan) if lost is None else lost
        trial = Trial(max(trial.error, lost * _WORSE), growth.joint)
        trial = max(trial, _carried_out(plan, shape), key=lambda each: each.error)
    hard = None
    if plan.form == "segment":
        turned = joints_in_own_axes(plan) if shape == "kernels" else None
        trial = max(trial, tried(plan, turned), key=lambda each: each.error)
        hard = max(trial, tried_hard(plan, turned), key=lambda each: each.error)
    worst, hardest = (model.joints[each.joint].name for each in (trial, hard or trial))
    more = None if hard is None else min(1.0, hard.error)
    error = min(1.0, trial.error)
    return Digits(objective, error, growth.largest, name, worst, more, hardest)


def _joins(plan: Plan, shared: bool) -> tuple[Growth, float | None]:
    """The growth of a plan's joins, and for long plans what is lost in a generic state, too."""
    long = len(plan.joints) >= _TRIED and (shared or any(plan.steps_of(Join)))
    return (growth_and_loss(plan) if long else None) or (predicted_growth(plan), None)


def _carried_out(plan: Plan, shape: str) -> Trial:
    """Loss of the plan in the program's own states, where the executor can show that."""
    slaved = any(joint.mimic for joint in plan.joints)
    if plan.wanted or slaved or len(plan.joints) > MANY:  # many: seconds
        return Trial(0.0, 0)
    try:
        found = carried_out(plan)
    except FloatingPointError:  # in one state: refused there
        return Trial(0.0, 0)
    several = sum(bool(process.owns) for process in plan.processes) > 1
    more = _IN_BASE_AXES if shape == "kernels" and several else _WORSE
    return replace(found, error=found.error * more)


def suited_shape(
    objective: str, plan: Plan, shape: str = "auto", profile: CostProfile | None = None
) -> str:
    """Return the shape that suits an objective: for accuracy the one that loses clearly less.

    Args:
        objective: one of ``OBJECTIVES``.
        plan: what each process computes.
        shape: what is asked for; "auto" leaves it open.
        profile: by which "auto" chooses; the shipped one if not given.

    Returns:
        A shape, or "auto" where the fastest one is as good as any: its error is at most twice as
        large.
    """
    if objective != "accuracy" or shape != "auto" or plan.closed:
        return shape
    errors = {
        name: tried(plan, joints_in_own_axes(plan) if name == "kernels" else None).error
        for name in offered(plan, profile)
    }
    fine = [name for name, error in errors.items() if error <= _ALIKE * min(errors.values())]
    return fine[0] if len(fine) == 1 else shape


def _tried(plan: Plan) -> float:
    """The relative error found in generic states, the largest of their first corrections.

    Few poses are bad ones: two states would tell too little.

    Zero where nothing but g is known: where the plan cannot be refined, or takes the second way
    that it has for singular poses, which refinement does not know. Infinite where no digit is
    right.
    """
    seeds = range(1, min(_TRIALS, -(-_TRIED // len(plan.joints))) + 1)
    q = np.stack([generic_configuration(plan.joints, seed) for seed in seeds], axis=-1)
    motions = [generic_motion(plan.nv, seed) for seed in seeds]
    v, tau = (np.stack(each, axis=-1) for each in zip(*motions, strict=True))
    v *= not plan.at_rest
    try:
        (sizes,) = interpret_refined(plan, q, v, tau, steps=1).corrections
    except UsageError:
        return 0.0
    except FloatingPointError:  # in one state: what is found in the others counts
        sizes = np.zeros(1)
        for state in zip(q.T, v.T, tau.T, strict=True):
            with suppress(UsageError, FloatingPointError):
                sizes = np.append(sizes, interpret_refined(plan, *state, steps=1).corrections)
    in_double = EPSILON[plan.scalar] / EPSILON["double"]
    return float(max(sizes)) * in_double if np.isfinite(sizes).all() else np.inf


def _orders(model: Model, found: Schedule, profile: CostProfile) -> Iterator[Schedule]:
    """Yield the schedules by name."""
    seen = fold_of(model, "ada")
    for name in get_args(Named):
        other = named_schedule(name, seen.topology, found.processes, profile=profile.joins_only())
        yield seen.unfold(other, profile)


def _most_accurate(
    model: Model, found: Schedule, others: Iterable[Schedule], form: str, scalar: str
) -> Schedule:
    """The schedule, or another of as many processes that is predicted to lose much less."""
    working = _working(model, found, form)
    best, least = found, _growth(model, found, form, scalar)
    for candidate in others:
        growth = _growth(model, candidate, form, scalar)
        if growth is None or _working(model, candidate, form) < working:
            continue
        if least is None or growth.error < _BETTER * least.error:
            best, least = candidate, growth
    return best


def _growth(model: Model, schedule: Schedule, form: str, scalar: str) -> Growth | None:
    """Loss of digits of a schedule's joins; None where it cannot be carried out."""
    try:
        return predicted_growth(make_plan(model, schedule, form=form, scalar=scalar))
    except FloatingPointError:
        return None


def _working(model: Model, schedule: Schedule, form: str) -> int:
    """How many processes have something to do."""
    return sum(bool(process.owns) for process in make_plan(model, schedule, form=form).processes)
