"""What solves another robot is not emitted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.emit import program_of
from adagen.executor.rows import Rows
from adagen.executor.run import PlanError
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
    checked(replace(quadruped(), at_rest=True))  # looked at without velocities
    monkeypatch.setattr("adagen.executor.closures.is_rigid", lambda *_: True)
    with pytest.raises(AssertionError, match="solves another robot"):
        checked(geared_pairs(["trunk"] * 3, [("trunk", None), ("tail", "near2")]))


@pytest.mark.parametrize(
    ("shape", "form", "procs"),
    [("kernels", "segment", 2), ("joints", "ada", 2), ("unrolled", "ada", 1)],
)
def test_other_shapes_are_checked_too(shape: str, form: str, procs: int) -> None:
    """A body whose centre of mass is elsewhere, and a joint whose acceleration is left out."""
    robot = adagen.read(EXAMPLES / "mobile.urdf")
    found = adagen.compile(robot, procs, shape=shape, form=form, schedule="balanced")
    plan, program = found.plan, found.program
    check_answer(robot.model, plan, program)
    *links, tip = plan.links
    moved = replace(
        tip, com=(0.3, *tip.com[1:]), phi=tuple(map(tuple, np.diag([5.0] * 3 + [1.0] * 3)))
    )
    with pytest.raises(AssertionError, match="solves another robot"):
        check_answer(robot.model, replace(plan, links=(*links, moved)), program)
    first, *others = program.processes
    kept = [each for each in first.operations if each.does not in ("accelerate", "disassemble")]
    short = replace(program, processes=(replace(first, operations=tuple(kept)), *others))
    with pytest.raises((AssertionError, PlanError), match=r"solves another robot|does not have"):
        check_answer(robot.model, plan, short)
