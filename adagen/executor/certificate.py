"""A bound of an answer's error, for a fraction of the cost of the answer.

The answer's accelerations leave a residual in each link's equation of motion. One inward sweep with
the known factors gives the missing joint forces u, and sum u^T D^-1 u is the square of the error in
the energy norm, r^T H^-1 r, without an outward sweep. Errors of the factors show in the residual,
whatever their cause. Rounding that does not show is allowed for (allowance.py).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.allowance import Allowance, Sums
from adagen.executor.floating_parts import FloatingParts
from adagen.executor.frames import Transform
from adagen.executor.inner_root import InnerRoot
from adagen.executor.kinematics import Motion
from adagen.executor.segments import Articulated
from adagen.executor.shared_bound import Heard, parting, seen_with, spread_of, told
from adagen.executor.state import State
from adagen.executor.swept_records import outermost
from adagen.executor.swept_rows import SweptRows
from adagen.graph import Expression, Factors, Graph, factorize, matrix_times, total
from adagen.plan.certificate import ROUNDING, has_inner_root
from adagen.plan.digits import EPSILON
from adagen.plan.limb_spread import spread_beyond
from adagen.plan.steps import Certify, StartLink, Step

Array = NDArray[Any]
_NOTHING = 1e-30
"""What a pivot of which no digit is known is taken to be known by, that bounds are infinite."""


class Certificate(Allowance):
    """Bounds the error of an answer, from the memory of a process after the answer.

    What is kept of links beside what rounding takes: ``("bare", link)``, under floating bases,
    force that the reference field takes of the link and all beyond (3), and their mass, shape (4,).

    Processes that gather elsewhere than at the base reach links from there, and find the energy of
    the answer link by link (inner_root.py).

    Attributes:
        seen: the square of the error that shows.
        answer: the energy of the answer.
        own: links that the process looks at.
        inner_root: the root where processes gather, if that is not the base or the ground.
    """

    def __init__(self, state: State, motion: Motion, steps: Iterable[Step]) -> None:
        super().__init__(state, motion)
        steps = list(steps)
        self.seen, self.answer = Sums(state), Sums(state)
        self.own = {step.link for step in steps if isinstance(step, StartLink)}
        self.unit = ROUNDING * EPSILON[state.plan.scalar]
        self.inner_root: InnerRoot | None = None
        self.parts = FloatingParts.of(self, steps)
        if has_inner_root(state.plan):
            self.inner_root = InnerRoot(state, motion, steps, self.bases)
            self.bases = []  # nothing is taken of their free fall as a whole
        asked = max((step.looped for step in steps if isinstance(step, Certify)), default=0)
        self.rows_in_loop = asked if isinstance(state.graph, Graph) else 0  # numbers need none

    def reach(self, j: int, *, root: bool = False) -> None:
        """Use the acceleration of the link beyond a joint as soon as it is known.

        Args:
            j: the joint.
            root: whether all others are reached from that link.
        """
        fall = self.inner_root.fall_at(j, root=root) if self.inner_root else None
        if root and self.parts:
            fall = self.state.upwards()  # a part's first link: nothing is before it
        if root and self.inner_root and self.inner_root.shown and self.inner_root.held == j + 1:
            self.memory["unheld", j + 1] = self.memory["a", j + 1]
            self.size(j, self.state.zeros(6, 6), fall)
            return  # it is looked at as the way to the ground has it
        inertia = self._inertia(j + 1)
        self.size(j, inertia, fall if root else None)
        self._look_at(j + 1, inertia)

    def reach_back(self, j: int) -> None:
        """Use the acceleration of the parent link of a reversed joint."""
        link = self.state.plan.joints[j].parent
        assert self.inner_root is not None
        if link == self.inner_root.held:  # it is looked at as the way to the ground has it
            self.memory["unheld", link] = self.memory["a", link]
            return
        inertia = self._inertia(link)
        self.size_back(j, inertia)
        self._look_at(link, inertia)

    def _inertia(self, link: int) -> Array:
        """A link's inertia; zeros where another process adds it."""
        return self.motion.link_inertia(link) if link in self.own else self.state.zeros(6, 6)

    def _look_at(self, link: int, inertia: Array) -> None:
        if link - 1 in self._in_loop:
            return
        if link in self.own:
            self._start(link, inertia)
            return
        self.memory["left", link], self.memory["noise", link] = map(self.state.zeros, (6, 4))
        self.memory["bare", link] = self.state.zeros(4)

    def carry_out(self, step: Certify) -> None:
        """Compute the squared energy norms of the error's bound and of the answer.

        Where several processes share the robot, each finds its share; process 0 finishes it.
        """
        shares = self._heard(step)
        self.uncertain_motions()
        self._sweep(step)
        energy = total([self.answer.total(), *(each.energy for each in shares)])
        seen = total([self.seen.total(), *(each.seen for each in shares)])
        apart = self.parts.apart() if self.parts else []
        rounded = self.rounded.total() * self.unit**2
        rounded = total([rounded, *(each.rounded for each in shares)])
        if step.tells is not None:
            own = [seen, rounded, energy]
            self.memory["share", step.tells.process] = told(self, step, own)
            return
        parted = [x for each in shares for x in each.parted]
        if self.inner_root is not None and self.inner_root.held:
            seen = self._both(seen, self.held.total())
            held, steps = self.inner_root.held, self.inner_root.steps
            beyond = spread_beyond(self.state.plan, steps, held)
            limbs = spread_of(self, beyond, held, shares)
            parted += parting(self, self.inner_root.apart(), limbs)
        error = seen_with(seen, parted) if parted else seen
        if apart:
            error = self._both(seen, total(apart))
        self.state.certificate = (error + rounded, energy)

    def _heard(self, step: Certify) -> list[Heard]:
        """The parts that other processes have sent."""
        if self.inner_root is None or not step.hears:
            return [Heard(self, share) for share in step.hears]
        found: list[Heard] = self.inner_root.set_aside(
            lambda: [Heard(self, share) for share in step.hears]
        )
        return found

    def _both(self, one: Expression, other: Expression) -> Expression:
        """The square of the sum of two lengths, from their squares."""
        graph = self.state.graph
        product = graph.larger(one * other, graph.constant(0))  # a form may round below zero
        return total([one, other, graph.sqrt(product) * 2])

    def _sweep(self, step: Certify) -> None:
        """Sweep residuals inwards."""
        inwards = [name[1] for name in list(self.memory) if _is(name, "articulated")]
        inwards = [j for j in inwards if not step.joints or j in step.joints]
        if self.inner_root is not None:
            self._sweep_elsewhere(inwards, step)
            return
        if self.parts is not None:
            self._sweep_parts(self.parts, inwards)
            return
        if self._in_loop:
            self._sweep_in_loop()
        for j in inwards:
            if j not in self._in_loop:
                self._inwards(j)
            body: Articulated = self.memory["articulated", j]
            with self.when_reached(j + 1):
                for energy in body.u[:, 0] * body.moved[:, 0]:
                    self.answer.add(self.run(j), self.count(j), energy)
        for base in self.bases:
            if not step.joints or base in step.joints:
                self._error_of_base(base)
                self.answer.add(base, 1, self._energy_of_base(base))

    @cached_property
    def _in_loop(self) -> list[int]:
        """Joints whose rows a loop sweeps: the outermost ones, inwards."""
        if not self.rows_in_loop:
            return []
        inwards = [name[1] for name in self.memory if _is(name, "articulated")]
        return outermost(self.state.rows, inwards, self.rows_in_loop)

    closed = False

    def wrench_at(self, link: int) -> Array:
        """Return the wrench that the reference field takes of a link, shape (6,)."""
        return self.motion.link_force(link)

    def squares_at(self, link: int) -> Array:
        """Return those of outer forces on it, shape (4,)."""
        return self.pushed(link)

    def torque_at(self, j: int) -> Expression:
        """Return the torque of a joint, less what its rotor takes."""
        return self._given(j, 1)[0]  # type: ignore[no-any-return]

    def _sweep_in_loop(self) -> None:
        """Have a loop sweep them; the links within gather what is left over."""
        rows = SweptRows(self, self._in_loop)
        self.state.swept = rows.swept
        seen, rounded, _ = rows.summed()
        self.seen.add("loop", 1, seen)
        self.rounded.add("loop", 1, rounded)
        masses = rows.masses() if self.bases else {}
        for link in rows.gather:
            left, noise, force = rows.gathered(link)
            self.memory["left", link] = self.memory["left", link] + left
            self.memory["noise", link] = self.memory["noise", link] + noise
            if self.bases:
                bare = np.array([*(left[3:] - force), *masses[link]], dtype=object)
                self.memory["bare", link] = self.memory["bare", link] + bare

    def _sweep_parts(self, parts: FloatingParts, inwards: Sequence[int]) -> None:
        """The same in each part, to its first link."""
        parts.load()
        for j in inwards:
            self._inwards(j)
        for root, phi, known in parts.shown(self.unit):
            least = self.state.graph.larger(known, self.state.graph.constant(_NOTHING))
            self._weigh_shown(root, phi, self.state.graph.reciprocal(least))

    def _sweep_elsewhere(self, inwards: Sequence[int], step: Certify) -> None:
        """The same towards another root; first from the ground to a held link."""
        at = self.inner_root
        assert at is not None
        for base in at.bases:
            if not step.joints or base in step.joints:
                free, link = list(self.state.kind(base).free), base + 1
                left = self.memory["left", link].copy()
                left[free] = left[free] - self.state.torques(base)[:, 0]
                self.memory["left", link] = left
        at.load(self.square, of_rest=False)
        for j in (j for j in inwards if j not in at.beyond):
            self._inwards(j)
        self.held = self.seen
        if at.held:
            self.seen = Sums(self.state)
        at.load(self.square, of_rest=True)
        for j in (j for j in inwards if j in at.beyond):
            if j in at.reversed:
                self._back(j)
            else:
                self._inwards(j)
        if step.tells is None:
            for root in at.roots:
                factors, noise = factorize(self.memory["IA", root]), self.noise_at(root)
                left = self.memory["left", root]
                self._weigh(root - 1, factors, left, noise[[0, 1, 2, 3, 3, 3]])
            if at.shown is not None:
                self._weigh_shown(at.held, self.memory[at.shown])

    def _weigh_shown(self, root: int, phi: Array, times: Expression | None = None) -> None:
        """The residual at a root of known mobility Phi: its error is at most that by Phi alone."""
        left, noise = self.memory["left", root], self.noise_at(root)
        for x, moved in zip(left, matrix_times(phi, left), strict=True):
            self.seen.add(root - 1, 1, x * moved if times is None else x * moved * times)
        for k in range(6):
            self.rounded.add(root - 1, 1, phi[k, k] * noise[min(k, 3)])

    # -- the sweep --------------------------------------------------------------------------------

    def _start(self, link: int, inertia: Array) -> None:
        """The wrench of a bare link."""
        own = self.motion.link_force(link)
        a = self.memory["a", link][:, 0]
        taken = matrix_times(inertia, a)
        self.memory["left", link] = taken + own
        if self.inner_root is not None:
            for energy in self.inner_root.energies(link, inertia, a, taken):
                self.answer.add(self.run(link - 1), self.count(link - 1), energy)
        if self.parts is not None:
            self.answer.add(self.run(link - 1), self.count(link - 1), total(a * taken))
        self.memory["noise", link] = self.pushed(link)
        if self.bases:
            self.memory["bare", link] = np.array([*own[3:], inertia[3, 3]], dtype=object)

    def _inwards(self, j: int) -> None:
        """Sweep a wrench through a joint to its near link; returns the squared error there."""
        x: Transform = self.memory["X", j]
        body: Articulated = self.memory["articulated", j]
        left, noise = self.memory["left", j + 1], self.noise_at(j + 1)
        free = list(self.state.kind(j).free)
        given, spent = self._given(j, 1), self.state.spent_squares(j)
        driven = given - left[free]
        self._weigh(j, body.factors, driven, noise[[min(k, 3) for k in free]] + spent)
        if not any(self.state.rows.near_links(j)):
            return
        passed = self._passed(j, left, given, driven)
        self.state.rows.hand_on("left", j, x.force(passed))
        self.state.rows.hand_on("noise", j, self.handed_noise(j, free, given, spent, noise))
        if self.bases:
            bare = self.memory["bare", j + 1]
            own = np.array([*x.rotation.vector(bare[:3]), bare[3]], dtype=object)
            self.state.rows.hand_on("bare", j, own)

    def _back(self, j: int) -> None:
        """The same for a reversed joint: from its parent link to its child link."""
        x: Transform = self.memory["X", j]
        body: Articulated = self.memory["articulated", j]
        far, free = self.state.plan.joints[j].parent, list(self.state.kind(j).free)
        left = x.force_back(self.memory["left", far])
        noise = self.noise_back(j, self.noise_at(far))
        given, spent = self._given(j, -1), self.state.spent_squares(j)
        driven = given - left[free]
        self._weigh(j, body.factors, driven, noise[[min(k, 3) for k in free]] + spent)
        for name, own in (
            ("left", self._passed(j, left, given, driven)),
            ("noise", self.torques_in(free, given, spent, noise)),
        ):
            self.memory[name, j + 1] = self.memory[name, j + 1] + own

    def _given(self, j: int, sign: int) -> Array:
        """Torque on the far side of a joint, less the rotor's."""
        given, rotor = self.state.torques(j)[:, 0], self.state.rotor(j)
        if rotor is not None:
            given = given - self.memory["accelerated", j] * rotor
        return given * sign

    def _passed(self, j: int, left: Array, given: Array, driven: Array) -> Array:
        """The wrench that a joint passes to its near link."""
        body: Articulated = self.memory["articulated", j]
        free, rotor = list(self.state.kind(j).free), self.state.rotor(j)
        passed = left.copy()
        for k in range(6):
            if k not in free or rotor is not None:
                passed[k] = total([left[k], *(body.scaled[:, k] * driven)])
            else:
                passed[k] = given[free.index(k)]
        return passed

    def _weigh(self, j: int, factors: Factors, u: Array, noise: Array) -> None:
        """Add u^T M^-1 u to the squared residual error, and the allowance for its rounding."""
        y = factors.forward(u.reshape(-1, 1))[:, 0]
        for k, inverse in enumerate(factors.inverses):
            self.seen.add(self.run(j), self.count(j), y[k] * (y[k] * inverse))
        self.weigh_noise(self.run(j), self.count(j), factors, noise)

    # -- floating bases ---------------------------------------------------------------------------

    def _error_of_base(self, j: int) -> None:
        """Residual at a floating base, and the rounding of its free fall."""
        link, free = j + 1, list(self.state.kind(j).free)
        left, noise = self.memory["left", link].copy(), self.noise_at(link)
        left[free] = left[free] - self.state.torques(j)[:, 0]
        factors = factorize(self.memory["IA", link])
        self._weigh(j, factors, left, noise[[0, 1, 2, 3, 3, 3]])
        fall = self.square([*self._fall(j), *self.memory["a", link][3:, 0]])
        self.rounded.add(j, 1, self.memory["bare", link][3] * fall)

    def _energy_of_base(self, j: int) -> Expression:
        """Part of a floating base in the energy of the answer, free fall included.

        Links' accelerations are relative to free fall, d; with m the mass and P the sum of
        what they take, the energy is that relative to it less 2 d^T P - m d^T d.
        """
        link, fall = j + 1, self._fall(j)
        relative = -(self.memory["pA", link][:, 0] * self.memory["a", link][:, 0])
        bare = self.memory["bare", link]
        taken = self.memory["left", link][3:] - bare[:3]
        return total([*relative, *(fall * (fall * bare[3] - taken * 2))])

    def _fall(self, j: int) -> Array:
        drift = self.motion.drift(j)
        assert drift is not None  # a floating base has one
        fall: Array = drift[3:, 0]
        return fall


def _is(name: Any, word: str) -> bool:
    return isinstance(name, tuple) and name[0] == word
