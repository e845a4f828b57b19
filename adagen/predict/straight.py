"""Which plans are emitted as straight lines, and priced as they are emitted."""

from __future__ import annotations

from adagen.emit.shapes import SHAPES, chosen_shape, stepwise
from adagen.plan import Plan


def goes_straight(plan: Plan, shape: str = "auto") -> bool:
    """Return whether a plan is emitted as straight lines.

    Args:
        plan: the plan.
        shape: what was asked for, as ``adagen.emit.emit`` takes it.
    """
    if SHAPES["unrolled"].why_not(plan) is not None:
        return False
    return (chosen_shape(plan) if shape == "auto" else shape) == "unrolled"


def is_priced(plan: Plan, shape: str) -> bool:
    """Return whether cost profiles price a plan in a shape, and not only in a faster one.

    Args:
        plan: the plan.
        shape: one of ``adagen.emit.shapes.KNOWN``.
    """
    return goes_straight(plan, shape) or shape == stepwise(plan)
