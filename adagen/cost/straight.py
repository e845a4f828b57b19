"""What straight lines of statements take: shape `unrolled`."""

from __future__ import annotations

import math

from adagen.cost.features import Features, added
from adagen.executor import simulate, stretches
from adagen.program import Program
from adagen.schedule.costs import StepCosts


def straight_features(program: Program, held: float) -> Features:
    """Return what the straight line of a program of one process is made of.

    Args:
        program: of shape `unrolled`.
        held: statements that the first instruction cache holds.
    """
    (process,) = simulate(program.plan, program.slots.limbs)
    parts = stretches(process, program.plan.processes[0].steps, held)
    return added([{"unrolled.evaluation": 1}, *(part.features for part in parts)])


def straight_times(program: Program, costs: StepCosts) -> list[list[float]]:
    """Return the time of every operation of every process, microseconds on a core of speed 1.

    The operations of a stretch share its time by their statements.
    """
    found = []
    line = simulate(program.plan, program.slots.limbs)
    # In batches instructions are fetched once for all lanes.
    held = math.inf if program.batch else costs["unrolled.held"]
    for simulated, process in zip(line, program.plan.processes, strict=True):
        times = [0.0] * len(process.steps)
        for part in stretches(simulated, process.steps, held):
            total, all_of_them = costs.total(part.features), max(1, sum(part.statements.values()))
            for step, count in part.statements.items():
                times[step] = total * count / all_of_them
        found.append(times)
    return found
