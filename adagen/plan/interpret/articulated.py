"""What the steps of form `segment` mean, in numpy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import JointKind
from adagen.plan.steps import (
    Accelerate,
    AccelerateRoot,
    Articulate,
    Deliver,
    FreeAcceleration,
    FreeBase,
    HoldMobility,
    InvertRoot,
    Load,
    LoadRoot,
    Propagate,
    SolveMobility,
    SolveRoot,
    StartEmpty,
    StartLink,
    Step,
)
from adagen.plan.types import FACTORS

if TYPE_CHECKING:
    from adagen.plan.interpret.machine import Machine

Array = NDArray[np.float64]

LEAST_PIVOT = {"double": 1e-5, "float": 1e-2}
"""Least pivot of Phi with which a mobility is taken for an inertia, angular and linear pivots each
relative to the largest entry of their diagonal."""


class SegmentMachine:
    """Executes the steps inside a segment on a process's memory.

    A joint is treated in its own frame, the child link's. Seen from the segment's root the far
    link's acceleration is a_far = a_near + sigma (S qdd + c), sigma being -1 where the far link is
    the parent, and the force f on it obeys sigma tau = S^T f.
    """

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.memory: dict[Any, Any] = machine.memory

    def step(self, step: Step) -> None:
        """Do one step."""
        match step:
            case StartLink():
                self._start(step.link)
            case StartEmpty():
                self.memory["IA", step.link] = np.zeros((6, 6))
                self.memory["pA", step.link] = np.zeros((6, self.machine.columns))
            case FreeBase():
                free = list(self._kind(step.joint).free)
                self.memory["pA", step.joint + 1][free] -= self.machine.torques(step.joint)
            case Articulate():
                self._articulate(step)
            case Propagate():
                self._propagate(step)
            case Deliver():
                self._deliver(step)
            case FreeAcceleration():
                x, free = self.memory["X", step.joint], list(self._kind(step.joint).free)
                a = self.memory["a", step.joint + 1] - x @ self.machine.ground()
                self.machine.accelerate(step.joint, a[free])
            case Accelerate():
                self._accelerate(step)
            case InvertRoot() | SolveRoot() | SolveMobility() | LoadRoot() | Load():
                self._at_root(step)
            case HoldMobility():
                self._hold(step)
            case AccelerateRoot():
                phi, b = self.memory[step.block], self.memory[step.bias]
                self.memory["a", step.link] = b + phi @ self.memory["load", step.link]

    def _hold(self, step: HoldMobility) -> None:
        phi, b = self.memory[step.block], self.memory[step.bias]
        most = np.diag(phi).reshape(2, 3).max(axis=1).repeat(3)
        pivots = np.diag(np.linalg.cholesky(phi)) ** 2
        if (pivots / most).min() < LEAST_PIVOT[FACTORS[self.machine.plan.scalar]]:
            raise np.linalg.LinAlgError
        inverse = np.linalg.inv(phi)
        self.memory["IA", step.link], self.memory["pA", step.link] = inverse, -inverse @ b

    def _at_root(self, step: InvertRoot | SolveRoot | SolveMobility | LoadRoot | Load) -> None:
        if isinstance(step, Load):
            none = np.zeros((6, self.machine.columns))
            force = none if step.force is None else self.memory[step.force]
            self.memory["load", step.link] = force.copy()
            return
        inertia, p = self.memory["IA", step.link], self.memory["pA", step.link]
        match step:
            case InvertRoot():
                phi = np.linalg.inv(inertia)
                self.memory[step.block], self.memory[step.bias] = phi, -phi @ p
            case SolveRoot():
                self.memory["a", step.link] = np.linalg.solve(inertia, -p)
            case SolveMobility():
                phi, b = self.memory[step.block], self.memory[step.bias]
                held = np.eye(6) + phi @ inertia
                self.memory["a", step.link] = np.linalg.solve(held, b - phi @ p)
            case LoadRoot():
                load = inertia @ self.memory["a", step.link] + p
                self.memory["load", step.link] = load if step.held else -load

    def _kind(self, j: int) -> JointKind:
        return self.machine.kind(j)

    def _rotor(self, j: int) -> Array:
        """Rotor inertia of a joint, shape (n, n)."""
        return np.eye(self._kind(j).nv) * self.machine.plan.joints[j].rotor_inertia

    def _ends(self, step: Articulate | Propagate | Deliver | Accelerate) -> tuple[int, int, float]:
        """Near link, far link and sigma of a joint."""
        parent, child = self.machine.plan.joints[step.joint].parent, step.joint + 1
        return (child, parent, -1.0) if step.reversed else (parent, child, 1.0)

    def _start(self, number: int) -> None:
        link = self.machine.plan.links[number]
        c = np.array(link.com)
        cx = np.array([[0.0, -c[2], c[1]], [c[2], 0.0, -c[0]], [-c[1], c[0], 0.0]])
        inertia = np.zeros((6, 6))
        inertia[:3, :3] = np.array(link.tensor) - link.mass * cx @ cx
        inertia[:3, 3:] = link.mass * cx
        inertia[3:, :3] = -link.mass * cx
        inertia[3:, 3:] = link.mass * np.eye(3)
        velocity = self.memory["velocity", number]
        momentum = inertia @ velocity
        w, v = velocity[:3], velocity[3:]
        force = np.concatenate(
            [np.cross(w, momentum[:3]) + np.cross(v, momentum[3:]), np.cross(w, momentum[3:])]
        )
        self.memory["IA", number] = inertia
        self.memory["pA", number] = self.machine.column(force - self.machine.push(number))

    def _articulate(self, step: Articulate) -> None:
        near, far, sigma = self._ends(step)
        kind = self._kind(step.joint)
        free, constrained = list(kind.free), list(kind.constrained)
        x = self.memory["X", step.joint]
        inertia, p = self.memory["IA", far], self.memory["pA", far]
        if step.reversed:
            back = np.linalg.inv(x)
            inertia, p = back.T @ inertia @ back, back.T @ p
        c = self.machine.velocity_product(step.joint)
        tau = self.machine.torques(step.joint)
        rotor = self._rotor(step.joint)
        d = inertia[np.ix_(free, free)] + rotor
        u = sigma * tau - p[free]
        scaled = np.linalg.solve(d, inertia[free])  # D^-1 U^T
        self.memory["articulated", step.joint] = (d, u, scaled)
        if near == 0:
            return  # the ground does not feel it
        handed = np.zeros((6, 6))  # exact projection: rows and columns of S hold the rotor alone
        rows = np.ix_(constrained, constrained)
        handed[rows] = inertia[rows] - inertia[np.ix_(constrained, free)] @ scaled[:, constrained]
        handed[free] = rotor @ scaled
        handed[:, free] = handed[free].T
        force = np.zeros_like(p)
        force[free] = sigma * tau - rotor @ np.linalg.solve(d, u) + sigma * handed[free] @ c
        force[constrained] = (
            p[constrained]
            + inertia[np.ix_(constrained, free)] @ np.linalg.solve(d, u)
            + sigma * handed[constrained] @ c
        )
        if not step.reversed:
            handed, force = x.T @ handed @ x, x.T @ force
        self.memory["IA", near] = self.memory["IA", near] + handed
        self.memory["pA", near] = self.memory["pA", near] + force

    def _across(self, step: Propagate | Deliver) -> Array:
        """L, the far link's acceleration for a unit acceleration of the near link."""
        x = self.memory["X", step.joint]
        free = list(self._kind(step.joint).free)
        d, _, scaled = self.memory["articulated", step.joint]
        held = np.eye(6)
        held[free] -= scaled
        held[np.ix_(free, free)] = np.linalg.solve(d, self._rotor(step.joint))
        return np.linalg.inv(x) @ held if step.reversed else held @ x

    def _far_acceleration(
        self, j: int, reverse: bool, near: Array, u: Array
    ) -> tuple[Array, Array]:
        """The product sigma qdd, and the acceleration of the far link, from the near link's."""
        sigma = -1.0 if reverse else 1.0
        x = self.memory["X", j]
        free = list(self._kind(j).free)
        d, _, scaled = self.memory["articulated", j]
        a = (near if reverse else x @ near) + sigma * self.machine.velocity_product(j)
        moved = np.linalg.solve(d, u) - scaled @ a
        a[free] += moved
        return moved, np.linalg.inv(x) @ a if reverse else a

    def _propagate(self, step: Propagate) -> None:
        d, u, _ = self.memory["articulated", step.joint]
        free = list(self._kind(step.joint).free)
        across = self._across(step)
        own = np.zeros((6, 6))
        own[np.ix_(free, free)] = np.linalg.inv(d)
        if step.reversed:
            back = np.linalg.inv(self.memory["X", step.joint])
            own = back @ own @ back.T
        if step.near is not None:
            own = own + across @ self.memory[step.near] @ across.T
        self.memory[step.block] = own
        ground = self.machine.ground()
        near = ground if step.near_bias is None else self.memory[step.near_bias]
        _, bias = self._far_acceleration(step.joint, step.reversed, near, u)
        self.memory[step.bias] = bias
        for spread in step.spreads:
            source = self.memory[spread.source]
            value = across @ (source.T if spread.source_transposed else source)
            self.memory[spread.target] = value.T if spread.target_transposed else value

    def _deliver(self, step: Deliver) -> None:
        near, far, _ = self._ends(step)
        load = self.memory["load", far]
        if near > 0:
            self.memory["load", near] = self.memory["load", near] + self._across(step).T @ load
        if step.reversed:
            load = np.linalg.inv(self.memory["X", step.joint]).T @ load
        d, u, scaled = self.memory["articulated", step.joint]
        u = u + load[list(self._kind(step.joint).free)]
        self.memory["articulated", step.joint] = (d, u, scaled)

    def _accelerate(self, step: Accelerate) -> None:
        near, far, sigma = self._ends(step)
        a = self.machine.ground() if near == 0 else self.memory["a", near]
        _, u, _ = self.memory["articulated", step.joint]
        moved, self.memory["a", far] = self._far_acceleration(step.joint, step.reversed, a, u)
        self.machine.accelerate(step.joint, sigma * moved)
