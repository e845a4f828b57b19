"""What joining and releasing joints means, in numpy: Eq. (3)-(10)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from adagen.plan.interpret.joint_frames import JointFrame, joint_frame
from adagen.plan.steps import Bias, Block, Disassemble, Join, LinkBias

if TYPE_CHECKING:
    from adagen.plan.interpret.machine import Machine

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Joined:
    """What disassembly needs of a join; names as in the paper (templates/runtime/joins.hpp)."""

    step: Join
    frame: JointFrame
    lower: NDArray[Any]
    z0: NDArray[Any]
    z: dict[int, Array]
    y: dict[int, Array]
    phi: Array
    beta: Array


class JoinMachine:
    """Executes joins and disassemblies on a process's memory."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.memory: dict[Any, Any] = machine.memory

    def step(self, step: LinkBias | Join | Disassemble) -> None:
        """Do one step."""
        match step:
            case LinkBias():
                self._link_bias(step.link)
            case Join():
                self._join(step)
            case Disassemble():
                self._disassemble(step)

    def _link_bias(self, number: int) -> None:
        link = self.machine.plan.links[number]
        velocity = self.memory["velocity", number]
        w, v, c = velocity[:3], velocity[3:], np.array(link.com)
        tensor, inverse = np.array(link.tensor), np.array(link.tensor_inverse)
        al = -inverse @ np.cross(w, tensor @ w)
        linear = -np.cross(al, c) - np.cross(w, np.cross(w, c)) - np.cross(w, v)
        pushed = np.array(link.phi) @ self.machine.push(number)
        self.memory[Bias(None, number)] = self.machine.column(np.concatenate([al, linear]) + pushed)

    def _block(self, block: Block, transposed: bool = False) -> Array:
        if block.joint is None:
            matrix = np.array(self.machine.plan.links[block.row].phi)
        else:
            matrix = self.memory[block]
        return matrix.T if transposed else matrix

    def _join(self, step: Join) -> None:
        frame = joint_frame(self.machine, step)
        x, y, free, constrained = frame.x, frame.y, frame.free, frame.constrained
        tau = frame.tau
        phi_a = np.zeros((6, 6)) if step.a is None else x @ self._block(step.a) @ x.T
        b_a = x @ (self.machine.ground() if step.a_bias is None else self.memory[step.a_bias])
        phi = phi_a + y @ self._block(step.b) @ y.T + frame.give
        beta = b_a - y @ self.memory[step.b_bias] + frame.c - phi[:, free] @ tau
        m = phi[np.ix_(constrained, constrained)]
        lower = np.linalg.cholesky(m) if constrained else m
        z0 = np.linalg.solve(lower, beta[constrained]) if constrained else beta[constrained]
        z: dict[int, Array] = {}
        free_rows: dict[int, Array] = {}
        for coupling in step.couplings:
            phi_ij = self._block(coupling.source, coupling.transposed)
            phi_ij = (x if coupling.side == "A" else y) @ phi_ij
            rows = phi_ij[constrained]
            z[coupling.handle] = np.linalg.solve(lower, rows) if constrained else rows
            free_rows[coupling.handle] = phi_ij[free]
        for block in step.blocks:
            product = z[block.target.row].T @ z[block.target.column]
            if block.across:
                self.memory[block.target] = product
            else:
                assert block.source is not None  # handles of one side that feel one joint
                self.memory[block.target] = self._block(block.source) - product
        for bias in step.biases:
            h = bias.target.handle
            sign = -1.0 if bias.side == "A" else 1.0
            change = z[h].T @ z0 + free_rows[h].T @ tau
            self.memory[bias.target] = self.memory[bias.source] + sign * change
        self.memory["join", step.joint] = Joined(step, frame, lower, z0, z, free_rows, phi, beta)

    def _disassemble(self, step: Disassemble) -> None:
        i: Joined = self.memory["join", step.joint]
        frame, free, constrained = i.frame, i.frame.free, i.frame.constrained
        right, qdd = i.z0.copy(), -i.beta[free]
        for coupling, name in zip(i.step.couplings, step.forces, strict=True):
            force = self.memory[name]
            sign = 1.0 if coupling.side == "A" else -1.0
            right += sign * i.z[coupling.handle] @ force
            qdd -= sign * i.y[coupling.handle] @ force
        n = np.linalg.solve(i.lower.T, right) if constrained else right
        qdd += i.phi[np.ix_(free, constrained)] @ n
        f = np.zeros((6, self.machine.columns))
        f[constrained] = n
        f[free] = frame.tau
        for update in step.updates:
            acting = 0.0 if update.source is None else self.memory[update.source]
            felt = -frame.x.T @ f if update.side == "A" else frame.y.T @ f
            self.memory[update.target] = acting + felt
        f = frame.y.T @ f
        for j in reversed(frame.run):  # a link without mass hands on what it gets
            self.memory["force", j] = f
            f = self.memory["X", j].T @ f
        rotor = self.machine.plan.joints[step.joint].rotor_inertia
        if rotor:
            f_own = self.memory["force", step.joint][list(self.machine.kind(step.joint).free)]
            qdd = (self.machine.torques(step.joint) - f_own) / rotor
        for j, rows in zip(frame.run, frame.parts(self.machine.plan.joints), strict=True):
            self.machine.accelerate(j, qdd[rows])
