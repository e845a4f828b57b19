"""Allowance for rounding in the bound of an answer's error: squares summed outwards and inwards.

A certificate's residual does not show its own rounding, nor that of the kinematics that it shares
with the answer. Two terms allow for that (docs/explanation/certificates.md has the derivation):

* Wrenches that are passed inwards are uncertain by some units in their last place; the squares of
  all wrenches at a joint, N, are summed inwards, and N / D are added to the error's square.
* Accelerations of links are uncertain by some units in the last place of the largest one on the
  path from the ground. The energy of the resulting error is at most the energy of this uncertainty,
  because H^-1 J^T I is a projection.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.kinematics import Motion
from adagen.executor.state import State
from adagen.graph import Expression, Factors, total
from adagen.plan.steps import Step

Array = NDArray[Any]


class Sums:
    """A sum of many terms, which come in the order in which joints are swept.

    Each serial run of joints has a sum of its own, so that no term is kept until the end and runs
    do not wait for each other. Wide terms are added up across their lanes once.
    """

    def __init__(self, state: State) -> None:
        self.state = state
        self._parts: dict[tuple[Hashable, int], Expression] = {}

    def add(self, run: Hashable, count: int, term: Expression) -> None:
        """Add the first ``count`` lanes of a term."""
        key = run, count
        self._parts[key] = self._parts[key] + term if key in self._parts else term

    def total(self) -> Expression:
        """Return the sum; zero if there are no terms."""
        rows, by_count = self.state.rows, dict[int, list[Expression]]()
        for (_, count), part in self._parts.items():
            by_count.setdefault(count, []).append(part)
        each = [rows.summed(total(parts), count) for count, parts in by_count.items()]
        return total([self.state.graph.constant(0), *each])


@dataclass(frozen=True)
class _Reached:
    """A link whose acceleration is known.

    Attributes:
        link: the link.
        joint: the joint that it was reached by; of a root, the one before it.
        near: whether that joint has it from its child link (reversed), from its parent link, or
            nothing is before it (root).
        inertia: the trace of its inertia about its origin, and its mass, shape (2,).
        arm: the square of the way to it from the joint's near link.
        turning: the square of what its angular acceleration is added up from.
        own: of its linear one, what does not come from that near link's.
    """

    link: int
    joint: int
    near: str
    inertia: Array
    arm: Expression
    turning: Expression
    own: Expression


class Allowance:
    """Sums the allowance for rounding in the square of an answer's error.

    What is kept of links: ``("size", link)``, squares of angular and linear accelerations, shape
    (2,); ``("left", link)``, the wrench that the motion of the link and of all beyond takes, shape
    (6,); ``("noise", link)``, squares of moments (3) and forces that are passed on to it, shape
    (4,).

    Attributes:
        rounded: what it may add, in units of the square of a certificate's unit.
    """

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion
        self.memory: dict[Any, Any] = state.memory
        self.bases = [
            j
            for j, joint in enumerate(state.plan.joints)
            if joint.kind == "floating" and joint.parent == 0
        ]
        self.rounded = Sums(state)
        self._reached: list[_Reached] = []  # outwards
        self._marks: dict[int, int] = {}  # by link
        self._runs: dict[int, int] = {}

    def square(self, numbers: Iterable[Expression]) -> Expression:
        """The sum of squares."""
        return total([self.state.graph.constant(0), *(x * x for x in numbers)])

    def count(self, j: int) -> int:
        """Number of joints in the lanes of a joint."""
        return len(self.state.rows.own(j))

    def run(self, j: int) -> int:
        """The first joint of the serial run that a joint is in."""
        if j not in self._runs:
            plan = self.state.plan
            near = plan.joints[j].parent
            serial = near > 0 and len(plan.children[near]) == 1
            self._runs[j] = self.run(near - 1) if serial else j
        return self._runs[j]

    # -- how large accelerations are --------------------------------------------------------------

    def turning(self, link: int) -> Expression:
        """The square of a link's angular acceleration."""
        return self.square(self.memory["a", link][:3, 0])

    def size(self, j: int, inertia: Array, fall: Array | None = None) -> None:
        """Magnitude from which a joint's child link's accelerations are computed, never decreasing.

        Args:
            j: the joint.
            inertia: the link's, shape (6, 6); zeros where another process counts it.
            fall: by how much a base falls, in the link's frame, where the link is a root, from
                which all others are reached; none of roots that are bases themselves.
        """
        state, rows = self.state, self.state.rows
        nothing = state.graph.constant(0)
        if fall is not None or j in self.bases:
            falls = () if fall is None else fall
            own = self.square([*falls, *self.memory["a", j + 1][3:, 0]])
            self._reach(j + 1, j, "root", inertia, nothing, self.turning(j + 1), own, own)
            return
        upwards = self.square(state.upwards())
        turning, sliding = rows.of_near("size", j, np.array([nothing, upwards]))
        arm, slides = self._across(j)
        grounded = [np.array(nothing if near else upwards, object) for near in rows.near_links(j)]
        sliding = total([sliding, turning * arm, *slides])
        turning = state.graph.larger(turning, self.turning(j + 1))
        own = total([rows.packed(grounded).item(), *slides])
        self._reach(j + 1, j, "parent", inertia, arm, turning, sliding, own)

    def size_back(self, j: int, inertia: Array) -> None:
        """The same for the parent link of a reversed joint."""
        graph, far = self.state.graph, self.state.plan.joints[j].parent
        turning, sliding = self.memory["size", j + 1]
        arm, slides = self._across(j)
        sliding = total([sliding, turning * arm, *slides])
        turning = graph.larger(turning, self.turning(far))
        own = total([graph.constant(0), *slides])
        self._reach(far, j, "child", inertia, arm, turning, sliding, own)

    def _reach(
        self,
        link: int,
        j: int,
        near: str,
        inertia: Array,
        arm: Expression,
        turning: Expression,
        sliding: Expression,
        own: Expression,
    ) -> None:
        """Store the data of a link that a joint reaches."""
        self._marks[link] = self.state.graph.mark
        whole = np.array([total(inertia[k, k] for k in range(3)), inertia[3, 3]], dtype=object)
        self.memory["size", link] = np.array([turning, sliding], dtype=object)
        self._reached.append(_Reached(link, j, near, whole, arm, turning, own))

    def _across(self, j: int) -> tuple[Expression, list[Expression]]:
        """Squares of a joint's lever arm, and of its sliding."""
        state = self.state
        slides: list[Expression] = []
        linear = [k for k, place in enumerate(state.kind(j).free) if place >= 3]
        if linear:
            _, v = state.configuration(j)
            spin = self.square(self.memory["field", j + 1].omega)
            slides.append(self.square(self.memory["accelerated", j][linear]))
            slides.append(spin * self.square(v[k] for k in linear) * 4)
        return total(self._arm_squares(j)), slides

    def uncertain_motions(self) -> None:
        """Add the energy of the uncertainty of all links' accelerations.

        Of a link that is tr(I) times the square of the angular one and m times that of the linear
        one. The latter is that of the link before and an arm's square times the angular one, so
        that squares of angular accelerations come together with factors that mostly are constants.
        Each is added where its link is reached.
        """
        for each in self._reached:
            self.memory["weighs", each.link] = each.inertia
        for each in reversed(self._reached):
            mass = self.memory["weighs", each.link][1]
            handed = np.array([mass * each.arm, mass], dtype=object)
            if each.near == "child":
                near = "weighs", each.joint + 1
                self.memory[near] = self.memory[near] + handed
            elif each.near == "parent" and any(self.state.rows.near_links(each.joint)):
                self.state.rows.hand_on("weighs", each.joint, handed)
        for each in self._reached:
            turns, slides = self.memory["weighs", each.link]
            run, count = self.run(each.joint), self.count(each.joint)
            with self.when_reached(each.link):
                self.rounded.add(("motion", run), count, turns * each.turning)
                self.rounded.add(("motion", run), count, slides * each.own)

    @contextmanager
    def when_reached(self, link: int) -> Iterator[None]:
        """Have a computation belong to the step that reached a link.

        Straight lines compute it there, where its operands are at hand.
        """
        graph = self.state.graph
        now, graph.mark = graph.mark, self._marks.get(link, graph.mark)
        yield
        graph.mark = now

    def begin(self, step: Step) -> None:
        """Have a loop sweep residuals before the first step of a correction that does."""

    def swept(self, step: Step) -> None:
        """Use a step of a correction, if it sweeps residuals inwards."""

    # -- what is passed on ------------------------------------------------------------------------

    def pushed(self, link: int) -> Array:
        """Squares of moments and forces of outer forces, which may cancel inertial forces."""
        noise = self.state.zeros(4)
        for push in self.motion.pushes(link):
            noise[:3] = noise[:3] + push[:3] * push[:3]
            noise[3] = noise[3] + self.square(push[3:])
        return noise

    def noise_at(self, link: int) -> Array:
        """Squares of all moments and forces at a link, shape (4,)."""
        left, passed = self.memory["left", link], self.memory["noise", link]
        moments = [total([passed[k], left[k] * left[k]]) for k in range(3)]
        force = total([passed[3], *(x * x for x in left[3:])])
        return np.array([*moments, force], dtype=object)

    def handed_noise(
        self, j: int, free: list[int], given: Array, spent: Array, noise: Array
    ) -> Array:
        """The squares that a joint passes on; along it at most those of its torques.

        Args:
            j: the joint.
            free: the entries of a wrench that are along it.
            given: its torques, shape (n,).
            spent: squares of what passive forces took of these, which is rounded, too, shape (n,).
            noise: squares at the link beyond, shape (4,).
        """
        passed = self.torques_in(free, given, spent, noise)
        turned = self.memory["X", j].rotation.magnitudes(passed[:3])
        return np.array([*(turned + self._levers(j, passed[3])), passed[3]], dtype=object)

    def torques_in(self, free: list[int], given: Array, spent: Array, noise: Array) -> Array:
        """Squares of moments and forces with a joint's torques in place of those along it."""
        torques = dict(zip(free, given * given + spent, strict=True))
        force = total([noise[3], *(x for k, x in zip(free, spent, strict=True) if k >= 3)])
        return np.array([*(torques.get(k, noise[k]) for k in range(3)), force], dtype=object)

    def noise_back(self, j: int, noise: Array) -> Array:
        """Squares of moments and forces at a joint's parent link, from those at its child link."""
        moved = noise[:3] + self._levers(j, noise[3])
        turn = self.memory["X", j].rotation.transposed()
        return np.array([*turn.magnitudes(moved), noise[3]], dtype=object)

    def _levers(self, j: int, force: Expression) -> Array:
        """Squares of the moments of forces at a joint whose squares are given."""
        arms = self._arm_squares(j)
        levers = [total([arms[(k + 1) % 3], arms[(k + 2) % 3]]) for k in range(3)]
        return np.array([lever * force for lever in levers], dtype=object)

    def _arm_squares(self, j: int) -> Array:
        """Squares of how far a joint's child frame is from its parent's, by axes, shape (3,).

        Where the joint slides, they are no less than those of its place, which sliding may take
        back: both are rounded.
        """
        state, x = self.state, self.memory["X", j]
        squares: Array = x.origin * x.origin
        if all(place < 3 for place in state.kind(j).free):
            return squares
        placed = state.rows.of_joint(j, lambda joint: joint.translation)
        return np.array(
            [
                square if place.constant == 0 else state.graph.larger(square, place * place)
                for square, place in zip(squares, placed, strict=True)
            ],
            dtype=object,
        )

    def weigh_noise(self, run: Hashable, count: int, factors: Factors, noise: Array) -> Array:
        """Add the energy of rounding with given factors and squares.

        Args:
            run: what they belong to.
            count: how many lanes they have.
            factors: of an inertia.
            noise: shape (n,).

        Returns:
            What comes together at each pivot, shape (n,).
        """
        rest: list[Expression] = []
        for k, inverse in enumerate(factors.inverses):
            row = factors.lower[k]
            rest.append(total([noise[k], *(row[i] * row[i] * rest[i] for i in range(k))]))
            self.rounded.add(run, count, rest[k] * inverse)
        return np.array(rest, dtype=object)
