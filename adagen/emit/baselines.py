"""Textbook algorithms as loops over any tree, to compare with (baseline.cpp.j2)."""

from __future__ import annotations

from adagen.emit.symbols import Symbols
from adagen.plan import Plan


def why_not(plan: Plan) -> str | None:
    """Return why a plan cannot be emitted as a baseline; None where it can."""
    if len(plan.processes) > 1:
        return "a baseline runs on one process"
    if plan.closed:
        return "baselines do not support closed loops"
    passive = ("damping", "friction", "stiffness", "rotor_inertia", "prescribed")
    if any(getattr(joint, name) for joint in plan.joints for name in passive) or plan.wrenches:
        return "baselines do not support passive effects, prescribed motions or outer forces"
    if plan.wanted or plan.outputs or plan.at_rest:
        return "baselines compute all accelerations, and nothing else"
    if plan.parameters:
        return "baselines do not support constants that are set at run time"
    return "baselines do not support slaved joints" if plan.slaved else None


def values(_: Symbols) -> dict[str, object]:
    """Return the values of baseline.cpp.j2: its runtime headers."""
    runtime = ["spatial.hpp", "failures.hpp", "joins.hpp"]
    return {"runtime": [*runtime, "inertia.hpp", "articulated.hpp"]}
