"""Certificates of a chain that one process has in parts (adagen/plan/parts.py).

Each part is weighed as if it floated and nothing but the wrenches on its ends acted on it that were
found in the evaluation. Whatever these are, they do no work on motions that the joints between
parts allow, if along each joint they are its torque. So the residual of a part costs no more than
if it floated: that of its joints by their own factors, and at its first link by the mobility there.

The answer has other accelerations of first links than the parts: those that follow from the links
before them. By the difference a part moves as one body; its energy is added as a length
(docs/explanation/certificates.md has the derivation).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.allowance import Allowance
from adagen.executor.frames import Transform
from adagen.graph import Expression, total
from adagen.plan.steps import InvertRoot, Join, Load, Step

Array = NDArray[Any]
_ANGULAR, _LINEAR = range(3), range(3, 6)


class FloatingParts:
    """The parts of a chain, as a process's certificate needs them.

    Attributes:
        roots: the mobilities of the parts' first links, by link, outwards.
    """

    def __init__(self, found: Allowance, steps: Sequence[Step]) -> None:
        self.found, self.state, self.memory = found, found.state, found.memory
        inverted = [step for step in steps if isinstance(step, InvertRoot)]
        self.roots = {step.link: step.block for step in sorted(inverted, key=lambda s: s.link)}
        self.loads = {
            step.link: step.force
            for step in steps
            if isinstance(step, Load) and step.force is not None
        }

    @staticmethod
    def of(found: Allowance, steps: Sequence[Step]) -> FloatingParts | None:
        """Return the parts of a process's chain; None where it joins none."""
        joins = any(isinstance(step, Join) for step in steps)
        return FloatingParts(found, steps) if joins and not found.state.plan.several else None

    def load(self) -> None:
        """Take the wrenches on the parts' ends for outer forces.

        Along a joint between parts that is its torque, to the bit, and the last link before it
        takes the opposite, to the bit.
        """
        for link, name in self.loads.items():
            if link not in self.roots:
                continue
            j = link - 1
            x: Transform = self.memory["X", j]
            free = list(self.state.kind(j).free)
            force = self.memory[name][:, 0].copy()
            force[free] = self._driving(j)
            spent = self.state.spent_squares(j)
            noise = np.array([*(force[:3] * force[:3]), self.found.square(force[3:])], object)
            noise = self.found.torques_in(free, force[free], spent, noise)
            self._add(link, -force, noise)
            if self.state.plan.joints[j].parent:
                handed = self.found.handed_noise(j, free, force[free], spent, noise)
                self._add(link - 1, x.force(force), handed)

    def _driving(self, j: int) -> Array:
        given, rotor = self.state.torques(j)[:, 0], self.state.rotor(j)
        return given if rotor is None else given - self.memory["accelerated", j] * rotor

    def _add(self, link: int, left: Array, noise: Array) -> None:
        self.memory["left", link] = self.memory["left", link] + left
        self.memory["noise", link] = self.memory["noise", link] + noise

    def shown(self, unit: float) -> Iterator[tuple[int, Array, Expression]]:
        """Yield each first link, its mobility, and what is known of the least pivots of that.

        With the link's inertia M = [[A, B], [B^T, C]], a pivot is uncertain by units of the entry
        that it was subtracted from: by a part of tr(A) and tr(C) times the traces of its inverse.

        Args:
            unit: of rounding, as certificates allow for it.
        """
        one = self.state.graph.constant(1)
        for link, block in self.roots.items():
            phi, inertia = self.memory[block], self.memory["IA", link]
            lost = [
                total(phi[k, k] for k in half) * total(inertia[k, k] for k in half)
                for half in (_ANGULAR, _LINEAR)
            ]
            yield link, phi, total([one, *(x * -unit for x in lost)])

    def apart(self) -> list[Expression]:
        """Return squared energies of parts that move as the links before them have it.

        Also adds what of that may be rounding. Of x angular and y linear at its first link a part
        takes at most K |x|^2 + M |y|^2, with distances d from there

            K = sum tr(I) + 4 sum m d^2,    M = 4 sum m.

        A link's motion is uncertain by what turns any link before it, over the whole way from
        there: at most the sum of squares of the parts' spans, times their number.
        """
        zero = self.state.graph.constant(0)
        off, turns, slides, way = self.state.zeros(6), zero, zero, zero
        last: Array = self.state.zeros(6)
        spent = np.array([zero, self.found.square(self.state.upwards())], object)
        span: Array = self.state.zeros(3)
        taken: list[Expression] = []
        for number, link in enumerate(self.roots):
            x: Transform = self.memory["X", link - 1]
            own = self.memory["a", link][:, 0]
            seen = x.motion(last)
            free = list(self.state.kind(link - 1).free)
            seen[free] = seen[free] + self.memory["accelerated", link - 1]
            off = x.motion(off) + seen - own
            arm = self.found.square(span + x.origin) if number else zero
            turns = total([turns, spent[0], self.found.square(own[:3])])
            slides = total([slides, spent[1], arm * spent[0], self.found.square(own[3:])])
            way = way + arm
            joints = self._inside(link)
            turning, sliding, span = self._spread(link, joints)
            slid = total([slides, turns * way * len(self.roots)])
            end = joints[-1] + 1
            spent = self.memory["size", end]
            both = total([turning * (turns + spent[0]), sliding * slid])
            self.found.rounded.add(("apart", link), 1, both)
            taken += [turning * self.found.square(off[:3]), sliding * self.found.square(off[3:])]
            for j in joints:
                off = self.memory["X", j].motion(off)
            last = self.memory["a", end][:, 0]
        return taken

    def _inside(self, root: int) -> range:
        """The joints of a part, by its first link."""
        ends = [*list(self.roots)[1:], len(self.state.plan.joints) + 1]
        return range(root, next(end for end in ends if end > root) - 1)

    def _spread(self, root: int, joints: range) -> tuple[Expression, Expression, Array]:
        """K and M of a part, and the way from its first link to its last, in the last one's axes.

        Squares of distances are those in any axes.
        """
        way: Array = self.state.zeros(3)
        turning, masses = list[Expression](), list[Expression]()
        for link in (root, *(j + 1 for j in joints)):
            if link != root:
                x: Transform = self.memory["X", link - 1]
                way = x.rotation.transposed().vector(way + x.origin)
            inertia = self.found.motion.link_inertia(link)
            turning += [inertia[k, k] for k in _ANGULAR]
            turning.append(self.found.square(way) * inertia[3, 3] * 4)
            masses.append(inertia[3, 3] * 4)
        return total(turning), total(masses), way
