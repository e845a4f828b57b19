"""What the steps of closed loops mean (adagen/plan/steps/closed.py).

A closure is the stationary point of a quadratic function of its links' accelerations a, and of its
unknowns w, accelerations held back and constraint forces: a^T I^A a / 2 + a^T p^A + w^T (C^T a)
+ w^T E w / 2 + w^T e. Whatever is eliminated leaves such a function of what is left. A column of C
is kept for each link and unknown that act on each other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import SINGULAR, Check
from adagen.executor.frames import Transform, columnwise
from adagen.executor.kinematics import Field, Motion
from adagen.executor.loop_frames import LoopFrames
from adagen.executor.state import State
from adagen.graph import (
    Expression,
    Factors,
    cross,
    dot,
    factorize,
    matrix_times,
    reflect,
    solved_by_reflections,
    total,
)
from adagen.plan.digits import EPSILON
from adagen.plan.steps import (
    AccelerateHeld,
    CarryRows,
    CloseCoupling,
    CloseLoop,
    Eliminate,
    HoldBack,
    Release,
)
from adagen.plan.types import FACTORS

Array = NDArray[Any]
ClosedStep = CloseLoop | CloseCoupling | HoldBack | CarryRows | Eliminate | Release | AccelerateHeld

FOLLOWS = 1e-3
"""How far a row that is left out may be from following, relative to its size: where loops are open
within their tolerance, it is so far."""

LEAST = {"double": 1e-7, "float": 1e-3}
"""Pivots of rows, brought to one size, below which a pose counts as singular."""

MOST_LOST = 0.1
"""Digits that the size of G may cost, as a part of half of all."""

RATES = 10.0
"""1/s: how fast a loop may open, beside how far it may be open, where joints move by 1 rad/s."""


@dataclass(frozen=True)
class Solved:
    """Unknowns that follow from the top's acceleration and others: w = across a + more w' + bias.

    Attributes:
        unknowns: their numbers.
        across: shape (n, 6).
        others: numbers of the others.
        more: shape (n, m).
        bias: shape (n, columns).
    """

    unknowns: tuple[int, ...]
    across: Array
    others: tuple[int, ...]
    more: Array
    bias: Array


@dataclass
class Front:
    """A closure on its way inwards.

    Attributes:
        columns: C by link and unknown, shape (6,) each.
        square: E by pairs of unknowns, the smaller one first; those that are not there are zero.
        bias: e by unknown, shape (columns,).
        solved: what has been eliminated, in the order in which it is found outwards.
        carried: joints that were articulated, with their rows of C, by unknown, shape (n,) each.
        found: w by unknown, shape (columns,), on the way outwards.
        ties: unknowns of couplings with factors, by joint.
        places: what each unknown is blamed on: its joint; a loop, coupling, counted behind joints.
        first: number of the first unknown of each joint that was held back.
    """

    columns: dict[int, dict[int, Array]] = field(default_factory=dict)
    square: dict[tuple[int, int], Expression] = field(default_factory=dict)
    bias: dict[int, Array] = field(default_factory=dict)
    solved: list[Solved] = field(default_factory=list)
    carried: dict[int, dict[int, Array]] = field(default_factory=dict)
    found: dict[int, Array] = field(default_factory=dict)
    ties: dict[int, list[tuple[int, float]]] = field(default_factory=dict)
    places: dict[int, int] = field(default_factory=dict)
    first: dict[int, int] = field(default_factory=dict)

    def add_column(self, link: int, unknown: int, column: Array) -> None:
        """Add to what an unknown and a link's acceleration do to each other."""
        own = self.columns.setdefault(link, {})
        own[unknown] = own[unknown] + column if unknown in own else column

    def add(self, i: int, k: int, value: Expression) -> None:
        """Add to an entry of E."""
        if value.constant == 0:
            return
        key = (min(i, k), max(i, k))
        self.square[key] = self.square[key] + value if key in self.square else value

    def entry(self, i: int, k: int) -> Expression | None:
        """Return an entry of E; None for zero."""
        return self.square.get((min(i, k), max(i, k)))

    def add_bias(self, unknown: int, value: Array) -> None:
        """Add to e, shape (columns,)."""
        self.bias[unknown] = self.bias[unknown] + value if unknown in self.bias else value


