"""A straight line that solves another robot is not emitted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

import adagen
from adagen.emit import program_of
from adagen.executor.rows import Rows
from adagen.library.self_check import check_answer
from adagen.model import Model
from tests.executor.test_closed_lane_branches import geared_pairs
from tests.executor.test_closures import plan_of
from tests.mechanisms import quadruped
from tests.models import Array
from tests.options import EXAMPLES


def test_a_sum_in_lanes_that_leaves_a_limb_out_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """The gravity is that of no other test: lines are kept for each plan."""
    robot = adagen.read(EXAMPLES / "human40.urdf", gravity=(0.0, 0.0, -9.7))
    line = adagen.compile(robot, shape="unrolled")
    assert line.program.slots.limbs[0]

    def first_alone(rows: Rows, value: Array, lanes: Sequence[int], _: int) -> Any:
        return rows.lane(value, lanes[0])

    other = adagen.read(EXAMPLES / "human40.urdf", gravity=(0.0, 0.0, -9.6))
    monkeypatch.setattr(Rows, "_summed", first_alone)
    with pytest.raises(AssertionError, match="solves another robot"):
        adagen.compile(other, shape="unrolled")


def checked(model: Model) -> None:
    """Make a straight line of a robot with loops in lanes, and check its answer."""
    plan = plan_of(model)
    program = program_of(plan, "unrolled")
    assert any(program.slots.limbs)
    check_answer(model, plan, program)


def test_a_limb_on_a_closed_loop_that_is_left_out_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """As it was where it hangs on a link of another lane than the first."""
    checked(geared_pairs(["trunk"] * 3, [("trunk", None), ("tail", "near1")]))
    checked(quadruped())
    monkeypatch.setattr("adagen.executor.closures.is_rigid", lambda *_: True)
    with pytest.raises(AssertionError, match="solves another robot"):
        checked(geared_pairs(["trunk"] * 3, [("trunk", None), ("tail", "near2")]))
