"""Joints with passive forces, which are computed before all else."""

from __future__ import annotations

from adagen.plan.types import Plan, Process


def loaded(plan: Plan, process: Process) -> list[int]:
    """Return the joints that a process reads the torque of and that have passive forces.

    Those with friction come first.
    """
    numbers = sorted((*process.owns, *process.shares, *process.spares))
    found = [j for j in numbers if plan.joints[j].loads]
    return sorted(found, key=lambda j: not plan.joints[j].friction)


def tangents(plan: Plan, process: Process) -> int:
    """Return how many hyperbolic tangents a process takes in an evaluation, for friction."""
    return sum(plan.joints[j].tangents for j in loaded(plan, process))
