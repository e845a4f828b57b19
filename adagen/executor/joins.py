"""Joins and releases of joints: Eq. (3)-(10)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.executor.frames import columnwise
from adagen.executor.join_frames import JointFrame, joint_frame
from adagen.executor.kinematics import Motion
from adagen.executor.state import State
from adagen.graph import Factors, matrix_times, total
from adagen.plan.digits import least_mobility
from adagen.plan.steps import Bias, Block, Disassemble, Join

Array = NDArray[Any]


@dataclass(frozen=True)
class Joined:
    """Data of an assembled joint that its disassembly needs.

    Attributes:
        step: the join.
        frame: what it is done in.
        factors: L D L^T = N (Phi_A + Phi_B) N^T.
        z0: L^-1 N beta.
        z: by handle, L^-1 N Phi_ij.
        y: by handle, R Phi_ij.
        phi: Phi_A + Phi_B in the joint's frame.
        beta: the right-hand side.
    """

    step: Join
    frame: JointFrame
    factors: Factors | None
    z0: Array
    z: dict[int, Array]
    y: dict[int, Array]
    phi: Array
    beta: Array


class Joins:
    """Executes joins and disassemblies on a process's memory."""

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion
        self.memory: dict[Any, Any] = state.memory

    def link_bias(self, number: int) -> None:
        """Deviation of a bare link from the reference field when nothing acts on it: -Phi p."""
        p = self.state.on_link(number, self.motion.link_force(number))
        self.memory[Bias(None, number)] = -matrix_times(self._block(Block(None, number, number)), p)

    def join(self, step: Join) -> None:
        """Assembly of a joint, or of a run of joints as one: Eq. (3)-(7)."""
        frame = joint_frame(self.state, self.motion, step)
        free, constrained, tau = frame.free, frame.constrained, frame.tau
        b_b, phi_b = self.memory[step.b_bias], frame.mobility_of_child(self._block(step.b))
        b_b = frame.from_child(b_b)
        phi = phi_b if step.a is None else frame.mobility_of_parent(self._block(step.a)) + phi_b
        phi = phi.copy() if frame.give else phi
        for row, more in frame.give.items():
            phi[row, row] = phi[row, row] + more
        beta = -b_b if step.a_bias is None else frame.from_parent(self.memory[step.a_bias]) - b_b
        if frame.drift is not None:
            beta = beta + frame.drift
        if free:
            beta = beta - matrix_times(phi[:, free], tau)
        least = [] if frame.turn is not None else least_mobility(self.state.plan, step)
        self.state.checks.extend(
            Check(phi[row, row], self.state.graph.constant(least[row]), step.joint, "kGrowth")
            for row in (constrained if least else [])
        )
        factors = None
        if constrained:
            factors = self.state.factorize(phi[np.ix_(constrained, constrained)], step.joint)
        z0 = self._forward(factors, beta[constrained])
        z: dict[int, Array] = {}
        y: dict[int, Array] = {}
        for coupling in step.couplings:
            phi_ij = self._block(coupling.source, coupling.transposed)
            parent = coupling.side == "A"
            phi_ij = frame.from_parent(phi_ij) if parent else frame.from_child(phi_ij)
            z[coupling.handle] = self._forward(factors, phi_ij[constrained])
            y[coupling.handle] = phi_ij[free]
        joined = Joined(step, frame, factors, z0, z, y, phi, beta)
        self.memory["join", step.joint] = joined
        self._update(joined)

    @staticmethod
    def _forward(factors: Factors | None, x: Array) -> Array:
        return x if factors is None else factors.forward(x)

    def _block(self, block: Block, transposed: bool = False) -> Array:
        if block.joint is None:
            matrix = self.state.constants(self.state.plan.links[block.row].phi)
        else:
            matrix = self.memory[block]
        return matrix.T if transposed else matrix

    def _update(self, joined: Joined) -> None:
        """Blocks and biases of the chain that a join completes."""
        zero, factors = self.state.graph.constant(0), joined.factors
        over = {h: z if factors is None else factors.scaled(z) for h, z in joined.z.items()}
        for block in joined.step.blocks:
            row, column = block.target.row, block.target.column
            result = self.state.zeros(6, 6)
            source = None if block.across or block.source is None else self._block(block.source)
            for i in range(6):
                for k in range(6):
                    if row == column and k < i:
                        result[i, k] = result[k, i]
                        continue
                    terms = joined.z[row][:, i] * over[column][:, k]
                    result[i, k] = (
                        total([zero, *terms])
                        if source is None
                        else total([source[i, k], *(-terms)])
                    )
            self.memory[block.target] = result
        for bias in joined.step.biases:
            h = bias.target.handle
            change = self.state.zeros(6, self.state.columns)
            if len(joined.frame.tau):
                change = matrix_times(joined.y[h].T, joined.frame.tau)
            if factors is not None:
                change = change + matrix_times(over[h].T, joined.z0)
            before = self.memory[bias.source]
            self.memory[bias.target] = before - change if bias.side == "A" else before + change

    def disassemble(self, step: Disassemble) -> None:
        """Acceleration and force of a joint: Eq. (8)-(10)."""
        joined: Joined = self.memory["join", step.joint]
        frame = joined.frame
        free, constrained = frame.free, frame.constrained
        right, qdd = joined.z0, -joined.beta[free]
        for coupling, name in zip(joined.step.couplings, step.forces, strict=True):
            force = self.memory[name]
            if constrained:
                felt = matrix_times(joined.z[coupling.handle], force)
                right = right + felt if coupling.side == "A" else right - felt
            moved = matrix_times(joined.y[coupling.handle], force)
            qdd = qdd - moved if coupling.side == "A" else qdd + moved
        f = self.state.zeros(6, self.state.columns)
        f[free] = joined.frame.tau
        if joined.factors is not None:
            n = joined.factors.backward(joined.factors.scaled(right))
            qdd = qdd + matrix_times(joined.phi[np.ix_(free, constrained)], n)
            f[constrained] = n
        for update in step.updates:
            value = -frame.on_parent(f) if update.side == "A" else frame.on_child(f)
            if update.source is not None:
                value = self.memory[update.source] + value
            self.memory[update.target] = value
        rotor = self.state.rotor(step.joint)
        if rotor is not None:
            over, own = self.state.graph.reciprocal(rotor), list(self.state.kind(step.joint).free)
            qdd = (self.state.torques(step.joint) - f[own]) * over
        for j, rows in zip(frame.run, frame.parts, strict=True):
            self.state.accelerate(j, qdd[rows])
        if self.state.refining:
            f = frame.on_child(f)
            for j, x in zip(reversed(frame.run), reversed(frame.transforms), strict=True):
                # A link without mass hands on what it gets.
                self.state.keep_force(j, f, driven=len(frame.run) == 1 and self.state.plan.closed)
                f = columnwise(x.force, f)
