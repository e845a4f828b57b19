"""Which limbs of a plan share a straight line, and whether that is less work."""

from __future__ import annotations

from adagen.executor.align import unlike
from adagen.executor.lanes import Grouping, fit_for_lanes
from adagen.executor.run import Simulated, simulate
from adagen.plan import Plan
from adagen.plan.simd_groups import Limbs, more_alike, simd_groups
from adagen.plan.types import Process


def grouping_of(plan: Plan) -> Grouping:
    """Return the limbs that go together: those of shape kernels, or others that are more alike."""
    if plan.form != "segment":
        return tuple(() for _ in plan.processes)
    return tuple(fit_for_lanes(plan, _alike(plan, process)) for process in plan.processes)


def _alike(plan: Plan, process: Process) -> list[Limbs]:
    found = simd_groups(plan, process)
    return more_alike(plan, process, found, lambda limbs: unlike(plan, limbs))


def straight_line(plan: Plan, *, lanes: bool = True) -> tuple[Simulated, ...]:
    """Return the plan's processes as a straight line is emitted: in lanes where that is less work.

    Args:
        plan: the plan.
        lanes: whether limbs may share code at all.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    grouping = chosen_grouping(plan) if lanes else ()
    return simulate(plan, grouping) if any(grouping) else simulate(plan)


def chosen_grouping(plan: Plan) -> Grouping:
    """Return the limbs that share a straight line: for each process none where that is more work.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    grouping = grouping_of(plan)
    if any(grouping):
        alone, together = (
            max(one.operations.instructions for one in line)
            for line in (simulate(plan), simulate(plan, grouping))
        )
        if together < alone:
            return grouping
    return tuple(() for _ in plan.processes)
