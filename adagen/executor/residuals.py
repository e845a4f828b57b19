"""Residuals of an answer: of the equations of motion and of the constraint rows of loops.

The answer is used as the reference field. A link's residual is the wrench that its acceleration
and the loop forces on it leave unbalanced, a joint's the part of its torque that is missing, and a
row's the relative acceleration of the two links. A sweep with the known factors then gives the
error of the answer, constraint forces included. The residuals contain no factors, so all errors
of the factors show in them (adagen/executor/corrections.py).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.front import End
from adagen.executor.kinematics import Motion
from adagen.executor.left_over import LeftOver
from adagen.graph import Expression, matrix_times, total
from adagen.model.paths import path_to_ground
from adagen.plan.arms import WideUnknown

Array = NDArray[Any]


@dataclass(frozen=True)
class Answer:
    """An answer so far: links and joints of rows under the name of the first.

    Attributes:
        links: accelerations of links, deviations from the reference field, shape (6,).
        joints: accelerations of joints, shape (n,).
        forces: of kept rows, by closure and number.
        wrenches: of joints on their child links, shape (6,): in form ada, where these are unknowns
            beside the accelerations.
    """

    links: Mapping[int, Array]
    joints: Mapping[int, Array]
    forces: Mapping[tuple[int, int], Expression]
    wrenches: Mapping[int, Array] = field(default_factory=dict)

    def plus(self, other: Answer) -> Answer:
        """Return it with a correction added; prescribed joints have none."""

        def added(one: Mapping[Any, Any], more: Mapping[Any, Any]) -> dict[Any, Any]:
            return {key: x + more[key] if key in more else x for key, x in one.items()}

        return Answer(
            added(self.links, other.links),
            added(self.joints, other.joints),
            added(self.forces, other.forces),
            added(self.wrenches, other.wrenches),
        )


class Residuals(LeftOver):
    """Residuals of one answer at the links, joints and loops of a process.

    Args:
        motion: of the correction.
        forces: of the reference field, by links, shape (6,).
        answer: the answer.
        ends: of loops, by closure.
        ties: rows of couplings and their factors, by closure and joint.

    Attributes:
        in_loop: joints whose residuals a loop sweeps (swept_rows.py).
    """

    def __init__(
        self,
        motion: Motion,
        forces: Mapping[int, Array],
        answer: Answer,
        ends: Mapping[int, Sequence[End]],
        ties: Mapping[tuple[int, int], Sequence[tuple[int, Expression]]],
    ) -> None:
        self.state, self.motion, self.forces = motion.state, motion, forces
        self.answer, self.ties = answer, ties
        self.in_loop: frozenset[int] = frozenset()
        state = self.state
        for link, a in answer.links.items():
            state.memory["whole", link] = a
        for link in forces:
            state.memory["held", link] = state.zeros(6)
        for closure, each in ends.items():
            for end in each:
                self._hold(closure, end)

    def _hold(self, closure: int, end: End) -> None:
        """Wrench of a loop's rows on a link, with opposite sign."""
        forces = self.answer.forces
        parts = [
            column * self.state.rows.joined([forces[closure, unknown] for unknown in wide_unknown])
            for wide_unknown, column in end.columns.items()
            if (closure, wide_unknown[0]) in forces
        ]
        if parts:
            self.state.rows.add("held", end.links, end.count, sum(parts[1:], parts[0]))

    def handed(self, j: int, force: Array) -> Array:
        """Return what a joint hands on: nothing where a loop sweeps its residual."""
        return self.state.zeros(*force.shape) if j in self.in_loop else force

    def by_loops(self, link: int) -> Array:
        """Return the wrench on a link from loops that end at it, with opposite sign, shape (6,)."""
        found: Array = self.state.memory["held", link]
        return found

    def of_link(self, link: int) -> Array:
        """Return the residual wrench of a link for the answer's acceleration, shape (6,)."""
        inertia = self.motion.link_inertia(link)
        taken = matrix_times(inertia, self.answer.links[link]) + self.forces[link]
        return taken + self.by_loops(link) - self._by_joints(link)

    def _by_joints(self, link: int) -> Array:
        """Wrench of joints on a link, where their forces are known; shape (6,)."""
        wrenches, found = self.answer.wrenches, self.state.zeros(6)
        if link - 1 in wrenches:
            found = found + wrenches[link - 1]
        for j in self.state.plan.children[link]:
            if j in wrenches:
                found = found - self.state.memory["X", j].force(wrenches[j])
        return found

    def of_joint(self, j: int, torques: Array) -> Array:
        """Return the residual torques of a joint, less rotor and couplings, shape (n,).

        Nothing where its force is an unknown: along the joint that is the torque, to the bit.
        """
        if self.answer.wrenches:
            return self.state.zeros(len(torques))
        rotor = self.state.rotor(j)
        left = torques if rotor is None else torques - self.answer.joints[j] * rotor
        for (closure, joint), rows in self.ties.items():
            for unknown, factor in rows if joint == j else ():
                if (closure, unknown) in self.answer.forces:
                    left = left - self.answer.forces[closure, unknown] * factor
        return left

    def of_row(
        self, bias: Expression, ends: Sequence[End], wide_unknown: WideUnknown
    ) -> Expression:
        """Return the residual of a loop's row; ``bias``: its value for zero deviations."""
        terms = [bias]
        for end in ends:
            if wide_unknown in end.columns:
                ground = self.state.zeros(6)
                a = self.state.rows.of_links("whole", end.links, ground)
                terms += list(end.columns[wide_unknown] * a)
        return total(terms)

    def of_coupling(self, joints: Sequence[int], factors: Array) -> Expression:
        """Return the residual of a coupling's row."""
        return total([self.answer.joints[j][0] * x for j, x in zip(joints, factors, strict=True)])


