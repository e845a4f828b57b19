"""Runs that exceed the second-level cache, computed tile by tile.

See templates/include/adagen/kernels/tiles.hpp. All tiles use the same memory; beyond that, only the
data of the outward sweep is stored for each joint.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from adagen.plan import Plan
from adagen.plan.steps import Join
from adagen.program.runs import Run, own_axes_in_loops, pays_columns
from adagen.schedule.caches import swept_whole
from adagen.schedule.costs import StepCosts

TILE = 128
"""Joints of a tile: what they are swept with, some 500 bytes each, stays in the second-level cache
beside what is kept of all. A chain of 10,000 takes 46, 43 and 41 ns a joint by tiles of 512, 256
and 128. Whole blocks, in double and in float."""


def fits_tiles(plan: Plan, in_strips: Sequence[Run], costs: StepCosts) -> bool:
    """Whether a plan is that of a long chain of hinges on the ground, on one process.

    Args:
        plan: the plan.
        in_strips: the runs that are passed outwards in strips.
        costs: by which runs are computed by columns, and the size of the cache.
    """
    joints = plan.joints
    whole = Run(0, len(joints) - 1)
    if (
        len(plan.processes) > 1
        or any(plan.steps_of(Join))
        or list(in_strips) != [whole]
        or whole.length <= max(TILE, swept_whole(costs))
    ):
        return False
    if plan.slaved or plan.wrenches or plan.parameters or plan.closed:
        return False
    if plan.wanted or plan.outputs or plan.at_rest:
        return False
    if plan.weighed:
        return False  # certificates and corrections sweep all joints once more
    if any(joint.kind != "revolute" or joint.prescribed for joint in joints):
        return False
    own_axes = own_axes_in_loops(plan, ((),))
    return not own_axes.always and not own_axes.if_lost and pays_columns(joints, whole, costs)


def tiles_of(run: Run, tile: int) -> Iterator[Run]:
    """Yield the tiles of a run; the last one may be shorter."""
    for first in range(run.first, run.last + 1, tile):
        yield Run(first, min(first + tile - 1, run.last))
