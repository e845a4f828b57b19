"""Constants of a robot that can be set at run time."""

from __future__ import annotations

from adagen.errors import UsageError, printable
from adagen.model import Model
from adagen.plan.types import PlanParameter


def parameters_of(model: Model, runtime: str) -> tuple[PlanParameter, ...]:
    """Return what of a robot can be set at run time.

    Args:
        model: the robot.
        runtime: words with commas between them: "gravity".

    Raises:
        UsageError: an unknown word, or one that is said twice.
    """
    found: dict[str, PlanParameter] = {}
    for word in filter(None, runtime.split(",")):
        if word in found:
            raise UsageError(f"{printable(word)} is to be set at run time twice: say it once")
        found[word] = _parameter(model, word)
    return tuple(found.values())


def _parameter(model: Model, word: str) -> PlanParameter:
    if word == "gravity":
        return PlanParameter("gravity", tuple(float(g) + 0.0 for g in model.gravity))
    raise UsageError(f"what can be set at run time is gravity, not {printable(word)}")
