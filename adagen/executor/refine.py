"""Iterative refinement of a plan's answer: residuals of all links, then a correction.

The unknowns are the joint accelerations and the joint forces together. The links' accelerations
follow from the joints', a_l = X a_parent + S qdd + c, and with the joint forces f the residual of
each link is rho_l = f_l - sum X_c^T f_c - I_l a_l - v_l x* I_l v_l. The plan is carried out once
more, with the same factors, with rho as the only forces: no velocities, no gravity, no torques. Its
answer is added to both unknowns, and the size of it is the error that the answer had.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.many_states import cross
from adagen.executor.solve import Run
from adagen.model.kinds import KINDS
from adagen.plan.placement import configuration, cross_motion, placement
from adagen.plan.refine import handed_on, refinable
from adagen.plan.types import Plan

Array = NDArray[Any]


@dataclass(frozen=True, eq=False)
class Refined:
    """A refined answer.

    Attributes:
        qdd: accelerations, shape (nv,) or (nv, S).
        corrections: for each step of refinement the size of what it changed, relative to the
            answer, in the energy norm sqrt(e^T H e / t^T H t): the error before that step; of S
            states an array of them, shape (S,).
    """

    qdd: NDArray[np.float64]
    corrections: tuple[Any, ...]


def interpret_refined(
    plan: Plan, q: Any, v: Any, tau: Any, steps: int, wide: Any = np.longdouble
) -> Refined:
    """Return the accelerations that a plan computes, refined.

    Args:
        plan: the plan.
        q: configuration, shape (nq,), or (nq, S) for S states at once.
        v: velocity, shape (nv,) or (nv, S).
        tau: joint torques and forces, shape (nv,) or (nv, S).
        steps: of refinement.
        wide: numpy's type for residuals and sums; the plan itself is carried out in double.

    Raises:
        FloatingPointError: a factorization failed, in one state at least; the message names the
            joint.
        UsageError: the plan cannot be refined.
    """
    plan = refinable(plan)
    q, v = _with_slaved(plan, q, v)
    tau = np.asarray(tau, dtype=float)
    apart, together = (_apart, _together) if q.ndim > 1 else (_alone, lambda found: found[0])
    chains = [WideLinks(plan, *state, wide) for state in zip(apart(q), apart(v), strict=True)]
    torques = apart(tau)
    first = map(apart, _solve(plan, q, v, tau))
    answers = [
        (chain.follow(qdd.astype(wide)), chain.handed_on(forces, own))
        for chain, qdd, forces, own in zip(chains, *first, torques, strict=True)
    ]
    sizes = []
    for _ in range(steps):
        rows = list(zip(chains, answers, torques, strict=True))
        rho = [chain.residual(*answer).astype(float) for chain, answer, _ in rows]
        lacking = [chain.lacking(own, forces) for chain, (_, forces), own in rows]
        more = map(apart, _solve(plan, q, v, together(lacking), together(rho)))
        found = list(zip(chains, answers, *more, lacking, strict=True))
        sizes.append(together([chain.off(step, qdd) for chain, (qdd, _), step, *_ in found]))
        answers = [
            (chain.follow(qdd + step), forces + chain.handed_on(step_forces, missing))
            for chain, (qdd, forces), step, step_forces, missing in found
        ]
    return Refined(together([qdd for qdd, _ in answers]).astype(float), tuple(sizes))


def _alone(values: Array) -> list[Array]:
    return [values]


def _apart(values: Array) -> list[Array]:
    """Return the arrays of single states, which come last."""
    return list(np.moveaxis(values, -1, 0))


def _together(values: list[Any]) -> Array:
    return np.stack(values, axis=-1)


def _solve(
    plan: Plan, q: Array, v: Array, tau: Array, rho: Array | None = None
) -> tuple[Array, Array]:
    """Return accelerations, shape (nv,), and joint forces in the child links' frames, (N, 6).

    With ``rho``, shape (N + 1, 6), those that these wrenches and the torques cause alone. Of
    several states all have one more axis, the last.
    """
    count = q.shape[1:]
    given = np.zeros(0) if rho is None else rho.reshape(-1, *count)
    inputs = {"q": q, "v": v, "tau": tau, "rho": given}
    run = Run(plan, inputs, refining="answer" if rho is None else "correction", once=True)
    run.check(digits=False)
    columns = 1 + len(plan.slaved)
    forces = np.zeros((len(plan.joints), 6, *(count or (1,))))
    for p, machine in enumerate(run.machines):
        memory = machine.memory
        kept = [name for name in memory if isinstance(name, tuple) and name[0] == "force"]
        for name in kept:
            force = run.of(p, memory[name]).reshape(6, columns, -1)
            forces[name[1]] = force[:, 0]
            if plan.slaved:
                torques = run.of(p, memory["torques"]).reshape(columns - 1, -1)
                forces[name[1]] += (force[:, 1:] * torques).sum(axis=1)
    qdd = run.accelerations()
    if qdd.ndim <= len(count):  # the same in all states
        qdd = np.broadcast_to(qdd[:, None], (len(qdd), *count))
    return qdd, forces.reshape(-1, 6, *count)


def _with_slaved(plan: Plan, q: Array, v: Array) -> tuple[Array, Array]:
    """Return q, shape (nq,), and v, shape (nv,), with slaved joints' entries from their sources."""
    q, v = np.array(q, dtype=float), np.array(v, dtype=float)
    for j in plan.slaved:
        joint = plan.joints[j]
        assert joint.mimic is not None
        source, multiplier, offset = joint.mimic
        q[joint.q] = multiplier * q[plan.joints[source].q] + offset
        v[joint.v] = multiplier * v[plan.joints[source].v]
    return q, v


