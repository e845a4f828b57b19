"""Where the joints of loops lie in memory."""

from __future__ import annotations

from adagen.plan.simd_groups import Limbs
from adagen.program.slots import COLUMNS, Slots
from adagen.schedule import step_costs
from tests.emitted import plan_of
from tests.models import star

LEGS = Limbs(((1, 3), (2, 4)))
"""The first two arms of a star with two joints in each, side by side."""


def _slots(arms: int) -> tuple[int, ...]:
    plan = plan_of(star(arms, floating=True), 1)
    return Slots.of(plan, ((LEGS,),), step_costs(None)).slots


def test_joints_keep_their_order_where_no_other_takes_fewer_blocks() -> None:
    assert _slots(3) == (4, 0, 2, 1, 3, 5, 6)


def test_joints_of_one_freedom_lie_in_one_block_where_they_fit() -> None:
    slots = _slots(4)
    assert slots == (8, 0, 2, 1, 3, 4, 5, 6, 7)  # the floating base, joint 0, lies behind
    assert {slot // COLUMNS for slot in slots[1:]} == {0}
