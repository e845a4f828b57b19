"""Certificates of processes that gather at an inner root, neither the base nor the ground.

Links are reached from that root, and residuals are swept towards it. If the ground is beyond the
root, the joints between it and a link h have a mobility at h, whose inverse acts as a body
(``HoldMobility``). The force at h between these joints and the rest may be chosen freely; it is the
one that acted in the evaluation, so that both residuals are small. The residual of the joints up to
h costs no more than if only this force acted on them, and the lengths of both errors are added. The
answer has the motion of h as computed from the ground. Its difference from that as computed from
the root is added as for limbs of other processes (shared_bound.py).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.frames import Transform
from adagen.executor.kinematics import Motion
from adagen.executor.state import State
from adagen.graph import Expression, total
from adagen.model.paths import path_to_ground
from adagen.plan.limb_spread import beyond_held
from adagen.plan.steps import Articulate, LoadRoot, SolveMobility, SolveRoot, Step

Array = NDArray[Any]


class InnerRoot:
    """The root where processes gather, as a process's certificate needs it.

    What is kept of links: ``("fall", link)``, by how much a base falls, in the link's frame, shape
    (3,).

    Attributes:
        steps: of the process.
        bases: joints by which robots float.
        roots: links that all inertias are swept to.
        reversed: joints whose parent link is the far one.
        held: the link that the ground holds, or a root whose mobility is shown; 0 for none.
        shown: the mobility of such a root.
        beyond: joints that are not between the ground and that link.
    """

    def __init__(
        self, state: State, motion: Motion, steps: Sequence[Step], bases: Sequence[int]
    ) -> None:
        self.state, self.motion, self.steps, self.bases = state, motion, steps, bases
        self.memory: dict[Any, Any] = state.memory
        self.roots = [step.link for step in steps if isinstance(step, SolveRoot)]
        swept = [step for step in steps if isinstance(step, Articulate)]
        self.reversed = {step.joint for step in swept if step.reversed}
        self.held = next((step.link for step in steps if isinstance(step, LoadRoot)), 0)
        shown = (step for step in steps if isinstance(step, SolveMobility))
        self.shown = next((step.block for step in shown if step.link == self.held), None)
        self._aside: tuple[Array, Array] | None = None
        every = range(len(state.plan.joints))
        self.beyond = beyond_held(state.plan, steps) if self.held else list(every)

    def fall_at(self, j: int, *, root: bool) -> Array:
        """Return the free fall of a base in the frame of a joint's child link, shape (3,).

        That of a root is known first, and with it those on the way to the base.
        """
        if not self.bases:
            return self.state.zeros(3)
        if root:
            self._on_the_way(j)
        elif ("fall", j + 1) not in self.memory:
            near = self.state.rows.of_near("fall", j, self.state.zeros(3))
            self.memory["fall", j + 1] = self._beyond(j, near)
        found: Array = self.memory["fall", j + 1]
        return found

    def _on_the_way(self, j: int) -> None:
        way = path_to_ground(self.state.plan.joints, j + 1)
        drift = self.motion.drift(way[-1])
        assert drift is not None  # a floating base has one
        self.memory["fall", way[-1] + 1] = fall = drift[3:, 0]
        for k in reversed(way[:-1]):
            self.memory["fall", k + 1] = fall = self._beyond(k, fall)

    def _beyond(self, j: int, near: Array) -> Array:
        x: Transform = self.memory["X", j]
        return x.rotation.transposed().vector(near)

    def energies(self, link: int, inertia: Array, a: Array, taken: Array) -> Iterator[Expression]:
        """Yield the terms of the energy of a link's acceleration, less a base's free fall d.

        That is a^T I a - 2 d^T f + m d^T d, with f the force of I a.
        """
        yield total(a * taken)
        if self.bases:
            fall = self.memory["fall", link]
            yield total(fall * (fall * inertia[3, 3] - taken[3:] * 2))

    def load(self, square: Callable[[Iterable[Expression]], Expression], *, of_rest: bool) -> None:
        """Apply the force on a held link to it, or to the links beyond.

        Args:
            square: the sum of squares.
            of_rest: on what is beyond, for which the link takes the opposite of it.
        """
        if not self.held:
            return
        link = self.held
        load = self.memory["load", self.held][:, 0]
        noise = np.array([*(load[:3] * load[:3]), square(load[3:])], dtype=object)
        if not of_rest:
            self.memory["left", link] = self.memory["left", link] - load
            self.memory["noise", link] = self.memory["noise", link] + noise
            return
        self.memory["left", link], self.memory["noise", link] = load, noise
        if self._aside is not None:
            self.memory["left", link] = load + self._aside[0]
            self.memory["noise", link] = noise + self._aside[1]

    def set_aside(self, add: Callable[[], Any]) -> Any:
        """Store what ``add`` adds at a root of known mobility separately: it is of the rest."""
        if self.shown is None:
            return add()
        names = ("left", self.held), ("noise", self.held)
        own = [self.memory[name] for name in names]
        for name, size in zip(names, (6, 4), strict=True):
            self.memory[name] = self.state.zeros(size)
        found = add()
        self._aside = self.memory[names[0]], self.memory[names[1]]
        for name, each in zip(names, own, strict=True):
            self.memory[name] = each
        return found

    def apart(self) -> Array:
        """Return the difference of the held link's accelerations from both sides."""
        link = self.held
        found: Array = self.memory["a", link][:, 0] - self.memory["unheld", link][:, 0]
        return found
