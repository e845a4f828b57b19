"""Runs a process's steps over expressions: what each means is told in adagen/plan/interpret/.

Frames are the links' own, with every joint axis z: a joint's inertia D is an entry of a matrix,
what a joint hands on has structural zeros, and link inertias are constants. Accelerations are
deviations from a reference field, the accelerations that the links would have with q-double-dot
zero: no velocity product and no gravity enters the sweeps. The reference is classical (that of a
point, not the spatial one), so that no linear velocity is needed but that of a floating base.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.emit.unrolled.checks import Check
from adagen.emit.unrolled.joins import JoinMachine
from adagen.emit.unrolled.kinematics import KinematicMachine
from adagen.emit.unrolled.lanes import rows_of
from adagen.emit.unrolled.rows import RowMachine
from adagen.emit.unrolled.segments import SegmentMachine
from adagen.graph import Expression, Factors, Graph, factorize, total
from adagen.model.kinds import HELD, KINDS, JointKind
from adagen.plan import Plan
from adagen.plan.abreast import Limbs
from adagen.plan.growth import EPSILON
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


class Machine:
    """One process: a graph, a memory and the meaning of each step.

    Joints in one row (rows.py) are treated as one, whose values are wide.

    Attributes:
        graph: all that the process computes; inputs are named as the emitted code names them.
        angles: joint angles whose sine and cosine are taken, in order.
        checks: pivots to be looked at.
        lengths: squared lengths of quaternions and their joints.
        results: accelerations by joints, of a row wide; known after the last step.
        sent: contents of the messages sent so far, without what is known beforehand.
    """

    def __init__(
        self, plan: Plan, mail: dict[int, list[Any]], all_limbs: Sequence[Limbs] = ()
    ) -> None:
        self.plan, self.mail = plan, mail
        self.graph = Graph()
        self.columns = plan.right_hand_sides
        self.memory: dict[Any, Any] = {}
        self.angles: list[Expression] = []
        self.checks: list[Check] = []
        self.lengths: list[tuple[Expression, int]] = []
        self.results: dict[int, Array] = {}
        self.sent: dict[int, list[Expression]] = {}
        self.rows = RowMachine(self, rows_of(all_limbs))
        self.motion = KinematicMachine(self)
        self.segments = SegmentMachine(self)
        self.joins = JoinMachine(self)
        self.motion.take_angles_of_rows()

    def step(self, step: Step) -> bool:
        """Do one step; return False if it has to wait for a message."""
        match step:
            case Receive():
                return self._receive(step.message)
            case Send():
                self._send(step.message)
            case Kinematics():
                self.motion.kinematics(step.joint)
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
        pivots = [x for check in self.checks for x in (check.pivot, check.least)]
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

    def kind(self, j: int) -> JointKind:
        """What a joint leaves free: nothing where its acceleration is prescribed."""
        joint = self.plan.joints[j]
        return HELD if joint.prescribed else KINDS[joint.kind]

    def given(self, j: int) -> Array:
        """What tau holds for joint j: its torques, or its accelerations; shape (n,)."""
        return self.rows.entries("tau", j, KINDS[self.plan.joints[j].kind].nv)

    def factorize(self, matrix: Array, joint: int) -> Factors:
        """Return the factors of a matrix, its pivots being checked in the name of a joint.

        A pivot has to be positive, and not lost against the entry that it was subtracted from.
        """
        factors, lost = factorize(matrix), 16 * EPSILON[self.plan.scalar]
        for pivot, entry in zip(factors.pivots, factors.diagonal, strict=True):
            least = self.graph.constant(0) if pivot == entry else entry * lost
            self.checks.append(Check(pivot, least, joint))
        return factors

    def torques(self, j: int) -> Array:
        """Torques of joint j, shape (n, columns): its own, then those of the coupling rows."""
        result = self.column(self.given(j)[: self.kind(j).nv])
        for column, slaved in enumerate(self.plan.slaved, start=1):
            mimic = self.plan.joints[slaved].mimic
            assert mimic is not None
            if j == slaved:
                result[0, column] = self.graph.constant(1)
            if j == mimic[0]:
                result[0, column] = self.graph.constant(-mimic[1])
        return result

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
        if self.plan.joints[j].prescribed:
            qdd = self.column(self.given(j))
        self.memory.update((("qdd", each), own) for each, own in self.rows.apart(j, qdd))
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
