"""What rounding may do to an answer: squares that are summed outwards and inwards.

What a certificate's residual cannot see is its own rounding, and that of the kinematics that it
shares with the answer. Two terms allow for that (docs/explanation/certificates.md has the
derivation):

* Wrenches that are passed on are uncertain by some units in their last place; squares of all that
  comes together at a joint, N, are summed inwards, and N / D are added to the error's square.
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
from adagen.executor.state import State
from adagen.graph import Expression, Factors, total

Array = NDArray[Any]


class Allowance:
    """Sums what rounding may add to the square of an answer's error.

    What is kept of links: ``("size", link)``, squares of angular and linear accelerations, shape
    (2,); ``("left", link)``, the wrench that the motion of the link and of all beyond takes, shape
    (6,); ``("noise", link)``, squares of moments (3) and forces that are passed on to it, shape
    (4,).

    Attributes:
        rounded: the parts, in units of the square of a certificate's unit.
    """

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion
        self.memory: dict[Any, Any] = state.memory
        self.bases = [
            j
            for j, joint in enumerate(state.plan.joints)
            if joint.kind == "floating" and joint.parent == 0
        ]
        self.rounded: list[Expression] = []

    def square(self, numbers: Iterable[Expression]) -> Expression:
        """The sum of squares."""
        return total([self.state.graph.constant(0), *(x * x for x in numbers)])

    def count(self, j: int) -> int:
        """How many joints are treated as a joint."""
        return len(self.state.rows.own(j))

    def summed(self, x: Expression, count: int) -> Expression:
        """The sum of the first numbers of a row; of a single joint its own."""
        found: Expression = self.state.rows.sum_of(np.array(x, object), count).item()
        return found

    def whole(self, j: int, x: Expression) -> Expression:
        """The sum of a joint's row."""
        return self.summed(x, self.count(j))

    # -- how large accelerations are --------------------------------------------------------------

    def turning(self, link: int) -> Expression:
        """The square of a link's angular acceleration."""
        return self.square(self.memory["a", link][:3, 0])

    def size(self, j: int) -> None:
        """What a joint's child link's accelerations are added up from, no less than before."""
        if j in self.bases:
            size = [self.turning(j + 1), self.square(self.memory["a", j + 1][3:, 0])]
            self.memory["size", j + 1] = np.array(size, dtype=object)
            return
        ground = np.array([self.state.graph.constant(0), self.square(self.state.upwards())])
        turning, sliding = self.state.rows.of_near("size", j, ground)
        x: Transform = self.memory["X", j]
        terms = [sliding, turning * self.square(x.origin)]
        linear = [k for k, place in enumerate(self.state.kind(j).free) if place >= 3]
        if linear:
            _, v = self.state.configuration(j)
            spin = self.square(self.memory["field", j + 1].omega)
            terms.append(self.square(self.memory["accelerated", j][linear]))
            terms.append(spin * self.square(v[k] for k in linear) * 4)
        turning = self.state.graph.larger(turning, self.turning(j + 1))
        self.memory["size", j + 1] = np.array([turning, total(terms)], dtype=object)

    def uncertain_motion(self, link: int, inertia: Array) -> None:
        """Add the energy of what is uncertain of a link's acceleration."""
        turning, sliding = self.memory["size", link]
        trace = total(inertia[k, k] for k in range(3))
        energy = total([trace * turning, inertia[3, 3] * sliding])
        self.rounded.append(self.whole(link - 1, energy))

    # -- what is passed on ------------------------------------------------------------------------

    def pushed(self, link: int) -> Array:
        """Squares of moments and forces of outer forces: they may cancel what the motion takes."""
        noise = self.state.zeros(4)
        for push in self.motion.pushes(link):
            noise[:3] = noise[:3] + push[:3] * push[:3]
            noise[3] = noise[3] + self.square(push[3:])
        return noise

    def noise_at(self, link: int) -> Array:
        """Squares of the moments and forces that come together at a link, shape (4,)."""
        left, passed = self.memory["left", link], self.memory["noise", link]
        moments = [total([passed[k], left[k] * left[k]]) for k in range(3)]
        force = total([passed[3], *(x * x for x in left[3:])])
        return np.array([*moments, force], dtype=object)

    def handed_noise(self, x: Transform, free: list[int], given: Array, noise: Array) -> Array:
        """What a joint hands on of it: of its torques no more than they are themselves."""
        torques = dict(zip(free, given * given, strict=True))
        moments = [torques.get(k, noise[k]) for k in range(3)]
        turned = x.rotation.magnitudes(np.array(moments, dtype=object))
        arms = [[x.origin[(k + 1) % 3], x.origin[(k + 2) % 3]] for k in range(3)]
        levers = [self.square(arm) * noise[3] for arm in arms]
        return np.array([*(turned + np.array(levers, dtype=object)), noise[3]], dtype=object)

    def weigh_noise(self, count: int, factors: Factors, noise: Array) -> Array:
        """Add what rounding may add to the energy of what has these factors, squares of it given.

        Args:
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
            self.rounded.append(self.summed(rest[k] * inverse, count))
        return np.array(rest, dtype=object)
