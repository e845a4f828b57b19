"""Poses, motions and inertias of all links in many states at once, for the trial sweeps.

Arrays have the joints or links first, then the states. Quantities of a single joint are computed
for all hinges at once, because numpy takes about as long for a thousand hinges as for one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.many_states import cross, rotation, skew
from adagen.model.kinds import KINDS
from adagen.plan.edges import is_free_base
from adagen.plan.placement import configuration
from adagen.plan.robot import PlanJoint, PlanLink
from adagen.plan.types import Plan

Array = NDArray[Any]
AT_ONCE = 512
"""Links whose inertias are found at once: what is computed on the way then stays in the cache."""


class LinkMotions:
    """Poses and motions of the links of a robot in many configurations.

    Args:
        plan: its joints are looked at.
        own: whether each link's body is expressed in the link's axes, or in those of the base.
        q: configurations, shape (S, nq), in the numbers that all is computed in.
        line: whether a straight line is swept, in which nothing is in axes of the base.

    Attributes:
        axes: of each link in those of the base, shape (links, S, 3, 3); of the base alone in
            straight lines.
        place: of each link in its parent's axes, shape (links, S, 3).
        ways: the same by joints, in the axes of the parent's body, shape (joints, S, 3).
        free: S of each joint, in the axes of its child's body, shape (S, 6, freedoms).
    """

    def __init__(self, plan: Plan, own: Sequence[bool], q: Array, line: bool) -> None:
        self.plan, self.own, self.q, self.number = plan, own, q, q.dtype.type
        self.count, links = len(q), len(plan.joints) + 1
        eye = np.eye(3, dtype=self.number)
        self._local = np.zeros((links, self.count, 3, 3), self.number) + eye
        self.place = np.zeros((links, self.count, 3), self.number)
        self._displace()
        self.axes = np.broadcast_to(eye, (1, self.count, 3, 3))
        parents = np.array([joint.parent for joint in plan.joints])
        self.ways = self.place[1:]
        if not line:
            self._orient()
            rotated = np.flatnonzero(~np.array(own)[parents])
            self.ways = self.ways.copy()
            self.ways[rotated] = self.in_base_axes(parents[rotated], self.ways[rotated])
        self.free = self._freedoms()

    def turn(self, j: int) -> Array | None:
        """Return the rotation from the child body's axes to the parent body's, or None."""
        parent, child = self.plan.joints[j].parent, j + 1
        if self.own[child]:
            found: Array = self._local[child] if self.own[parent] else self.axes[child]
            return found
        return self.axes[parent].transpose(0, 2, 1) if self.own[parent] else None

    def in_base_axes(self, links: Array, vectors: Array) -> Array:
        """Return vectors of links' axes, shape (links, S, 3), in base axes."""
        found: Array = np.einsum("jsik,jsk->jsi", self.axes[links], vectors)
        return found

    def _displace(self) -> None:
        joints = self.plan.joints
        hinges = [j for j, one in enumerate(joints) if one.kind == "revolute" and not one.mimic]
        children = np.array(hinges, dtype=int) + 1
        angles = self.q[:, [joints[j].q for j in hinges]].T
        turns = np.zeros((len(hinges), self.count, 3, 3), self.number)
        c, s = np.cos(angles), np.sin(angles)
        turns[..., 0, 0], turns[..., 0, 1], turns[..., 1, 0], turns[..., 1, 1] = c, -s, s, c
        turns[..., 2, 2] = 1
        bases = np.array([joints[j].rotation for j in hinges], self.number).reshape(-1, 1, 3, 3)
        places = np.array([joints[j].translation for j in hinges], self.number).reshape(-1, 1, 3)
        self._local[children], self.place[children] = bases @ turns, places
        for j in set(range(len(joints))).difference(hinges):
            turn, shift = self._displaced(joints[j])
            base = np.array(joints[j].rotation, dtype=self.number)
            self._local[j + 1] = base @ turn
            self.place[j + 1] = np.array(joints[j].translation, self.number) + shift @ base.T

    def _displaced(self, joint: PlanJoint) -> tuple[Array, Array]:
        kind, q = KINDS[joint.kind], configuration(self.plan.joints, joint, self.q)
        turn = np.zeros((self.count, 3, 3), self.number) + np.eye(3, dtype=self.number)
        shift = np.zeros((self.count, 3), self.number)
        if kind.quaternion is not None:
            turn = rotation(q[:, kind.quaternion :])
            shift[:, : kind.quaternion] = q[:, : kind.quaternion]
        elif joint.kind == "prismatic":
            shift[:, 2] = q[:, 0]
        else:
            c, s = np.cos(q[:, -1]), np.sin(q[:, -1])
            turn[:, 0, 0], turn[:, 0, 1], turn[:, 1, 0], turn[:, 1, 1] = c, -s, s, c
            if joint.kind == "planar":
                shift[:, :2] = q[:, :2]
        return turn, shift

    def _orient(self) -> None:
        base = self.axes[0]
        self.axes = np.empty_like(self._local)
        self.axes[0] = base
        for j, joint in enumerate(self.plan.joints):
            if is_free_base(joint):  # the base, in whose axes loops are
                self.axes[j + 1] = base
            else:
                np.matmul(self.axes[joint.parent], self._local[j + 1], out=self.axes[j + 1])

    def _freedoms(self) -> list[Array]:
        units = {name: self._units(list(kind.free)) for name, kind in KINDS.items()}
        found = []
        for j, joint in enumerate(self.plan.joints):
            free = units[joint.kind]
            if not self.own[j + 1]:
                axes = self.axes[j + 1]
                free = np.concatenate([axes @ free[:, :3], axes @ free[:, 3:]], axis=1)
            found.append(free)
        return found

    def _units(self, free: list[int]) -> Array:
        found = np.zeros((self.count, 6, len(free)), self.number)
        found[:, free, range(len(free))] = 1
        return found


