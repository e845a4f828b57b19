"""A straight line that solves another robot is not emitted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

import adagen
from adagen.executor.rows import Rows
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
