"""Joints that the loops of a program compute in the axes of their own links."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from adagen.executor.lanes import Grouping
from adagen.plan.order import inward_order
from adagen.plan.own_axes import OwnAxes, own_axes_of_units
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Articulate
from adagen.plan.types import Plan
from adagen.program.runs import units_of_sweep


@lru_cache(maxsize=16)  # of one program it is asked for each process, and again to print it
def own_axes_in_loops(plan: Plan, limbs: Grouping, batch: bool = False) -> OwnAxes:
    """Return the joints of a plan that loops sweep in their own axes.

    Args:
        plan: a plan of form segment.
        limbs: those that each process takes side by side.
        batch: whether SIMD lanes are for states: one of them loses digits too often for a sweep to
            be repeated for all.
    """
    rows = [row for own in limbs for each in own for row in each.rows]
    found = own_axes_of_units(plan, rows, _units(plan, limbs))
    return OwnAxes(found.always | found.if_lost, frozenset()) if batch else found


def _units(plan: Plan, limbs: Grouping) -> Iterator[frozenset[int]]:
    """The joints that are swept at once."""
    for process, own in zip(plan.processes, limbs, strict=True):
        for steps, together in ((process.steps, own), (process.recovery, ())):
            swept = [step for step in steps if isinstance(step, Articulate)]
            for unit in units_of_sweep(plan.joints, swept, together, inward_order):
                yield frozenset(unit.members() if isinstance(unit, Limbs) else unit.joints())
