"""Subnormal numbers: solvers that make them in float take them for zero."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.plan import make_plan
from adagen.plan.digits import meets_subnormals
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States
from tests.emitted import ROUNDING, forward_error, truth_of
from tests.plan.test_parts import hinges

LINK = (
    '<link name="{0}"><inertial><origin xyz="0.1 0 0"/><mass value="0.5"/>'
    '<inertia ixx="1e-4" iyy="2e-3" izz="2e-3" ixy="0" ixz="0" iyz="0"/></inertial></link>'
)
JOINT = (
    '<joint name="{0}" type="continuous"><parent link="{1}"/><child link="{2}"/>'
    '<origin xyz="0.2 0 0" rpy="{3} 0 0"/><axis xyz="0 0 1"/></joint>'
)
SETTING = "kMeetsSubnormals = true"
REST = np.zeros(2)
RIGHT_ANGLE = np.pi / 2  # a rotation by it has entries of 6e-17


def compiled(folder: Path, angle: float, **asked: Any) -> adagen.Compiled:
    """Two links without gravity, joined by hinges whose frames are turned by an angle."""
    parts = [
        '<link name="ground"/>',
        *(LINK.format(name) for name in ("upper", "lower")),
        JOINT.format("first", "ground", "upper", angle),
        JOINT.format("second", "upper", "lower", angle),
    ]
    path = folder / "turned.urdf"
    path.write_text(f'<robot name="turned">{"".join(parts)}</robot>', encoding="utf-8")
    return adagen.compile(adagen.read(path, gravity=(0, 0, 0)), **asked)


@pytest.mark.parametrize(("shape", "batch"), [("unrolled", False), ("kernels", True)])
def test_they_are_zero_in_a_solver_and_nowhere_else(
    shape: str, batch: bool, tmp_path: Path
) -> None:
    made = compiled(tmp_path, RIGHT_ANGLE, scalar="float", shape=shape, batch=batch)
    assert SETTING in made.source
    solver = made.build()
    least = np.finfo(np.float32).tiny
    rest = np.zeros((1, 2) if batch else 2)
    assert not np.any(solver(rest, rest, rest + least / 8))
    assert np.all(solver(rest, rest, rest + least * 8))
    assert np.float32(least) / np.float32(4) != 0  # this thread computes with them as before
    rng = np.random.default_rng(1)
    q, v, tau = rng.uniform(-1, 1, size=(3, *rest.shape))
    true = truth_of(made.model, States(*(np.atleast_2d(x) for x in (q, v, tau))))
    assert forward_error(np.atleast_2d(solver(q, v, tau)), true) < ROUNDING["float"]


@pytest.mark.parametrize(
    ("angle", "asked"),
    [
        (RIGHT_ANGLE, {"scalar": "double"}),
        (0.3, {"scalar": "float"}),
    ],
)
def test_solvers_that_meet_none_do_not_care(
    angle: float, asked: dict[str, str], tmp_path: Path
) -> None:
    made = compiled(tmp_path, angle, **asked)
    assert SETTING not in made.source
    assert np.all(made.build()(REST, REST, REST + np.finfo(np.float32).tiny / 8))


def test_a_reproducible_solver_computes_with_them(tmp_path: Path) -> None:
    made = compiled(tmp_path, RIGHT_ANGLE, scalar="float", reproducible=True)
    assert np.all(made.build()(REST, REST, REST + np.finfo(np.float32).tiny / 8))


def test_solvers_that_carry_unit_wrenches_far_make_them() -> None:
    """Hinge by hinge some of these become a tenth: within 31 of them less than 1e-38."""
    model = hinges(400, seed=2)
    schedule = best_schedule(model, 1, load_profile("xeon"))
    for parts, meets in ((16, True), (0, False)):
        plan = make_plan(model, replace(schedule, parts=parts), scalar="float")
        assert meets_subnormals(plan) == meets
    assert not meets_subnormals(make_plan(model, replace(schedule, parts=8)))
