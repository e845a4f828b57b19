"""What a process has while its steps run: a graph, a memory, and what is wanted of both."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.graph import Expression, Factors, Graph, Numbers, factorize, total
from adagen.model.kinds import HELD, KINDS, JointKind
from adagen.plan.digits import EPSILON
from adagen.plan.types import FACTORS, Plan

Array = NDArray[Any]
Refining = Literal["answer", "correction"] | None
"""What of iterative refinement (adagen/executor/refine.py) is computed: the answer, joint forces
being kept, or a correction of it; None: it is no refinement."""

READY = 40
"""Cycles until the polynomials have given sines and cosines."""


class State:
    """The graph and the memory of one process; what the meaning of every step is told with.

    Attributes:
        plan: whose process it is.
        graph: all that the process computes, or what computes it at once; inputs are named as the
            emitted code names them.
        memory: values by the names that steps give them.
        columns: right-hand sides: the motion, and one for each slaved joint.
        angles: joint angles whose sine and cosine are taken, in order.
        checks: pivots to be looked at.
        lengths: squared lengths of quaternions and their joints.
        results: accelerations in the order of ``owns``, known after the last step.
        refining: whether joint forces are kept, in the frames of the child links, and whether links
            feel what is left over of their equations of motion, and nothing else.
    """

    def __init__(
        self, plan: Plan, refining: Refining = None, graph: Graph | Numbers | None = None
    ) -> None:
        self.plan, self.refining = plan, refining
        self.graph: Any = Graph() if graph is None else graph
        self.memory: dict[Any, Any] = {}
        self._constants: dict[float, Any] = {}
        self.columns = plan.right_hand_sides
        self.angles: list[Expression] = []
        self.checks: list[Check] = []
        self.lengths: list[tuple[Expression, int]] = []
        self.results: dict[int, Array] = {}

    # -- numbers ----------------------------------------------------------------------------------

    def constants(self, values: Any) -> Array:
        """Return numbers as constants, in the shape they have."""
        array = np.asarray(values, dtype=float)
        result, known = np.empty(array.size, dtype=object), self._constants
        for k, value in enumerate(array.ravel().tolist()):
            if value not in known:
                known[value] = self.graph.constant(value)
            result[k] = known[value]
        return result.reshape(array.shape)

    def zeros(self, *shape: int) -> Array:
        """Return zeros."""
        return np.full(shape, self.graph.constant(0), dtype=object)

    def column(self, first: Array) -> Array:
        """First column of a right-hand side; the others answer to unit torques of slaved joints."""
        result = self.zeros(len(first), self.columns)
        result[:, 0] = first
        return result

    def factorize(self, matrix: Array, joint: int) -> Factors:
        """Return the factors of a matrix, its pivots being checked in the name of a joint.

        A pivot has to be positive, and not lost against the entry that it was subtracted from.
        """
        factors, lost = factorize(matrix), 16 * EPSILON[FACTORS[self.plan.scalar]]
        for pivot, entry in zip(factors.pivots, factors.diagonal, strict=True):
            least = self.graph.constant(0) if pivot == entry else entry * lost
            self.checks.append(Check(pivot, least, joint))
        return factors

    # -- joints -----------------------------------------------------------------------------------

    def kind(self, j: int) -> JointKind:
        """What a joint leaves free: nothing where its acceleration is prescribed."""
        joint = self.plan.joints[j]
        return HELD if joint.prescribed else KINDS[joint.kind]

    def configuration(self, j: int) -> tuple[list[Expression], list[Expression]]:
        """Configuration and velocity of a joint, a slaved one's from its source."""
        joint, kind = self.plan.joints[j], KINDS[self.plan.joints[j].kind]
        if joint.mimic is None:
            q = [self.graph.input(f"q[{joint.q + k}]") for k in range(kind.nq)]
            if self.refining == "correction":
                return q, [self.graph.constant(0)] * kind.nv
            return q, [self.graph.input(f"v[{joint.v + k}]") for k in range(kind.nv)]
        source, multiplier, offset = joint.mimic
        (angle, *_), (rate, *_) = self.configuration(source)
        return [angle * multiplier + offset], [rate * multiplier]

    def upwards(self) -> Array:
        """Return the ground's acceleration relative to free fall, shape (3,)."""
        if self.refining == "correction":
            return self.zeros(3)
        return self.constants([-g for g in self.plan.gravity])

    def circular(self, angle: Expression) -> tuple[Expression, Expression]:
        """Cosine and sine; they are taken of all angles of the process at once."""
        if angle not in self.angles:
            self.angles.append(angle)
        k = self.angles.index(angle)
        return self.graph.input(f"cosine[{k}]", READY), self.graph.input(f"sine[{k}]", READY)

    def given(self, j: int) -> Array:
        """What tau holds for joint j: its torques, or its accelerations; shape (n,)."""
        joint = self.plan.joints[j]
        own = [self.graph.input(f"tau[{joint.v + k}]") for k in range(KINDS[joint.kind].nv)]
        return np.array(own, dtype=object)

    def torques(self, j: int) -> Array:
        """Torques of joint j, shape (n, columns): those at work, then those of the coupling rows.

        At work is what tau holds, less damping, friction and what a spring takes.
        """
        result = self.column(self.given(j)[: self.kind(j).nv])
        for k, lost in enumerate(self._lost(j)):
            result[k, 0] = total([result[k, 0], *lost])
        for column, slaved in enumerate(self.plan.slaved, start=1):
            mimic = self.plan.joints[slaved].mimic
            assert mimic is not None
            if j == slaved:
                result[0, column] = self.graph.constant(1)
            if j == mimic[0]:
                result[0, column] = self.graph.constant(-mimic[1])
        return result

    def _lost(self, j: int) -> list[list[Expression]]:
        """What damping, friction and a spring add to each torque of a joint."""
        joint = self.plan.joints[j]
        if not (joint.damping or joint.friction or joint.stiffness):
            return []
        q, v = self.configuration(j)
        lost = [[-(joint.damping * rate)] for rate in v] if joint.damping else [[] for _ in v]
        if joint.friction:
            slope = self.graph.reciprocal(self.graph.constant(joint.friction_speed))
            for terms, rate in zip(lost, v, strict=True):
                terms.append(-(joint.friction * self.graph.tanh(rate * slope)))
        if joint.stiffness:
            lost[0].append(-(joint.stiffness * (q[0] - joint.rest)))
        return lost

    def rotor(self, j: int) -> Expression | None:
        """Rotor inertia of a joint, None for none."""
        size = self.plan.joints[j].rotor_inertia
        return self.graph.constant(size) if size else None

    def keep_force(self, j: int, force: Array, *, driven: bool = False) -> None:
        """Keep the force of a joint in its child link's frame, shape (6, columns).

        Args:
            j: the joint.
            force: its force.
            driven: whether it is the torque along the joint, to the bit.
        """
        if driven:
            force = force.copy()
            force[list(self.kind(j).free)] = self.torques(j)
        self.memory["force", j] = force

    def accelerate(self, j: int, qdd: Array) -> None:
        """Keep a joint's accelerations, shape (n, columns); with slaved joints they come later."""
        if self.plan.joints[j].prescribed:
            qdd = self.column(self.given(j))
        self.memory["qdd", j] = qdd
        if not self.plan.slaved:
            self.results[j] = qdd[:, 0]
