"""How many digits a way of sweeping keeps on a robot, found by a trial in the program's own states.

Articulated bodies are swept in numpy as emitted code sweeps them: in straight lines each body is
in its link's axes, in which a joint's projection is exact, and turned by as few operations
(frames.py); in loops in axes of the base, but for joints that are swept in their own
(adagen/plan/turned.py). The same is done in more digits than the scalar has; what differs is the
rounding error of that way. Joining is no part of it.
"""

from __future__ import annotations

from collections.abc import Set
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.program_states import COUNT, program_states
from adagen.executor.solve import interpret
from adagen.executor.stacked import (
    about_z,
    cross,
    is_turn,
    rotation,
    shifted_body,
    solved,
    spatial_body,
    turned_body,
)
from adagen.graph import DOUBLE, FLOAT
from adagen.model.kinds import KINDS
from adagen.plan.robot import PlanJoint
from adagen.plan.turned import ENOUGH, Turned, losing_joints
from adagen.plan.types import Plan

Array = NDArray[Any]
STATES = {"few joints": COUNT, "many joints": 4}
HARDEST, TIMES = 8, 8
"""How many of the states that lose most are tried again, and how often: what is lost there differs
from one rounding to the next by more than a decade."""
MANY = 200
"""Joints beyond which fewer states are tried: what many joints lose varies less."""
_MORE: dict[str, tuple[Any, Any]] = {
    "double": (np.float64, np.longdouble),
    "float": (np.float32, np.float64),
}


@dataclass(frozen=True)
class Trial:
    """What a way of sweeping is found to lose.

    Attributes:
        error: relative forward error in the energy norm, the largest of the states; infinite where
            a factorization fails.
        joint: the joint that has the largest share of it.
    """

    error: float
    joint: int


def tried(plan: Plan, turned: Turned | None) -> Trial:
    """Return what sweeping a robot inwards and outwards loses.

    Args:
        plan: its joints, links and scalar are looked at.
        turned: joints that are swept in their own axes, always or where digits are lost, all others
            in those of the base; None: every body is expressed in its link's axes.
    """
    states = _states(plan)
    shares, errors = _lost(plan, turned, states)
    hardest = np.argsort(errors)[-HARDEST:]
    again, repeated = _lost(plan, turned, _rounded_anew(states, hardest))
    shares, errors = np.vstack([shares, again]), np.hstack([errors, repeated])
    worst = int(np.argmax(errors))
    return Trial(float(np.sqrt(errors[worst])), int(np.argmax(np.nan_to_num(shares[worst]))))


def carried_out(plan: Plan) -> Trial:
    """Return what all processes together lose, as the executor carries their plan out.

    Passive torques and outer forces are left out: factors are the same without them.

    Args:
        plan: of a robot without closed loops or slaved joints, all accelerations wanted.

    Raises:
        FloatingPointError: a factorization fails; the message names the joint.
    """
    own, more = _MORE[plan.scalar]
    algebra = FLOAT if own is np.float32 else DOUBLE
    states = q, v, tau = _states(plan)
    tau[:, plan.nv :] = 0
    free = [replace(each, damping=0.0, friction=0.0, stiffness=0.0) for each in plan.joints]
    bare = replace(plan, joints=tuple(free))
    found = interpret(bare, q.T, v.T, tau.T, algebra)[: plan.nv].T
    shares, errors = _off(plan, states, np.asarray(found, more), accelerations(plan, *states))
    worst = int(np.argmax(errors))
    return Trial(float(np.sqrt(errors[worst])), int(np.argmax(np.nan_to_num(shares[worst]))))


def _off(
    plan: Plan, states: tuple[Array, Array, Array], found: Array, truth: Array
) -> tuple[Array, Array]:
    """The squares of relative errors in the energy norm, and what joints share in them."""
    size = _Sweep(plan, np.float64, None, states)
    with np.errstate(all="ignore"):
        shares = size.energy((found - truth).astype(np.float64))
        errors = shares.sum(axis=1) / size.energy(truth.astype(np.float64)).sum(axis=1)
    errors[~np.isfinite(errors)] = np.inf
    return shares, errors


def _lost(
    plan: Plan, turned: Turned | None, states: tuple[Array, Array, Array]
) -> tuple[Array, Array]:
    """The squares of errors in states, and what joints share in them, shape (states, joints)."""
    own, more = _MORE[plan.scalar]
    with np.errstate(all="ignore"):
        truth = _Sweep(plan, more, None, states).solved()
        found = _swept(plan, own, turned, states).astype(more)
        return _off(plan, states, found, truth)


def _rounded_anew(states: tuple[Array, Array, Array], which: Array) -> tuple[Array, Array, Array]:
    """States with angles so little off that only rounding differs, each several times."""
    rng = np.random.default_rng(3)
    q, v, tau = (np.repeat(x[which], TIMES, axis=0) for x in states)
    return q * (1 + rng.uniform(-1e-8, 1e-8, q.shape)), v, tau


