"""What the steps of form `segment` mean, over expressions (see adagen/plan/interpret/)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from adagen.emit.unrolled.frames import Transform, columnwise
from adagen.graph import Factors, matrix_times, total
from adagen.plan.steps import (
    Accelerate,
    AccelerateRoot,
    Articulate,
    Deliver,
    FreeAcceleration,
    FreeBase,
    InvertRoot,
    Load,
    Propagate,
    SolveRoot,
    StartLink,
    Step,
)

if TYPE_CHECKING:
    from adagen.emit.unrolled.machine import Machine

Array = NDArray[Any]


@dataclass(frozen=True)
class Articulated:
    """A joint's share of the articulated body on its far side.

    Attributes:
        factors: of D.
        u: sigma tau - S^T p, shape (n, columns).
        moved: D^-1 u, likewise.
        scaled: D^-1 U^T, shape (n, 6), without meaning in the joint's own columns.
    """

    factors: Factors
    u: Array
    moved: Array
    scaled: Array


class SegmentMachine:
    """Executes the steps inside a segment on a process's memory; see the namesake in the plan."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.memory: dict[Any, Any] = machine.memory

    def step(self, step: Step) -> None:
        """Do one step."""
        match step:
            case StartLink():
                self.memory["IA", step.link] = self.machine.motion.link_inertia(step.link)
                force = self.machine.motion.link_force(step.link)
                self.memory["pA", step.link] = self.machine.column(force)
            case FreeBase():
                free = list(self.machine.kind(step.joint).free)
                p = self.memory["pA", step.joint + 1].copy()
                p[free] = p[free] - self.machine.torques(step.joint)
                self.memory["pA", step.joint + 1] = p
            case Articulate():
                self._articulate(step)
            case InvertRoot():
                self._invert_root(step)
            case SolveRoot():
                factors = self.machine.factorize(self.memory["IA", step.link], step.link - 1)
                self.memory["a", step.link] = factors.solve(-self.memory["pA", step.link])
            case Propagate():
                self._propagate(step)
            case Load():
                none = self.machine.zeros(6, self.machine.columns)
                force = none if step.force is None else self.memory[step.force]
                self.memory["load", step.link] = force
            case Deliver():
                self._deliver(step)
            case AccelerateRoot():
                phi, b = self.memory[step.block], self.memory[step.bias]
                load = self.memory["load", step.link]
                self.memory["a", step.link] = b + matrix_times(phi, load)
            case FreeAcceleration():
                a, drift = self.memory["a", step.joint + 1], self.machine.motion.drift(step.joint)
                free = list(self.machine.kind(step.joint).free)
                self.machine.accelerate(step.joint, (a if drift is None else a - drift)[free])
            case Accelerate():
                self._accelerate(step)
            case _:
                raise AssertionError(f"no meaning for {step}")

    def _ends(self, step: Articulate | Propagate | Deliver | Accelerate) -> tuple[int, int, int]:
        """Near link, far link and sigma of a joint."""
        parent, child = self.machine.plan.joints[step.joint].parent, step.joint + 1
        return (child, parent, -1) if step.reversed else (parent, child, 1)

    def _articulate(self, step: Articulate) -> None:
        near, far, sigma = self._ends(step)
        kind = self.machine.kind(step.joint)
        free, constrained = list(kind.free), list(kind.constrained)
        x: Transform = self.memory["X", step.joint]
        inertia, p = self.memory["IA", far], self.memory["pA", far]
        if step.reversed:
            inertia, p = x.inertia_back(inertia), columnwise(x.force_back, p)
        pull = self.machine.torques(step.joint) * sigma
        factors = self.machine.factorize(inertia[np.ix_(free, free)], step.joint)
        u = pull - p[free]
        moved = factors.solve(u)
        half = factors.forward(inertia[np.ix_(free, constrained)])  # L^-1 U^T
        over = factors.scaled(half)
        scaled = self.machine.zeros(len(free), 6)
        scaled[:, constrained] = factors.backward(over)
        self.memory["articulated", step.joint] = Articulated(factors, u, moved, scaled)
        if near == 0 and not any(self.machine.rows.near_links(step.joint)):
            return  # the ground does not feel it
        handed = self.machine.zeros(6, 6)  # exact projection: rows and columns of S stay zero
        for i, row in enumerate(constrained):
            for k, column in enumerate(constrained[i:], start=i):
                terms = [-(a * b) for a, b in zip(half[:, i], over[:, k], strict=True)]
                value = total([inertia[row, column], *terms])
                handed[row, column] = handed[column, row] = value
        force = p.copy()
        force[free] = pull
        for row in constrained:
            for c in range(p.shape[1]):
                force[row, c] = total([p[row, c], *(inertia[row, free] * moved[:, c])])
        drift = self.machine.motion.drift(step.joint)
        if drift is not None:
            force = force + matrix_times(handed, drift * sigma)
        if not step.reversed:
            handed, force = x.inertia(handed), columnwise(x.force, force)
        if step.reversed:
            self.memory["IA", near] = self.memory["IA", near] + handed
            self.memory["pA", near] = self.memory["pA", near] + force
        else:
            self.machine.rows.hand_on("IA", step.joint, handed)
            self.machine.rows.hand_on("pA", step.joint, force)

    def _invert_root(self, step: InvertRoot) -> None:
        """Phi = (I^A)^-1 by its factors, and b = -Phi p^A."""
        factors = self.machine.factorize(self.memory["IA", step.link], step.link - 1)
        unit = self.machine.constants(np.eye(6))
        half = factors.forward(unit)
        over = factors.scaled(half)
        phi = self.machine.zeros(6, 6)
        for i in range(6):
            for k in range(i, 6):
                phi[i, k] = phi[k, i] = total(half[:, i] * over[:, k])
        self.memory[step.block] = phi
        self.memory[step.bias] = -matrix_times(phi, self.memory["pA", step.link])

    def _held(self, step: Propagate | Deliver, m: Array) -> Array:
        """K m with K = 1 - S D^-1 S^T I^A: what of a motion of the near side the far one shares."""
        kind = self.machine.kind(step.joint)
        body: Articulated = self.memory["articulated", step.joint]
        free, constrained = list(kind.free), list(kind.constrained)
        result = m.copy()
        for k, row in enumerate(free):
            for c in range(m.shape[1]):
                terms = body.scaled[k, constrained] * m[constrained, c]
                result[row, c] = -total([self.machine.graph.constant(0), *terms])
        return result

    def _propagate(self, step: Propagate) -> None:
        x: Transform = self.memory["X", step.joint]
        free = list(self.machine.kind(step.joint).free)
        body: Articulated = self.memory["articulated", step.joint]
        own = self.machine.zeros(6, 6)
        if step.near is not None:
            near = self.memory[step.near]
            own = self._held(step, near if step.reversed else x.mobility(near))
            own = self._held(step, own.T)
        unit = self.machine.constants(np.eye(len(free)))
        own[np.ix_(free, free)] = own[np.ix_(free, free)] + body.factors.solve(unit)
        self.memory[step.block] = _mirrored(x.mobility_back(own) if step.reversed else own)
        start = None if step.near_bias is None else self.memory[step.near_bias]
        _, self.memory[step.bias] = self._far_acceleration(step, start)
        for spread in step.spreads:
            source = self.memory[spread.source]
            value = source.T if spread.source_transposed else source
            if step.reversed:
                value = columnwise(x.motion_back, self._held(step, value))
            else:
                value = self._held(step, columnwise(x.motion, value))
            self.memory[spread.target] = value.T if spread.target_transposed else value

    def _far_acceleration(
        self, step: Propagate | Accelerate, near: Array | None
    ) -> tuple[Array, Array]:
        """The product sigma qdd, and the far link's deviation from the near link's (None: none)."""
        _, _, sigma = self._ends(step)
        x: Transform = self.memory["X", step.joint]
        kind = self.machine.kind(step.joint)
        free, constrained = list(kind.free), list(kind.constrained)
        body: Articulated = self.memory["articulated", step.joint]
        if near is None:
            a = self.machine.zeros(6, self.machine.columns)
        else:
            a = near if step.reversed else columnwise(x.motion, near)
        drift = self.machine.motion.drift(step.joint)
        if drift is not None:
            a = a + drift * sigma
        far = a.copy()
        for k, row in enumerate(free):
            for c in range(a.shape[1]):
                terms = -(body.scaled[k, constrained] * a[constrained, c])
                far[row, c] = total([body.moved[k, c], *terms])
        moved = far[free] - a[free]
        return moved, columnwise(x.motion_back, far) if step.reversed else far

    def _deliver(self, step: Deliver) -> None:
        near, far, _ = self._ends(step)
        x: Transform = self.memory["X", step.joint]
        kind = self.machine.kind(step.joint)
        free, constrained = list(kind.free), list(kind.constrained)
        body: Articulated = self.memory["articulated", step.joint]
        load = self.memory["load", far]
        if step.reversed:
            load = columnwise(x.force_back, load)
        u = body.u + load[free]
        self.memory["articulated", step.joint] = Articulated(
            body.factors, u, body.factors.solve(u), body.scaled
        )
        if near == 0:
            return
        rest = load.copy()
        rest[free] = self.machine.zeros(len(free), load.shape[1])
        for row in constrained:
            for c in range(load.shape[1]):
                terms = -(body.scaled[:, row] * load[free, c])
                rest[row, c] = total([load[row, c], *terms])
        if not step.reversed:
            rest = columnwise(x.force, rest)
        self.memory["load", near] = self.memory["load", near] + rest

    def _accelerate(self, step: Accelerate) -> None:
        near, far, sigma = self._ends(step)
        start = (
            self.memory["a", near] if step.reversed else self.machine.rows.near_motion(step.joint)
        )
        moved, self.memory["a", far] = self._far_acceleration(step, start)
        self.machine.accelerate(step.joint, moved * sigma)


def _mirrored(matrix: Array) -> Array:
    """A matrix that is symmetric but for rounding, from its upper triangle."""
    result = matrix.copy()
    for i in range(6):
        for k in range(i):
            result[i, k] = result[k, i]
    return result
