"""One process in numpy: what its steps do to its memory."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model.kinds import HELD, KINDS, JointKind
from adagen.plan.interpret.articulated import SegmentMachine
from adagen.plan.interpret.joins import JoinMachine
from adagen.plan.placement import cross_motion, motion_transform, placement
from adagen.plan.steps import (
    ApplyCoupling,
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
        self.joins = JoinMachine(self)
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
            case LinkBias() | Join() | Disassemble():
                self.joins.step(step)
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
        """Return right-hand sides, shape (n, columns), from the first one, shape (n,).

        The others answer to unit torques of slaved joints.
        """
        result = np.zeros((len(first), self.columns))
        result[:, 0] = first
        return result

    def ground(self) -> Array:
        """Return the acceleration of the ground relative to free fall, shape (6, columns)."""
        return self.column(np.concatenate([np.zeros(3), -np.array(self.plan.gravity)]))

    def push(self, link: int) -> Array:
        """Return the outer wrench [moment; force] on a link at its origin, shape (6,)."""
        result = np.zeros(6)
        for k, wrench in enumerate(self.plan.wrenches):
            if wrench.link == link:
                start = self.plan.entry_of_wrench(k)
                given = self.tau[start : start + 6]
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
        """Return c = v x S qd, and S qdd where that is prescribed, shape (6, columns)."""
        velocity = self.memory["velocity", j + 1]
        c = self.column(cross_motion(velocity, self.memory["motion", j]))
        joint = self.plan.joints[j]
        if joint.prescribed:
            kind = KINDS[joint.kind]
            c[list(kind.free), 0] += self.tau[joint.v : joint.v + kind.nv]
        return c

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
