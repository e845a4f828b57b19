"""Sweeps of articulated bodies in numpy, in many states at once, rounded as in emitted code."""

from __future__ import annotations

from collections.abc import Sequence, Set
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.many_states import (
    about_z,
    cross,
    is_turn,
    pivots,
    shifted_body,
    skew,
    solved,
    turned_body,
)
from adagen.executor.trial_motion import LinkInertias, LinkMotions
from adagen.model.kinds import KINDS
from adagen.plan.edges import is_free_base
from adagen.plan.own_axes import ENOUGH, losing_joints
from adagen.plan.robot import PlanLink
from adagen.plan.types import Plan

Array = NDArray[Any]
LOST = 16
"""Units in the last place of what a pivot is found in, below which emitted code refuses it."""


class Sweep:
    """Sweeps of all states at once, in numbers of one type; arrays have the states first.

    Args:
        plan: its joints, links and gravity are looked at.
        number: the type.
        own_axes: joints that are swept in their own axes, all others in those of the base; None:
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
        own_axes: Set[int] | None,
        states: tuple[Array, Array, Array],
        rounded: bool = False,
        watched: Set[int] = frozenset(),
    ) -> None:
        self.plan, self.number, self.watched = plan, number, watched
        self.line = own_axes is None
        self.rounded = np.random.default_rng(2) if rounded else None
        q, self.v, self.tau = (x.astype(number) for x in states)
        self.count = len(q)
        self.lost, self.refused = np.zeros((2, self.count), dtype=bool)
        self.own = [True] + [
            own_axes is None or j in own_axes or is_free_base(joint)
            for j, joint in enumerate(plan.joints)
        ]
        self.at = LinkMotions(plan, self.own, q, self.line)
        self.bare = LinkInertias(self.at, self.line)
        self._arms = skew(self.at.ways)
        self._pivots = np.ones((len(plan.joints), self.count), number)
        self._quickly = self._turned_by_few() if self.line and rounded else frozenset()

    def solved(self) -> Array:
        """Accelerations, shape (states, nv)."""
        n = len(self.plan.joints)
        bodies, forces = self.bare.moving(self.v, self.tau, self.rounded)
        kept: list[Any] = [None] * n
        for j in reversed(range(n)):
            kept[j] = self._eliminate(j, bodies, forces)
        self._look(bodies)
        return self._outwards(kept) if self.line else self._outwards_in_base(kept)

    def energy(self, qdd: Array) -> Array:
        """The joints' parts in qdd^T H qdd, shape (states, joints)."""
        n = len(self.plan.joints)
        bodies = self.bare.at_rest()
        motion = np.zeros((n + 1, self.count, 6), self.number)
        shares = np.zeros((self.count, n))
        for j, joint in enumerate(self.plan.joints):
            a, axes = self._at_child(j, motion[joint.parent]), self.at.free[j]
            own = qdd[:, joint.v : joint.v + axes.shape[2]]
            motion[j + 1] = a = a + np.einsum("smk,sk->sm", axes, own)
            shares[:, j] = np.einsum("sm,mk,sk->s", a, bodies[j + 1], a)
            shares[:, j] += joint.rotor_inertia * (own**2).sum(axis=1)
        return shares

    # -- inwards ----------------------------------------------------------------------------------

    def _eliminate(self, j: int, bodies: Array, forces: Array) -> Any:
        """Eliminate a joint, pass the rest to its near link; (D^-1 u, D^-1 U^T)."""
        joint, body, force = self.plan.joints[j], bodies[j + 1], forces[j + 1]
        kept = None
        if not joint.prescribed:
            body, force, kept = self._projected(j, body, force)
        if joint.parent > 0:
            turn, way = self.at.turn(j), self.at.ways[j]
            if j in self._quickly:
                body, force = self._turned_quickly(j, body, force)
            elif turn is not None:
                body, force = turned_body(turn, body, force)
            body, force = shifted_body(body, force, way, self._arms[j])
            bodies[joint.parent] += body
            forces[joint.parent] += force
        return kept

    def _projected(self, j: int, body: Array, force: Array) -> tuple[Array, Array, Any]:
        """A body and the force on it after projection through a joint, and its factors."""
        joint, axes = self.plan.joints[j], self.at.free[j]
        count = axes.shape[2]
        rotor = self.number(joint.rotor_inertia)
        wide = np.einsum("smk,skf->smf", body, axes)
        d = np.einsum("skf,skg->sfg", axes, wide)
        if rotor:
            d += rotor * np.eye(count, dtype=self.number)
        self._note(j, d)
        tau = self.tau[:, joint.v : joint.v + count]
        pull = tau - np.einsum("skf,sk->sf", axes, force)
        u, over = solved(d, pull[:, :, None])[:, :, 0], solved(d, wide.transpose(0, 2, 1))
        body = body - wide @ over
        force = force + np.einsum("smf,sf->sm", wide, u)
        exact = self.own[j + 1] or count in (3, 6)
        if exact and not joint.rotor_inertia and joint.kind != "planar":
            free = list(KINDS[joint.kind].free)  # nothing is subtracted there
            body[:, free], body[:, :, free] = 0, 0
            force[:, free] = np.einsum("smf,sf->sm", axes, tau)[:, free]
        return (body + body.transpose(0, 2, 1)) / 2, force, (u, over)

    def _note(self, j: int, d: Array) -> None:
        """Store a joint's pivot; of several refuse those that are only rounding."""
        if d.shape[1] == 1:
            self._pivots[j] = d[:, 0, 0]
            return
        unit = np.finfo(self.number).eps / 2
        part = LOST * unit * self.line * (np.arange(d.shape[1]) > 0)
        least = np.einsum("sff->sf", d) * part.astype(self.number)
        self.refused |= ~(pivots(d) > least).all(axis=1)

    def _look(self, bodies: Array) -> None:
        """Note the states in which pivots of one-freedom joints lose digits, or have none.

        Args:
            bodies: with all that hangs on them.
        """
        joints, links, unit = self.plan.joints, self.plan.links, np.finfo(self.number).eps / 2
        part = (LOST * unit) ** 2 if self.line else 2 * LOST * unit
        for kind, axes in (("revolute", (0, 1, 2)), ("prismatic", (3, 4, 5))):
            some = [j for j, one in enumerate(joints) if one.kind == kind and not one.prescribed]
            a, b, c = (bodies[:, :, k, k][[j + 1 for j in some]] for k in axes)
            trace, d = a + b + c, self._pivots[some]
            watched = np.array([j in self.watched for j in some], dtype=bool)
            self.lost |= (~(d * ENOUGH > trace) & watched[:, None]).any(axis=0)
            bare = np.zeros((len(some), 1), self.number)
            for k, j in enumerate(some):
                if self.own[j + 1]:  # what the bare link brings is exact there
                    bare[k] = _trace(links[j + 1]) if kind == "revolute" else 3 * links[j + 1].mass
            nothing = ~(d > part * (trace - bare))
            self.refused |= (nothing & ~watched[:, None]).any(axis=0)

    def _turned_by_few(self) -> frozenset[int]:
        """Joints that rotate bodies by as few operations as straight lines (frames.py)."""
        exact = losing_joints(self.plan)
        return frozenset(
            j
            for j, joint in enumerate(self.plan.joints)
            if joint.kind in ("revolute", "planar")
            and j not in exact
            and is_turn(np.array(joint.rotation))
        )

    def _turned_quickly(self, j: int, body: Array, force: Array) -> tuple[Array, Array]:
        """A body rotated about its joint's axis, and on into its parent's axes."""
        base = np.array(self.plan.joints[j].rotation, dtype=self.number)
        local = self.at.turn(j)
        assert local is not None  # in straight lines all are in their own axes
        turn = base.T @ local
        if base[2, 2] == 1:
            turn, base = local, np.eye(3, dtype=self.number)
        return turned_body(
            np.broadcast_to(base, turn.shape), *turned_body(turn, body, force, about_z)
        )

    # -- outwards ---------------------------------------------------------------------------------

    def _outwards(self, kept: Sequence[Any]) -> Array:
        """Accelerations from joint to joint, each in its own axes."""
        motion = np.zeros((len(kept) + 1, self.count, 6), self.number)
        qdd = np.zeros((self.count, self.v.shape[1]), self.number)
        for j, joint in enumerate(self.plan.joints):
            a = self._at_child(j, motion[joint.parent])
            if kept[j] is not None:
                axes, (u, over) = self.at.free[j], kept[j]
                own = u - np.einsum("skm,sm->sk", over, a)
                qdd[:, joint.v : joint.v + own.shape[1]] = own
                a = a + np.einsum("smk,sk->sm", axes, own)
            motion[j + 1] = a
        return qdd

    def _outwards_in_base(self, kept: Sequence[Any]) -> Array:
        """The same in base axes, in which loops have all accelerations."""
        motion = np.zeros((len(kept) + 1, self.count, 6), self.number)
        qdd = np.zeros((self.count, self.v.shape[1]), self.number)
        parents = np.array([joint.parent for joint in self.plan.joints])
        ways = self.at.in_base_axes(parents, self.at.place[1:])
        arms = skew(ways)
        for j, joint in enumerate(self.plan.joints):
            near, a = motion[joint.parent], motion[j + 1]
            a[:] = near
            a[:, 3:] += cross(near[:, :3], ways[j])
            if kept[j] is not None:
                u, over = kept[j]
                axes, over = self._in_base(j, over, arms[j])
                own = u - np.einsum("skm,sm->sk", over, near)
                qdd[:, joint.v : joint.v + own.shape[1]] = own
                a += np.einsum("smk,sk->sm", axes, own)
        return qdd

    def _in_base(self, j: int, over: Array, arm: Array) -> tuple[Array, Array]:
        """S and D^-1 U^T in base axes, as in loops: the latter at the parent's origin."""
        axes = self.at.free[j]
        if self.own[j + 1]:
            turn = self.at.axes[j + 1]
            axes = np.concatenate([turn @ axes[:, :3], turn @ axes[:, 3:]], axis=1)
            turned = [x @ turn.transpose(0, 2, 1) for x in (over[:, :, :3], over[:, :, 3:])]
            over = np.concatenate(turned, axis=2)
        moments = over[:, :, :3] - over[:, :, 3:] @ arm
        return axes, np.concatenate([moments, over[:, :, 3:]], axis=2)

    def _at_child(self, j: int, a: Array) -> Array:
        """An acceleration of the parent's, at the child and in the axes of the child's body."""
        turn, way = self.at.turn(j), self.at.ways[j]
        turning, sliding = a[:, :3], a[:, 3:] + cross(a[:, :3], way)
        if turn is not None:
            turning, sliding = (np.einsum("ski,sk->si", turn, x) for x in (turning, sliding))
        return np.concatenate([turning, sliding], axis=1)


def _trace(link: PlanLink) -> float:
    """The trace of a bare link's inertia about its origin."""
    about = link.tensor[0][0] + link.tensor[1][1] + link.tensor[2][2]
    return about + 2 * link.mass * sum(x * x for x in link.com)
