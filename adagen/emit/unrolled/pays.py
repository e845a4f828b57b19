"""Where a straight line is expected to be the fastest shape of a batch."""

from __future__ import annotations

from adagen.executor import simulate
from adagen.model.kinds import KINDS
from adagen.plan import Plan

_MOST_FREEDOMS_IN_LANES = 512
_MOST_EACH_IN_LANES = 450


def pays_in_lanes(plan: Plan) -> bool:
    """Return whether a straight line is expected to be the best shape for batches.

    Its code is fetched once for all lanes, so that it wins on large robots, too, if structure saves
    something (docs/code_shapes.md); with more freedoms it takes a compiler minutes.
    """
    freedoms = _freedoms(plan)
    if freedoms > _MOST_FREEDOMS_IN_LANES:
        return False
    work = sum(one.operations.arithmetic for one in simulate(plan))
    return work <= _MOST_EACH_IN_LANES * freedoms


def _freedoms(plan: Plan) -> int:
    return sum(KINDS[joint.kind].nv for joint in plan.joints)
