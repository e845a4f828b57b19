"""What follows from what in a closure."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.plan.independent_coordinates import chosen, covered, expected, largest, uncovered

ROW = np.array([[1.0, 0.9, 0.8]])
STEEP = np.array([[1.0, 0.3, 0.25]])
LIGHT = 1e-8
SAMPLES = np.array([STEEP, STEEP, [[0.95, 1.0, 0.9]]])
DEPTHS = [1, 1, 1]


def test_a_heavy_link_does_not_follow_light_ones() -> None:
    """Its inertia would hide theirs: 42 + 1e-8 has not half of the digits of 1e-8."""
    (alone, _), _ = chosen(SAMPLES, DEPTHS, whole=True)
    assert alone == (0,)
    inertia = np.diag([42.0, LIGHT, LIGHT])
    (beside, rows), _ = chosen(SAMPLES, DEPTHS, [inertia], whole=True)
    assert (beside, rows) == ((1,), (0,))


def test_masses_decide_nothing_else() -> None:
    for inertia in (np.zeros((3, 3)), np.diag([3.0, 1.0, 1.0]), np.diag([0.0, 1.0, LIGHT])):
        assert chosen(SAMPLES, DEPTHS, [inertia], whole=True)[0] == ((0,), (0,))


def test_of_choices_that_are_as_good_the_outermost_joints_follow() -> None:
    """Legs that are alike are sampled in other states, and choose alike for all that."""
    for samples in (np.array([ROW, ROW]), np.array([[[0.93, 0.97, 0.95]], [[1.0, 0.9, 0.98]]])):
        offers = [((k,), (0,)) for k in range(3)]
        pattern = np.abs(samples).max(axis=0) > 0.0
        sizes = [largest(offer, samples) for offer in offers]
        best = min(range(3), key=lambda k: expected(offers[k], pattern, sizes[k]))
        assert offers[best] == ((2,), (0,))


def test_what_a_choice_hides() -> None:
    inertia = np.diag([42.0, LIGHT, LIGHT])
    hidden = covered(((0,), (0,)), ROW, inertia)
    assert hidden == pytest.approx(42.0 * 0.8**2 / (LIGHT * (1 + 0.64 / 0.81)), rel=1e-6)
    assert covered(((1,), (0,)), ROW, inertia) == pytest.approx(1.0, rel=1e-6)
    offers = [((0,), (0,)), ((1,), (0,)), ((2,), (0,))]
    assert uncovered(offers, ROW[None], [inertia]) == [1, 2]
    assert uncovered(offers[:1], ROW[None], [inertia]) == [0]  # where nothing else is to be had
    assert uncovered(offers, ROW[None], []) == [0, 1, 2]