class Closures:
    """Executes the steps of closed loops on a process's memory."""

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion
        self.memory: dict[Any, Any] = state.memory
        self.fronts: dict[int, Front] = {}

    def step(self, step: ClosedStep) -> None:
        """Do one step."""
        front = self.fronts.setdefault(step.closure, Front())
        match step:
            case CloseLoop():
                self._close_loop(step, front)
            case CloseCoupling():
                self._close_coupling(step, front)
            case HoldBack():
                self._hold_back(step, front)
            case CarryRows():
                self._carry(step, front)
            case Eliminate():
                self._eliminate(step, front)
            case Release():
                self._release(step, front)
            case AccelerateHeld():
                self._accelerate(step, front)

    # -- constraints ------------------------------------------------------------------------------

    def _close_loop(self, step: CloseLoop, front: Front) -> None:
        loop = self.state.plan.loops[step.loop]
        frames = LoopFrames(self.state, loop)
        place = len(self.state.plan.joints) + step.loop
        joints = (*frames.one.joints, *frames.two.joints)
        self._refuse_open(place, frames.gap(), frames.rate(), joints, loop.tolerance)
        fields = [self._field(link) for link in (loop.link1, loop.link2)]
        for unknown, number in enumerate(step.rows, start=step.first):
            linear, *directions = frames.row(number)
            bias = frames.turned(number, fields[0].omega, fields[1].omega)
            ends = zip((loop.link1, loop.link2), fields, directions, frames.arms, strict=True)
            for k, (link, motion, direction, arm) in enumerate(ends):
                sign = 1.0 if k else -1.0  # of link 2 less of link 1
                if linear:
                    at_arm = [total([motion.a[i], *(motion.gradient[i] * arm)]) for i in range(3)]
                    part = dot(direction, at_arm)
                    column = np.concatenate([cross(arm, direction), direction])
                else:
                    part = dot(direction, motion.alpha)
                    column = np.concatenate([direction, self.state.zeros(3)])
                bias = bias + part * sign
                if link > 0:
                    front.add_column(link, unknown, column * sign)
            front.places[unknown] = place
            front.add_bias(unknown, self.state.column(np.array([bias], dtype=object))[0])

    def _field(self, link: int) -> Field:
        return self.memory["field", link] if link else self.motion.ground()

    def _refuse_open(
        self,
        place: int,
        gap: Expression,
        rate: Expression,
        joints: Sequence[int],
        tolerance: float,
    ) -> None:
        """Check that a constraint holds, and goes on to; its gap and rate are squares.

        The faster its joints move, the faster it may open.
        """
        zero = self.state.graph.constant(0)
        speeds = total([v * v for j in joints for v in self.state.configuration(j)[1]])
        fastest = (speeds + 1.0) * (tolerance * RATES) ** 2
        for left, failure in ((tolerance**2 - gap, "kLoopOpen"), (fastest - rate, "kLoopTorn")):
            self.state.checks.append(Check(left, zero, place, failure))

    def _close_coupling(self, step: CloseCoupling, front: Front) -> None:
        plan = self.state.plan
        coupling = plan.couplings[step.coupling]
        states = [self.state.configuration(j) for j, _ in coupling.terms]
        factors = [factor for _, factor in coupling.terms]
        gap = total([q[0] * x for (q, _), x in zip(states, factors, strict=True)])
        rate = total([v[0] * x for (_, v), x in zip(states, factors, strict=True)])
        gap = gap - coupling.offset
        place = len(plan.joints) + len(plan.loops) + step.coupling
        joints = [j for j, _ in coupling.terms]
        self._refuse_open(place, gap * gap, rate * rate, joints, coupling.tolerance)
        if step.unknown is None:
            return
        front.places[step.unknown] = place
        front.add_bias(step.unknown, self.state.zeros(self.state.columns))
        for j, factor in coupling.terms:
            front.ties.setdefault(j, []).append((step.unknown, factor))

    # -- inwards ----------------------------------------------------------------------------------

    def _hold_back(self, step: HoldBack, front: Front) -> None:
        """Pass a joint as if it were rigid; what its motion does to all else goes into C, E, e."""
        j, parent = step.joint, self.state.plan.joints[step.joint].parent
        free, x = list(self.state.kind(j).free), self.memory["X", j]
        inertia, p = self.memory["IA", j + 1], self.memory["pA", j + 1]
        columns = front.columns.pop(j + 1, {})
        drift = self.motion.drift(j)
        if drift is not None:
            p = p + matrix_times(inertia, drift)
            for unknown, column in columns.items():
                front.add_bias(unknown, matrix_times(column[None, :], drift)[0])
        pull = self.state.torques(j)
        rotor = self.state.rotor(j)
        front.first[j] = step.first
        for k, row in enumerate(free):
            own = step.first + k
            front.add_bias(own, p[row] - pull[k])
            for m, other in enumerate(free[k:], start=k):
                value = inertia[row, other]
                if m == k and rotor is not None:
                    value = value + rotor
                front.add(own, step.first + m, value)
            for unknown, column in columns.items():
                front.add(own, unknown, column[row])
            for unknown, factor in front.ties.get(j, []):
                front.add(own, unknown, self.state.graph.constant(factor))
            front.places[own] = j
        if parent == 0:
            return
        for k, row in enumerate(free):
            front.add_column(parent, step.first + k, x.force(inertia[:, row]))
        for unknown, column in columns.items():
            front.add_column(parent, unknown, x.force(column))
        self.memory["IA", parent] = self.memory["IA", parent] + x.inertia(inertia)
        self.memory["pA", parent] = self.memory["pA", parent] + columnwise(x.force, p)

    def _carry(self, step: CarryRows, front: Front) -> None:
        """Take C through a joint that was articulated: C - U D^-1 S^T C, and what that does."""
        j, parent = step.joint, self.state.plan.joints[step.joint].parent
        kind = self.state.kind(j)
        free, constrained = list(kind.free), list(kind.constrained)
        x: Transform = self.memory["X", j]
        body = self.memory["articulated", j]
        columns = front.columns.pop(j + 1, {})
        front.carried[j] = {unknown: column[free] for unknown, column in columns.items()}
        halves = {
            unknown: body.factors.forward(column[free][:, None])[:, 0]
            for unknown, column in columns.items()
        }
        overs = {u: body.factors.scaled(half[:, None])[:, 0] for u, half in halves.items()}
        drift = self.motion.drift(j)
        for number, (unknown, column) in enumerate(columns.items()):
            for other in list(columns)[number:]:
                terms = [-(a * b) for a, b in zip(halves[unknown], overs[other], strict=True)]
                if terms:
                    front.add(unknown, other, total(terms))
            moved = column[free]
            if free:
                front.add_bias(unknown, matrix_times(moved[None, :], body.moved)[0])
            handed = column.copy()
            handed[free] = self.state.zeros(len(free))
            for row in constrained:
                terms = [-(body.scaled[k, row] * moved[k]) for k in range(len(free))]
                handed[row] = total([column[row], *terms])
            if drift is not None:
                front.add_bias(unknown, matrix_times(handed[None, :], drift)[0])
            if parent > 0:
                front.add_column(parent, unknown, x.force(handed))

    def _eliminate(self, step: Eliminate, front: Front) -> None:
        columns = front.columns.pop(step.link, {}) if step.link else {}
        forces = (*step.rows, *step.followers)
        coupled = any(front.entry(i, k) is not None for i in forces for k in forces)
        if coupled:
            self._solve_all(step, front, columns)
        elif step.rows and not step.moved:
            self._follow_basis(step, front, columns)
        else:
            self._follow(step, front, columns)

    def _block(self, front: Front, rows: Sequence[int], columns: Sequence[int]) -> Array:
        """Part of E, shape (rows, columns)."""
        block = self.state.zeros(len(rows), len(columns))
        for i, row in enumerate(rows):
            for k, column in enumerate(columns):
                entry = front.entry(row, column)
                if entry is not None:
                    block[i, k] = entry
        return block

    def _biases(self, front: Front, unknowns: Sequence[int]) -> Array:
        """Part of e, shape (n, columns)."""
        result = self.state.zeros(len(unknowns), self.state.columns)
        for k, unknown in enumerate(unknowns):
            result[k] = front.bias[unknown]
        return result

    def _at_top(self, columns: Mapping[int, Array], unknowns: Sequence[int]) -> Array:
        """Part of C^T at the top, shape (n, 6)."""
        result = self.state.zeros(len(unknowns), 6)
        for k, unknown in enumerate(unknowns):
            if unknown in columns:
                result[k] = columns[unknown]
        return result

    def _follow(self, step: Eliminate, front: Front, columns: Mapping[int, Array]) -> None:
        """Z = G y + g by the rows, then y by its inertia; no row acts on the top itself."""
        y, z = step.singles, step.moved
        to_z, to_y = (self._block(front, step.rows, each) for each in (z, y))
        right = np.concatenate([to_y, self._biases(front, step.rows)], axis=1)
        scales = self.state.constants(step.scales)[:, None]
        solved, diagonal = solved_by_reflections(to_z * scales, right * scales)
        gained = -solved
        self._check_rank(step, front, diagonal)
        g, offset = gained[:, : len(y)], gained[:, len(y) :]
        self._check_size(step, front, g)
        self._check_followers(step, front, g)
        between, own = self._block(front, y, z), self._block(front, z, z)
        half = between + matrix_times(g.T, own) if len(z) else between
        reduced = self._block(front, y, y)
        if len(z):
            reduced = _symmetric(reduced + matrix_times(half, g) + matrix_times(g.T, between.T))
        top_y, top_z = self._at_top(columns, y), self._at_top(columns, z)
        bias = self._biases(front, y)
        if len(z):
            top_y = top_y + matrix_times(g.T, top_z)
            bias = bias + matrix_times(g.T, self._biases(front, z)) + matrix_times(half, offset)
        front.solved.append(Solved(z, self.state.zeros(len(z), 6), y, g, offset))
        if step.link and len(z):
            self.memory["pA", step.link] = self.memory["pA", step.link] + matrix_times(
                top_z.T, offset
            )
        if not y:
            return
        factors = self._inertia_of(front, y, reduced)
        right = np.concatenate([top_y, bias], axis=1)
        found = factors.solve(right)
        none = self.state.zeros(len(y), 0)
        front.solved.append(Solved(y, -found[:, :6], (), none, -found[:, 6:]))
        self._add_to_top(step.link, top_y, found)

    def _follow_basis(self, step: Eliminate, front: Front, columns: Mapping[int, Array]) -> None:
        """By an orthogonal basis N of what the rows leave free, w = N y + g: J^T = Q R, N in Q."""
        w, count = step.singles, len(step.rows)
        scales = self.state.constants(step.scales)[:, None]
        r = (self._block(front, step.rows, w) * scales).T.copy()
        none = self.state.zeros(len(w), 0)
        reflections = [reflect(k, r, none) for k in range(count)]
        self._check_rank(step, front, [r[k, k] for k in range(count)])
        least = self._forward(r.T, -(self._biases(front, step.rows) * scales))
        basis = self.state.zeros(len(w), len(w) - count + self.state.columns)
        basis[count:, : len(w) - count] = self.state.constants(np.eye(len(w) - count))
        basis[:count, len(w) - count :] = least
        for reflection in reversed(reflections):
            if reflection is not None:
                reflection.apply(basis)
        n, offset = basis[:, : len(w) - count], basis[:, len(w) - count :]
        self._check_basis(step, front, n)
        own, top, bias = (
            self._block(front, w, w),
            self._at_top(columns, w),
            self._biases(front, w),
        )
        half = matrix_times(n.T, own)
        across = matrix_times(n.T, top)
        bias = matrix_times(n.T, bias) + matrix_times(half, offset)
        y = tuple(-1 - k for k in range(len(w) - count))
        front.solved.append(Solved(w, self.state.zeros(len(w), 6), y, n, offset))
        if step.link:
            self.memory["pA", step.link] = self.memory["pA", step.link] + matrix_times(
                top.T, offset
            )
        factors = self._inertia_of(front, w[: len(y)], _symmetric(matrix_times(half, n)))
        found = factors.solve(np.concatenate([across, bias], axis=1))
        none = self.state.zeros(len(y), 0)
        front.solved.append(Solved(y, -found[:, :6], (), none, -found[:, 6:]))
        self._add_to_top(step.link, across, found)

    def _forward(self, lower: Array, right: Array) -> Array:
        """Solve L x = right for a lower triangular L, shape (n, k)."""
        x = right.copy()
        for i in range(len(x)):
            over = self.state.graph.reciprocal(lower[i, i])
            for c in range(x.shape[1]):
                terms = [-(lower[i, k] * x[k, c]) for k in range(i)]
                x[i, c] = total([x[i, c], *terms]) * over
        return x

    def _check_basis(self, step: Eliminate, front: Front, n: Array) -> None:
        """Rows that are left out have to leave free what the kept ones do."""
        graph = self.state.graph
        for unknown in step.followers:
            row = self._block(front, (unknown,), step.singles)
            squares = [x * x for x in matrix_times(row, n).flat if x.constant != 0]
            sizes = [x * x for x in row.flat if x.constant != 0]
            if squares:
                left = total(sizes) * FOLLOWS**2 - total(squares)
                place = front.places[unknown]
                self.state.checks.append(Check(left, graph.constant(0), place, self._fails(step)))

    def _inertia_of(self, front: Front, unknowns: Sequence[int], reduced: Array) -> Factors:
        """Factors of the inertia of what the loops leave free; each pivot has to be positive."""
        factors = factorize(reduced)
        lost = 16 * EPSILON[FACTORS[self.state.plan.scalar]]
        pivots = zip(unknowns, factors.pivots, factors.diagonal, strict=True)
        for unknown, pivot, entry in pivots:
            least = self.state.graph.constant(0) if pivot == entry else entry * lost
            self.state.checks.append(Check(pivot, least, front.places[unknown], "kLoopFree"))
        return factors

    def _add_to_top(self, link: int, across: Array, found: Array) -> None:
        """Take what unknowns give way from the top's inertia and bias force."""
        if not link:
            return
        inertia, p = self.memory["IA", link].copy(), self.memory["pA", link]
        for i in range(6):
            for k in range(i, 6):
                value = inertia[i, k] - dot(across[:, i], found[:, k])
                inertia[i, k] = inertia[k, i] = value
        self.memory["IA", link] = inertia
        self.memory["pA", link] = p - matrix_times(across.T, found[:, 6:])

    def _check_size(self, step: Eliminate, front: Front, g: Array) -> None:
        """Look at G: where it is large, this choice of what follows is poor."""
        graph = self.state.graph
        squares = [x * x for x in g.flat if x.constant != 0] or [graph.constant(0)]
        limit = min(step.limit, MOST_LOST / EPSILON[FACTORS[self.state.plan.scalar]] ** 0.5)
        left = limit**2 - total(squares)
        place = front.places[step.rows[0]] if step.rows else 0
        self.state.checks.append(Check(left, graph.constant(0), place, self._fails(step)))

    def _fails(self, step: Eliminate) -> str:
        return SINGULAR if step.recovers else "kLoopSingular"

    def _check_rank(self, step: Eliminate, front: Front, diagonal: Sequence[Expression]) -> None:
        """What follows has to follow: no pivot of the rows, brought to one size, may vanish."""
        least = self.state.graph.constant(LEAST[FACTORS[self.state.plan.scalar]] ** 2)
        for unknown, pivot in zip(step.rows, diagonal, strict=True):
            place = front.places[unknown]
            self.state.checks.append(Check(pivot * pivot, least, place, self._fails(step)))

    def _check_inverse(
        self, step: Eliminate, front: Front, matrix: Array, diagonal: Sequence[Expression]
    ) -> None:
        """No pivot of all unknowns may have lost its digits."""
        lost = (16 * EPSILON[FACTORS[self.state.plan.scalar]]) ** 2
        every = (*step.singles, *step.moved, *step.rows)
        for k, pivot in enumerate(diagonal):
            squares = [x * x for x in matrix[:, k] if x.constant != 0]
            place = front.places[every[k]]
            least = total(squares) * lost
            self.state.checks.append(Check(pivot * pivot, least, place, "kLoopSingular"))

    def _check_followers(self, step: Eliminate, front: Front, g: Array) -> None:
        """Rows that are left out have to follow from the others in this pose, too."""
        if not step.followers:
            return
        graph = self.state.graph
        to_y = self._block(front, step.followers, step.singles)
        to_z = self._block(front, step.followers, step.moved)
        rest = to_y + matrix_times(to_z, g) if len(step.moved) else to_y
        for k, unknown in enumerate(step.followers):
            squares = [x * x for x in rest[k] if x.constant != 0]
            if not squares:
                continue
            sizes = [x * x for x in (*to_y[k], *to_z[k]) if x.constant != 0]
            left = total(sizes) * FOLLOWS**2 - total(squares)
            place = front.places[unknown]
            self.state.checks.append(Check(left, graph.constant(0), place, self._fails(step)))

    def _solve_all(self, step: Eliminate, front: Front, columns: Mapping[int, Array]) -> None:
        """All unknowns at once, where rows push each other through articulated joints."""
        every = (*step.singles, *step.moved, *step.rows)
        matrix = self._block(front, every, every)
        across, bias = self._at_top(columns, every), self._biases(front, every)
        to_left_out = self._block(front, every, step.followers)
        right = np.concatenate([across, bias, to_left_out], axis=1)
        whole, diagonal = solved_by_reflections(matrix, right)
        self._check_inverse(step, front, matrix, diagonal)
        count = 6 + self.state.columns
        self._check_left_out(step, front, to_left_out, whole[:, count:])
        found = whole[:, :count]
        none = self.state.zeros(len(every), 0)
        front.solved.append(Solved(every, -found[:, :6], (), none, -found[:, 6:]))
        self._add_to_top(step.link, across, found)

    def _check_left_out(
        self, step: Eliminate, front: Front, to_left_out: Array, found: Array
    ) -> None:
        """Rows that are left out have to push nothing that the kept ones do not push."""
        for k, unknown in enumerate(step.followers):
            own = front.entry(unknown, unknown)
            if own is None:
                continue
            rest = own - dot(to_left_out[:, k], found[:, k])
            left = own * own * FOLLOWS**4 - rest * rest
            place = front.places[unknown]
            zero = self.state.graph.constant(0)
            self.state.checks.append(Check(left, zero, place, "kLoopSingular"))

    # -- outwards ---------------------------------------------------------------------------------

    def _release(self, step: Release, front: Front) -> None:
        """Find w from the top's acceleration; joints that were articulated feel it, too."""
        for solved in reversed(front.solved):
            found = solved.bias
            if step.link:
                found = found + matrix_times(solved.across, self.memory["a", step.link])
            if solved.others:
                others = np.array([front.found[u] for u in solved.others], dtype=object)
                found = found + matrix_times(solved.more, others)
            front.found.update(zip(solved.unknowns, found, strict=True))
        for j, columns in front.carried.items():
            body = self.memory["articulated", j]
            pushed = None
            for u, column in columns.items():
                if u in front.found:
                    part = np.outer(column, front.found[u])
                    pushed = part if pushed is None else pushed + part
            if pushed is not None and len(pushed):
                moved = body.moved - body.factors.solve(pushed)
                self.memory["articulated", j] = replace(body, moved=moved)

    def _accelerate(self, step: AccelerateHeld, front: Front) -> None:
        j, parent = step.joint, self.state.plan.joints[step.joint].parent
        free, x = list(self.state.kind(j).free), self.memory["X", j]
        if parent:
            a = columnwise(x.motion, self.memory["a", parent])
        else:
            a = self.state.zeros(6, self.state.columns)
        drift = self.motion.drift(j)
        if drift is not None:
            a = a + drift
        qdd = np.array([front.found[front.first[j] + k] for k in range(len(free))], dtype=object)
        far = a.copy()
        for k, row in enumerate(free):
            far[row] = a[row] + qdd[k]
        self.memory["a", j + 1] = far
        self.state.accelerate(j, qdd)


def _symmetric(matrix: Array) -> Array:
    """A matrix that is symmetric but for rounding, from its lower triangle."""
    result = matrix.copy()
    for i in range(len(matrix)):
        for k in range(i):
            result[k, i] = result[i, k]
    return result