class LinkInertias:
    """Inertias of bare links, and their wrenches for zero joint accelerations.

    As in emitted code both are found from constants that are rounded once: sums of m x x^T about
    the origin in loops, the inertia itself in straight lines, where the difference of equal
    entries is nothing.

    Args:
        placed: where the links are.
        line: whether a straight line is swept.
    """

    def __init__(self, placed: LinkMotions, line: bool) -> None:
        self.placed, self.line = placed, line
        self.number, self.count = placed.number, placed.count
        links = placed.plan.links
        mass = np.array([link.mass for link in links], np.longdouble)
        com = np.array([link.com for link in links], np.longdouble)
        tensor = np.array([link.tensor for link in links], np.longdouble)
        spread = mass[:, None, None] * (com[:, :, None] * com[:, None, :])
        about = tensor - spread if line else spread - tensor
        for k in range(3):
            if line:
                others = spread[:, k - 2, k - 2] + spread[:, k - 1, k - 1]
                about[:, k, k] = tensor[:, k, k] + others
            else:
                about[:, k, k] = [_second_moment(link, k) for link in links] + spread[:, k, k]
        self._mass = mass.astype(self.number)
        self._moments = (mass[:, None] * com).astype(self.number)
        self._about = about.astype(self.number)

    def moving(
        self, v: Array, tau: Array, rounding: np.random.Generator | None
    ) -> tuple[Array, Array]:
        """Return inertias about the links' origins, and wrenches from their motion.

        Args:
            v: velocities, shape (S, nv).
            tau: torques; of prescribed joints, their accelerations.
            rounding: draws whether entries of inertias are rounded up or down, one by one; None:
                they are as computed. Emitted code rounds so where a product and a sum are one
                instruction: differences of equal products are no longer zero.

        Returns:
            Arrays of shapes (links, S, 6, 6) and (links, S, 6).
        """
        motion = self._motion(v, tau)
        links = len(motion[0])
        bodies = np.zeros((links, self.count, 6, 6), self.number)
        forces = np.zeros((links, self.count, 6), self.number)
        for first in range(1, links, AT_ONCE):
            some = slice(first, min(first + AT_ONCE, links))
            moments, about = self._in_body(some, rounding)
            bodies[some] = self._inertias(some, moments, about)
            spin, rate, rise = (each[some] for each in motion)
            forces[some] = self._forces(some, moments, about, spin, rate, rise)
            if self.line:
                bodies[some] = _as_rounded(bodies[some], rounding)
        return bodies, forces

    def at_rest(self) -> Array:
        """Return inertias in the axes of links, shape (links, 6, 6): the same in all states."""
        found: Array = self._inertias(slice(None), self._moments[:, None], self._about[:, None])
        return found[:, 0]

    def _in_body(self, links: slice, rounding: np.random.Generator | None) -> tuple[Array, Array]:
        """Moments and second moments of links, with their states, in the axes of their bodies."""
        shape = (links.stop - links.start, self.count)
        moments = np.broadcast_to(self._moments[links, None], (*shape, 3))
        about = np.broadcast_to(self._about[links, None], (*shape, 3, 3))
        rotated = np.flatnonzero(~np.array(self.placed.own[links]))
        if not rotated.size:
            return moments, about
        moments, about = moments.copy(), about.copy()
        axes = self.placed.axes[links][rotated]
        found = np.tril(axes @ about[rotated] @ axes.transpose(0, 1, 3, 2))
        found = found + np.tril(found, -1).transpose(0, 1, 3, 2)  # symmetric to the last bit
        about[rotated] = _as_rounded(found, rounding)
        moments[rotated] = self.placed.in_base_axes(rotated + links.start, moments[rotated])
        return moments, about

    def _inertias(self, links: slice, moments: Array, about: Array) -> Array:
        found = np.zeros((*about.shape[:2], 6, 6), self.number)
        found[..., :3, :3] = about
        if not self.line:
            trace = np.einsum("jskk->js", about)[..., None, None]
            found[..., :3, :3] = trace * np.eye(3, dtype=self.number) - about
            for k in range(3):  # without what is taken away again
                found[..., k, k] = about[..., k - 2, k - 2] + about[..., k - 1, k - 1]
        arms = skew(moments)
        found[..., :3, 3:], found[..., 3:, :3] = arms, -arms
        found[..., 3:, 3:] = self._mass[links, None, None, None] * np.eye(3, dtype=self.number)
        return found

    def _forces(
        self, links: slice, moments: Array, about: Array, spin: Array, rate: Array, rise: Array
    ) -> Array:
        field = skew(rate) + spin[..., :, None] * spin[..., None, :]
        for k in range(3):
            a, b = spin[..., k - 2], spin[..., k - 1]
            field[..., k, k] = -(a * a + b * b)
        if self.line:
            moment = _moment(about, spin, rate, field)
        else:
            each = field @ about  # what turns is what is not symmetric of it
            pairs = [each[..., i - 1, i - 2] - each[..., i - 2, i - 1] for i in range(3)]
            moment = np.stack(pairs, axis=-1)
        pull = np.einsum("jsik,jsk->jsi", field, moments)
        force = self._mass[links, None, None] * rise + pull
        return np.concatenate([moment + cross(moments, rise), force], axis=-1)

    # -- from joint to joint ----------------------------------------------------------------------

    def _motion(self, v: Array, tau: Array) -> tuple[Array, Array, Array]:
        """Angular velocity, angular and linear acceleration for zero joint accelerations."""
        placed = self.placed
        links = len(placed.plan.joints) + 1
        spins, rates, rises = np.zeros((3, links, self.count, 3), self.number)
        rises[0] = -np.array(placed.plan.gravity, self.number)
        for j, joint in enumerate(placed.plan.joints):
            turn, way = placed.turn(j), placed.ways[j]
            spin, rate, rise = (each[joint.parent] for each in (spins, rates, rises))
            rise = rise + cross(rate, way) + cross(spin, cross(spin, way))
            if turn is not None:
                spin, rate, rise = (np.einsum("ski,sk->si", turn, x) for x in (spin, rate, rise))
            axes = placed.free[j]
            own = slice(joint.v, joint.v + axes.shape[2])
            speed = np.einsum("smk,sk->sm", axes, v[:, own])
            turning, sliding = speed[:, :3], speed[:, 3:]
            spins[j + 1], rates[j + 1] = spin + turning, rate + cross(spin, turning)
            if joint.kind != "revolute":
                rise = rise + 2 * cross(spin, sliding) + cross(turning, sliding)
            rises[j + 1] = rise
            if joint.prescribed:
                extra = np.einsum("smk,sk->sm", axes, tau[:, own])
                rates[j + 1] += extra[:, :3]
                rises[j + 1] += extra[:, 3:]
        return spins, rates, rises


