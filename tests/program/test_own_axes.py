"""Which joints loops sweep in their own axes, as their runs and limbs are swept together."""

from __future__ import annotations

from adagen.plan.own_axes import OwnAxes
from adagen.plan.simd_groups import Limbs
from adagen.program.runs import own_axes_in_loops
from adagen.studies.stability import robots
from tests.emitted import plan_of
from tests.models import POINT, three_axis_chain

BALLS = frozenset(range(6))


def test_a_run_swept_at_once_turns_where_digits_are_lost() -> None:
    plan = plan_of(three_axis_chain(2, POINT), 1)
    assert own_axes_in_loops(plan, ((),)) == OwnAxes(frozenset(), BALLS)


def test_joints_told_to_another_unit_always_turn() -> None:
    # Joints 1 and 2 in lanes are passed to joint 0, along whose axis they may come to lie; the link
    # beyond joint 2 is solid.
    plan = plan_of(three_axis_chain(2, POINT), 1)
    found = own_axes_in_loops(plan, ((Limbs(((1,), (2,))),),))
    assert found.always == {0, 1, 2}
    assert found.if_lost == BALLS - found.always


def test_ordinary_robots_do_not_turn_however_they_are_swept() -> None:
    plan = plan_of(robots.rods(6), 1)
    none = OwnAxes(frozenset(), frozenset())
    assert own_axes_in_loops(plan, ((Limbs(((2,), (3,))),),)) == none
