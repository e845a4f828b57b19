"""Loops and couplings whose rows are small, beside others or beside what they are made of."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from adagen.executor import interpret
from adagen.library import read
from adagen.model import REVOLUTE, Model, NamedCoupling, closed
from adagen.reference.closed import closed_forward_dynamics
from tests.executor.test_closures import plan_of
from tests.mechanisms import four_bar, states_of
from tests.models import Part, rod, vector

BODY = """<inertial><origin xyz="0.1 0.02 0.05"/><mass value="1"/><inertia ixx="0.01" iyy="0.02"
  izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial>"""
AXIS = "0.3 -0.5 0.8"
TURN = "0.5 -0.7 1.1"


def solves(model: Model) -> None:
    """Check the plan's answers by dense algebra."""
    plan = plan_of(model)
    for state in states_of(model, 3).each:
        truth = closed_forward_dynamics(model, *state)
        assert np.abs(interpret(plan, *state) - truth).max() < 1e-9 * np.abs(truth).max()


def test_a_loop_that_holds_nothing(tmp_path: Path) -> None:
    """A plane across a hinge that is there anyway: its rows are rounding, all of them."""
    joints, above = "", "base"
    for k in range(3):
        joints += f"""<link name="l{k}">{BODY}</link><joint name="j{k}" type="continuous">
          <parent link="{above}"/><child link="l{k}"/><origin xyz="0.1 0.2 0.3" rpy="{TURN}"/>
          <axis xyz="{AXIS}"/></joint>"""
        above = f"l{k}"
    urdf, scene = tmp_path / "chain.urdf", tmp_path / "plane.toml"
    urdf.write_text(f'<robot name="chain"><link name="base"/>{joints}</robot>')
    axis, turn = AXIS.replace(" ", ", "), TURN.replace(" ", ", ")
    scene.write_text(
        f"""[[loops]]
        kind = "planar"
        axis = [{axis}]
        link1 = "l0"
        origin1 = {{ xyz = [0.1, 0.2, 0.3], rpy = [{turn}] }}
        link2 = "l1"
        """
    )
    robot = read(urdf, scene=scene)
    assert robot.model.closed
    solves(robot.model)


@pytest.mark.parametrize("size", [1e-12, 1e-6, 1e6])
def test_factors_of_couplings_are_of_any_size(size: float) -> None:
    """Beside a loop, and with a tolerance in the same units."""
    finger = Part("finger", None, REVOLUTE, rod(0.1, vector(0.1, 0, 0)), axis=vector(1, 0, 2))
    model = four_bar(beside=[finger])
    names = [joint.name for joint in model.joints]
    terms = (("p0", size), ("finger", -2.0 * size))
    tied = closed(
        model,
        [],
        [NamedCoupling("tie", terms, 0.1 * size, 1e-3 * size)],
        lambda _: (0, None),
        names.index,
    )
    (coupling,) = tied.couplings
    (_, first), (_, second) = coupling.terms
    assert 0.5 <= abs(second) <= 2.0
    found = (second / first, coupling.offset / first, coupling.tolerance / first)
    assert found == pytest.approx((-2.0, 0.1, 1e-3))
    solves(tied)
