"""Runs of joints through links without mass, and point masses that rest in a neighbour."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.model import FLOATING, REVOLUTE, Inertia, Passive
from adagen.model.fuse import runs_of, settled
from adagen.reference import inverse_dynamics
from adagen.states import random_states
from tests.links import with_inertia
from tests.models import Part, assemble, random_rotation, rod, three_axis_chain, vector


def point(mass: float, *place: float) -> Inertia:
    """Return the inertia of a point."""
    return Inertia(mass, vector(*place), np.zeros((3, 3)))


def test_three_axes_are_one_run() -> None:
    assert runs_of(three_axis_chain(3)) == ((0, 1, 2), (3, 4, 5), (6, 7, 8))


def test_a_link_with_mass_or_with_inertia_alone_ends_a_run() -> None:
    model = three_axis_chain(2)
    assert runs_of(with_inertia(model, 2, rod(1.0, vector(0.1, 0, 0)))) == ((0, 1), (3, 4, 5))
    only_inertia = Inertia(0.0, np.zeros(3), np.eye(3) * 1e-3)
    assert runs_of(with_inertia(model, 4, only_inertia)) == ((0, 1, 2), (4, 5))


def test_branches_and_rotors_are_not_fused() -> None:
    step = vector(0.3, 0.0, 0.0)
    parts = [
        Part("a", None, REVOLUTE, rod(1.0, step)),
        Part("b", "a", REVOLUTE, Inertia.zero(), step),
        Part("c", "b", REVOLUTE, rod(1.0, step), step, axis=vector(0, 1, 0)),
        Part("d", "b", REVOLUTE, rod(1.0, step), -step, axis=vector(1, 0, 0)),
    ]
    assert runs_of(assemble("fork", parts)) == ()
    model = three_axis_chain(2)
    joints = list(model.joints)
    joints[1] = replace(joints[1], passive=Passive(rotor_inertia=0.1))
    assert runs_of(replace(model, joints=tuple(joints))) == ((3, 4, 5),)


def test_a_run_has_six_freedoms_at_most() -> None:
    parts = [Part("base", None, FLOATING, Inertia.zero())]
    parts.append(Part("knee", "base", REVOLUTE, rod(1.0, vector(0.3, 0, 0))))
    assert runs_of(assemble("seven", parts)) == ()


@pytest.mark.parametrize(
    ("place", "end"),
    [((0, 0, 0), 0), ((0.2, 0, 0), 0), ((0, 0.1, 0), 3), ((0, 0, 0.1), None)],
    ids=["on both axes", "on its own axis", "on the next axes", "on none"],
)
def test_points_on_an_axis_rest_in_a_neighbour(
    place: tuple[float, float, float], end: int | None
) -> None:
    """The first of three links turns about x, the second one about y."""
    model = three_axis_chain(1)
    if end == 3:  # two axes only: the last one would move the point
        model = with_inertia(model, 2, rod(1.0, vector(0.3, 0, 0)))
    loaded = with_inertia(model, 1, point(0.7, *place))
    if end is None:
        assert runs_of(loaded) != runs_of(model)
    else:
        assert runs_of(loaded) == runs_of(model)
        assert settled(loaded, runs_of(loaded)).links[1].inertia.mass == 0.0


@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1))
def test_settled_points_change_nothing(seed: int) -> None:
    rng = np.random.default_rng(seed)
    step, parts = vector(0.3, 0.0, 0.0), list[Part]()
    for i in range(9):
        turn, axis = random_rotation(rng), rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        body = rod(1.0, step) if i % 3 == 2 else point(float(rng.uniform(0.1, 2.0)), 0.0, 0.0, 0.0)
        place = step if i % 3 == 0 and i else np.zeros(3)
        above = parts[-1].name if parts else None
        parts.append(Part(f"j{i}", above, REVOLUTE, body, place, turn, axis))
    model = assemble("points", parts)
    runs = runs_of(model)
    assert len(runs) == 3
    same = settled(model, runs)
    assert not any(same.links[j + 1].inertia.mass for run in runs for j in run[:-1])
    sample = random_states(model, 1, seed=seed % 1000)
    qdd = rng.normal(size=model.nv)
    truth = inverse_dynamics(model, sample.q[0], sample.v[0], qdd)
    answer = inverse_dynamics(same, sample.q[0], sample.v[0], qdd)
    assert np.abs(answer - truth).max() < 1e-12 * np.abs(truth).max()