class WideLinks:
    """Motion of all links in higher precision."""

    def __init__(self, plan: Plan, q: Array, v: Array, wide: Any) -> None:
        self.plan, self.wide = plan, wide
        self.pairs = [pair for process in plan.processes for pair in handed_on(process)]
        n = len(plan.joints)
        self.turn = np.zeros((n, 3, 3), dtype=wide)  # parent to child coordinates
        self.shift = np.zeros((n, 3), dtype=wide)
        self.velocity = np.zeros((n + 1, 6), dtype=wide)
        self.product = np.zeros((n, 6), dtype=wide)  # c
        for j, joint in enumerate(plan.joints):
            state = configuration(plan.joints, joint, q.astype(wide))
            turn, shift = placement(KINDS[joint.kind], state)
            base = np.array(joint.rotation, dtype=wide)
            self.turn[j] = (base @ turn).T
            self.shift[j] = np.array(joint.translation, dtype=wide) + base @ shift
            motion = self._along(j, v.astype(wide))
            self.velocity[j + 1] = self._carried(j, self.velocity[joint.parent]) + motion
            self.product[j] = cross_motion(self.velocity[j + 1], motion)

    def follow(self, qdd: Array) -> Array:
        """Return accelerations, shape (nv,), with those of slaved joints from their sources."""
        qdd = qdd.copy()
        joints = self.plan.joints
        for slaved, source, multiplier in self.plan.following:
            qdd[joints[slaved].v] = self.wide(multiplier) * qdd[joints[source].v]
        return qdd

    def residual(self, qdd: Array, forces: Array) -> Array:
        """Return the residual of each link, shape (N + 1, 6); the ground's row is zero."""
        n = len(self.plan.joints)
        a, rho = np.zeros((n + 1, 6), dtype=self.wide), np.zeros((n + 1, 6), dtype=self.wide)
        a[0, 3:] = -np.array(self.plan.gravity, dtype=self.wide)
        for j, joint in enumerate(self.plan.joints):
            a[j + 1] = self._carried(j, a[joint.parent]) + self._along(j, qdd) + self.product[j]
            v = self.velocity[j + 1]
            momentum = self._inertia(j + 1, v)
            rho[j + 1] += forces[j] - self._inertia(j + 1, a[j + 1]) - _cross_force(v, momentum)
            rho[joint.parent] -= self._returned(j, forces[j])
        rho[0] = 0
        return rho

    def handed_on(self, forces: Array, tau: Array) -> Array:
        """Return joint forces, shape (N, 6), inside fused runs from the ones at their ends.

        At the end of a run the force along the joint is the torque, to the bit.
        """
        forces = forces.astype(self.wide)
        inner = {j for j, _ in self.pairs}
        for j in {beyond for _, beyond in self.pairs} - inner:
            joint, kind = self.plan.joints[j], KINDS[self.plan.joints[j].kind]
            forces[j, list(kind.free)] = tau[joint.v : joint.v + kind.nv]
        for j, beyond in self.pairs:
            forces[j] = self._returned(beyond, forces[beyond])
        return forces

    def lacking(self, tau: Array, forces: Array) -> Array:
        """Return the missing torques of joints inside fused runs, shape (nv,)."""
        missing = np.zeros(len(tau))
        for j, _ in self.pairs:
            joint, kind = self.plan.joints[j], KINDS[self.plan.joints[j].kind]
            own = slice(joint.v, joint.v + kind.nv)
            missing[own] = tau[own] - forces[j, list(kind.free)]
        return missing

    def off(self, step: Array, qdd: Array) -> float:
        """Return the size of a correction of accelerations, relative to these."""
        size = self.energy(step) / max(self.energy(qdd), np.finfo(float).tiny)
        return float(np.sqrt(size))

    def energy(self, qdd: Array) -> Any:
        """Return qdd^T H qdd of accelerations, shape (nv,), from the links' motions."""
        w, energy = np.zeros((len(self.plan.joints) + 1, 6), dtype=self.wide), self.wide(0)
        for j, joint in enumerate(self.plan.joints):
            w[j + 1] = self._carried(j, w[joint.parent]) + self._along(j, qdd)
            energy += w[j + 1] @ self._inertia(j + 1, w[j + 1])
        return energy

    def _along(self, j: int, rates: Array) -> Array:
        joint, kind = self.plan.joints[j], KINDS[self.plan.joints[j].kind]
        motion = np.zeros(6, dtype=self.wide)
        motion[list(kind.free)] = rates[joint.v : joint.v + kind.nv]
        return motion

    def _carried(self, j: int, motion: Array) -> Array:
        linear = motion[3:] - cross(self.shift[j], motion[:3])
        return np.concatenate([self.turn[j] @ motion[:3], self.turn[j] @ linear])

    def _returned(self, j: int, force: Array) -> Array:
        """Return a wrench on a joint's child link in its parent link's frame."""
        moment, linear = self.turn[j].T @ force[:3], self.turn[j].T @ force[3:]
        return np.concatenate([moment + cross(self.shift[j], linear), linear])

    def _inertia(self, number: int, motion: Array) -> Array:
        """Return I m of a link: its mass at the centre of mass, and its tensor about it."""
        link = self.plan.links[number]
        c = np.array(link.com, dtype=self.wide)
        force = self.wide(link.mass) * (motion[3:] + cross(motion[:3], c))
        moment = np.array(link.tensor, dtype=self.wide) @ motion[:3] + cross(c, force)
        return np.concatenate([moment, force])


def _cross_force(v: Array, f: Array) -> Array:
    moment = cross(v[:3], f[:3]) + cross(v[3:], f[3:])
    return np.concatenate([moment, cross(v[:3], f[3:])])
