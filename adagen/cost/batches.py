"""Predicted time of batches: registers of which each lane holds a state."""

from __future__ import annotations

import math
from collections.abc import Iterator

from adagen.cost.features import Features, added, weighed_joints
from adagen.cost.straight import straight_stretches
from adagen.executor.stretches import SINES
from adagen.model import KINDS
from adagen.plan import Plan
from adagen.plan.passive import tangents
from adagen.program import Program
from adagen.schedule.costs import BATCH, StepCosts

_BYTES = {"double": 8, "float": 4}
"""Of a number."""


def states_at_once(program: Program, register: float) -> int:
    """Return how many states an evaluation solves: those in a register of so many bytes, or one."""
    return int(register) // _BYTES[program.plan.scalar] if program.batch else 1


def batch_features(program: Program) -> Features:
    """Return the coefficients by which a register full of states is priced.

    Args:
        program: of a batch.
    """
    return added((*_computed(program), {f"{BATCH}.number": _moved(program.plan)}))


def _computed(program: Program) -> Iterator[Features]:
    for own in program.plan.processes:
        if rates := tangents(program.plan, own):
            yield {f"{BATCH}.tangent": rates}
    if program.shape != "unrolled":
        yield from ({f"{BATCH}.{joint.kind}": 1.0} for joint in program.plan.joints)
        yield from _beside(program)
        return
    for process in straight_stretches(program, math.inf):
        for part in process:
            yield {
                f"{BATCH}.operation": part.features["unrolled.operation"],
                f"{BATCH}.sine": part.features[SINES],
            }


def _beside(program: Program) -> Iterator[Features]:
    """What loops cost beside their joints: own axes, and sweeps of residuals."""
    joints = len(program.plan.joints)
    for process in program.processes:
        for operation in process.operations:
            if operation.method == "turned":
                yield {f"{BATCH}.turned": len(operation.steps)}
            for step in operation.steps:
                if swept := len(weighed_joints(step, joints)):
                    yield {f"{BATCH}.weighed": swept}


def _moved(plan: Plan) -> int:
    """The numbers of a state that are moved into a lane or out of it."""
    nq = sum(KINDS[joint.kind].nq for joint in plan.joints)
    return nq + plan.nv + plan.entry_of_wrench(len(plan.wrenches)) + plan.nqdd


def of_registers(program: Program, costs: StepCosts, times: list[list[float]]) -> list[list[float]]:
    """Return times of operations on registers: shares of what all of them are priced.

    Args:
        program: of a batch.
        costs: the prices.
        times: of the operations of each process on numbers of one state.
    """
    share = costs.total(batch_features(program)) / (sum(map(sum, times)) or 1.0)
    return [[share * time for time in own] for own in times]
