"""Code shapes: how the steps of a plan become functions.

* ``kernels``: loops over runs of joints in axes that all links of a base share, several links at
  once where nothing is carried along. It takes plans of form segment.
* ``joints``: joint-local frames, a function for each joint and step, one call after the other. It
  takes every plan.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from adagen.emit import kernels
from adagen.emit.joints import joint_rows
from adagen.emit.processes import step_rows
from adagen.emit.words import Words
from adagen.errors import UsageError
from adagen.plan import Plan
from adagen.plan.steps import StartLink


@dataclass(frozen=True)
class Shape:
    """A code shape.

    Attributes:
        why_not: says why a plan cannot be emitted in it; None where it can.
        values: what its template (SHAPE.cpp.j2, sections 4 and 5 of the file) is told.
    """

    why_not: Callable[[Plan], str | None]
    values: Callable[[Words], dict[str, object]]


def _joints_why_not(plan: Plan) -> str | None:
    if any(message.inertias for message in plan.messages):
        return "the processes of this plan gather their inertias"
    return None


def _joints(words: Words) -> dict[str, object]:
    segments = any(
        isinstance(step, StartLink) for process in words.plan.processes for step in process.steps
    )
    runtime = ["spatial.hpp", "status.hpp", "joins.hpp", *["articulated.hpp"] * segments]
    return {
        "runtime": runtime,
        "joint_functions": joint_rows(words),
        "steps": step_rows(words),
    }


SHAPES: dict[str, Shape] = {
    "kernels": Shape(kernels.why_not, kernels.values),
    "joints": Shape(_joints_why_not, _joints),
}
"""By name; where none is asked for, the first that takes a plan."""


def chosen_shape(plan: Plan, shape: str = "auto") -> str:
    """Return the shape that a plan is emitted in: the one asked for, or the fastest that takes it.

    Raises:
        UsageError: the plan cannot be emitted in the shape asked for.
    """
    if shape == "auto":
        return next(name for name, candidate in SHAPES.items() if candidate.why_not(plan) is None)
    reason = SHAPES[shape].why_not(plan)
    if reason is not None:
        raise UsageError(f"shape {shape} cannot be emitted: {reason}")
    return shape
