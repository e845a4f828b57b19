"""Executes a plan in numpy, all processes in one: how plans are tested without a compiler."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.plan.interpret.machine import Machine, PlanError
from adagen.plan.types import Plan

Array = NDArray[np.float64]

__all__ = ["PlanError", "execute", "interpret", "run_machines", "with_slaved"]


def interpret(plan: Plan, q: Array, v: Array, tau: Array) -> Array:
    """Return the joint accelerations that a plan computes.

    Args:
        plan: the plan.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        tau: joint torques and forces (prescribed joints: accelerations), then outer forces.

    Returns:
        Accelerations, shape (nv,).

    Raises:
        PlanError: a process waits for a message that never comes, or reads what it does not have.
        FloatingPointError: a factorization failed; the message names the joint.
    """
    qdd, _ = execute(plan, q, v, tau)
    return qdd


def execute(plan: Plan, q: Array, v: Array, tau: Array) -> tuple[Array, list[dict[Any, Any]]]:
    """Do what ``interpret`` does; return every process's memory as well."""
    q, v = with_slaved(plan, q, v)
    qdd = np.full(v.shape, np.nan)
    mail: dict[int, dict[Any, Array]] = {}
    machines = [Machine(plan, mail, q, v, tau, qdd) for _ in plan.processes]
    try:
        run_machines(plan, machines)
    except FloatingPointError:
        if not any(process.recovery for process in plan.processes):
            raise
        return execute(plan.recovering(), q, v, tau)
    return qdd, [machine.memory for machine in machines]


def run_machines(plan: Plan, machines: Sequence[Machine]) -> None:
    """Let each process do its steps, as far as messages have come, until all are done.

    Raises:
        PlanError: a process waits for a message that never comes.
    """
    positions = [0] * len(machines)
    moved = True
    while moved:
        moved = False
        for p, (machine, process) in enumerate(zip(machines, plan.processes, strict=True)):
            while positions[p] < len(process.steps) and machine.step(process.steps[positions[p]]):
                positions[p] += 1
                moved = True
    for p, process in enumerate(plan.processes):
        if positions[p] < len(process.steps):
            raise PlanError(f"process {p} waits for ever at {process.steps[positions[p]]}")


def with_slaved(plan: Plan, q: Array, v: Array) -> tuple[Array, Array]:
    """Return q, shape (nq,), and v, shape (nv,), with slaved joints' entries from their sources."""
    q, v = np.array(q, dtype=float), np.array(v, dtype=float)
    for j in plan.slaved:
        joint = plan.joints[j]
        assert joint.mimic is not None
        source, multiplier, offset = joint.mimic
        q[joint.q] = multiplier * q[plan.joints[source].q] + offset
        v[joint.v] = multiplier * v[plan.joints[source].v]
    return q, v
