"""From a plan to a program: steps combined to operations, with their methods."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from adagen.executor.lanes import Grouping
from adagen.plan.stages import stages
from adagen.plan.steps import Step
from adagen.plan.types import Plan, Process
from adagen.program.loops import Loops
from adagen.program.slots import Slots
from adagen.program.types import Method, Operation, ProcessProgram, Program
from adagen.schedule import step_costs
from adagen.schedule.costs import StepCosts

LOOPS = "kernels"
"""The shape whose operations are loops over runs and limbs; the others go step by step."""


@lru_cache(maxsize=16)  # a plan is priced, checked, drawn and emitted one after the other
def lower(
    plan: Plan,
    shape: str,
    *,
    batch: bool = False,
    limbs: Grouping | None = None,
    costs: StepCosts | None = None,
    again: bool = False,
) -> Program:
    """Return the program of a plan in a shape (``adagen.cost.programmed``: the fastest one).

    Args:
        plan: what each process computes.
        shape: "kernels", "unrolled", "joints" or a baseline; one that takes the plan.
        batch: whether SIMD lanes are for states.
        limbs: those that each process takes side by side; None for none.
        costs: prices the methods by which runs can be passed; the shipped ones if not given.
        again: whether sweeps are done again, for what is left over (refinement).
    """
    grouping = tuple(() for _ in plan.processes) if limbs is None else limbs
    prices = step_costs(None) if costs is None else costs
    if shape != LOOPS:
        method: Method = "straight" if shape == "unrolled" else "step"
        processes = tuple(
            ProcessProgram(
                _step_by_step(process, method),
                _step_by_step(_recovery_of(process), method),
                tuple(
                    _step_by_step(replace(process, steps=other), method) for other in process.others
                ),
            )
            for process in plan.processes
        )
        slots = replace(Slots.plainly(plan), limbs=grouping)
        return Program(plan, shape, batch, slots, processes, tuple(() for _ in plan.processes))
    slots = Slots.plainly(plan) if batch else Slots.of(plan, grouping, prices, again=again)
    programs = []
    for p, process in enumerate(plan.processes):
        found = Loops(plan, process, slots, slots.limbs[p], batch, prices, again=again)
        recovery: tuple[Operation, ...] = ()
        if process.recovery:
            other = _recovery_of(process)
            recovery = Loops(plan, other, slots, (), batch, prices, again=again).operations()
        programs.append(ProcessProgram(found.operations(), recovery))
    return Program(plan, shape, batch, slots, tuple(programs))


def _recovery_of(process: Process) -> Process:
    """The process with the steps of its recovery in place of the others."""
    return Process(process.recovery, process.reads, process.owns, process.shares)


def _step_by_step(process: Process, method: Method) -> tuple[Operation, ...]:
    """One operation for each step."""
    steps: tuple[Step, ...] = process.steps
    return tuple(
        Operation(step.does, None, method, (step,), number)
        for number, stage in enumerate(stages(process))
        for step in steps[stage.first : stage.last]
    )
