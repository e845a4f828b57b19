"""Which joints loops sweep in their own axes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.emit.shapes import chosen_shape
from adagen.model import SPHERICAL, Inertia, Model
from adagen.plan.own_axes import OwnAxes, balls_lose, joints_in_own_axes
from adagen.studies.stability import robots
from benchmarks.stability.adversary import Part, assembled
from tests.emitted import plan_of
from tests.models import human_figure


def tool(radius: float) -> Model:
    links = [robots.rod(), robots.rod(), robots.rod(radius=radius)]
    return robots.chain("tool", links, axes="xyz")


@pytest.mark.parametrize("model", [robots.rods(30), robots.coil(20), human_figure()])
def test_ordinary_robots_stay_in_axes_of_the_base(model: Model) -> None:
    assert joints_in_own_axes(plan_of(model, 1)) == OwnAxes(frozenset(), frozenset())


def test_hinges_about_one_axis_of_the_base_stay_in_its_axes() -> None:
    """Moments about other axes are a million times D, but neither added to it nor taken from it."""
    rods = [robots.rod() for _ in range(100)]
    none = OwnAxes(frozenset(), frozenset())
    flat = robots.chain("flat", rods, axes="y")
    assert joints_in_own_axes(plan_of(flat, 1)) == none
    oblique = np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    first = replace(flat.joints[0], rotation=oblique @ flat.joints[0].rotation)
    tilted = replace(flat, joints=(first, *flat.joints[1:]))
    assert len(joints_in_own_axes(plan_of(tilted, 1)).always) > 80


def test_a_hinge_that_shares_its_axis_with_a_heavy_one_turns_in_its_own() -> None:
    """What the one beyond takes away is all but the least of what is brought about the axis."""
    axis = np.array([0.0, 1.0, 0.0])
    for lighter, turned in ((1.0, False), (1e-8, True)):
        parts = [
            Part(k, axis, np.zeros(3), robots.rod(mass)) for k, mass in enumerate((lighter, 1.0))
        ]
        found = joints_in_own_axes(plan_of(assembled("coaxial", parts), 1))
        assert (0 in found.always | found.if_lost) is turned


def test_a_slender_tool_turns_in_its_own_axes() -> None:
    # tr A / D is 4/3 of the squared ratio of length and radius: 1.3e4 at 1 cm, 1.3e6 at 1 mm.
    assert joints_in_own_axes(plan_of(tool(0.3), 1)).always == set()
    assert joints_in_own_axes(plan_of(tool(1e-3), 1)).always == {2}
    assert joints_in_own_axes(plan_of(tool(0.01), 1)).always == set()
    assert joints_in_own_axes(plan_of(tool(0.01), 1, scalar="float")).always == {2}


def test_links_of_no_inertia_turn_with_the_joints_beyond() -> None:
    # Balls of three axes x y z: joints 0 and 1 bear nothing themselves, but they lose digits near
    # gimbal lock alone.
    point = Inertia(0.1, np.zeros(3), np.zeros((3, 3)))
    found = joints_in_own_axes(plan_of(robots.three_axis(1, point), 1))
    assert found == OwnAxes(frozenset(), frozenset({0, 1, 2}))


def test_links_without_mass_always_turn_with_the_joints_beyond() -> None:
    found = joints_in_own_axes(plan_of(robots.three_axis(1), 1))
    assert found == OwnAxes(frozenset({0, 1, 2}), frozenset())


def test_ball_joints_of_slender_links_lose_digits_in_loops() -> None:
    assert not balls_lose(plan_of(robots.spherical_rods(4), 1))
    assert not balls_lose(plan_of(human_figure(), 1))
    slender = robots.rods(4, kind=SPHERICAL, radius=1e-4)
    assert balls_lose(plan_of(slender, 1))
    assert chosen_shape(plan_of(slender, 1)) == "unrolled"
