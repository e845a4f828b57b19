"""Articulated bodies swept in numpy, in many states at once, as emitted code sweeps them."""

from __future__ import annotations

import math
from collections.abc import Set
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.stacked import (
    about_z,
    cross,
    is_turn,
    pivots,
    rotation,
    shifted_body,
    skew,
    solved,
    turned_body,
)
from adagen.model.kinds import KINDS
from adagen.plan.edges import is_free_base
from adagen.plan.robot import PlanJoint
from adagen.plan.turned import ENOUGH, losing_joints
from adagen.plan.types import Plan

Array = NDArray[Any]
_TURNING, _SLIDING = slice(0, 3), slice(3, 6)
LOST = 16
"""Units in the last place of what a pivot is found in, below which emitted code refuses it."""


class Sweep:
    """All states at once, in numbers of one type; arrays have the states first.

    Args:
        plan: its joints, links and gravity are looked at.
        number: the type.
        turned: joints that are swept in their own axes, all others in those of the base; None:
            all are, as in straight lines.
        states: q, v and tau.
        rounded: whether entries of bare inertias are rounded up or down one by one.
        watched: joints that are looked at for lost digits.

    Attributes:
        lost: states in which a joint that is watched loses digits, shape (S,).
        refused: states that emitted code refuses, for a pivot that is nothing but rounding.
    """

    def __init__(
        self,
        plan: Plan,
        number: Any,
        turned: Set[int] | None,
        states: tuple[Array, Array, Array],
        rounded: bool = False,
        watched: Set[int] = frozenset(),
    ) -> None:
        self.plan, self.number, self.watched = plan, number, watched
        self.line = turned is None
        self.rounded = np.random.default_rng(2) if rounded else None
        self.q, self.v, self.tau = (x.astype(number) for x in states)
        self.count = len(self.q)
        self.lost, self.refused = np.zeros((2, self.count), dtype=bool)
        eye = np.broadcast_to(np.eye(3, dtype=number), (self.count, 3, 3))
        self.axes, self.place, self.local = [eye], [np.zeros((self.count, 3), number)], [eye]
        self.exact = losing_joints(plan)
        self.own = [True] + [
            turned is None or j in turned or is_free_base(joint)
            for j, joint in enumerate(plan.joints)
        ]
        self._place()

    def solved(self) -> Array:
        """Accelerations, shape (states, nv)."""
        n = len(self.plan.joints)
        bodies, forces = self._bare()
        kept: list[Any] = [None] * n
        for j in reversed(range(n)):
            kept[j] = self._eliminate(j, bodies, forces)
        motion: list[Any] = [np.zeros((self.count, 6), self.number)] * (n + 1)
        qdd = np.zeros((self.count, self.v.shape[1]), self.number)
        for j, joint in enumerate(self.plan.joints):
            near = motion[joint.parent]
            a = self._outwards(j, near) if self.line else self._outwards_in_base(j, near)
            if not joint.prescribed:
                axes, u, over = kept[j]
                if self.line:
                    own = u - np.einsum("skm,sm->sk", over, a)
                else:
                    axes, over = self._in_base(j, axes, over)
                    own = u - np.einsum("skm,sm->sk", over, near)
                qdd[:, joint.v : joint.v + own.shape[1]] = own
                a = a + np.einsum("smk,sk->sm", axes, own)
            motion[j + 1] = a
        return qdd

    def energy(self, qdd: Array) -> Array:
        """What joints' accelerations share in qdd^T H qdd, shape (states, joints)."""
        bodies, _ = self._bare()
        n = len(self.plan.joints)
        motion: list[Any] = [np.zeros((self.count, 6), self.number)] * (n + 1)
        shares = np.zeros((self.count, n))
        for j, joint in enumerate(self.plan.joints):
            a = self._outwards(j, motion[joint.parent])
            axes = self._freedoms(j)
            own = qdd[:, joint.v : joint.v + axes.shape[2]]
            motion[j + 1] = a = a + np.einsum("smk,sk->sm", axes, own)
            shares[:, j] = np.einsum("sm,smk,sk->s", a, bodies[j + 1], a)
            shares[:, j] += joint.rotor_inertia * (own**2).sum(axis=1)
        return shares

    # -- kinematics -------------------------------------------------------------------------------

    def _place(self) -> None:
        for joint in self.plan.joints:
            turn, shift = self._displaced(joint)
            base = np.array(joint.rotation, dtype=self.number)
            local = base @ turn
            offset = np.array(joint.translation, dtype=self.number) + shift @ base.T
            self.local.append(local)
            if is_free_base(joint):  # the base, in whose axes loops are
                self.axes.append(self.axes[0])
            else:
                self.axes.append(self.axes[joint.parent] @ local)
            self.place.append(offset)  # in the parent's axes

    def _displaced(self, joint: PlanJoint) -> tuple[Array, Array]:
        kind, q = KINDS[joint.kind], self._configuration(joint)
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

    def _configuration(self, joint: PlanJoint) -> Array:
        if joint.mimic is None:
            return self.q[:, joint.q : joint.q + KINDS[joint.kind].nq]
        source, multiplier, offset = joint.mimic
        at = self.plan.joints[source].q
        own = self.number(multiplier) * self.q[:, at : at + 1] + self.number(offset)
        return np.asarray(own, dtype=self.number)

    def _told(self, link: int, vectors: Array) -> Array:
        """Vectors of a link's axes, shape (states, 3), in those that its body is expressed in."""
        return vectors if self.own[link] else np.einsum("sik,sk->si", self.axes[link], vectors)

    def _freedoms(self, j: int) -> Array:
        """S of a joint, in the axes of its child link's body, shape (states, 6, freedoms)."""
        free = list(KINDS[self.plan.joints[j].kind].free)
        found = np.zeros((self.count, 6, len(free)), self.number)
        found[:, free, range(len(free))] = 1
        if not self.own[j + 1]:
            found[:, :3] = self.axes[j + 1] @ found[:, :3]
            found[:, 3:] = self.axes[j + 1] @ found[:, 3:]
        return found

    def _between(self, j: int) -> tuple[Array | None, Array]:
        """From the axes of the child's body to those of the parent's, and the way between."""
        parent, child = self.plan.joints[j].parent, j + 1
        way = self._told(parent, self.place[child])
        if self.own[child]:
            return (self.local[child] if self.own[parent] else self.axes[child]), way
        return (self.axes[parent].transpose(0, 2, 1) if self.own[parent] else None), way

    # -- bodies -----------------------------------------------------------------------------------

    def _bare(self) -> tuple[list[Array], list[Array]]:
        """Inertia of each link, and the force that it takes where no joint accelerates."""
        zero = np.zeros((self.count, 3), self.number)
        gravity = np.zeros((self.count, 3), self.number) - np.array(self.plan.gravity, self.number)
        spins, rates, rises = [zero], [zero], [gravity]
        bodies, forces = [np.zeros((self.count, 6, 6), self.number)], [np.zeros((self.count, 6))]
        for j in range(len(self.plan.joints)):
            spin, rate, rise = self._carried(j, spins, rates, rises)
            spins.append(spin)
            rates.append(rate)
            rises.append(rise)
            body, force = self._of_link(j + 1, spin, rate, rise)
            bodies.append(body)
            forces.append(force)
        return bodies, forces

    def _of_link(self, link: int, spin: Array, rate: Array, rise: Array) -> tuple[Array, Array]:
        """A bare link's inertia about its origin, and the force that its motion takes.

        As in emitted code both are found from constants that are rounded once: sums of m x x^T
        about the origin in loops, the inertia itself in straight lines, where the difference of
        equal entries is nothing.
        """
        mass, moments, about = self._constants(link)
        found = np.zeros((self.count, 6, 6), self.number)
        if not self.own[link]:
            axes = self.axes[link]
            about = np.tril(axes @ about @ axes.transpose(0, 2, 1))  # symmetric to the last bit
            about = self._as_rounded(about + np.tril(about, -1).transpose(0, 2, 1))
            moments = self._told(link, moments)
        found[:, :3, :3] = about
        if not self.line:
            trace = np.einsum("skk->s", about)[:, None, None]
            found[:, :3, :3] = trace * np.eye(3, dtype=self.number) - about
            for k in range(3):  # without what is taken away again
                found[:, k, k] = about[:, k - 2, k - 2] + about[:, k - 1, k - 1]
        found[:, :3, 3:], found[:, 3:, :3] = skew(moments), -skew(moments)
        found[:, 3:, 3:] = mass * np.eye(3, dtype=self.number)
        field = skew(rate) + np.einsum("si,sk->sik", spin, spin)
        for k in range(3):
            field[:, k, k] = -(spin[:, k - 2] * spin[:, k - 2] + spin[:, k - 1] * spin[:, k - 1])
        if self.line:
            moment = self._moment(found[:, :3, :3], spin, rate, field)
        else:
            each = field @ about  # what turns is what is not symmetric of it
            moment = np.stack([each[:, i - 1, i - 2] - each[:, i - 2, i - 1] for i in range(3)], 1)
        force = mass * rise + np.einsum("sik,sk->si", field, moments)
        both = np.hstack([moment + cross(moments, rise), force])
        return (self._as_rounded(found) if self.line else found), both

    def _constants(self, link: int) -> tuple[Any, Array, Array]:
        """Mass, moments and second moments of a link, in its axes and rounded once."""
        own = self.plan.links[link]
        com = np.array(own.com, np.longdouble)
        tensor, spread = np.array(own.tensor, np.longdouble), own.mass * np.outer(com, com)
        about = tensor - spread if self.line else spread - tensor
        for k in range(3):
            if self.line:
                about[k, k] = tensor[k, k] + (spread[k - 2, k - 2] + spread[k - 1, k - 1])
            else:
                parts = (-own.tensor[k][k], own.tensor[k - 2][k - 2], own.tensor[k - 1][k - 1])
                about[k, k] = math.fsum(parts) / 2 + spread[k, k]
        moments = (own.mass * com).astype(self.number)
        return (
            self.number(own.mass),
            np.broadcast_to(moments, (self.count, 3)),
            np.broadcast_to(about.astype(self.number), (self.count, 3, 3)),
        )

    @staticmethod
    def _moment(inertia: Array, spin: Array, rate: Array, field: Array) -> Array:
        """I alpha + omega x I omega, term by term as straight lines have it (kinematics.py)."""
        found = np.empty_like(spin)
        for i in range(3):
            k, m = (i + 1) % 3, (i + 2) % 3
            found[:, i] = (
                rate[:, i] * inertia[:, i, i]
                + (spin[:, k] * spin[:, m]) * (inertia[:, m, m] - inertia[:, k, k])
                - field[:, m, i] * inertia[:, i, k]
                + field[:, k, i] * inertia[:, i, m]
                + (field[:, k, k] - field[:, m, m]) * inertia[:, k, m]
            )
        return found

    def _as_rounded(self, matrix: Array) -> Array:
        """A symmetric matrix whose entries are rounded up or down one by one.

        Emitted code does so where a product and a sum are one instruction: differences of equal
        products are no longer zero.
        """
        if self.rounded is None:
            return matrix
        half = np.tril(self.rounded.choice([-1.0, 1.0], matrix.shape))
        signs = (half + np.tril(half, -1).transpose(0, 2, 1)).astype(self.number)
        found: Array = matrix * (1 + signs * (np.finfo(self.number).eps / 2))
        return found

    def _carried(
        self, j: int, spins: list[Array], rates: list[Array], rises: list[Array]
    ) -> tuple[Array, Array, Array]:
        """Spin, its rate and acceleration of a child link where its joint does not accelerate."""
        joint = self.plan.joints[j]
        turn, way = self._between(j)
        spin, rate, rise = (x[joint.parent] for x in (spins, rates, rises))
        rise = rise + cross(rate, way) + cross(spin, cross(spin, way))
        if turn is not None:
            spin, rate, rise = (np.einsum("ski,sk->si", turn, x) for x in (spin, rate, rise))
        axes = self._freedoms(j)
        count = axes.shape[2]
        speed = np.einsum("smk,sk->sm", axes, self.v[:, joint.v : joint.v + count])
        extra = np.zeros_like(speed)
        if joint.prescribed:
            extra = np.einsum("smk,sk->sm", axes, self.tau[:, joint.v : joint.v + count])
        turning, sliding = speed[:, :3], speed[:, 3:]
        rate = rate + cross(spin, turning) + extra[:, :3]
        rise = rise + 2 * cross(spin, sliding) + cross(turning, sliding) + extra[:, 3:]
        return spin + turning, rate, rise

    def _eliminate(self, j: int, bodies: list[Array], forces: list[Array]) -> Any:
        """Take a joint out of the body beyond, hand that on; (S, D^-1 u, D^-1 U^T)."""
        joint, body, force = self.plan.joints[j], bodies[j + 1], forces[j + 1]
        kept = None
        if not joint.prescribed:
            axes = self._freedoms(j)
            count = axes.shape[2]
            rotor = self.number(joint.rotor_inertia)
            wide = np.einsum("smk,skf->smf", body, axes)
            d = np.einsum("skf,skg->sfg", axes, wide) + rotor * np.eye(count, dtype=self.number)
            self._look_at(j, body, d)
            pull = self.tau[:, joint.v : joint.v + count] - np.einsum("skf,sk->sf", axes, force)
            u, over = solved(d, pull[:, :, None])[:, :, 0], solved(d, wide.transpose(0, 2, 1))
            body = body - wide @ over
            force = force + np.einsum("smf,sf->sm", wide, u)
            exact = self.own[j + 1] or count in (3, 6)
            if exact and not joint.rotor_inertia and joint.kind != "planar":
                free = list(KINDS[joint.kind].free)  # nothing is subtracted there
                body[:, free], body[:, :, free] = 0, 0
                along = np.einsum("smf,sf->sm", axes, self.tau[:, joint.v : joint.v + count])
                force[:, free] = along[:, free]
            body = (body + body.transpose(0, 2, 1)) / 2
            kept = (axes, u, over)
        if joint.parent > 0:
            turn, way = self._between(j)
            if self._turns_quickly(j):
                body, force = self._turned_quickly(j, body, force)
            elif turn is not None:
                body, force = turned_body(turn, body, force)
            body, force = shifted_body(body, force, way)
            bodies[joint.parent] = bodies[joint.parent] + body
            forces[joint.parent] = forces[joint.parent] + force
        return kept

    def _look_at(self, j: int, body: Array, d: Array) -> None:
        """Note the states in which a joint's pivots lose digits, or have none."""
        joint, unit = self.plan.joints[j], np.finfo(self.number).eps / 2
        if d.shape[1] > 1:
            part = LOST * unit * self.line * (np.arange(d.shape[1]) > 0)
            least = np.einsum("sff->sf", d) * part.astype(self.number)
            self.refused |= ~(pivots(d) > least).all(axis=1)
            return
        turning = KINDS[joint.kind].free[0] < 3
        half = slice(0, 3) if turning else slice(3, 6)
        trace = np.trace(body[:, half, half], axis1=1, axis2=2)
        if j in self.watched:
            self.lost |= ~(d[:, 0, 0] * ENOUGH > trace)
            return
        part = (LOST * unit) ** 2 if self.line else 2 * LOST * unit
        if self.own[j + 1]:  # what the bare link brings is exact there
            link = self.plan.links[j + 1]
            bare = np.trace(link.tensor) + 2 * link.mass * np.dot(link.com, link.com)
            trace = trace - self.number(bare if turning else 3 * link.mass)
        self.refused |= ~(d[:, 0, 0] > part * trace)

    def _turns_quickly(self, j: int) -> bool:
        """Whether a joint turns bodies by as few operations as in straight lines (frames.py)."""
        joint = self.plan.joints[j]
        turns = joint.kind in ("revolute", "planar") and is_turn(np.array(joint.rotation))
        return self.line and turns and self.rounded is not None and j not in self.exact

    def _turned_quickly(self, j: int, body: Array, force: Array) -> tuple[Array, Array]:
        """A body turned about its joint's axis, and on into its parent's axes."""
        base = np.array(self.plan.joints[j].rotation, dtype=self.number)
        turn = base.T @ self.local[j + 1]
        if base[2, 2] == 1:
            turn, base = self.local[j + 1], np.eye(3, dtype=self.number)
        return turned_body(
            np.broadcast_to(base, turn.shape), *turned_body(turn, body, force, about_z)
        )

    def _outwards_in_base(self, j: int, a: Array) -> Array:
        """The same in axes of the base, in which loops have all accelerations."""
        way = self._way_in_base(j)
        return np.hstack([a[:, :3], a[:, 3:] + cross(a[:, :3], way)])

    def _way_in_base(self, j: int) -> Array:
        near = self.axes[self.plan.joints[j].parent]
        found: Array = np.einsum("sik,sk->si", near, self.place[j + 1])
        return found

    def _in_base(self, j: int, axes: Array, over: Array) -> tuple[Array, Array]:
        """S and D^-1 U^T in axes of the base, as in loops: the latter at the parent's origin."""
        if self.own[j + 1]:
            turn = self.axes[j + 1]
            axes = np.concatenate([turn @ axes[:, :3], turn @ axes[:, 3:]], axis=1)
            turned = [over[:, :, half] @ turn.transpose(0, 2, 1) for half in (_TURNING, _SLIDING)]
            over = np.concatenate(turned, axis=2)
        arm = skew(self._way_in_base(j))
        moments = over[:, :, :3] - over[:, :, 3:] @ arm
        return axes, np.concatenate([moments, over[:, :, 3:]], axis=2)

    def _outwards(self, j: int, a: Array) -> Array:
        """An acceleration of the parent's, at the child and in the axes of the child's body."""
        turn, way = self._between(j)
        turning, sliding = a[:, :3], a[:, 3:] + cross(a[:, :3], way)
        if turn is not None:
            turning, sliding = (np.einsum("ski,sk->si", turn, x) for x in (turning, sliding))
        return np.hstack([turning, sliding])
