"""``canonical`` turns frames and keeps the robot."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.executor import simulate
from adagen.model import PLANAR, PRISMATIC, REVOLUTE, SPHERICAL, JointKind, Model, canonical
from adagen.reference import (
    forward_dynamics,
    inverse_dynamics,
    joint_space_inertia,
    kinetic_energy,
    potential_energy,
)
from tests.emitted import plan_of
from tests.models import human_figure, random_configuration, random_tree, serial_chain

SEEDS = range(6)


def tree(seed: int, floating: bool = False) -> Model:
    return random_tree(np.random.default_rng(seed), 9, floating=floating)


def state(model: Model, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    q = random_configuration(model, rng)
    return q, rng.normal(size=model.nv), rng.normal(size=model.nv)


def defect(rotation: np.ndarray) -> float:
    return float(np.max(np.abs(rotation @ rotation.T - np.eye(3))))


@pytest.mark.parametrize("seed", SEEDS)
def test_every_axis_is_z_and_every_frame_a_rotation(seed: int) -> None:
    model = tree(seed)
    for old, joint in zip(model.joints, canonical(model).joints, strict=True):
        assert joint.axis.tolist() == [0.0, 0.0, 1.0]
        # what the frames of the given model lack in orthogonality stays; rounding adds 4 eps
        assert defect(joint.rotation) <= defect(old.rotation) + 1e-15
        assert np.linalg.det(joint.rotation) > 0


@pytest.mark.parametrize("floating", [False, True])
@pytest.mark.parametrize("seed", SEEDS)
def test_dynamics_and_energies_are_kept(seed: int, floating: bool) -> None:
    """Coordinates keep their meaning; that of a planar joint is defined in the turned frame."""
    model = tree(seed, floating)
    turned = canonical(model)
    q, v, tau = state(model, seed)
    assert joint_space_inertia(turned, q) == pytest.approx(
        joint_space_inertia(model, q), rel=1e-11, abs=1e-12
    )
    assert inverse_dynamics(turned, q, v, tau) == pytest.approx(
        inverse_dynamics(model, q, v, tau), rel=1e-10, abs=1e-11
    )
    a, b = forward_dynamics(model, q, v, tau), forward_dynamics(turned, q, v, tau)
    assert a == pytest.approx(b, rel=1e-8, abs=1e-8 * float(np.max(np.abs(a))))
    assert kinetic_energy(turned, q, v) == pytest.approx(kinetic_energy(model, q, v), rel=1e-12)
    assert potential_energy(turned, q) == pytest.approx(
        potential_energy(model, q), rel=1e-12, abs=1e-12
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_masses_moments_names_and_structure_are_kept(seed: int) -> None:
    model = tree(seed)
    turned = canonical(model)
    for old, new in zip(model.links, turned.links, strict=True):
        assert (old.name, old.merged, old.inertia.mass) == (new.name, new.merged, new.inertia.mass)
        assert np.linalg.norm(old.inertia.com) == pytest.approx(np.linalg.norm(new.inertia.com))
        assert np.linalg.eigvalsh(old.inertia.tensor) == pytest.approx(
            np.linalg.eigvalsh(new.inertia.tensor), rel=1e-12
        )
        assert np.array_equal(new.inertia.tensor, new.inertia.tensor.T)
    for a, b in zip(model.joints, turned.joints, strict=True):
        assert (a.name, a.kind, a.parent, a.mimic) == (b.name, b.kind, b.parent, b.mimic)
    assert np.array_equal(model.gravity, turned.gravity)


@pytest.mark.parametrize("kind", [REVOLUTE, PRISMATIC, PLANAR, SPHERICAL])
def test_twice_is_once(kind: JointKind) -> None:
    once = canonical(random_tree(np.random.default_rng(3), 5, (kind,)))
    twice = canonical(once)
    for a, b in zip(once.joints, twice.joints, strict=True):
        assert a.rotation == pytest.approx(b.rotation, abs=1e-16)


def test_coordinate_axes_round_nothing() -> None:
    """Axes along x, y or z only permute numbers: digits stay, up to signs and places."""
    model = human_figure()
    turned = canonical(model)
    for old, new in zip(model.links[1:], turned.links[1:], strict=True):
        assert sorted(abs(old.inertia.com)) == sorted(abs(new.inertia.com))
        assert sorted(abs(old.inertia.tensor).ravel()) == sorted(abs(new.inertia.tensor).ravel())


def test_parallel_axes_stay_in_their_plane() -> None:
    """Hinges about one axis that is no coordinate axis: frames differ by turns about it alone."""
    model, axis = serial_chain(4, axes="z"), np.array([0.3, -0.5, 0.7])

    def turned(off: float) -> Model:
        """Its axes turned, each by a little more than the one before."""
        axes = [axis + off * k * np.array([1.0, 0.0, 0.0]) for k in range(4)]
        joints = zip(model.joints, axes, strict=True)
        return replace(model, joints=tuple(replace(joint, axis=own) for joint, own in joints))

    for joint in canonical(turned(0.0)).joints[1:]:
        assert joint.rotation.tolist() == np.eye(3).tolist()
    planar, spatial = (
        simulate(plan_of(turned(off), 1))[0].operations.arithmetic for off in (0.0, 0.01)
    )
    assert planar < spatial / 2
