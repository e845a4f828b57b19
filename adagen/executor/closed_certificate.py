"""A bound of an answer's error for robots with closed loops.

The residual of the answer is swept inwards once more, as for a correction (corrections.py). Each
elimination adds its part of the squared energy norm, so that no outward sweep is needed; the
residual of the rows is a separate term. Allowances for rounding are summed as for trees
(allowance.py). The unknowns of a closure pass on all wrenches at their joints, and their part uses
the inertia of the independent accelerations. Rows are as uncertain as the accelerations at their
ends; the resulting change of the dependent accelerations has at most the energy of moving these
alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.allowance import Allowance, Sums
from adagen.executor.corrections import Corrections
from adagen.executor.front import End, Front
from adagen.executor.repeatable import Repeatable
from adagen.executor.residuals import Energies, Residuals
from adagen.executor.segments import Articulated
from adagen.executor.swept_records import outermost
from adagen.executor.swept_rows import SweptRows
from adagen.graph import Expression, Graph, factorize, total
from adagen.plan.arms import WideUnknown
from adagen.plan.certificate import ROUNDING
from adagen.plan.digits import EPSILON
from adagen.plan.steps import Articulate, Certify, Eliminate, HoldBack, SolveRoot, StartLink, Step

Array = NDArray[Any]


class ClosedCertificate(Allowance):
    """Bounds the error of an answer by the residuals of one correction."""

    def __init__(self, machine: Repeatable, corrections: Corrections) -> None:
        super().__init__(machine, machine.motion)
        self.machine, self.corrections, self.seen = machine, corrections, Sums(machine)
        self.held: dict[int, dict[int, Expression]] = {}
        self.unit = ROUNDING * EPSILON[machine.plan.scalar]
        self.loop: SweptRows | None = None  # of the outermost rows of joints, in long lines
        self._in_loop: set[int] = set()
        self._begun = False

    def reach(self, j: int, **_: bool) -> None:
        """Look at the link beyond a joint, whose acceleration is there; roots are bases here."""
        self.size(j, self.motion.link_inertia(j + 1))

    def carry_out(self, _: Certify) -> None:
        """Compute the squared energy norms of the error's bound and of the answer."""
        self.uncertain_motions()
        error = self.seen.total() + self.rounded.total() * self.unit**2
        self.state.certificate = (error, self._energy_of_answer())

    def _energy_of_answer(self) -> Expression:
        """The squared energy norm of the answer, from its links and rotors."""
        corrections, sums = self.corrections, Sums(self.machine)
        answer, energies = corrections.answer(), corrections.energies()
        if self.loop is not None:
            self._energy_in_loop(self.loop, energies, sums)
        for link in energies.links:
            if link - 1 in self._in_loop:
                continue
            with self.when_reached(link):
                energy = energies.in_fall(link, answer.links[link])
                sums.add(self.run(link - 1), self.count(link - 1), energy)
        for j, qdd in answer.joints.items():
            with self.when_reached(j + 1):
                rotor = energies.of_rotor(j, qdd)
                if rotor is not None:
                    sums.add(self.run(j), self.count(j), rotor)
        return sums.total()

    # -- in a loop --------------------------------------------------------------------------------

    closed = True

    def wrench_at(self, link: int) -> Array:
        """Return the wrench that the reference field and loops take of a link, shape (6,)."""
        memory = self.corrections.current.memory
        return self.motion.field_force(link) + memory["held", link]  # type: ignore[no-any-return]

    def squares_at(self, link: int) -> Array:
        """Return those of forces that act on it by themselves, shape (4,)."""
        squares: Array = self.memory["noise", link]
        return squares

    def torque_at(self, j: int) -> Expression:
        """Return the torque of a joint, less what its rotor and couplings take."""
        return self.corrections.current.torques(j)[0, 0]  # type: ignore[no-any-return]

    def begin(self, step: Step) -> None:
        """Have a loop sweep the outermost rows; the links within gather what is left over."""
        if self._begun or not isinstance(step, Articulate | HoldBack | Eliminate | SolveRoot):
            return
        self._begun = True
        looped = self._outermost()
        if not looped:
            return
        residual = self.corrections.current
        self.loop = loop = SweptRows(self, looped)
        self.state.swept = loop.swept
        self._in_loop = set(looped)
        assert isinstance(residual.left, Residuals)
        residual.left.in_loop = frozenset(self._in_loop)
        for j in self._in_loop:
            p = self.state.zeros(6, 1)
            if loop.holds(j):
                p[loop.along(j), 0], _ = loop.held(j)
            residual.memory["pA", j + 1] = p
        for link in loop.gather:
            left, noise, _ = loop.gathered(link)
            residual.memory["pA", link] = residual.memory["pA", link] + left[:, None]
            self.memory["noise", link] = self.memory["noise", link] + noise
        seen, rounded, _ = loop.summed()
        self.seen.add("loop", 1, seen)
        self.rounded.add("loop", 1, rounded)

    def _outermost(self) -> list[int]:
        """The rows of joints that a loop sweeps, beyond the tops of closures."""
        asked = max((step.looped for step in self.state.plan.steps_of(Certify)), default=0)
        if not asked or self.motion.rod_halves or not isinstance(self.state.graph, Graph):
            return []  # numbers need none
        steps = self.corrections.in_order()
        inwards = [step.joint for step in steps if isinstance(step, Articulate | HoldBack)]
        tops = (step.link for step in self.corrections.steps if isinstance(step, Eliminate))
        return outermost(self.state.rows, inwards, asked, tops)

    def _energy_in_loop(self, loop: SweptRows, energies: Energies, sums: Sums) -> None:
        """That of links in the loop, less free fall d: a^T I a - 2 d^T P + m d^T d."""
        sums.add("loop", 1, loop.summed()[2])
        for j in sorted(self._in_loop):  # of masses that are set at run time
            sums.add(self.run(j), self.count(j), loop.energy(j))
        masses = loop.masses() if self.bases else {}
        for link, (mass,) in masses.items():
            _, _, force = loop.gathered(link)
            run, count = self.run(link - 1), self.count(link - 1)
            sums.add(run, count, energies.of_fall(link, force, mass))

    # -- sweeps -----------------------------------------------------------------------------------

    def swept(self, step: Step) -> None:
        """Add a step's squared residual error, and its allowance for rounding."""
        if not self.state.plan.certified:
            return
        residual = self.corrections.current
        match step:
            case StartLink(link):
                held = residual.memory["held", link]
                self.memory["noise", link] = self.pushed(link) + self._of_wrench(held)
            case Articulate(j) if j in self._in_loop:
                pass
            case Articulate(j):
                self._pass_articulated(j)
                body: Articulated = residual.memory["articulated", j]
                for energy in body.u[:, 0] * body.moved[:, 0]:
                    self.seen.add(self.run(j), self.count(j), energy)
            case HoldBack():
                self._pass_held(step)
            case Eliminate():
                front, left = (x.closures.fronts[step.closure] for x in (self.machine, residual))
                if front.first:
                    self._eliminate(step, front, left)
                    assert left.reduced is not None  # others are not certified
                    for freed in left.reduced.freed:
                        count = self._lanes(step, freed.unknowns)
                        self.seen.add(self._closure(step), count, freed.energy)
            case SolveRoot(link):
                self._at_root(link)
                a, p = residual.memory["a", link], residual.memory["pA", link]
                self.seen.add(self.run(link - 1), 1, -total(p[:, 0] * a[:, 0]))

    def _closure(self, step: Eliminate) -> tuple[str, int]:
        """Names of the sums of a closure's elimination."""
        return ("closure", step.closure)

    def _of_wrench(self, wrench: Array) -> Array:
        """Squares of moments and force, shape (4,)."""
        squares = wrench * wrench
        return np.array([*squares[:3], total(squares[3:])], dtype=object)

    def noise_at(self, link: int) -> Array:
        """Squares of all moments and forces at a link, shape (4,)."""
        self.memory["left", link] = self.corrections.current.memory["pA", link][:, 0]
        return super().noise_at(link)

    # -- joints -----------------------------------------------------------------------------------

    def _pass_articulated(self, j: int) -> None:
        body: Articulated = self.memory["articulated", j]
        noise, free = self.noise_at(j + 1), list(self.state.kind(j).free)
        spent = self.state.spent_squares(j)
        noise_along = noise[[min(k, 3) for k in free]] + spent
        self.weigh_noise(self.run(j), self.count(j), body.factors, noise_along)
        given = self.state.torques(j)[:, 0]
        self._hand_on(j, free, given, spent, noise)

    def _pass_held(self, step: HoldBack) -> None:
        """Squares at a joint whose acceleration is an unknown: its own, and all passed on."""
        j = step.joint
        noise = self._held_noise(j) if j in self._in_loop else self.noise_at(j + 1)
        front = self.machine.closures.fronts[step.closure]
        tied = [
            front.forces[unknown] * factor
            for unknown, factor in front.ties.get(j, [])
            if unknown in front.forces
        ]
        own, arm_lanes = self.held.setdefault(step.closure, {}), self.machine.closures.arm_lanes
        firsts = [front.first[each] for each in arm_lanes.holds.get(j, (j,))]
        spent = self.state.spent_squares(j)
        for k, row in enumerate(self.state.kind(j).free):
            squares = total([noise[min(row, 3)], spent[k], *(x * x for x in tied)])
            here = arm_lanes.each(squares, len(firsts))
            own.update((first + k, x) for first, x in zip(firsts, here, strict=True))
        if j not in self._in_loop:
            self._hand_on(j, [], self.state.zeros(0), self.state.zeros(0), noise)

    def _held_noise(self, j: int) -> Array:
        """Squares at a joint that a loop sweeps, of which only those along it count here."""
        assert self.loop is not None
        noise = self.state.zeros(4)
        _, noise[min(self.loop.along(j), 3)] = self.loop.held(j)
        return noise

    def _hand_on(self, j: int, free: list[int], given: Array, spent: Array, noise: Array) -> None:
        if any(self.state.rows.near_links(j)):
            passed = self.handed_noise(j, free, given, spent, noise)
            self.state.rows.hand_on("noise", j, passed)

    # -- closures ---------------------------------------------------------------------------------

    def _eliminate(self, step: Eliminate, front: Front, left: Front) -> None:
        """Effect of the unknowns' rounding on independent accelerations and on the top.

        Args:
            step: what eliminates them.
            front: the closure as it was answered.
            left: the same with what the answer leaves over.
        """
        reduced, noise = front.reduced, self.held[step.closure]
        assert reduced is not None  # others are not certified
        for each in reduced.followed:
            own, count = self._noise_of(noise, each.unknowns), self._lanes(step, each.unknowns)
            self._hand_over(noise, each.others, each.gained, own, len(each.unknowns[0]))
            rows = np.array([self._of_row(front, left, row) for row in each.rows], dtype=object)
            for energy in each.moves(rows) * each.inertia:
                self.rounded.add(self._closure(step), count, energy)
            if step.link and any(x.constant != 0 for x in each.across.flat):
                self._hand_to_top(step, each.across, own, len(each.unknowns[0]))
        for freed in reduced.freed:
            own, count = self._noise_of(noise, freed.unknowns), self._lanes(step, freed.unknowns)
            rest = self.weigh_noise(self._closure(step), count, freed.factors, own)
            self._hand_over(noise, freed.others, freed.gained, rest, len(freed.unknowns[0]))

    def _lanes(self, step: Eliminate, unknowns: Sequence[WideUnknown]) -> int:
        """Number of arms, or closures, of wide unknowns."""
        closures = self.machine.closures.lanes(step.closure)
        return max(len(unknowns[0]), len({lane.number for lane in closures}))

    def _noise_of(self, noise: dict[int, Expression], unknowns: Sequence[WideUnknown]) -> Array:
        """Squares at unknowns, shape (n,)."""
        joined = self.state.rows.joined
        return np.array([joined([noise[u] for u in own]) for own in unknowns], dtype=object)

    def _hand_over(
        self,
        noise: dict[int, Expression],
        others: Sequence[WideUnknown],
        gained: Array,
        own: Array,
        count: int,
    ) -> None:
        """Add the squares at dependent unknowns to those that they depend on."""
        for k, wide_unknown in enumerate(others):
            handed = total((gained[:, k] * gained[:, k]) * own)
            if len(wide_unknown) == 1:
                each = [self.state.rows.summed(handed, count)]
            else:
                each = self.machine.closures.arm_lanes.each(handed, count)
            for unknown, x in zip(
                wide_unknown, each, strict=True
            ):  # those of a basis have none before
                noise[unknown] = noise[unknown] + x if unknown in noise else x

    def _hand_to_top(self, step: Eliminate, across: Array, moved: Array, arms: int) -> None:
        """Pass squares at unknowns that depend on the top's acceleration to the top."""
        parts = [total((across[:, i] * across[:, i]) * moved) for i in range(6)]
        lanes = self.machine.closures.lanes(step.closure)
        tops = [lane.eliminate.link for lane in lanes]
        count = len(dict.fromkeys(lane.eliminate.closure for lane in lanes))
        handed = np.array([*parts[:3], total(parts[3:])], dtype=object)
        self.state.rows.add("noise", tops, count, self.state.rows.sum_of(handed, arms))

    def _of_row(self, front: Front, left: Front, wide_unknown: WideUnknown) -> Expression:
        """Squared residual of a row, and of the terms in its sum, in squares of units.

        Rows of alike arms are looked at together, also where what follows from them is not.
        """
        if wide_unknown not in left.gaps:
            wide = next(own for own in left.gaps if wide_unknown[0] in own)
            each = self.machine.closures.arm_lanes.each(self._of_row(front, left, wide), len(wide))
            return each[wide.index(wide_unknown[0])]
        gap = left.gaps[wide_unknown] * (1 / self.unit)
        terms = [gap * gap]
        for end in front.ends:
            if wide_unknown not in end.columns:
                continue
            column, field = end.columns[wide_unknown], self.motion.field_of_all(end.links)
            ground = np.array([self.state.graph.constant(0)] * 2, dtype=object)
            turning, sliding = self.state.rows.of_links("size", end.links, ground)
            spin = self.square(field.omega)
            turning = total([turning, self.square(field.alpha), spin * spin])
            lever, along = self._sizes_of(end, column)
            terms.append(turning * lever)
            terms.append(total([sliding, self.square(field.a)]) * along)
        for j, ties in front.ties.items():
            for tied, factor in ties:
                if (tied,) == wide_unknown:
                    moved = self.memory["accelerated", j][0] * factor
                    terms.append(moved * moved)
        return total(terms)

    def _sizes_of(self, end: End, column: Array) -> tuple[Expression, Expression]:
        """Upper bounds of |column[:3]|^2 and |column[3:]|^2 of a row; exact where constant.

        The direction d of a row is a unit vector or the product of two; the lever of a row of
        places is arm x d. With |arm|^2 for its square, all rows of a point have the same bound.
        """
        one, exact = self.state.graph.constant(1), (column[:3], column[3:])
        places = any(x.constant != 0 for x in column[3:])
        most = (self.square(end.arm), one) if places else (one, self.square(column[3:]))
        lever, along = (
            self.square(part) if all(x.constant is not None for x in part) else bound
            for part, bound in zip(exact, most, strict=True)
        )
        return lever, along

    # -- floating bases ---------------------------------------------------------------------------

    def _at_root(self, link: int) -> None:
        """Squares at a floating base, and the rounding of its free fall."""
        noise = self.noise_at(link)
        factors = factorize(self.memory["IA", link])
        self.weigh_noise(link - 1, self.count(link - 1), factors, noise[[0, 1, 2, 3, 3, 3]])
        drift = self.motion.drift(link - 1)
        if drift is None:
            return
        links = self.corrections.links()
        masses = [self.state.rows.whole(each - 1, self.state.rows.mass(each)) for each in links]
        fall = self.square([*drift[3:, 0], *self.memory["a", link][3:, 0]])
        self.rounded.add(link - 1, 1, total(masses) * fall)
