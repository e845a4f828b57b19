"""A bound of an answer's error, for a fraction of what the answer costs.

With the accelerations of the answer each link's equation of motion leaves something over. One sweep
inwards with the factors at hand finds what the joints would have to be driven with besides, u, and
sum u^T D^-1 u is the square of the error in the energy norm: what forward dynamics makes of the
residual, r^T H^-1 r, without its accelerations. So are errors of the factors seen, whatever their
cause. What the sweep cannot see is its own rounding, and that of the kinematics that it shares with
the answer. Two terms allow for that (docs/explanation/certificates.md has the derivation):

* Wrenches that are passed on are uncertain by some units in their last place; squares of all that
  comes together at a joint, N, are summed inwards, and N / D are added to those of u.
* Accelerations of links are uncertain by some units in the last place of the largest on the way
  from the ground. An error of them costs no more energy than it has itself: H^-1 J^T I projects.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.frames import Transform
from adagen.executor.kinematics import Motion
from adagen.executor.segments import Articulated
from adagen.executor.state import State
from adagen.graph import Expression, Factors, factorize, matrix_times, total
from adagen.plan.certificate import ROUNDING
from adagen.plan.digits import EPSILON

Array = NDArray[Any]


class Certificate:
    """Bounds the error of an answer from what a process's memory holds after it.

    What is kept of links: ``("size", link)``, squares of angular and linear accelerations, shape
    (2,); ``("left", link)``, the wrench that the motion of the link and of all beyond takes, shape
    (6,); ``("noise", link)``, squares of moments (3) and forces that are passed on to it, shape
    (4,); ``("bare", link)``, under floating bases, force that the reference field takes of the link
    and all beyond (3), and their mass, shape (4,).

    Attributes:
        seen: parts of the square of the error that shows.
        rounded: parts of that of rounding, in units of the square of its unit.
    """

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion
        self.memory: dict[Any, Any] = state.memory
        self.bases = [
            j
            for j, joint in enumerate(state.plan.joints)
            if joint.kind == "floating" and joint.parent == 0
        ]
        self.seen: list[Expression] = []
        self.rounded: list[Expression] = []

    def reach(self, j: int) -> None:
        """Look at the link beyond a joint, whose acceleration is there: while it is at hand."""
        if j in self.bases:
            self._size_of_base(j)
        else:
            self._size(j)
        self._start(j + 1)

    def carry_out(self) -> None:
        """Find the squares of the energy norms of the error, as bounded, and of the answer."""
        inwards = [name[1] for name in list(self.memory) if _is(name, "articulated")]
        energies: list[Expression] = []
        for j in inwards:
            self._inwards(j)
            body: Articulated = self.memory["articulated", j]
            energies += [self._whole(j, x) for x in body.u[:, 0] * body.moved[:, 0]]
        for base in self.bases:
            self._error_of_base(base)
            energies.append(self._energy_of_base(base))
        unit = ROUNDING * EPSILON[self.state.plan.scalar]
        error = total(self.seen) + total(self.rounded) * unit**2
        self.state.certificate = (error, total(energies))

    def _square(self, numbers: Iterable[Expression]) -> Expression:
        """The sum of squares."""
        return total([self.state.graph.constant(0), *(x * x for x in numbers)])

    def _whole(self, j: int, x: Expression) -> Expression:
        """The sum of a row's numbers; of a single joint its own."""
        if j not in self.state.rows:
            return x
        found: Expression = self.state.graph.across(x, len(self.state.rows.own(j)))
        return found

    # -- how large accelerations are --------------------------------------------------------------

    def _turning(self, link: int) -> Expression:
        """The square of a link's angular acceleration."""
        return self._square(self.memory["a", link][:3, 0])

    def _size_of_base(self, j: int) -> None:
        size = [self._turning(j + 1), self._square(self.memory["a", j + 1][3:, 0])]
        self.memory["size", j + 1] = np.array(size, dtype=object)

    def _size(self, j: int) -> None:
        """What the accelerations of a joint's child link are added up from, no less than before."""
        ground = np.array([self.state.graph.constant(0), self._square(self.state.upwards())])
        turning, sliding = self.state.rows.of_near("size", j, ground)
        x: Transform = self.memory["X", j]
        terms = [sliding, turning * self._square(x.origin)]
        linear = [k for k, place in enumerate(self.state.kind(j).free) if place >= 3]
        if linear:
            _, v = self.state.configuration(j)
            spin = self._square(self.memory["field", j + 1].omega)
            terms.append(self._square(self.memory["accelerated", j][linear]))
            terms.append(spin * self._square(v[k] for k in linear) * 4)
        turning = self.state.graph.larger(turning, self._turning(j + 1))
        self.memory["size", j + 1] = np.array([turning, total(terms)], dtype=object)

    # -- the sweep --------------------------------------------------------------------------------

    def _start(self, link: int) -> None:
        """What a link by itself takes, and what is uncertain of its acceleration."""
        inertia, own = self.motion.link_inertia(link), self.motion.link_force(link)
        self.memory["left", link] = matrix_times(inertia, self.memory["a", link][:, 0]) + own
        self.memory["noise", link] = self._pushed(link)
        if self.bases:
            self.memory["bare", link] = np.array([*own[3:], inertia[3, 3]], dtype=object)
        turning, sliding = self.memory["size", link]
        trace = total(inertia[k, k] for k in range(3))
        energy = total([trace * turning, inertia[3, 3] * sliding])
        self.rounded.append(self._whole(link - 1, energy))

    def _pushed(self, link: int) -> Array:
        """Squares of moments and forces of outer forces: they may cancel what the motion takes."""
        noise = self.state.zeros(4)
        for push in self.motion.pushes(link):
            noise[:3] = noise[:3] + push[:3] * push[:3]
            noise[3] = noise[3] + self._square(push[3:])
        return noise

    def _noise(self, link: int) -> Array:
        """Squares of the moments and forces that come together at a link, shape (4,)."""
        left, passed = self.memory["left", link], self.memory["noise", link]
        moments = [total([passed[k], left[k] * left[k]]) for k in range(3)]
        force = total([passed[3], *(x * x for x in left[3:])])
        return np.array([*moments, force], dtype=object)

    def _inwards(self, j: int) -> None:
        """Hand on what a joint's far link takes; what that says of the error, squared."""
        x: Transform = self.memory["X", j]
        body: Articulated = self.memory["articulated", j]
        left, noise = self.memory["left", j + 1], self._noise(j + 1)
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
        self.state.rows.hand_on("noise", j, self._handed_noise(x, free, given, noise))
        if self.bases:
            bare = self.memory["bare", j + 1]
            own = np.array([*x.rotation.vector(bare[:3]), bare[3]], dtype=object)
            self.state.rows.hand_on("bare", j, own)

    def _handed_noise(self, x: Transform, free: list[int], given: Array, noise: Array) -> Array:
        """What a joint hands on of it: of its torques no more than they are themselves."""
        torques = dict(zip(free, given * given, strict=True))
        moments = [torques.get(k, noise[k]) for k in range(3)]
        turned = x.rotation.magnitudes(np.array(moments, dtype=object))
        arms = [[x.origin[(k + 1) % 3], x.origin[(k + 2) % 3]] for k in range(3)]
        levers = [self._square(arm) * noise[3] for arm in arms]
        return np.array([*(turned + np.array(levers, dtype=object)), noise[3]], dtype=object)

    def _weigh(self, j: int, factors: Factors, u: Array, noise: Array) -> None:
        """Add u^T M^-1 u to what is seen of the error, and what rounding may add to it."""
        y = factors.forward(u.reshape(-1, 1))[:, 0]
        rest: list[Expression] = []
        for k, inverse in enumerate(factors.inverses):
            row = factors.lower[k]
            rest.append(total([noise[k], *(row[i] * row[i] * rest[i] for i in range(k))]))
            self.seen.append(self._whole(j, y[k] * y[k] * inverse))
            self.rounded.append(self._whole(j, rest[k] * inverse))

    # -- floating bases ---------------------------------------------------------------------------

    def _error_of_base(self, j: int) -> None:
        """What is left over at a floating base, and what its acceleration of free fall rounds."""
        link, free = j + 1, list(self.state.kind(j).free)
        left, noise = self.memory["left", link].copy(), self._noise(link)
        left[free] = left[free] - self.state.torques(j)[:, 0]
        factors = factorize(self.memory["IA", link])
        self._weigh(j, factors, left, noise[[0, 1, 2, 3, 3, 3]])
        fall = self._square([*self._fall(j), *self.memory["a", link][3:, 0]])
        self.rounded.append(self.memory["bare", link][3] * fall)

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
