"""Changes of frame: those that know more of what they change agree with those that do not."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from adagen.executor.frames import Dense, Rotation, Transform, about_z, placed
from adagen.graph import Graph, count_operations
from adagen.model import Inertia
from adagen.plan.placement import spatial_inertia
from tests.graph.test_linear import given_as, numbers
from tests.models import rod, vector


def rigid(body: Inertia, graph: Graph) -> Any:
    """Return the spatial inertia of a body as constants."""
    found = np.empty((6, 6), dtype=object)
    for place, value in np.ndenumerate(spatial_inertia(body)):
        found[place] = graph.constant(float(value))
    return found


@pytest.mark.parametrize("oblique", [False, True])
def test_a_rigid_body_is_felt_as_any_other_for_less(oblique: bool) -> None:
    graph, inputs = Graph(), dict[str, float]()
    angle = given_as("a", np.array([np.cos(0.7), np.sin(0.7)]), graph, inputs)
    base = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0] if oblique else np.eye(3)
    base = base * np.linalg.det(base)
    constants = np.empty((3, 3), dtype=object)
    for place, value in np.ndenumerate(base):
        constants[place] = graph.constant(float(value))
    rotation: Rotation = placed(constants, about_z(*angle))
    assert isinstance(rotation.factors[0], Dense) == oblique
    x = Transform(rotation, given_as("r", vector(0.3, -0.2, 0.5), graph, inputs))
    body = rigid(rod(2.0, vector(0.4, 0.1, -0.3)), graph)
    twice = [felt(felt(body)) for felt in (x.inertia, x.rigid_inertia)]
    some, same = (numbers(one, inputs) for one in twice)
    np.testing.assert_allclose(some, same, rtol=0, atol=1e-14)
    general, special = (count_operations(graph, list(one.flat)) for one in twice)
    assert special.multiply + special.add < 0.8 * (general.multiply + general.add)


@pytest.mark.parametrize("seed", range(6))
def test_squares_turn_to_no_more_than_they_are_said_to(seed: int) -> None:
    """Whatever the angle; where axes only change places, they change places, too."""
    rng, graph, inputs = np.random.default_rng(seed), Graph(), dict[str, float]()
    axes = np.eye(3)[:, rng.permutation(3)] * rng.choice([-1.0, 1.0], size=3)
    axes = axes * np.linalg.det(axes)
    slant, angle = rng.uniform(0.3, 1.2, size=2)
    tilted = axes @ [
        [1, 0, 0],
        [0, np.cos(slant), -np.sin(slant)],
        [0, np.sin(slant), np.cos(slant)],
    ]
    squares = rng.uniform(size=3)
    u = given_as("u", squares, graph, inputs)
    turn = about_z(*given_as("a", np.array([np.cos(angle), np.sin(angle)]), graph, inputs))
    for base in (axes, tilted):
        for own in (None, turn):
            constants = np.array([[graph.constant(x) for x in row] for row in base], dtype=object)
            rotation = placed(constants, own)
            whole = np.array([rotation.vector(axis) for axis in _axes(graph)]).T
            most = numbers(rotation.magnitudes(u), inputs)
            true = numbers(whole * whole, inputs) @ squares
            assert (most >= true - 1e-15).all()
            if own is None and base is axes:
                np.testing.assert_allclose(most, true)


def _axes(graph: Graph) -> list[Any]:
    """Unit vectors."""
    return [np.array([graph.constant(x) for x in row], dtype=object) for row in np.eye(3)]
