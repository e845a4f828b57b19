"""Predictions for a schedule, as text and as JSON."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING

from adagen.errors import printable

if TYPE_CHECKING:
    from adagen.cost import Timeline
    from adagen.library.solver import Compiled
    from adagen.schedule import Schedule
    from adagen.search.objective import Digits


def batch_prediction(made: Compiled) -> str:
    """Return what is predicted of a batch in a few words."""
    profile = made.request.profile
    if made.predicted is None:
        return f"the time of batches is not predicted: the profile {profile} prices joins alone"
    time = made.predicted
    told = f"{1e3 * time:.3g} ns" if time < 0.9995 else f"{time:.3g} us"
    return f"{told} a state predicted ({made.schedule.profile} profile)"


def prediction(schedule: Schedule, line: Timeline | None) -> str:
    """Return the prediction and its bound in a few words.

    Args:
        schedule: the schedule.
        line: how its program is predicted to go on a machine, where the profile tells that.
    """
    time = schedule.makespan if line is None else line.makespan
    # What is proven is of the schedules and the price that were searched.
    searched = math.isclose(time, schedule.makespan, rel_tol=1e-9)
    proof = f"; {schedule.proven}" if searched else ""
    return f"{time:.2f} us predicted ({schedule.profile} profile{proof})"


def accuracy_line(digits: Digits | None) -> str:
    """Return in a line what is predicted of a schedule's digits."""
    if digits is None:
        return "no digits predicted: a factorization fails"
    kept = f"{-math.log10(digits.error):.1f} digits predicted"
    hard = "" if digits.hard is None else f"; {-math.log10(digits.hard):.1f} in hard poses"
    if digits.joint is None:
        at = printable(digits.worst)
        return f'{kept}: no loss at joins; the largest loss is in the sweep at joint "{at}"{hard}'
    return f'{kept}: growth {digits.growth:.1e} at joint "{printable(digits.joint)}"{hard}'


def with_accuracy(text: str, digits: Digits | None) -> str:
    """Return a schedule's JSON (however deep) with a member on its accuracy before the last brace.

    Args:
        text: a JSON object that is not empty.
        digits: what is predicted; null where a factorization fails.
    """
    found = None
    if digits is not None:
        found = {
            "objective": digits.objective,
            "digits": round(-math.log10(digits.error), 2),
            "error": digits.error,
            "growth": digits.growth if math.isfinite(digits.growth) else None,
            "joint": digits.joint,
            "worst": digits.worst,
            "hard_digits": None if digits.hard is None else round(-math.log10(digits.hard), 2),
            "hard_error": digits.hard,
            "hardest": digits.hardest,
        }
    head = text.rstrip().removesuffix("}")
    return f'{head}, "accuracy": {json.dumps(found)}}}'
