"""Where a robot can be cut between processes without losing digits.

At a cut, Eq. (3)-(10) need the mobility of the side that does not hold the ground, (I^A)^-1. Where
the link at the cut has no mass, or is much lighter than what is attached to it, I^A cannot be
inverted or loses digits: form `segment` keeps such joints inside a segment, where nothing of the
kind is needed. The joins themselves subtract, too, where a light link's mobility is used up by its
neighbours.
"""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import Inertia, Model, canonical
from adagen.model.kinds import KINDS
from adagen.plan.constants import inverse_inertia, joints_of
from adagen.plan.growth import generic_configuration, lost_mobility
from adagen.plan.placement import motion_transform, placement

Array = NDArray[Any]

LARGEST_CONDITION = {"double": 1e6, "float": 1e3}
LARGEST_GROWTH = {"double": 1e5, "float": 1e3}
SMALLEST_MASS = {"double": 1e-5, "float": 1e-3}
_NEAR = 3  # joints to links that a link's mass is compared with


def cuttable_joints(model: Model, scalar: str = "double") -> tuple[bool, ...]:
    """Return for each joint whether two processes may meet there; length N."""
    robot = _Robot(model)
    condition = np.maximum(robot.condition(1), robot.condition(2))
    growth = np.maximum(robot.growth(1), robot.growth(2))
    good = (condition <= LARGEST_CONDITION[scalar]) & (growth <= LARGEST_GROWTH[scalar])
    heavy = [ratio >= SMALLEST_MASS[scalar] for ratio in _mass_ratios(model)]
    return tuple(
        bool(good[j]) and heavy[j + 1] and heavy[joint.parent]
        for j, joint in enumerate(model.joints)
    )


def _mass_ratios(model: Model) -> list[float]:
    """Return each link's mass relative to the heaviest one near it; 1 for the ground."""
    mass = [0.0, *(link.inertia.mass for link in model.links[1:])]
    heaviest = list(mass)
    for _ in range(_NEAR):
        reach = list(heaviest)
        for j, joint in enumerate(model.joints):
            if joint.parent > 0:
                reach[joint.parent] = max(reach[joint.parent], heaviest[j + 1])
                reach[j + 1] = max(reach[j + 1], heaviest[joint.parent])
        heaviest = reach
    return [
        1.0,
        *(m / most if most else 0.0 for m, most in zip(mass[1:], heaviest[1:], strict=True)),
    ]


