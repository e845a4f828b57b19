"""State of a process while its steps run: graph, memory, checks and options."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal, cast

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.executor.lanes import rows_of
from adagen.executor.left_over import LeftOver
from adagen.executor.placed import Placed
from adagen.executor.process_memory import ProcessMemory
from adagen.executor.rows import Rows
from adagen.executor.swept import Swept
from adagen.graph import Expression, Factors, Graph, Numbers, factorize, total
from adagen.model import LINK_ACCELERATION
from adagen.model.kinds import HELD, KINDS, JointKind
from adagen.plan.digits import EPSILON
from adagen.plan.own_axes import losing_joints
from adagen.plan.robot import PlanJoint
from adagen.plan.simd_groups import Limbs
from adagen.plan.types import Plan

Array = NDArray[Any]
Refining = Literal["answer", "correction"] | None
"""What of iterative refinement (adagen/executor/refine.py) is computed: the answer, joint forces
being kept, or a correction of it; None: it is no refinement."""

READY = 40
"""Cycles until the polynomials have given sines and cosines."""
TANGENT_READY = 100
"""Cycles until those of hyperbolic tangents have, with two quotients after each other."""
Scaled = tuple[Expression, Expression]
"""A rate, which is an input, and the constant by which it is multiplied."""


class State(ProcessMemory):
    """What the steps of one process read and change, its memory included.

    Attributes:
        angles: joint angles whose sine and cosine are computed, in order.
        tangents: rates whose hyperbolic tangent is computed, in order; as friction asks for them.
        checks: pivots to be looked at.
        lengths: squared lengths of quaternions and their joints.
        results: accelerations by joints, known after the last step; of a row wide. Those that
            are not wanted are not there.
        outputs: what is wanted beside them, by the place in the plan; known likewise.
        certificate: squares of the energy norms of the error, as bounded, and of the answer, where
            the plan asks for them.
        swept: what a loop that sweeps residuals finds in memory, if there is one.
        tied_joints: right-hand sides that push a joint, with factors (plan.tied_rows).
        tied_links: right-hand sides that push a link, each with a force, shape (6,).
        forces: of loops and couplings, by where they are given behind the accelerations.
        limbs: those that share code, one in each lane.
        rows: joints that are treated as one.
        asks_up: whether links' accelerations are asked for, which need gravity in their axes.
        left: what an answer leaves over, where it is corrected: links, joints and loops feel
            nothing else.
        refining: whether joint forces are kept, in the frames of the child links, and whether links
            feel what is left over of their equations of motion, and nothing else.
        unturned: the plan before its link frames were turned for limbs in lanes.
    """

    def __init__(
        self,
        plan: Plan,
        refining: Refining = None,
        graph: Graph | Numbers | None = None,
        all_limbs: Sequence[Limbs] = (),
        unturned: Plan | None = None,
    ) -> None:
        super().__init__(plan, graph)
        joined = plan.form == "ada" and plan.corrections > 0  # joints' forces are refined, too
        self.refining = "answer" if joined else refining
        self.angles: Placed[Expression] = Placed()
        self.tangents: Placed[Scaled] = Placed()
        self.checks: list[Check] = []
        self.lengths: list[tuple[Expression, int]] = []
        self.results: dict[int, Array] = {}
        self.certificate: tuple[Any, ...] = ()
        self.swept: Swept | None = None
        self.forces: dict[int, Array] = {}
        self.tied_joints: dict[int, list[tuple[int, float]]] = {}
        self.tied_links: dict[int, list[tuple[int, Array]]] = {}
        self.outputs: dict[int, Array] = {}
        self.limbs = tuple(all_limbs)
        self.rows = Rows(self, rows_of(all_limbs))
        self.left: LeftOver | None = None
        self.unturned = unturned or plan
        self._exact = losing_joints(self.unturned)  # turns change nothing of it but last digits
        self.asks_up = any(output.what == LINK_ACCELERATION for output in plan.outputs)

    # -- numbers ----------------------------------------------------------------------------------

    def column(self, first: Array) -> Array:
        """First column of a right-hand side; the others answer to unit torques of slaved joints."""
        result = self.zeros(len(first), self.columns)
        result[:, 0] = first
        return result

    def on_link(self, link: int, first: Array) -> Array:
        """Right-hand sides of a link's equation of motion: its own wrench, and loops' unit forces.

        Args:
            link: its number.
            first: what it feels without these, shape (6,).
        """
        result = self.column(first)
        for column, force in self.tied_links.get(link, ()):
            result[:, column] = result[:, column] + force
        return result

    def factorize(self, matrix: Array, joint: int, brought: Expression | None = None) -> Factors:
        """Return the factors of a matrix, its pivots being checked in the name of a joint.

        A pivot has to be positive, and not lost against the entry that it was subtracted from.

        Args:
            matrix: symmetric, shape (n, n).
            joint: whose it is.
            brought: of one entry, size of what comes to be it by exact turns, where it may be next
                to nothing: the square of the sine of an angle, whose last digits nobody knows.
        """
        factors, lost = factorize(matrix), 16 * EPSILON[self.plan.scalar]
        zero = self.graph.constant(0)
        noise = zero if brought is None else brought * lost**2
        for pivot, entry in zip(factors.pivots, factors.diagonal, strict=True):
            unchanged = noise if pivot.constant is None else zero  # constants are no noise
            self.checks.append(Check(pivot, unchanged if pivot == entry else entry * lost, joint))
        return factors

    # -- joints -----------------------------------------------------------------------------------

    def kind(self, j: int) -> JointKind:
        """The kind of a joint; one without freedom where its acceleration is prescribed."""
        joint = self.plan.joints[j]
        return HELD if joint.prescribed else KINDS[joint.kind]

    def configuration(self, j: int) -> tuple[list[Expression], list[Expression]]:
        """Configuration and velocity of a joint, a slaved one's from its source."""
        joint, kind = self.plan.joints[j], KINDS[self.plan.joints[j].kind]
        if joint.mimic is None:
            q = list(self.rows.entries("q", j, kind.nq))
            if self.at_rest:
                return q, [self.graph.constant(0)] * kind.nv
            return q, list(self.rows.entries("v", j, kind.nv))
        source, multiplier, offset = joint.mimic
        (angle, *_), (rate, *_) = self.configuration(source)
        return [angle * multiplier + offset], [rate * multiplier]

    @property
    def at_rest(self) -> bool:
        """Whether no joint moves: as a scene says, or while a correction is found."""
        return self.refining == "correction" or self.plan.at_rest

    def _tangents(self, j: int) -> list[Expression]:
        """Of each of its rates over ``friction_speed``; a slaved joint's rate is its source's."""
        factor = self.graph.reciprocal(self._of_joint(j, lambda joint: joint.friction_speed))
        mimic = self.plan.joints[j].mimic
        while mimic is not None:
            j, multiplier, _ = mimic
            factor, mimic = factor * multiplier, self.plan.joints[j].mimic
        rates = self.rows.entries("v", j, KINDS[self.plan.joints[j].kind].nv)
        return [self.tangent(rate, factor) for rate in rates]

    def tangent(self, rate: Expression, factor: Expression) -> Expression:
        """Return the tangent of a rate times a factor; all of the process are taken at once."""
        width = rate.node.width
        own = [(rate, factor)]
        if width > 1:
            own = [(self.graph.lane(rate, k), self.graph.lane(factor, k)) for k in range(width)]
        name = f"tangent[{self.tangents.place_of(tuple(own))}]"
        return cast("Expression", self.graph.input(name, TANGENT_READY, width))

    def upwards(self) -> Array:
        """Return the ground's acceleration relative to free fall, shape (3,)."""
        if self.refining == "correction":
            return self.zeros(3)
        first = self.plan.entry_of_parameter("gravity")
        if first is None:
            return self.constants([-g for g in self.plan.gravity])
        return -np.array([self.graph.input(f"parameter[{first + k}]") for k in range(3)], object)

    def circular(self, angle: Expression) -> tuple[Expression, Expression]:
        """Cosine and sine; those of all angles of the process are computed at once."""
        width = angle.node.width
        own = [angle] if width == 1 else [self.graph.lane(angle, k) for k in range(width)]
        k = self.angles.place_of(tuple(own))
        cosine = self.graph.input(f"cosine[{k}]", READY, width)
        return cosine, self.graph.input(f"sine[{k}]", READY, width)

    def turns_exactly(self, j: int) -> bool:
        """Whether a projected inertia may be small beside its parts, and needs exact rotations.

        So it is for joints that would lose digits in axes of the base, of a row for all.
        """
        return not self._exact.isdisjoint(self.rows.lanes(j))

    def take_angles_of_rows(self) -> None:
        """Place the angles of rows before all others, the widest first: loads are then aligned."""
        rows = self.rows.rows
        for j in sorted(rows, key=lambda j: -rows[j].width):
            if self.plan.joints[j].kind == "revolute":
                self.circular(self.rows.entries("q", j, 1)[0])

    def given(self, j: int) -> Array:
        """The entries of tau for joint j: its torques, or its accelerations; shape (n,)."""
        return self.rows.entries("tau", j, KINDS[self.plan.joints[j].kind].nv)

    def torques(self, j: int) -> Array:
        """Torques of joint j, shape (n, columns): the given ones, then those of coupling rows.

        At work is what tau holds, less damping, friction and what a spring takes.
        """
        result = self.column(self.given(j)[: self.kind(j).nv])
        for k, lost in enumerate(self._lost(j)):
            result[k, 0] = total([result[k, 0], *lost])
        if self.left is not None and len(result):
            result[:, 0] = self.left.of_joint(j, result[:, 0])
        for column, factor in self.tied_joints.get(j, ()) if len(result) else ():
            result[0, column] = result[0, column] - factor
        for column, (lent, k) in enumerate(reversed(self.plan.lent), start=1):
            if j == lent and len(result):
                result[k, -column] = self.graph.constant(-1)
        for column, (slaved, source, multiplier) in enumerate(self.plan.following, start=1):
            if j == slaved:
                result[0, column] = self.graph.constant(1)
            if j == source:
                result[0, column] = self.graph.constant(-multiplier)
        return result

    def handed(self, j: int, force: Array) -> Array:
        """Return what a joint hands on of a force: nothing of what a loop sweeps."""
        return force if self.left is None else self.left.handed(j, force)

    def _lost(self, j: int) -> list[list[Expression]]:
        """Torques of damping, friction and a spring on each freedom of a joint."""
        joint = self.plan.joints[j]
        if not joint.loads:
            return []
        q, v = self.configuration(j)
        lost: list[list[Expression]] = [[] for _ in v]
        if joint.damping:
            for terms, rate in zip(lost, v, strict=True):
                terms.append(-(rate * self._of_joint(j, lambda joint: joint.damping)))
        if joint.friction and not self.at_rest:
            for terms, part in zip(lost, self._tangents(j), strict=True):
                terms.append(-(part * self._of_joint(j, lambda joint: joint.friction)))
        if joint.stiffness:
            turned = q[0] - self._of_joint(j, lambda joint: joint.rest)
            lost[0].append(-(turned * self._of_joint(j, lambda joint: joint.stiffness)))
        return lost

    def spent_squares(self, j: int) -> Array:
        """Squares of what damping, friction and a spring take of a joint's torques, shape (n,)."""
        squares = self.zeros(self.kind(j).nv)
        for k, lost in enumerate(self._lost(j)):
            squares[k] = total([squares[k], *(x * x for x in lost)])
        return squares

    def _of_joint(self, j: int, read: Callable[[PlanJoint], float]) -> Expression:
        """A number of a joint; for a row, a wide one."""
        return cast("Expression", self.rows.of_joint(j, read)[()])

    def rotor(self, j: int) -> Expression | None:
        """Rotor inertia of a joint with its artificial inertia, None for none."""
        joint = self.plan.joints[j]
        if not (joint.rotor_inertia or joint.lent):
            return None
        return self._of_joint(j, lambda joint: joint.rotor_inertia + joint.lent)

    def keep_force(self, j: int, force: Array, *, driven: bool = False) -> None:
        """Store the force of a joint in its child link's frame, shape (6, columns).

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
        """Store a joint's accelerations, shape (n, columns); with slaved joints they come later."""
        if self.plan.joints[j].prescribed:
            given = self.given(j)  # which corrections leave as it is
            qdd = self.column(given) if self.left is None else self.zeros(len(given), self.columns)
        self.memory.update((("qdd", each), own) for each, own in self.rows.apart(j, qdd))
        if self.columns == 1:
            self.memory["accelerated", j] = qdd[:, 0]
        if self.columns == 1 and any(map(self.plan.wants, self.rows.own(j))):
            self.results[j] = qdd[:, 0]

    def lanes_of_result(self, j: int) -> tuple[int, ...]:
        """Return the joints whose accelerations ``results`` has for joint j, lane by lane."""
        return (j,) if self.columns > 1 else self.rows.lanes(j)
