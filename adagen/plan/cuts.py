"""Joints where a robot can be cut between processes without losing digits.

At a cut, Eq. (3)-(10) need the mobility (I^A)^-1 of the side without the ground. If the link at the
cut has no mass, or is much lighter than what is attached to it, I^A cannot be inverted or loses
digits: form `segment` keeps such joints inside a segment, where no inverse is needed. A join also
subtracts mobilities, and loses digits where a light link loses most of its mobility to its
neighbours.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model import Model, canonical
from adagen.model.fuse import Run, settled
from adagen.model.kinds import KINDS
from adagen.plan.clusters import is_regular
from adagen.plan.constants import joints_of
from adagen.plan.digits import generic_configuration, lost_mobility
from adagen.plan.edges import is_free_base
from adagen.plan.fused_frame import joint_coordinates, run_length, run_motion
from adagen.plan.placement import joint_transform, spatial_inertia

Array = NDArray[Any]

LARGEST_CONDITION = {"double": 1e6, "float": 1e3}
LARGEST_GROWTH = {"double": 1e5, "float": 1e3}
SMALLEST_MASS = {"double": 1e-5, "float": 1e-3}
_SEEDS = (1, 2)  # of configurations, of which the worse one counts
_NEAR = 3  # joints to links that a link's mass is compared with


def cuttable_joints(
    model: Model,
    scalar: str = "double",
    joints: Sequence[Run] | None = None,
    limit: float | None = None,
) -> tuple[bool, ...]:
    """Return for each joint whether two processes may meet there; length N.

    Args:
        model: the robot.
        scalar: "double" or "float".
        joints: the joints in question, each a run of joints that are joined as one; if not given,
            all joints by themselves.
        limit: largest growth g at a cut, instead of what suits the scalar.
    """
    number = scalar
    largest = LARGEST_GROWTH[number] if limit is None else limit
    conditioned = max(LARGEST_CONDITION[number], 0.0 if limit is None else limit)
    lightest = SMALLEST_MASS[number] if limit is None else 1.0 / limit
    whole = [(j,) for j in range(len(model.joints))] if joints is None else list(joints)
    robot = _Robot(settled(model, [run for run in whole if len(run) > 1]), whole)
    frames = robot.frames(_SEEDS)
    good = (robot.condition(frames) <= conditioned) & (robot.growth(frames) <= largest)
    heavy = robot.mass_ratios() >= lightest
    return tuple(
        bool(good[k] and heavy[joint.child] and heavy[joint.parent])
        for k, joint in enumerate(robot.joints)
    )


Frames = Sequence[tuple[Array, Array]]
"""Of each joint the transforms from its parent and child link, shape (S, 6, 6) each."""


@dataclass(frozen=True)
class _Joint:
    """A joint or a run of joints, in coordinates in which its motions are unit vectors."""

    run: Run
    parent: int
    child: int
    free: list[int]
    constrained: list[int]
    free_floating: bool


class _Robot:
    """A model's inertias and joints in canonical frames."""

    def __init__(self, model: Model, runs: Sequence[Run]) -> None:
        self.members = joints_of(model)
        self.links = canonical(model).links
        self.joints = [self._joint(run) for run in runs]
        self.inertia = [spatial_inertia(link.inertia) for link in self.links]
        self.regular = [True, *(is_regular(link.inertia) for link in self.links[1:])]

    def _joint(self, run: Run) -> _Joint:
        first, kind = self.members[run[0]], KINDS[self.members[run[-1]].kind]
        free, constrained = list(kind.free), list(kind.constrained)
        if len(run) > 1:
            n = sum(KINDS[self.members[j].kind].nv for j in run)
            free, constrained = list(range(n)), list(range(n, 6))
        if first.prescribed:  # to forces it is rigid
            free, constrained = [], list(range(6))
        alone = len(run) == 1 and is_free_base(first)
        return _Joint(run, first.parent, run[-1] + 1, free, constrained, alone)

    def mass_ratios(self) -> Array:
        """Return each link's mass relative to the heaviest near it, shape (N + 1,); 1 first."""
        mass = np.array([0.0, *(link.inertia.mass for link in self.links[1:])])
        heaviest = mass.copy()
        for _ in range(_NEAR):
            reach = heaviest.copy()
            for joint in self.joints:
                if joint.parent > 0:
                    reach[joint.parent] = max(reach[joint.parent], heaviest[joint.child])
                    reach[joint.child] = max(reach[joint.child], heaviest[joint.parent])
            heaviest = reach
        ratios: Array = np.divide(mass, heaviest, out=np.zeros_like(mass), where=heaviest > 0)
        ratios[0] = 1.0
        return ratios

    def condition(self, frames: Frames) -> Array:
        """Return the condition of I^A beside each joint, the largest of S configurations, (N,).

        That is the condition number of the articulated-body inertia of all below the joint, and of
        all above it unless the ground holds that, scaled to a unit diagonal (units are mixed).
        """
        n = len(self.joints)
        below = self._of_each(frames)
        passed = [below[0]] * n
        for k in reversed(range(n)):
            joint, (x, y) = self.joints[k], frames[k]
            passed[k] = _turned(x, self._projected(joint, _seen(below[joint.child], y)))
            below[joint.parent] = below[joint.parent] + passed[k]
        above: dict[int, Array | None] = {0: None}  # what reaches a link from above; None: ground
        result = np.ones(n)
        for k, (joint, (x, y)) in enumerate(zip(self.joints, frames, strict=True)):
            result[k] = _scaled_condition(below[joint.child])
            coming = above[joint.parent]
            above[joint.child] = None
            if joint.free_floating:
                above[joint.child] = np.zeros_like(x)  # nothing holds the link
            elif joint.parent > 0 and coming is not None:
                rest = below[joint.parent] - passed[k] + coming
                result[k] = max(result[k], _scaled_condition(rest))
                above[joint.child] = _turned(y, self._projected(joint, _seen(rest, x)))
        return result

    def growth(self, frames: Frames) -> Array:
        """Return the ratio of mobilities at each joint, the largest of S configurations, (N,).

        That is the largest generalised eigenvalue of (M with bare links, M with their neighbours
        attached), M = N (Phi_A + Phi_B) N^T: what the neighbours take away; or of the mobilities of
        the two bare links, either way round. Infinite beside a link of singular inertia.
        """
        near = self._of_each(frames)
        bare, n = list(near), len(self.joints)
        onto_parent, onto_child = ([np.zeros_like(near[0])] * n for _ in range(2))
        for k, (joint, (x, y)) in enumerate(zip(self.joints, frames, strict=True)):
            onto_parent[k] = _turned(x, self._projected(joint, _seen(bare[joint.child], y)))
            near[joint.parent] = near[joint.parent] + onto_parent[k]
            if joint.parent > 0:
                seen = _seen(bare[joint.parent], x)
                onto_child[k] = _turned(y, self._projected(joint, seen))
                near[joint.child] = near[joint.child] + onto_child[k]
        result = np.full(n, np.inf)
        for k, (joint, (x, y)) in enumerate(zip(self.joints, frames, strict=True)):
            if not (self.regular[joint.parent] and self.regular[joint.child]):
                continue
            child = y @ np.linalg.inv(self.inertia[joint.child]) @ y.swapaxes(1, 2)
            with suppress(np.linalg.LinAlgError):  # so unequal that double cannot tell: infinite
                rest = np.linalg.inv(near[joint.child] - onto_child[k])
                held = y @ rest @ y.swapaxes(1, 2)
                pairs = [(child, held)]
                if joint.parent > 0:
                    parent = x @ np.linalg.inv(self.inertia[joint.parent]) @ x.swapaxes(1, 2)
                    rest = np.linalg.inv(near[joint.parent] - onto_parent[k])
                    held = held + x @ rest @ x.swapaxes(1, 2)
                    pairs = [(child, parent), (parent, child), (child + parent, held)]
                result[k] = _largest_ratio(joint.constrained, pairs)
        return result

    def _of_each(self, frames: Frames) -> list[Array]:
        """The links' inertias, shape (S, 6, 6) each, the same in all configurations."""
        count = len(frames[0][0]) if frames else 1
        return [np.repeat(inertia[None], count, axis=0) for inertia in self.inertia]

    @staticmethod
    def _projected(joint: _Joint, inertia: Array) -> Array:
        """The inertia of one side of a joint as it acts on the other side."""
        columns = inertia[:, :, joint.free]
        d = columns[:, joint.free]
        projected: Array = inertia - columns @ np.linalg.pinv(d) @ inertia[:, joint.free]
        return projected

    def frames(self, seeds: Sequence[int]) -> Frames:
        """Return the transforms into a joint's coordinates, from its parent and its child link.

        Of each joint two arrays of shape (S, 6, 6), for the configurations of S seeds.
        """
        each = [self._frames(seed) for seed in seeds]
        return [
            (np.stack([x for x, _ in pairs]), np.stack([y for _, y in pairs]))
            for pairs in zip(*each, strict=True)
        ]

    def _frames(self, seed: int) -> list[tuple[Array, Array]]:
        q = generic_configuration(self.members, seed)
        frames = []
        for joint in self.joints:
            kinds = [KINDS[self.members[j].kind] for j in joint.run]
            x, s = run_motion([self._transform(j, q) for j in joint.run], kinds)
            y = np.eye(6)
            if len(kinds) > 1:
                of_run = [self.members[j] for j in joint.run]
                length = run_length(of_run, self.links[joint.child].inertia)
                y = joint_coordinates(s, length)[0]
            frames.append((y @ x, y))
        return frames

    def _transform(self, j: int, q: Array) -> Array:
        joint = self.members[j]
        return joint_transform(joint, q[joint.q : joint.q + KINDS[joint.kind].nq])


