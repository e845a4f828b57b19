"""The robots that tests use are of the form that the reader promises."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.model import FLOATING, KINDS, REVOLUTE, SPHERICAL, Model
from tests.models import (
    binary,
    human_figure,
    random_tree,
    serial_chain,
    star,
    three_axis_chain,
)

MODELS = [
    serial_chain(5),
    serial_chain(4, kind=SPHERICAL, floating=True),
    random_tree(np.random.default_rng(1), 30, floating=True),
    random_tree(np.random.default_rng(2), 30, mimics=4),
    star(16),
    binary(4, floating=True),
    human_figure(),
    three_axis_chain(2),
]


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_joints_are_depth_first_with_siblings_by_name(model: Model) -> None:
    visited: list[int] = []

    def visit(link: int) -> None:
        for j in sorted(model.children[link], key=lambda j: model.joints[j].name):
            visited.append(j)
            visit(j + 1)

    visit(0)
    assert visited == list(range(len(model.joints)))
    assert len({joint.name for joint in model.joints}) == len(model.joints)
    assert len(model.links) == len(model.joints) + 1


@pytest.mark.parametrize("model", MODELS, ids=lambda m: m.name)
def test_bodies_can_exist(model: Model) -> None:
    for link in model.links[1:]:
        moments = np.linalg.eigvalsh(link.inertia.tensor)
        assert link.inertia.mass >= 0
        assert moments[0] >= 0
        assert moments[0] + moments[1] >= moments[2] * (1 - 1e-12)
    for joint in model.joints:
        np.testing.assert_allclose(joint.rotation @ joint.rotation.T, np.eye(3), atol=1e-15)
        assert np.linalg.norm(joint.axis) == pytest.approx(1.0, abs=1e-15)


def test_the_human_figure_has_the_joints_of_the_paper() -> None:
    model = human_figure()
    kinds = [joint.kind for joint in model.joints]
    assert (kinds.count(FLOATING), kinds.count(SPHERICAL), kinds.count(REVOLUTE)) == (1, 10, 4)
    assert model.nv == 40


def test_trees_hold_all_kinds_and_mimics() -> None:
    model = random_tree(np.random.default_rng(3), 60, mimics=5)
    assert {joint.kind.name for joint in model.joints} == set(KINDS)
    followers = [joint for joint in model.joints if joint.mimic]
    assert len(followers) == 5
    for joint in followers:
        assert joint.mimic is not None
        assert model.joints[joint.mimic.source].mimic is None


def test_sizes() -> None:
    assert len(star(16).joints) == 33
    assert len(binary(5).joints) == 62
    assert serial_chain(7, floating=True).nv == 13
