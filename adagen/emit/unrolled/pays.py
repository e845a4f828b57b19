"""What a straight line costs, and where it is expected to be the fastest shape."""

from __future__ import annotations

from adagen.executor import simulate
from adagen.model.kinds import KINDS
from adagen.plan import Plan
from adagen.plan.abreast import limbs_abreast

_MOST_FREEDOMS = 24
_MOST_FREEDOMS_IN_LANES = 512
_MOST_EACH_IN_LANES = 450
_MOST_OPERATIONS = 3000  # of one process: about 20 kB of code
_MOST_EACH = 250  # products and sums for each degree of freedom
_MOST_EACH_ABREAST = 325  # the same, limbs that loops pass side by side being counted once


def pays_unrolled(plan: Plan) -> bool:
    """Return whether a straight line is expected to be the fastest shape (docs/code_shapes.md).

    It wins by what structure saves: few operations for each degree of freedom, and code that stays
    in the first-level cache. Loops win by what lies side by side.
    """
    freedoms = _freedoms(plan)
    if freedoms > _MOST_FREEDOMS:
        return False
    work = [one.operations.arithmetic for one in simulate(plan)]
    most = min(_MOST_EACH * freedoms, _MOST_EACH_ABREAST * (freedoms - _saved_abreast(plan)))
    return max(work) <= _MOST_OPERATIONS and sum(work) <= most


def pays_unrolled_in_lanes(plan: Plan) -> bool:
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


def _saved_abreast(plan: Plan) -> int:
    """Freedoms of limbs that shape kernels passes beside others, as no step of their own."""
    return sum(
        KINDS[plan.joints[j].kind].nv
        for process in plan.processes
        for limbs in limbs_abreast(plan, process)
        for row in limbs.rows
        for j in row[1:]
    )
