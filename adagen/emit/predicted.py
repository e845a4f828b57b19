"""Predicted time of a plan, for the program that is emitted for it."""

from __future__ import annotations

from adagen.cost import Timeline, programmed, timeline
from adagen.emit.shapes import SHAPES, chosen_shape, stepwise
from adagen.plan import Plan
from adagen.program import Program
from adagen.schedule import CostProfile


def priced_program(plan: Plan, shape: str = "auto", profile: CostProfile | None = None) -> Program:
    """Return the program by which a plan is priced, for one state at a time.

    Args:
        plan: what each process computes.
        shape: of the code, as ``adagen.emit.emit`` takes it; where the plan cannot be had in it,
            the fastest that does the plan step by step.
        profile: what shape, limbs side by side and methods are chosen by; the shipped one if not
            given.
    """
    if shape == "auto":
        return programmed(plan, chosen_shape(plan, profile=profile), profile)
    known = shape in SHAPES and SHAPES[shape].why_not(plan) is None
    return programmed(plan, shape if known else stepwise(plan), profile)


def predict(plan: Plan, profile: CostProfile, shape: str = "auto") -> Timeline:
    """Return the predicted timeline of an evaluation.

    Args:
        plan: what each process does, in either form.
        profile: a profile with the costs of steps.
        shape: of the code, as ``priced_program`` takes it.

    Raises:
        ValueError: the profile prices joins alone, as the paper's does.
    """
    return timeline(priced_program(plan, shape, profile), profile)
