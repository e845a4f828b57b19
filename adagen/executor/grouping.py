"""Limbs of a plan that share straight-line code in SIMD lanes, where that saves work."""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence

from adagen.executor.lane_frames import unlike
from adagen.executor.lanes import Grouping, fit_for_lanes, steps_in_order
from adagen.executor.run import Simulated, each_for_itself
from adagen.executor.stretches import Stretch, stretches
from adagen.plan import Plan
from adagen.plan.arms import arms_of, without_unlike
from adagen.plan.closure_steps import closures_in
from adagen.plan.simd_groups import (
    OFFERED,
    Limbs,
    more_alike,
    nearly_fewest,
    simd_groupings,
)
from adagen.plan.similar_closures import limbs_of, similar_closures
from adagen.plan.types import Process
from adagen.schedule import step_costs
from adagen.schedule.costs import StepCosts


def groupings_of(plan: Plan) -> list[Grouping]:
    """Return limbs that can share lanes, for each of ``OFFERED``: as many and similar as can be."""
    if plan.form != "segment":
        return [tuple(() for _ in plan.processes)]
    found: list[list[tuple[Limbs, ...]]] = [[] for _ in OFFERED]
    for process in plan.processes:
        every = simd_groupings(plan, process, spared)
        for own, limbs, counts in zip(found, every, OFFERED, strict=True):
            own.append(_alike(plan, process, limbs, counts))
    return [tuple(own) for own in found]


def _alike(
    plan: Plan, process: Process, found: list[Limbs], counts: Sequence[int]
) -> tuple[Limbs, ...]:
    if not found and not plan.closed:
        return ()
    found = more_alike(plan, process, found, lambda limbs: unlike(plan, limbs))
    limbs = fit_for_lanes(plan, process, found)
    groups = similar_closures(plan, process.steps, counts)
    closed = tuple(one for group in groups for one in limbs_of(plan, group))
    arms = _arms(plan, process, {one.number for group in groups for one in group}, counts)
    offers = (
        tuple(without_unlike(plan, process.steps, offer))
        for offer in ((*limbs, *closed, *arms), (*limbs, *closed), limbs, (*closed, *arms), closed)
    )
    return next((offer for offer in offers if _in_order(plan, process, offer)), ())


def _arms(
    plan: Plan, process: Process, besides: Container[int], counts: Sequence[int]
) -> tuple[Limbs, ...]:
    """Arms of single closures."""
    alone = (one for k, one in closures_in(process.steps).items() if k not in besides)
    return tuple(limbs for one in alone for limbs in arms_of(plan, one, counts))


def _in_order(plan: Plan, process: Process, limbs: tuple[Limbs, ...]) -> bool:
    """Whether sweeps can be done with limbs side by side."""
    try:
        steps_in_order(plan, process, limbs)
    except ValueError:
        return False
    return True


def spared(kinds: Sequence[str], count: int) -> float:
    """Number of joints that need no statements of their own."""
    return len(kinds) * (count - 1)


Simulating = Callable[[Plan, Grouping], Sequence[Simulated]]
"""Returns a plan's processes after all their steps, in a grouping."""


def stretches_in(
    line: Sequence[Simulated], plan: Plan, held: float
) -> tuple[tuple[Stretch, ...], ...]:
    """Return the stretches of a plan's processes after their steps, as ``stretches`` has them."""
    return tuple(
        tuple(stretches(simulated, process.steps, held))
        for simulated, process in zip(line, plan.processes, strict=True)
    )


def offered_groupings(plan: Plan) -> list[Grouping]:
    """Return possible groupings for straight lines; no grouping comes first."""
    none: Grouping = tuple(() for _ in plan.processes)
    return list(dict.fromkeys([none, *groupings_of(plan)]))


def least_of(
    plan: Plan,
    offers: Sequence[Grouping],
    costs: StepCosts | None = None,
    simulating: Simulating = each_for_itself,
) -> Grouping:
    """Return the grouping of least price for each process.

    Args:
        plan: the plan.
        offers: groupings, none first.
        costs: prices statements; the shipped ones if not given.
        simulating: makes the straight lines that are compared.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    options = [
        nearly_fewest(process, own)
        for process, own in zip(plan.processes, zip(*offers, strict=True), strict=True)
    ]
    most = max(map(len, options))
    if most == 1:
        return tuple(own for (own,) in options)
    prices = step_costs(None) if costs is None else costs
    offers = [tuple(own[min(k, len(own) - 1)] for own in options) for k in range(most)]
    held = prices["unrolled.held"]
    lines = (stretches_in(simulating(plan, offer), plan, held) for offer in offers)
    times = [[sum(part.time(prices) for part in own) for own in line] for line in lines]
    return tuple(
        offers[min(range(most), key=lambda k: times[k][p])][p] for p in range(len(options))
    )
