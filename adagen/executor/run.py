"""Runs all processes of a plan over expressions, messages included."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import accumulate, chain
from typing import Any

from adagen.executor.lane_frames import aligned
from adagen.executor.lanes import Grouping, steps_in_order
from adagen.executor.machine import Machine
from adagen.executor.state import Refining
from adagen.graph import Operations, count_operations
from adagen.plan.steps import Step
from adagen.plan.types import Plan


class PlanError(Exception):
    """A plan that cannot be executed: it deadlocks, or a step reads what nobody wrote."""


@dataclass(frozen=True)
class Simulated:
    """A process after all its steps.

    Attributes:
        machine: its graph and what is wanted of it.
        ends: number of nodes in the graph after each step and all before it.
    """

    machine: Machine
    ends: tuple[int, ...]

    @cached_property
    def operations(self) -> Operations:
        """Number of operations of an evaluation in this process."""
        return count_operations(self.machine.graph, self.machine.roots())


def _done(machine: Machine, step: Step) -> bool:
    """Execute a step; return whether it need not wait for a message."""
    try:
        return machine.step(step)
    except KeyError as missing:
        raise PlanError(f"{step} reads {missing}, which this process does not have") from None


@lru_cache(maxsize=12)  # a plan is judged, priced and emitted one after the other, in lanes or not
def each_for_itself(
    plan: Plan, grouping: Grouping | None = None, refining: Refining = None
) -> tuple[Simulated, ...]:
    """Return the plan's processes after all their steps, each with a straight line of its own.

    Args:
        plan: the plan.
        grouping: which limbs share code, one in each lane; None for none. Link frames are then
            turned as these agree best (lane_frames.py).
        refining: what of iterative refinement is computed, if any.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    mail: dict[int, list[Any]] = {}
    limbs = grouping or tuple(() for _ in plan.processes)
    robot = aligned(plan, chain.from_iterable(limbs)) if any(limbs) else plan
    machines = [
        Machine(robot, mail, refining, all_limbs=own, steps=process.steps)
        for own, process in zip(limbs, plan.processes, strict=True)
    ]
    return after_all_steps(plan, machines)


def after_all_steps(plan: Plan, machines: Sequence[Machine]) -> tuple[Simulated, ...]:
    """Run the steps of a plan's processes on machines that share their messages.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    orders = [
        steps_in_order(plan, process, machine.limbs)
        for machine, process in zip(machines, plan.processes, strict=True)
    ]
    done = [0] * len(machines)
    ends = [[0] * len(process.steps) for process in plan.processes]
    moved = True
    while moved:
        moved = False
        for p, (machine, process) in enumerate(zip(machines, plan.processes, strict=True)):
            while done[p] < len(orders[p]):
                place = orders[p][done[p]]
                machine.graph.mark = place
                if not _done(machine, process.steps[place]):
                    break
                ends[p][place] = len(machine.graph.nodes)
                done[p] += 1
                moved = True
    for p, (process, order) in enumerate(zip(plan.processes, orders, strict=True)):
        if done[p] < len(order):
            raise PlanError(f"process {p} waits for ever at {process.steps[order[done[p]]]}")
        own = plan.force_entries(process)
        machines[p].forces = {k: x for k, x in machines[p].forces.items() if k in own}
    return tuple(
        Simulated(machine, tuple(accumulate(own, max)))
        for machine, own in zip(machines, ends, strict=True)
    )
