"""Long chains in parts, one in each SIMD lane: where a chain may be divided.

See adagen/plan/parts.py. Parts are as long as each other, so that there is nothing to search: they
are cut where that falls, and where a cut would cost digits the chain stays whole.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from adagen.emit import kernels
from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import make_plan
from adagen.plan.certificate import certified
from adagen.plan.steps import Join
from adagen.schedule import Schedule

MOST_JOINTS = 3000
"""Joints of a chain that may be in parts: to find how many digits these keep takes 2 ms for each.

A chain of 10,000 would be generated in a minute instead of half of that. Parts stay the faster way
in caches beyond the second level, too (docs/records/chains.md).
"""


def parted(schedule: Schedule, model: Model, parts: int) -> Schedule | None:
    """Return a schedule whose processes sweep their chains in parts; None where none is parted.

    Args:
        schedule: who has what.
        model: the robot.
        parts: as many as SIMD lanes; 0: none.
    """
    if not parts or len(model.joints) > MOST_JOINTS:
        return None
    found = replace(schedule, parts=parts)
    more = joined(found, model) - joined(schedule, model)
    return found if more else None


def certifies(schedule: Schedule, model: Model) -> bool:
    """Return whether loops bound the errors of a schedule whose process has its chain in parts."""
    try:
        plan = certified(make_plan(model, schedule))
    except AdagenError:
        return False
    return any(plan.steps_of(Join)) and kernels.why_not(plan) is None


def joined(schedule: Schedule, model: Model) -> set[int]:
    """Return the joints at which a schedule's processes join anything."""
    return {step.joint for step in make_plan(model, schedule).steps_of(Join)}


def keeps_digits(schedule: Schedule, model: Model, cuttable: Sequence[bool]) -> bool:
    """Return whether joins lose no more digits than is let pass, those inside processes, too.

    Args:
        schedule: of a robot none of whose links are treated as one.
        model: the robot.
        cuttable: for each joint whether mobilities may meet there.
    """
    return all(cuttable[j] for j in joined(schedule, model))
