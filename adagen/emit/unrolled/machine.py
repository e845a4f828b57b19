"""Runs a process's steps over expressions: what each means is told in adagen/plan/interpret.py.

Frames are the links' own, with every joint axis z: a joint's inertia D is an entry of a matrix,
what a joint hands on has structural zeros, and link inertias are constants. Accelerations are
deviations from a reference field, the accelerations that the links would have with q-double-dot
zero: no velocity product and no gravity enters the sweeps. The reference is classical (that of a
point, not the spatial one), so that no linear velocity is needed but that of a floating base.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.emit.unrolled.frames import Dense, Transform, about_z, placed, plus_cross
from adagen.emit.unrolled.joins import JoinMachine
from adagen.emit.unrolled.segments import SegmentMachine
from adagen.graph import Expression, Factors, Graph, dot, factorize, total
from adagen.model.kinds import KINDS, JointKind
from adagen.plan import Plan
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
from adagen.plan.types import Message

Array = NDArray[Any]
RECEIVED = "w.from"
"""What names of inputs that messages bring begin with."""


@dataclass(frozen=True)
class Check:
    """A pivot that has to be positive, and not lost against what it was subtracted from.

    Attributes:
        pivot: the pivot.
        diagonal: the entry that it began as.
        joint: whose factorization failed otherwise.
    """

    pivot: Expression
    diagonal: Expression
    joint: int


@dataclass(frozen=True)
class Field:
    """A link's velocity and reference acceleration, in its own frame.

    Attributes:
        omega: angular velocity, shape (3,).
        alpha: angular acceleration, shape (3,).
        a: acceleration of the origin relative to free fall, shape (3,).
        gradient: H = alpha x + omega x omega x, shape (3, 3): a point at r accelerates by a + H r.
    """

    omega: Array
    alpha: Array
    a: Array
    gradient: Array


class Machine:
    """One process: a graph, a memory and the meaning of each step.

    Attributes:
        graph: all that the process computes; inputs are named as the emitted code names them.
        angles: joint angles whose sine and cosine are taken, in order.
        checks: pivots to be looked at.
        lengths: squared lengths of quaternions and their joints.
        results: accelerations in the order of ``owns``, known after the last step.
        sent: contents of the messages sent so far, without what is known beforehand.
    """

    def __init__(self, plan: Plan, mail: dict[int, list[Any]]) -> None:
        self.plan, self.mail = plan, mail
        self.graph = Graph()
        self.columns = plan.right_hand_sides
        self.memory: dict[Any, Any] = {}
        self.angles: list[Expression] = []
        self.checks: list[Check] = []
        self.lengths: list[tuple[Expression, int]] = []
        self.results: dict[int, Array] = {}
        self.sent: dict[int, list[Expression]] = {}
        self.segments = SegmentMachine(self)
        self.joins = JoinMachine(self)

    def step(self, step: Step) -> bool:
        """Do one step; return False if it has to wait for a message."""
        match step:
            case Receive():
                return self._receive(step.message)
            case Send():
                self._send(step.message)
            case Kinematics():
                self._kinematics(step.joint)
            case LinkBias():
                self.joins.link_bias(step.link)
            case Join():
                self.joins.join(step)
            case Disassemble():
                self.joins.disassemble(step)
            case SolveCoupling():
                self._solve_coupling()
            case ApplyCoupling():
                self._apply_coupling()
            case _:
                self.segments.step(step)
        return True

    def roots(self) -> list[Expression]:
        """Everything that is wanted: results, contents of messages, what is checked."""
        results = [x for values in self.results.values() for x in values]
        contents = [x for content in self.sent.values() for x in content]
        pivots = [x for check in self.checks for x in (check.pivot, check.diagonal)]
        return [*results, *contents, *pivots, *(length for length, _ in self.lengths)]

    # -- numbers ----------------------------------------------------------------------------------

    def constants(self, values: Any) -> Array:
        """Return numbers as constants, in the shape they have."""
        array = np.asarray(values, dtype=float)
        result = np.empty(array.shape, dtype=object)
        for index, value in np.ndenumerate(array):
            result[index] = self.graph.constant(float(value))
        return result

    def zeros(self, *shape: int) -> Array:
        """Return zeros."""
        return self.constants(np.zeros(shape))

    def column(self, first: Array) -> Array:
        """First column of a right-hand side; the others answer to unit torques of slaved joints."""
        result = self.zeros(len(first), self.columns)
        result[:, 0] = first
        return result

    def kind(self, joint: int) -> JointKind:
        """A joint's kind."""
        return KINDS[self.plan.joints[joint].kind]

    def factorize(self, matrix: Array, joint: int) -> Factors:
        """Return the factors of a matrix, its pivots being checked in the name of a joint."""
        factors = factorize(matrix)
        pairs = zip(factors.pivots, factors.diagonal, strict=True)
        self.checks.extend(Check(pivot, diagonal, joint) for pivot, diagonal in pairs)
        return factors

    def torques(self, j: int) -> Array:
        """Torques of joint j, shape (n, columns): its own, then those of the coupling rows."""
        joint = self.plan.joints[j]
        own = [self.graph.input(f"tau[{joint.v + k}]") for k in range(self.kind(j).nv)]
        result = self.column(np.array(own, dtype=object))
        for column, slaved in enumerate(self.plan.slaved, start=1):
            mimic = self.plan.joints[slaved].mimic
            assert mimic is not None
            if j == slaved:
                result[0, column] = self.graph.constant(1)
            if j == mimic[0]:
                result[0, column] = self.graph.constant(-mimic[1])
        return result

    # -- kinematics -------------------------------------------------------------------------------

    def state(self, j: int) -> tuple[list[Expression], list[Expression]]:
        """Configuration and velocity of a joint, a slaved one's from its source."""
        joint, kind = self.plan.joints[j], self.kind(j)
        if joint.mimic is None:
            q = [self.graph.input(f"q[{joint.q + k}]") for k in range(kind.nq)]
            return q, [self.graph.input(f"v[{joint.v + k}]") for k in range(kind.nv)]
        source, multiplier, offset = joint.mimic
        (angle, *_), (rate, *_) = self.state(source)
        return [angle * multiplier + offset], [rate * multiplier]

    def _kinematics(self, j: int) -> None:
        joint, kind = self.plan.joints[j], self.kind(j)
        q, v = self.state(j)
        base = self.constants(joint.rotation)
        turn, shift = self._placement(j, q)
        origin = self.constants(joint.translation)
        if shift is not None:
            origin = np.array(
                [total([origin[k], *(base[k] * shift)]) for k in range(3)], dtype=object
            )
        x = Transform(placed(base, turn), origin)
        motion = self.zeros(6)
        motion[list(kind.free)] = v
        self.memory["X", j] = x
        self._advance(j, x, motion[:3], motion[3:])

    def _placement(self, j: int, q: list[Expression]) -> tuple[Any, Array | None]:
        """Turn and shift of the child frame in the canonical joint frame, None for neither."""
        kind, zero = self.kind(j), self.graph.constant(0)
        if kind.quaternion is not None:
            shift = np.array(q[:3], dtype=object) if kind.quaternion else None
            return Dense(self._orientation(j, q[kind.quaternion :])), shift
        if kind.name == "prismatic":
            return None, np.array([zero, zero, q[0]], dtype=object)
        shift = np.array([q[0], q[1], zero], dtype=object) if kind.name == "planar" else None
        return about_z(*self._circular(q[-1])), shift

    def _circular(self, angle: Expression) -> tuple[Expression, Expression]:
        """Cosine and sine; they are taken of all angles of the process at once."""
        if angle not in self.angles:
            self.angles.append(angle)
        k = self.angles.index(angle)
        ready = 40  # cycles of the polynomials
        cosine = self.graph.input(f"cosine[{k}]", ready)
        return cosine, self.graph.input(f"sine[{k}]", ready)

    def _orientation(self, j: int, quaternion: list[Expression]) -> Array:
        """Rotation matrix of a quaternion (x, y, z, w) of any length."""
        squared = total(part * part for part in quaternion)
        self.lengths.append((squared, j))
        scale = 2 * self.graph.reciprocal(squared)
        x, y, z, w = quaternion
        sx, sy, sz = scale * x, scale * y, scale * z
        return np.array(
            [
                [1 - (sy * y + sz * z), sx * y - sz * w, sx * z + sy * w],
                [sx * y + sz * w, 1 - (sx * x + sz * z), sy * z - sx * w],
                [sx * z - sy * w, sy * z + sx * w, 1 - (sx * x + sy * y)],
            ],
            dtype=object,
        )

    def _advance(self, j: int, x: Transform, turning: Array, sliding: Array) -> None:
        """Velocity and reference acceleration of a joint's child link."""
        parent = self.plan.joints[j].parent
        back = x.rotation.transposed()
        if parent == 0 and self.kind(j).name == "floating":
            # It falls freely: gravity then enters its own acceleration only, at the very end.
            omega, alpha, a = turning, self.zeros(3), self.zeros(3)
            ground = back.vector(self.constants([-g for g in self.plan.gravity]))
            self.memory["drift", j] = np.concatenate(
                [self.zeros(3), plus_cross(ground, omega, sliding)]
            )
        else:
            above: Field = self.memory["field", parent] if parent > 0 else self._ground()
            turned = back.vector(above.omega)
            omega = turned + turning
            alpha = plus_cross(back.vector(above.alpha), turned, turning)
            carried = [total([above.a[k], *(above.gradient[k] * x.origin)]) for k in range(3)]
            a = back.vector(np.array(carried, dtype=object))
            a = plus_cross(plus_cross(a, turned + turned, sliding), turning, sliding)
        self.memory["field", j + 1] = Field(omega, alpha, a, _gradient(omega, alpha))

    def _ground(self) -> Field:
        nothing = self.zeros(3)
        upwards = self.constants([-g for g in self.plan.gravity])
        return Field(nothing, nothing, upwards, self.zeros(3, 3))

    def drift(self, j: int) -> Array | None:
        """What a joint's sides differ by in the reference field beyond S qdd; None for nothing."""
        drift = self.memory.get(("drift", j))
        return None if drift is None else self.column(drift)

    # -- links ------------------------------------------------------------------------------------

    def link_inertia(self, number: int) -> Array:
        """Spatial inertia at the link's origin, constant, shape (6, 6)."""
        link = self.plan.links[number]
        c, mass = self.constants(link.com), self.graph.constant(link.mass)
        zero = self.graph.constant(0)
        m = c * mass
        mx = np.array([[zero, -m[2], m[1]], [m[2], zero, -m[0]], [-m[1], m[0], zero]])
        inertia = self.zeros(6, 6)
        inertia[:3, 3:], inertia[3:, :3] = mx, mx.T
        about_com = self.constants(link.tensor)
        for i in range(3):
            inertia[3 + i, 3 + i] = mass
            for k in range(3):
                outer = dot(m, c) - m[i] * c[i] if i == k else -(m[i] * c[k])
                inertia[i, k] = about_com[i, k] + outer
        return inertia

    def link_force(self, number: int) -> Array:
        """What the reference field takes to be had by the link alone: [moment; force], shape (6,).

        The moment I alpha + omega x I omega + m c x a, the products in H being used again.
        """
        field: Field = self.memory["field", number]
        inertia = self.link_inertia(number)
        mass = inertia[3, 3]
        moment_of_mass = np.array([inertia[2, 4], inertia[0, 5], inertia[1, 3]], dtype=object)
        h, moment = field.gradient, []
        for i in range(3):
            k, m = (i + 1) % 3, (i + 2) % 3
            terms = [
                field.alpha[i] * inertia[i, i],
                (field.omega[k] * field.omega[m]) * (inertia[m, m] - inertia[k, k]),
                -(h[m, i] * inertia[i, k]),
                h[k, i] * inertia[i, m],
                (h[k, k] - h[m, m]) * inertia[k, m],
            ]
            moment.append(total(terms))
        moment_of_force = plus_cross(np.array(moment, dtype=object), moment_of_mass, field.a)
        force = [total([field.a[k] * mass, *(h[k] * moment_of_mass)]) for k in range(3)]
        return np.concatenate([moment_of_force, np.array(force, dtype=object)])

    # -- messages ---------------------------------------------------------------------------------

    def _items(self, message: Message) -> list[Any]:
        if message.sweep == "torques":
            return ["torques"]
        accelerations = [("qdd", j) for j in message.joints]
        return [*message.blocks, *message.biases, *message.forces, *accelerations]

    def _send(self, number: int) -> None:
        items = [(item, self.memory[item]) for item in self._items(self.plan.messages[number])]
        content: dict[Expression, None] = {}
        for _, value in items:
            content.update(dict.fromkeys(x for x in value.flat if x.constant is None))
        places = {x: k for k, x in enumerate(content)}
        self.sent[number] = list(content)
        self.mail[number] = [
            (item, [[x.constant, places.get(x)] for x in value.flat], value.shape)
            for item, value in items
        ]

    def _receive(self, number: int) -> bool:
        if number not in self.mail:
            return False
        for item, entries, shape in self.mail.pop(number):
            values = [
                self.graph.constant(known)
                if place is None
                else self.graph.input(f"{RECEIVED}[{number}][{place}]")
                for known, place in entries
            ]
            flat = np.empty(len(values), dtype=object)
            flat[:] = values
            self.memory[item] = flat.reshape(shape)
        return True

    # -- results ----------------------------------------------------------------------------------

    def accelerate(self, j: int, qdd: Array) -> None:
        """Keep a joint's accelerations, shape (n, columns); with slaved joints they come later."""
        self.memory["qdd", j] = qdd
        if not self.plan.slaved:
            self.results[j] = qdd[:, 0]

    def _solve_coupling(self) -> None:
        """Solve A qdd = 0 for the coupling torques; a row is qdd_slaved - multiplier qdd_source."""
        rows = []
        for slaved in self.plan.slaved:
            mimic = self.plan.joints[slaved].mimic
            assert mimic is not None
            source = self.memory["qdd", mimic[0]][0]
            rows.append(self.memory["qdd", slaved][0] - source * mimic[1])
        a = np.array(rows, dtype=object)
        factors = self.factorize(a[:, 1:], self.plan.slaved[0])
        self.memory["torques"] = factors.solve(-a[:, :1])[:, 0]

    def _apply_coupling(self) -> None:
        torques = self.memory["torques"]
        for name, qdd in list(self.memory.items()):
            if isinstance(name, tuple) and name[0] == "qdd":
                self.results[name[1]] = np.array(
                    [total([row[0], *(row[1:] * torques)]) for row in qdd], dtype=object
                )


def _gradient(omega: Array, alpha: Array) -> Array:
    """H = alpha x + omega x omega x, shape (3, 3)."""
    h = np.empty((3, 3), dtype=object)
    squares = omega * omega
    for i in range(3):
        k, m = (i + 1) % 3, (i + 2) % 3
        h[i, i] = -(squares[k] + squares[m])
        product = omega[i] * omega[k]
        h[i, k], h[k, i] = product - alpha[m], product + alpha[m]
    return h
