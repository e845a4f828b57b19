"""A bound of an answer's error, for a fraction of what the answer costs.

With the accelerations of the answer each link's equation of motion leaves something over. One sweep
inwards with the factors at hand finds what the joints would have to be driven with besides, u, and
sum u^T D^-1 u is the square of the error in the energy norm: what forward dynamics makes of the
residual, r^T H^-1 r, without its accelerations. So are errors of the factors seen, whatever their
cause. What the sweep cannot see is allowed for (allowance.py).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.allowance import Allowance, Sums
from adagen.executor.frames import Transform
from adagen.executor.kinematics import Motion
from adagen.executor.segments import Articulated
from adagen.executor.shares_of_bound import Heard, seen_with, told
from adagen.executor.state import State
from adagen.graph import Expression, Factors, factorize, matrix_times, total
from adagen.plan.certificate import ROUNDING
from adagen.plan.digits import EPSILON
from adagen.plan.steps import Certify, StartLink, Step

Array = NDArray[Any]


class Certificate(Allowance):
    """Bounds the error of an answer from what a process's memory holds after it.

    What is kept of links beside what rounding takes: ``("bare", link)``, under floating bases,
    force that the reference field takes of the link and all beyond (3), and their mass, shape (4,).

    Attributes:
        seen: the square of the error that shows.
        answer: the energy of the answer.
        own: links that the process looks at.
    """

    def __init__(self, state: State, motion: Motion, steps: Iterable[Step]) -> None:
        super().__init__(state, motion)
        self.seen, self.answer = Sums(state), Sums(state)
        self.own = {step.link for step in steps if isinstance(step, StartLink)}

    def reach(self, j: int) -> None:
        """Look at the link beyond a joint, whose acceleration is there: while it is at hand."""
        link, known = j + 1, j + 1 in self.own
        inertia = self.motion.link_inertia(link) if known else self.state.zeros(6, 6)
        self.size(j, inertia)
        if known:
            self._start(link, inertia)
        else:  # another process adds it
            self.memory["left", link], self.memory["noise", link] = map(self.state.zeros, (6, 4))
            self.memory["bare", link] = self.state.zeros(4)

    def carry_out(self, step: Certify) -> None:
        """Find the squares of the energy norms of the error, as bounded, and of the answer.

        Where several processes share the robot, each finds its share; process 0 finishes it.
        """
        shares = [Heard(self, share) for share in step.hears]
        self.uncertain_motions()
        self._sweep(step)
        energy = total([self.answer.total(), *(each.energy for each in shares)])
        seen = total([self.seen.total(), *(each.seen for each in shares)])
        unit = ROUNDING * EPSILON[self.state.plan.scalar]
        rounded = total([self.rounded.total() * unit**2, *(each.rounded for each in shares)])
        if step.tells is not None:
            own = [seen, rounded, energy]
            self.memory["share", step.tells.process] = told(self, step, own)
            return
        parted = [x for each in shares for x in each.parted]
        error = seen_with(seen, parted) if parted else seen
        self.state.certificate = (error + rounded, energy)

    def _sweep(self, step: Certify) -> None:
        """Sweep what is left over inwards."""
        inwards = [name[1] for name in list(self.memory) if _is(name, "articulated")]
        for j in inwards:
            if step.joints and j not in step.joints:
                continue
            self._inwards(j)
            body: Articulated = self.memory["articulated", j]
            with self.when_reached(j):
                for energy in body.u[:, 0] * body.moved[:, 0]:
                    self.answer.add(self.run(j), self.count(j), energy)
        for base in self.bases:
            if not step.joints or base in step.joints:
                self._error_of_base(base)
                self.answer.add(base, 1, self._energy_of_base(base))

    # -- the sweep --------------------------------------------------------------------------------

    def _start(self, link: int, inertia: Array) -> None:
        """What a link by itself takes."""
        own = self.motion.link_force(link)
        self.memory["left", link] = matrix_times(inertia, self.memory["a", link][:, 0]) + own
        self.memory["noise", link] = self.pushed(link)
        if self.bases:
            self.memory["bare", link] = np.array([*own[3:], inertia[3, 3]], dtype=object)

    def _inwards(self, j: int) -> None:
        """Hand on what a joint's far link takes; what that says of the error, squared."""
        x: Transform = self.memory["X", j]
        body: Articulated = self.memory["articulated", j]
        left, noise = self.memory["left", j + 1], self.noise_at(j + 1)
        free = list(self.state.kind(j).free)
        given, rotor = self.state.torques(j)[:, 0], self.state.rotor(j)
        if rotor is not None:
            given = given - self.memory["accelerated", j] * rotor
        driven = given - left[free]
        self._weigh(j, body.factors, driven, noise[[min(k, 3) for k in free]])
        if not any(self.state.rows.near_links(j)):
            return
        passed = left.copy()
        for k in range(6):
            if k not in free or rotor is not None:
                passed[k] = total([left[k], *(body.scaled[:, k] * driven)])
            else:
                passed[k] = given[free.index(k)]
        self.state.rows.hand_on("left", j, x.force(passed))
        self.state.rows.hand_on("noise", j, self.handed_noise(x, free, given, noise))
        if self.bases:
            bare = self.memory["bare", j + 1]
            own = np.array([*x.rotation.vector(bare[:3]), bare[3]], dtype=object)
            self.state.rows.hand_on("bare", j, own)

    def _weigh(self, j: int, factors: Factors, u: Array, noise: Array) -> None:
        """Add u^T M^-1 u to what is seen of the error, and what rounding may add to it."""
        y = factors.forward(u.reshape(-1, 1))[:, 0]
        for k, inverse in enumerate(factors.inverses):
            self.seen.add(self.run(j), self.count(j), y[k] * y[k] * inverse)
        self.weigh_noise(self.run(j), self.count(j), factors, noise)

    # -- floating bases ---------------------------------------------------------------------------

    def _error_of_base(self, j: int) -> None:
        """What is left over at a floating base, and what its acceleration of free fall rounds."""
        link, free = j + 1, list(self.state.kind(j).free)
        left, noise = self.memory["left", link].copy(), self.noise_at(link)
        left[free] = left[free] - self.state.torques(j)[:, 0]
        factors = factorize(self.memory["IA", link])
        self._weigh(j, factors, left, noise[[0, 1, 2, 3, 3, 3]])
        fall = self.square([*self._fall(j), *self.memory["a", link][3:, 0]])
        self.rounded.add(j, 1, self.memory["bare", link][3] * fall)

    def _energy_of_base(self, j: int) -> Expression:
        """What a floating base adds to the energy of the answer, that of free fall among it.

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