class _Robot:
    """A model's inertias and joints in canonical frames."""

    def __init__(self, model: Model) -> None:
        self.joints = joints_of(model)
        links = canonical(model).links
        self.inertia = [spatial_inertia(link.inertia) for link in links]
        self.regular = [True, *(_is_regular(link.inertia, link.name) for link in links[1:])]

    def condition(self, seed: int) -> Array:
        """Return what inverting I^A beside each joint costs in one configuration, shape (N,).

        That is the condition number of the articulated-body inertia of all below the joint, and of
        all above it unless the ground holds that, scaled to a unit diagonal (units are mixed).
        """
        n = len(self.joints)
        q = generic_configuration(self.joints, seed)
        x = [self._transform(j, q) for j in range(n)]
        below = [inertia.copy() for inertia in self.inertia]
        handed = [np.zeros((6, 6))] * n
        for j in reversed(range(n)):
            handed[j] = x[j].T @ self._projected(j, below[j + 1]) @ x[j]
            below[self.joints[j].parent] += handed[j]
        above: list[Array | None] = [None] * (n + 1)  # what reaches a link from above; None: ground
        result = np.ones(n)
        for j, joint in enumerate(self.joints):
            result[j] = _scaled_condition(below[j + 1])
            coming = above[joint.parent]
            if joint.parent == 0 and joint.kind == "floating":
                above[j + 1] = np.zeros((6, 6))  # nothing holds the link
            elif joint.parent > 0 and coming is not None:
                rest = below[joint.parent] - handed[j] + coming
                result[j] = max(result[j], _scaled_condition(rest))
                back = np.linalg.inv(x[j])
                above[j + 1] = self._projected(j, back.T @ rest @ back)
        return result

    def growth(self, seed: int) -> Array:
        """Return how unequal mobilities are at each joint in one configuration, shape (N,).

        That is the largest generalised eigenvalue of (M with bare links, M with their neighbours
        attached), M = N (Phi_A + Phi_B) N^T: what the neighbours take away; or of the mobilities of
        the two bare links, either way round. Infinite beside a link of singular inertia.
        """
        n = len(self.joints)
        q = generic_configuration(self.joints, seed)
        x = [self._transform(j, q) for j in range(n)]
        onto_parent = [x[j].T @ self._projected(j, self.inertia[j + 1]) @ x[j] for j in range(n)]
        onto_child = [np.zeros((6, 6))] * n
        near = [inertia.copy() for inertia in self.inertia]
        for j, joint in enumerate(self.joints):
            near[joint.parent] += onto_parent[j]
            if joint.parent > 0:
                back = np.linalg.inv(x[j])
                seen = back.T @ self.inertia[joint.parent] @ back
                onto_child[j] = self._projected(j, seen)
                near[j + 1] += onto_child[j]
        result = np.full(n, np.inf)
        for j, joint in enumerate(self.joints):
            rows = list(KINDS[joint.kind].constrained)
            if not (self.regular[joint.parent] and self.regular[j + 1]):
                continue
            child = np.linalg.inv(self.inertia[j + 1])
            held = np.linalg.inv(near[j + 1] - onto_child[j])
            with suppress(np.linalg.LinAlgError):  # so unequal that double cannot tell: infinite
                if joint.parent == 0:
                    result[j] = _largest_ratio(rows, (child, held))
                else:
                    parent = x[j] @ np.linalg.inv(self.inertia[joint.parent]) @ x[j].T
                    rest = np.linalg.inv(near[joint.parent] - onto_parent[j])
                    held = held + x[j] @ rest @ x[j].T
                    pairs = ((child, parent), (parent, child), (child + parent, held))
                    result[j] = _largest_ratio(rows, *pairs)
        return result

    def _projected(self, j: int, inertia: Array) -> Array:
        """What of an inertia on one side of a joint is felt on the other."""
        free = list(KINDS[self.joints[j].kind].free)
        d = inertia[np.ix_(free, free)]
        return inertia - inertia[:, free] @ np.linalg.pinv(d) @ inertia[free]

    def _transform(self, j: int, q: Array) -> Array:
        joint = self.joints[j]
        kind = KINDS[joint.kind]
        turn, shift = placement(kind, q[joint.q : joint.q + kind.nq])
        base = np.array(joint.rotation)
        return motion_transform((base @ turn).T, np.array(joint.translation) + base @ shift)


def _largest_ratio(rows: list[int], *pairs: tuple[Array, Array]) -> float:
    """The largest generalised eigenvalue of pairs of mobilities, at the constrained rows."""
    at = np.ix_(rows, rows)
    return max((lost_mobility(a[at], b[at]) for a, b in pairs), default=1.0) if rows else 1.0


def _is_regular(inertia: Inertia, name: str) -> bool:
    try:
        inverse_inertia(inertia, name)
    except InputError:
        return False
    return True


def _scaled_condition(inertia: Array) -> float:
    diagonal = np.diag(inertia)
    if not (diagonal > 0).all():
        return np.inf
    scale = 1.0 / np.sqrt(diagonal)
    values = np.linalg.eigvalsh(inertia * np.outer(scale, scale))
    return float(values[-1] / values[0]) if values[0] > 0 else np.inf


def spatial_inertia(inertia: Inertia) -> Array:
    """Return the spatial inertia at the link's origin, [angular; linear], shape (6, 6)."""
    c = inertia.com
    cx = np.array([[0.0, -c[2], c[1]], [c[2], 0.0, -c[0]], [-c[1], c[0], 0.0]])
    result = np.zeros((6, 6))
    result[:3, :3] = inertia.tensor - inertia.mass * cx @ cx
    result[:3, 3:] = inertia.mass * cx
    result[3:, :3] = -inertia.mass * cx
    result[3:, 3:] = inertia.mass * np.eye(3)
    return result
