"""A plan's straight lines: one for each process, or shares of one line for all processes."""

from __future__ import annotations

from functools import lru_cache

from adagen.executor.grouping import least_of, offered_groupings, stretches_in
from adagen.executor.lanes import Grouping
from adagen.executor.reproducible import own_limbs, shared_line
from adagen.executor.run import Simulated, each_for_itself
from adagen.executor.state import Refining
from adagen.executor.stretches import Stretch
from adagen.plan import Plan
from adagen.schedule.costs import StepCosts


def simulate(
    plan: Plan, grouping: Grouping | None = None, refining: Refining = None
) -> tuple[Simulated, ...]:
    """Return the plan's processes after all their steps; they must not be changed.

    Args:
        plan: the plan.
        grouping: which limbs share code, one in each lane; None for none. Link frames are then
            turned as these agree best (lane_frames.py).
        refining: what of iterative refinement is computed, if any.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    limbs = grouping if grouping is not None and any(grouping) else None  # cached as without any
    if plan.reproducible and refining is None:
        return shared_line(plan, limbs)
    return each_for_itself(plan, limbs, refining)


def straight_line(plan: Plan, *, lanes: bool = True) -> tuple[Simulated, ...]:
    """Return the plan's processes as emitted in straight lines: in lanes where that is cheaper.

    Args:
        plan: the plan.
        lanes: whether limbs may share code at all.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    return simulate(plan, chosen_grouping(plan) if lanes else None)


def groupings(plan: Plan) -> list[Grouping]:
    """Return the groupings of a plan's straight lines that are compared; the first is none."""
    if not plan.reproducible:
        return offered_groupings(plan)
    return list(dict.fromkeys([tuple(() for _ in plan.processes), own_limbs(plan)]))


def chosen_grouping(plan: Plan, costs: StepCosts | None = None) -> Grouping:
    """Return the grouping of least price for each process.

    Args:
        plan: the plan.
        costs: prices statements; the shipped ones if not given.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    return least_of(plan, groupings(plan), costs, simulate)


@lru_cache(maxsize=16)  # a plan is priced several times
def counted_stretches(
    plan: Plan, grouping: Grouping, held: float
) -> tuple[tuple[Stretch, ...], ...]:
    """Return the stretches of the straight line of each process, or of its share of one.

    Args:
        plan: the plan.
        grouping: which limbs share code, one in each lane.
        held: statements whose decoded instructions are held.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    return stretches_in(simulate(plan, grouping), plan, held)
