"""Passive torques of joints with several degrees of freedom."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.model import Joint, Passive
from adagen.model.kinds import FLOATING, KINDS, PLANAR, SPHERICAL, JointKind


def joint(kind: JointKind, passive: Passive) -> Joint:
    """Return a joint on the ground."""
    return Joint("cart", kind, 0, np.eye(3), np.zeros(3), np.array([0.0, 0.0, 1.0]), None, passive)


@pytest.mark.parametrize("kind", [PLANAR, FLOATING])
def test_planar_and_floating_joints_have_none(kind: JointKind) -> None:
    """No method, loops among them, computes them: they are not left out silently."""
    with pytest.raises(ValueError, match=f'{kind.name} joint "cart" has damping'):
        joint(kind, Passive(damping=0.1))
    with pytest.raises(ValueError, match="has rotor_inertia"):
        joint(kind, Passive(rotor_inertia=0.1))


def test_spherical_joints_have_what_is_alike_about_all_axes() -> None:
    passive = Passive(damping=0.1, rotor_inertia=0.2)
    assert joint(SPHERICAL, passive).passive == passive
    with pytest.raises(ValueError, match='spherical joint "cart" has friction'):
        joint(SPHERICAL, Passive(friction=0.1))


@pytest.mark.parametrize("kind", list(KINDS.values()))
def test_every_joint_can_be_without(kind: JointKind) -> None:
    assert joint(kind, Passive()).passive == Passive()