def _seen(inertia: Array, x: Array) -> Array:
    """Inertias in the coordinates of transforms x, shape (S, 6, 6)."""
    return _turned(np.linalg.inv(x), inertia)


def _turned(x: Array, inertia: Array) -> Array:
    """X^T I X, shape (S, 6, 6)."""
    result: Array = x.swapaxes(1, 2) @ inertia @ x
    return result


def _largest_ratio(rows: list[int], pairs: Sequence[tuple[Array, Array]]) -> float:
    """The largest generalised eigenvalue of pairs of mobilities, at the constrained rows."""
    at = np.ix_(rows, rows)
    each = ((a[at], b[at]) for pair in pairs for a, b in zip(*pair, strict=True))
    return max((lost_mobility(a, b) for a, b in each), default=1.0) if rows else 1.0


def _scaled_condition(inertia: Array) -> float:
    """The largest condition number of inertias scaled to a unit diagonal, shape (S, 6, 6)."""
    diagonal = np.diagonal(inertia, axis1=1, axis2=2)
    if not (diagonal > 0).all():
        return np.inf
    scale = 1.0 / np.sqrt(diagonal)
    values = np.linalg.eigvalsh(inertia * scale[:, :, None] * scale[:, None])
    return float((values[:, -1] / values[:, 0]).max()) if (values[:, 0] > 0).all() else np.inf