class Energies:
    """Squared energy norms: of corrections, of the answer, and of all link accelerations.

    Args:
        motion: of the answer.
        links: those that count, in the names that stand for rows.
    """

    def __init__(self, motion: Motion, links: Sequence[int]) -> None:
        self.state, self.motion, self.links = motion.state, motion, links

    def of(self, links: Mapping[int, Array], joints: Mapping[int, Array]) -> Expression:
        """Return the squared norm of joint accelerations, from their link accelerations.

        Args:
            links: accelerations of links, shape (6,).
            joints: accelerations of joints, shape (n,).
        """
        terms = [self.state.graph.constant(0)]
        for link in self.links:
            momentum = matrix_times(self.motion.link_inertia(link), links[link])
            terms.append(self.state.rows.whole(link - 1, total(momentum * links[link])))
        for j, qdd in joints.items():
            rotor = self.of_rotor(j, qdd)
            if rotor is not None:
                terms.append(self.state.rows.whole(j, rotor))
        return total(terms)

    def in_all(self) -> Expression:
        """Return the squared norm of the reference field, by the links' masses alone."""
        terms = [self.state.graph.constant(0)]
        for link in self.links:
            field = self.state.memory["field", link]
            mass = self.state.rows.mass(link)
            terms.append(self.state.rows.whole(link - 1, total(x * x for x in field.a) * mass))
        return total(terms)

    def in_fall(self, link: int, a: Array) -> Expression:
        """Return that of one link less free fall d, (a - 2 d)^T (I a) + m d^T d; by lanes."""
        momentum = matrix_times(self.motion.link_inertia(link), a)
        falls = self._falls([link])
        if not falls:
            return total(momentum * a)
        less = np.concatenate([a[:3], a[3:] - falls[link] * 2])
        return total([*(momentum * less), self._square(link) * self.state.rows.mass(link)])

    def of_fall(self, link: int, force: Array, mass: Expression) -> Expression:
        """Return what free fall d changes in that of links that fall with one, by lanes.

        Args:
            link: the link.
            force: what all together take, P in - 2 d^T P + m d^T d, in its axes, shape (3,).
            mass: m of all.
        """
        fall = self._fall(link)
        return total([self._square(link) * mass, *(-(fall * force * 2))])

    def of_rotor(self, j: int, qdd: Array) -> Expression | None:
        """Return that of a joint's rotor, if it has one; by lanes."""
        rotor = self.state.rotor(j)
        return None if rotor is None else total(x * x for x in qdd) * rotor

    def _square(self, link: int) -> Expression:
        """The square of a link's free fall, which rotations do not change: that of its base's."""
        base_joint = path_to_ground(self.state.plan.joints, link)[-1]
        base: Expression = total(x * x for x in self.state.memory["fall", base_joint + 1])
        return base

    def without_fall(self, links: Mapping[int, Array]) -> dict[int, Array]:
        """Return accelerations of links less those of free fall, with floating bases' own."""
        falls = self._falls(links)
        if not falls:
            return dict(links)
        return {link: np.concatenate([a[:3], a[3:] - falls[link]]) for link, a in links.items()}

    def _falls(self, links: Iterable[int]) -> dict[int, Array]:
        """Free fall in links' axes, shape (3,) each; nothing where no base floats."""
        joints = self.state.plan.joints
        if not any(joint.kind == "floating" and joint.parent == 0 for joint in joints):
            return {}
        return {link: self._fall(link) for link in links}

    def _fall(self, link: int) -> Array:
        """Free fall in a link's axes, from the ground on: the process may not have the whole path.

        Where processes meet around a link in the middle of a tree, what is between this and the
        base may be another's.
        """
        memory, rows, j = self.state.memory, self.state.rows, link - 1
        if ("fall", link) not in memory:
            joint = self.state.plan.joints[j]
            if joint.kind == "floating" and joint.parent == 0:
                memory["fall", link] = memory["drift", j][3:]
            else:
                for near in set(rows.near_links(j)) - {0}:
                    self._fall(rows.name_of(near))
                near_fall = rows.of_near("fall", j, self.state.zeros(3))
                back = memory["X", j].rotation.transposed()
                memory["fall", link] = back.vector(near_fall)
        found: Array = memory["fall", link]
        return found
