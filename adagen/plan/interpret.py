"""Executes a plan in numpy, all processes in one: how plans are tested without a compiler."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import HELD, KINDS, JointKind
from adagen.plan.interpret_join import Joined, JointFrame, joint_frame
from adagen.plan.interpret_segment import SegmentMachine
from adagen.plan.placement import cross_motion, motion_transform, placement
from adagen.plan.steps import (
    ApplyCoupling,
    Bias,
    Block,
    Disassemble,
    Join,
    Kinematics,
    LinkBias,
    Receive,
    Send,
    SolveCoupling,
    Step,
)
from adagen.plan.types import Message, Plan

Array = NDArray[np.float64]


class PlanError(Exception):
    """A plan that cannot be executed: it deadlocks, or a step reads what nobody wrote."""


def interpret(plan: Plan, q: Array, v: Array, tau: Array) -> Array:
    """Return the joint accelerations that a plan computes.

    Args:
        plan: the plan.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        tau: joint torques and forces (prescribed joints: accelerations), then outer forces.

    Returns:
        Accelerations, shape (nv,).

    Raises:
        PlanError: a process waits for a message that never comes, or reads what it does not have.
        FloatingPointError: a factorization failed; the message names the joint.
    """
    qdd, _ = execute(plan, q, v, tau)
    return qdd


def execute(plan: Plan, q: Array, v: Array, tau: Array) -> tuple[Array, list[dict[Any, Any]]]:
    """Do what ``interpret`` does; return every process's memory as well."""
    q, v = with_slaved(plan, q, v)
    qdd = np.full(v.shape, np.nan)
    mail: dict[int, dict[Any, Array]] = {}
    machines = [Machine(plan, mail, q, v, tau, qdd) for _ in plan.processes]
    try:
        run_machines(plan, machines)
    except FloatingPointError:
        if not any(process.recovery for process in plan.processes):
            raise
        return execute(recovering(plan), q, v, tau)
    return qdd, [machine.memory for machine in machines]


def recovering(plan: Plan) -> Plan:
    """Return the plan of what is done where a mobility cannot be taken for an inertia."""
    processes = (replace(p, steps=p.recovery, recovery=()) for p in plan.processes)
    return replace(plan, processes=tuple(processes))


def run_machines(plan: Plan, machines: Sequence[Machine]) -> None:
    """Let each process do its steps, as far as messages have come, until all are done.

    Raises:
        PlanError: a process waits for a message that never comes.
    """
    positions = [0] * len(machines)
    moved = True
    while moved:
        moved = False
        for p, (machine, process) in enumerate(zip(machines, plan.processes, strict=True)):
            while positions[p] < len(process.steps) and machine.step(process.steps[positions[p]]):
                positions[p] += 1
                moved = True
    for p, process in enumerate(plan.processes):
        if positions[p] < len(process.steps):
            raise PlanError(f"process {p} waits for ever at {process.steps[positions[p]]}")


def with_slaved(plan: Plan, q: Array, v: Array) -> tuple[Array, Array]:
    """Return q and v with the entries of slaved joints taken from their sources."""
    q, v = np.array(q, dtype=float), np.array(v, dtype=float)
    for j in plan.slaved:
        joint = plan.joints[j]
        assert joint.mimic is not None
        source, multiplier, offset = joint.mimic
        q[joint.q] = multiplier * q[plan.joints[source].q] + offset
        v[joint.v] = multiplier * v[plan.joints[source].v]
    return q, v