def _second_moment(link: PlanLink, k: int) -> float:
    """The sum of m x_k^2 about the centre of mass, from the inertias about all three axes."""
    parts = (-link.tensor[k][k], link.tensor[k - 2][k - 2], link.tensor[k - 1][k - 1])
    return math.fsum(parts) / 2


def _moment(inertia: Array, spin: Array, rate: Array, field: Array) -> Array:
    """I alpha + omega x I omega, term by term as straight lines have it (kinematics.py)."""
    found = np.empty_like(spin)
    for i in range(3):
        k, m = (i + 1) % 3, (i + 2) % 3
        found[..., i] = (
            rate[..., i] * inertia[..., i, i]
            + (spin[..., k] * spin[..., m]) * (inertia[..., m, m] - inertia[..., k, k])
            - field[..., m, i] * inertia[..., i, k]
            + field[..., k, i] * inertia[..., i, m]
            + (field[..., k, k] - field[..., m, m]) * inertia[..., k, m]
        )
    return found


def _as_rounded(matrix: Array, rounding: np.random.Generator | None) -> Array:
    """Symmetric matrices whose entries are rounded up or down one by one."""
    if rounding is None:
        return matrix
    half = np.tril(rounding.choice([-1.0, 1.0], matrix.shape))
    signs = (half + np.tril(half, -1).swapaxes(-1, -2)).astype(matrix.dtype)
    found: Array = matrix * (1 + signs * (np.finfo(matrix.dtype).eps / 2))
    return found