def _swept(
    plan: Plan, number: Any, turned: Turned | None, states: tuple[Array, Array, Array]
) -> Array:
    """What emitted code would find in states: sweeps that lose digits are repeated in own axes."""
    if turned is None:
        return _Sweep(plan, number, None, states, rounded=True).solved()
    first = _Sweep(plan, number, turned.always, states, rounded=True, watched=turned.if_lost)
    found = first.solved()
    if first.lost.any():
        everywhere = turned.always | turned.if_lost
        again = _Sweep(plan, number, everywhere, states, rounded=True).solved()
        found[first.lost] = again[first.lost]
    return found


def accelerations(plan: Plan, q: Array, v: Array, tau: Array) -> Array:
    """Return the accelerations of states in more digits than the plan's scalar has.

    Slaved joints are treated as independent ones.

    Args:
        plan: of the robot.
        q: configurations, shape (S, nq).
        v: velocities, shape (S, nv).
        tau: torques, shape (S, nv).
    """
    more = _MORE[plan.scalar][1]
    return _Sweep(plan, more, None, (q, v, tau)).solved()


def _states(plan: Plan) -> tuple[Array, Array, Array]:
    """States that the emitted program draws, one in each row; fewer where joints are many."""
    return program_states(plan, STATES["many joints" if len(plan.joints) > MANY else "few joints"])


class _Sweep:
    """All states at once, in numbers of one type; arrays have the states first."""

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
        self.rounded = np.random.default_rng(2) if rounded else None
        self.q, self.v, self.tau = (x.astype(number) for x in states)
        self.count = len(self.q)
        self.lost = np.zeros(self.count, dtype=bool)  # whether a watched joint lost digits
        eye = np.broadcast_to(np.eye(3, dtype=number), (self.count, 3, 3))
        self.axes, self.place, self.local = [eye], [np.zeros((self.count, 3), number)], [eye]
        self.exact = losing_joints(plan)
        self.own = [True] + [turned is None or j in turned for j in range(len(plan.joints))]
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
            a = self._outwards(j, motion[joint.parent])
            if not joint.prescribed:
                axes, u, over = kept[j]
                own = u - np.einsum("skm,sm->sk", over, a)
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
            link = self.plan.links[j + 1]
            tensor = np.array([link.tensor] * self.count, self.number)
            com = zero + np.array(link.com, self.number)
            if not self.own[j + 1]:
                axes = self.axes[j + 1]
                tensor, com = axes @ tensor @ axes.transpose(0, 2, 1), self._told(j + 1, com)
            mass = self.number(link.mass)
            bodies.append(self._as_rounded(spatial_body(mass, com, tensor)))
            force = mass * (rise + cross(rate, com) + cross(spin, cross(spin, com)))
            turning = np.einsum("sik,sk->si", tensor, spin)
            moment = np.einsum("sik,sk->si", tensor, rate) + cross(spin, turning)
            forces.append(np.hstack([moment + cross(com, force), force]))
        return bodies, forces

    def _as_rounded(self, body: Array) -> Array:
        """A body whose entries are rounded one by one.

        Emitted code does so where a product and a sum are one instruction.
        """
        if self.rounded is None:
            return body
        half = np.tril(self.rounded.choice([-1.0, 1.0], body.shape))
        signs = (half + np.tril(half, -1).transpose(0, 2, 1)).astype(self.number)
        found: Array = body * (1 + signs * (np.finfo(self.number).eps / 2))
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
            if j in self.watched:
                half = slice(0, 3) if KINDS[joint.kind].free[0] < 3 else slice(3, 6)
                trace = np.trace(body[:, half, half], axis1=1, axis2=2)
                self.lost |= ~(d[:, 0, 0] * ENOUGH > trace)
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

    def _turns_quickly(self, j: int) -> bool:
        """Whether a joint turns bodies by as few operations as in straight lines (frames.py)."""
        joint = self.plan.joints[j]
        known = self.own[j + 1] and self.own[joint.parent]
        turns = joint.kind in ("revolute", "planar") and is_turn(np.array(joint.rotation))
        return known and turns and self.rounded is not None and j not in self.exact

    def _turned_quickly(self, j: int, body: Array, force: Array) -> tuple[Array, Array]:
        """A body turned about its joint's axis, and on into its parent's axes."""
        base = np.array(self.plan.joints[j].rotation, dtype=self.number)
        turn = base.T @ self.local[j + 1]
        if base[2, 2] == 1:
            turn, base = self.local[j + 1], np.eye(3, dtype=self.number)
        return turned_body(
            np.broadcast_to(base, turn.shape), *turned_body(turn, body, force, about_z)
        )

    def _outwards(self, j: int, a: Array) -> Array:
        """An acceleration of the parent's, at the child and in the axes of the child's body."""
        turn, way = self._between(j)
        turning, sliding = a[:, :3], a[:, 3:] + cross(a[:, :3], way)
        if turn is not None:
            turning, sliding = (np.einsum("ski,sk->si", turn, x) for x in (turning, sliding))
        return np.hstack([turning, sliding])
