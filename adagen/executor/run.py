"""Lets all processes of a plan run over expressions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

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
        ends: number of nodes in the graph after each step.
    """

    machine: Machine
    ends: tuple[int, ...]

    @cached_property
    def operations(self) -> Operations:
        """What an evaluation costs this process."""
        return count_operations(self.machine.graph, self.machine.roots())


def _done(machine: Machine, step: Step) -> bool:
    """Do a step; whether it need not wait for a message."""
    try:
        return machine.step(step)
    except KeyError as missing:
        raise PlanError(f"{step} reads {missing}, which this process does not have") from None


@lru_cache(maxsize=4)  # a plan is judged, priced and emitted one after the other
def simulate(plan: Plan, refining: Refining = None) -> tuple[Simulated, ...]:
    """Return the plan's processes, each after all its steps; nobody may change them.

    Args:
        plan: the plan.
        refining: what of iterative refinement is computed, if any.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    mail: dict[int, list[Any]] = {}
    return after_all_steps(plan, [Machine(plan, mail, refining) for _ in plan.processes])


def after_all_steps(plan: Plan, machines: Sequence[Machine]) -> tuple[Simulated, ...]:
    """Let machines that share their mail do the steps of a plan's processes.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    ends: list[list[int]] = [[] for _ in machines]
    moved = True
    while moved:
        moved = False
        for machine, process, reached in zip(machines, plan.processes, ends, strict=True):
            while len(reached) < len(process.steps):
                machine.graph.mark = len(reached)
                if not _done(machine, process.steps[len(reached)]):
                    break
                reached.append(len(machine.graph.nodes))
                moved = True
    for p, (process, reached) in enumerate(zip(plan.processes, ends, strict=True)):
        if len(reached) < len(process.steps):
            raise PlanError(f"process {p} waits for ever at {process.steps[len(reached)]}")
    return tuple(Simulated(*pair) for pair in zip(machines, map(tuple, ends), strict=True))