class Machine:
    """One process: a memory and the meaning of each step."""

    def __init__(
        self,
        plan: Plan,
        mail: dict[int, dict[Any, Array]],
        q: Array,
        v: Array,
        tau: Array,
        qdd: Array,
    ) -> None:
        self.plan, self.mail, self.q, self.v, self.tau, self.qdd = plan, mail, q, v, tau, qdd
        self.memory: dict[Any, Any] = {}
        self.columns = plan.right_hand_sides
        self.segments = SegmentMachine(self)

    def step(self, step: Step) -> bool:
        """Do one step; return False if it has to wait for a message."""
        if isinstance(step, Receive) and step.message not in self.mail:
            return False
        try:
            self._do(step)
        except KeyError as missing:
            raise PlanError(f"{step} reads {missing}, which this process does not have") from None
        except np.linalg.LinAlgError:
            place = getattr(step, "joint", getattr(step, "link", 1) - 1)
            name = self.plan.joints[place].name
            raise FloatingPointError(f'joint "{name}": factorization failed') from None
        return True

    def _do(self, step: Step) -> None:
        match step:
            case Kinematics():
                self._kinematics(step)
            case LinkBias():
                self._link_bias(step.link)
            case Join():
                self._join(step)
            case Disassemble():
                self._disassemble(step)
            case Send():
                items = self._contents(self.plan.messages[step.message])
                self.mail[step.message] = {item: self.memory[item] for item in items}
            case Receive():
                for name, value in self.mail.pop(step.message).items():
                    found = name in self.gathered(step.message)
                    self.memory[name] = self.memory[name] + value if found else value
            case SolveCoupling():
                self._solve_coupling()
            case ApplyCoupling():
                self._apply_coupling()
            case _:
                self.segments.step(step)

    @staticmethod
    def _contents(message: Message) -> list[Any]:
        if message.sweep == "torques":
            return ["torques"]
        accelerations = [("qdd", j) for j in message.joints]
        inertias = [(what, link) for link in message.inertias for what in ("IA", "pA")]
        return [*message.blocks, *message.biases, *message.forces, *accelerations, *inertias]

    def gathered(self, message: int) -> set[Any]:
        """What of a message is added to what the process has, instead of taking its place."""
        links = self.plan.messages[message].inertias
        return {(what, link) for link in links for what in ("IA", "pA")}

    def _kinematics(self, step: Kinematics) -> None:
        joint = self.plan.joints[step.joint]
        kind = KINDS[joint.kind]
        q = self.q[joint.q : joint.q + kind.nq]
        turn, shift = placement(kind, q)
        base = np.array(joint.rotation)
        rotation, origin = base @ turn, np.array(joint.translation) + base @ shift
        x = motion_transform(rotation.T, origin)
        motion = np.zeros(6)
        motion[list(kind.free)] = self.v[joint.v : joint.v + kind.nv]
        parent = self.memory["velocity", joint.parent] if joint.parent > 0 else np.zeros(6)
        velocity = x @ parent + motion
        self.memory["X", step.joint] = x
        self.memory["velocity", step.joint + 1] = velocity
        self.memory["motion", step.joint] = motion

    def column(self, first: Array) -> Array:
        """First column of a right-hand side; the others answer to unit torques of slaved joints."""
        result = np.zeros((len(first), self.columns))
        result[:, 0] = first
        return result

    def ground(self) -> Array:
        """Acceleration of the ground relative to free fall."""
        return self.column(np.concatenate([np.zeros(3), -np.array(self.plan.gravity)]))

    def _link_bias(self, number: int) -> None:
        link = self.plan.links[number]
        velocity = self.memory["velocity", number]
        w, v, c = velocity[:3], velocity[3:], np.array(link.com)
        tensor, inverse = np.array(link.tensor), np.array(link.tensor_inverse)
        al = -inverse @ np.cross(w, tensor @ w)
        linear = -np.cross(al, c) - np.cross(w, np.cross(w, c)) - np.cross(w, v)
        pushed = np.array(link.phi) @ self.push(number)
        self.memory[Bias(None, number)] = self.column(np.concatenate([al, linear]) + pushed)

    def push(self, link: int) -> Array:
        """Outer wrench [moment; force] on a link at its origin."""
        result = np.zeros(6)
        start = sum(KINDS[joint.kind].nv for joint in self.plan.joints)
        for k, wrench in enumerate(self.plan.wrenches):
            if wrench.link == link:
                given = self.tau[start + 6 * k : start + 6 * k + 6]
                turn = np.array(wrench.rotation)
                force = turn @ given[:3]
                moment = turn @ given[3:] + np.cross(np.array(wrench.translation), force)
                result += np.concatenate([moment, force])
        return result

    def kind(self, j: int) -> JointKind:
        """What a joint leaves free: nothing where its acceleration is prescribed."""
        joint = self.plan.joints[j]
        return HELD if joint.prescribed else KINDS[joint.kind]

    def velocity_product(self, j: int) -> Array:
        """C = v x S qd of a joint, and S qdd where that is prescribed."""
        velocity = self.memory["velocity", j + 1]
        c = self.column(cross_motion(velocity, self.memory["motion", j]))
        joint = self.plan.joints[j]
        if joint.prescribed:
            kind = KINDS[joint.kind]
            c[list(kind.free), 0] += self.tau[joint.v : joint.v + kind.nv]
        return c

    def _block(self, block: Block, transposed: bool = False) -> Array:
        if block.joint is None:
            matrix = np.array(self.plan.links[block.row].phi)
        else:
            matrix = self.memory[block]
        return matrix.T if transposed else matrix

    def torques(self, j: int) -> Array:
        """Torques of joint j, shape (n, columns): its own, then those of the coupling rows."""
        joint = self.plan.joints[j]
        n = self.kind(j).nv
        result = self.column(self.tau[joint.v : joint.v + n])
        qd = self.v[joint.v : joint.v + n]
        result[:, 0] -= joint.damping * qd
        if joint.friction:
            result[:, 0] -= joint.friction * np.tanh(qd / joint.friction_speed)
        if joint.stiffness:
            result[0, 0] -= joint.stiffness * (self.q[joint.q] - joint.rest)
        for column, slaved in enumerate(self.plan.slaved, start=1):
            mimic = self.plan.joints[slaved].mimic
            assert mimic is not None
            if j == slaved:
                result[0, column] = 1.0
            if j == mimic[0]:
                result[0, column] = -mimic[1]
        return result

    def own_frame(self, j: int) -> JointFrame:
        """The frame that a joint by itself is joined in."""
        kind, rotor = self.kind(j), self.plan.joints[j].rotor_inertia
        c, tau = self.velocity_product(j), self.torques(j)
        give = np.zeros((6, 6))
        if rotor:  # the rotor gives way, S qdd = S J^-1 (tau - S^T f): nothing is free
            give[kind.free, kind.free] = 1.0 / rotor
            c[list(kind.free)] += tau / rotor
            kind, tau = HELD, tau[:0]
        free, constrained, x = list(kind.free), list(kind.constrained), self.memory["X", j]
        return JointFrame((j,), x, np.eye(6), free, constrained, c, tau, give)

    def _join(self, step: Join) -> None:
        frame = joint_frame(self, step)
        x, y, free, constrained = frame.x, frame.y, frame.free, frame.constrained
        tau = frame.tau
        phi_a = np.zeros((6, 6)) if step.a is None else x @ self._block(step.a) @ x.T
        b_a = x @ (self.ground() if step.a_bias is None else self.memory[step.a_bias])
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
        f = np.zeros((6, self.columns))
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
        rotor = self.plan.joints[step.joint].rotor_inertia
        if rotor:
            f_own = self.memory["force", step.joint][list(self.kind(step.joint).free)]
            qdd = (self.torques(step.joint) - f_own) / rotor
        for j, rows in zip(frame.run, frame.parts(self.plan.joints), strict=True):
            self.accelerate(j, qdd[rows])

    def accelerate(self, j: int, qdd: Array) -> None:
        """Keep a joint's accelerations, shape (n, columns); with slaved joints they come later."""
        joint = self.plan.joints[j]
        if joint.prescribed:
            qdd = self.column(self.tau[joint.v : joint.v + KINDS[joint.kind].nv])
        self.memory["qdd", j] = qdd
        if not self.plan.slaved:
            self.qdd[joint.v : joint.v + KINDS[joint.kind].nv] = qdd[:, 0]

    def _solve_coupling(self) -> None:
        """Solve A qdd = 0 for the coupling torques; a row is qdd_slaved - multiplier qdd_source."""
        rows = []
        for slaved in self.plan.slaved:
            mimic = self.plan.joints[slaved].mimic
            assert mimic is not None
            source = self.memory["qdd", mimic[0]][0]
            rows.append(self.memory["qdd", slaved][0] - mimic[1] * source)
        a = np.array(rows)
        self.memory["torques"] = np.linalg.solve(a[:, 1:], -a[:, 0])

    def _apply_coupling(self) -> None:
        torques = self.memory["torques"]
        for name, qdd in self.memory.items():
            if isinstance(name, tuple) and name[0] == "qdd":
                joint = self.plan.joints[name[1]]
                n = KINDS[joint.kind].nv
                self.qdd[joint.v : joint.v + n] = qdd[:, 0] + qdd[:, 1:] @ torques
