"""Predicted time of straight lines (shape `unrolled`)."""

from __future__ import annotations

import math

from adagen.executor import counted_stretches
from adagen.executor.stretches import Stretch
from adagen.plan.steps import Receive, Send
from adagen.program import Program
from adagen.schedule.costs import StepCosts


def straight_stretches(program: Program, held: float) -> tuple[tuple[Stretch, ...], ...]:
    """Return the stretches of the straight line of each process of a program.

    Args:
        program: of shape `unrolled`.
        held: statements whose decoded instructions are held.
    """
    return counted_stretches(program.plan, program.slots.limbs, held)


def straight_times(program: Program, costs: StepCosts) -> list[list[float]]:
    """Return the time of every operation of every process, microseconds on a core of speed 1.

    The operations of a stretch share its time by their statements.
    """
    found = []
    # In batches instructions are fetched once for all lanes.
    held = math.inf if program.batch else costs["unrolled.held"]
    parts = straight_stretches(program, held)
    for own, process in zip(parts, program.plan.processes, strict=True):
        times = [0.0] * len(process.steps)
        for part in own:
            counts = {  # messages have prices of their own
                step: count
                for step, count in part.statements.items()
                if not isinstance(process.steps[step], Send | Receive)
            }
            total, all_of_them = part.time(costs), max(1, sum(counts.values()))
            for step, count in counts.items():
                times[step] = total * count / all_of_them
        found.append(times)
    return found
