"""Steps inside a segment: articulated bodies, mobilities and accelerations.

A joint is computed in its own frame, the child link's. Seen from the segment's root, the far link's
acceleration is a_far = a_near + sigma (S qdd + c), sigma being -1 where the far link is the parent,
and the force f on it obeys sigma tau = S^T f.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import SINGULAR, Check
from adagen.executor.frames import Transform, columnwise
from adagen.executor.kinematics import Motion
from adagen.executor.state import State
from adagen.graph import Expression, Factors, factorize, matrix_times, solve_by_reflections, total
from adagen.model import REACTION_FORCE
from adagen.plan import steps as do
from adagen.plan.digits import LEAST_PIVOT
from adagen.plan.order import ends_of
from adagen.plan.steps import Step

Array = NDArray[Any]
_HALVES = (range(3), range(3, 6))  # angular and linear


@dataclass(frozen=True)
class Articulated:
    """A joint's factors in the articulated-body algorithm.

    Attributes:
        factors: of D.
        u: sigma tau - S^T p, shape (n, columns).
        moved: D^-1 u, likewise.
        scaled: D^-1 U^T, shape (n, 6); without a rotor without meaning in the joint's own columns,
            which are those of 1.
        kept: D^-1 J with a rotor of inertia J, shape (n, n): what of a motion along the joint
            passes it; None without one, nothing does.
    """

    factors: Factors
    u: Array
    moved: Array
    scaled: Array
    kept: Array | None = None


class Segments:
    """Executes the steps inside a segment on a process's memory."""

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion
        self.memory: dict[Any, Any] = state.memory
        outputs = state.plan.outputs
        self.reactions = {each.link for each in outputs if each.what == REACTION_FORCE}

    def step(self, step: Step) -> None:
        """Do one step."""
        match step:
            case do.StartLink():
                self.memory["IA", step.link] = self.motion.link_inertia(step.link)
                force = self.motion.link_force(step.link)
                self.memory["pA", step.link] = self.state.on_link(step.link, force)
            case do.StartEmpty():
                self.memory["IA", step.link] = self.state.zeros(6, 6)
                self.memory["pA", step.link] = self._nothing(step.link)
            case do.FreeBase():
                free = list(self.state.kind(step.joint).free)
                p = self.memory["pA", step.joint + 1].copy()
                p[free] = p[free] - self.state.torques(step.joint)
                self.memory["pA", step.joint + 1] = p
            case do.Articulate():
                self._articulate(step)
            case do.Propagate():
                self._propagate(step)
            case do.Load():
                none = self.state.zeros(6, self.state.columns)
                force = none if step.force is None else self.memory[step.force]
                self.memory["load", step.link] = force
            case do.Deliver():
                self._deliver(step)
            case do.FreeAcceleration():
                a, drift = self.memory["a", step.joint + 1], self.motion.drift(step.joint)
                free = list(self.state.kind(step.joint).free)
                self.state.accelerate(step.joint, (a if drift is None else a - drift)[free])
                if self.state.refining:
                    self.state.keep_force(step.joint, self.state.zeros(*a.shape), driven=True)
                if step.joint + 1 in self.reactions:  # nothing but what drives it
                    drive = self.state.zeros(*a.shape)
                    drive[free] = self.state.torques(step.joint)
                    self.memory["reaction", step.joint + 1] = drive
            case do.Accelerate():
                self._accelerate(step)
            case _:
                self._at_root(step)

    def _nothing(self, link: int) -> Array:
        """Initial inertia and bias of a link that another process starts: those of loops at it."""
        left = self.state.left
        if left is None:
            return self.state.zeros(6, self.state.columns)
        return self.state.column(left.by_loops(link))

    def _brought(self, step: do.Articulate, inertia: Array) -> Expression | None:
        """Trace of the contributions from beyond to where D is found; None if D cannot be noise.

        What the bare link has along a joint is exact, and so is what others bring, by exact turns;
        but where links without inertia come within rounding of gimbal lock, that is the square of
        an angle's last digits.
        """
        if not self.state.turns_exactly(step.joint):
            return None
        first = 0 if self.state.kind(step.joint).free[0] < 3 else 3
        brought = total([inertia[k, k] for k in range(first, first + 3)])
        if step.reversed:
            return brought
        bare = self.motion.link_inertia(step.joint + 1)
        return brought - total([bare[k, k] for k in range(first, first + 3)])

    def _articulate(self, step: do.Articulate) -> None:
        near, far = ends_of(self.state.plan.joints, step.joint, step.reversed)
        sigma = -1 if step.reversed else 1
        kind = self.state.kind(step.joint)
        free, constrained = list(kind.free), list(kind.constrained)
        x: Transform = self.memory["X", step.joint]
        inertia, p = self.memory["IA", far], self.memory["pA", far]
        if step.reversed:
            inertia, p = x.inertia_back(inertia), columnwise(x.force_back, p)
        pull = self.state.torques(step.joint) * sigma
        rotor, own = self.state.rotor(step.joint), inertia[np.ix_(free, free)]
        d = own if rotor is None else own + self._diagonal(len(free), rotor)
        factors = self.state.factorize(d, step.joint, self._brought(step, inertia))
        u = pull - p[free]
        moved = factors.solve(u)
        half = factors.forward(inertia[np.ix_(free, constrained)])  # L^-1 U^T
        over = factors.scaled(half)
        scaled = self.state.zeros(len(free), 6)
        scaled[:, constrained] = factors.backward(over)
        kept = None
        if rotor is not None:
            kept = factors.solve(self._diagonal(len(free), rotor))
            scaled[:, free] = factors.solve(own)
        self.memory["articulated", step.joint] = Articulated(factors, u, moved, scaled, kept)
        if near == 0 and not any(self.state.rows.near_links(step.joint)):
            return  # the ground does not feel it
        passed = self.state.zeros(6, 6)  # exact projection: rows and columns of S stay zero
        for i, row in enumerate(constrained):
            for k, column in enumerate(constrained[i:], start=i):
                terms = [-(a * b) for a, b in zip(half[:, i], over[:, k], strict=True)]
                value = total([inertia[row, column], *terms])
                passed[row, column] = passed[column, row] = value
        force = p.copy()
        force[free] = pull
        if rotor is not None:  # they hold what the rotor hands on
            passed[free] = scaled * rotor
            passed[:, free] = passed[free].T
            passed[np.ix_(free, free)] = _mirrored(passed[np.ix_(free, free)])
            force[free] = pull - moved * rotor
        for row in constrained:
            for c in range(p.shape[1]):
                force[row, c] = total([p[row, c], *(inertia[row, free] * moved[:, c])])
        drift = self.motion.drift(step.joint)
        if drift is not None:
            force = force + matrix_times(passed, drift * sigma)
        if not step.reversed:
            passed, force = x.inertia(passed), columnwise(x.force, force)
        if step.reversed:
            self.memory["IA", near] = self.memory["IA", near] + passed
            self.memory["pA", near] = self.memory["pA", near] + force
        else:
            self.state.rows.hand_on("IA", step.joint, passed)
            self.state.rows.hand_on("pA", step.joint, self.state.handed(step.joint, force))

    def _diagonal(self, n: int, entry: Expression) -> Array:
        matrix = self.state.zeros(n, n)
        for k in range(n):
            matrix[k, k] = entry
        return matrix

    def _held(self, step: do.Propagate | do.Deliver, m: Array) -> Array:
        """K m with K = 1 - S D^-1 S^T I^A: the near side's motion as the far side shares it."""
        kind = self.state.kind(step.joint)
        body: Articulated = self.memory["articulated", step.joint]
        free, constrained = list(kind.free), list(kind.constrained)
        result = m.copy()
        for k, row in enumerate(free):
            for c in range(m.shape[1]):
                terms = body.scaled[k, constrained] * m[constrained, c]
                result[row, c] = -total([self.state.graph.constant(0), *terms])
                if body.kept is not None:
                    result[row, c] = total([result[row, c], *(body.kept[k] * m[free, c])])
        return result

    def _propagate(self, step: do.Propagate) -> None:
        x: Transform = self.memory["X", step.joint]
        free = list(self.state.kind(step.joint).free)
        body: Articulated = self.memory["articulated", step.joint]
        own = self.state.zeros(6, 6)
        if step.near is not None:
            near = self.memory[step.near]
            own = self._held(step, near if step.reversed else x.mobility(near))
            own = self._held(step, own.T)
        unit = self.state.constants(np.eye(len(free)))
        own[np.ix_(free, free)] = own[np.ix_(free, free)] + body.factors.solve(unit)
        self.memory[step.block] = _mirrored(x.mobility_back(own) if step.reversed else own)
        start = None if step.near_bias is None else self.memory[step.near_bias]
        _, self.memory[step.bias] = self._far_acceleration(step, start)
        for spread in step.spreads:
            source = self.memory[spread.source]
            value = source.T if spread.source_transposed else source
            if step.reversed:
                value = columnwise(x.motion_back, self._held(step, value))
            else:
                value = self._held(step, columnwise(x.motion, value))
            self.memory[spread.target] = value.T if spread.target_transposed else value

    def _far_acceleration(
        self, step: do.Propagate | do.Accelerate, near: Array | None
    ) -> tuple[Array, Array]:
        """The product sigma qdd, and the far link's deviation from the near link's (None: none)."""
        sigma = -1 if step.reversed else 1
        x: Transform = self.memory["X", step.joint]
        kind = self.state.kind(step.joint)
        free, constrained = list(kind.free), list(kind.constrained)
        body: Articulated = self.memory["articulated", step.joint]
        if near is None:
            a = self.state.zeros(6, self.state.columns)
        else:
            a = near if step.reversed else columnwise(x.motion, near)
        drift = self.motion.drift(step.joint)
        if drift is not None:
            a = a + drift * sigma
        far = a.copy()
        for k, row in enumerate(free):
            for c in range(a.shape[1]):
                terms = -(body.scaled[k, constrained] * a[constrained, c])
                far[row, c] = total([body.moved[k, c], *terms])
        if body.kept is None:
            moved = far[free] - a[free]
        else:
            alike = far[free]
            moved = alike - matrix_times(body.scaled[:, free], a[free])
            far[free] = alike + matrix_times(body.kept, a[free])
        return moved, columnwise(x.motion_back, far) if step.reversed else far

    def _deliver(self, step: do.Deliver) -> None:
        near, far = ends_of(self.state.plan.joints, step.joint, step.reversed)
        x: Transform = self.memory["X", step.joint]
        kind = self.state.kind(step.joint)
        free, constrained = list(kind.free), list(kind.constrained)
        body: Articulated = self.memory["articulated", step.joint]
        load = self.memory["load", far]
        if step.reversed:
            load = columnwise(x.force_back, load)
        u = body.u + load[free]
        self.memory["articulated", step.joint] = Articulated(
            body.factors, u, body.factors.solve(u), body.scaled, body.kept
        )
        if near == 0:
            return
        rest = load.copy()
        rest[free] = self.state.zeros(len(free), load.shape[1])
        if body.kept is not None:
            rest[free] = matrix_times(body.kept.T, load[free])
        for row in constrained:
            for c in range(load.shape[1]):
                terms = -(body.scaled[:, row] * load[free, c])
                rest[row, c] = total([load[row, c], *terms])
        if not step.reversed:
            rest = columnwise(x.force, rest)
        self.memory["load", near] = self.memory["load", near] + rest

    def _accelerate(self, step: do.Accelerate) -> None:
        near, far = ends_of(self.state.plan.joints, step.joint, step.reversed)
        sigma = -1 if step.reversed else 1
        rows = self.state.rows
        start = self.memory["a", near] if step.reversed else rows.near_motion(step.joint)
        moved, self.memory["a", far] = self._far_acceleration(step, start)
        self.state.accelerate(step.joint, moved * sigma)
        if self.state.refining:
            self.state.keep_force(step.joint, self._force(step, far), driven=True)
        if self.reactions.intersection(j + 1 for j in rows.own(step.joint)):
            self.memory["reaction", step.joint + 1] = self._force(step, far)

    def _force(self, step: do.Accelerate, far: int) -> Array:
        """F = I^A a + p^A - load of the far link, as it acts on the child link."""
        force: Array = (
            matrix_times(self.memory["IA", far], self.memory["a", far]) + self.memory["pA", far]
        )
        if ("load", far) in self.memory:
            force = force - self.memory["load", far]
        if step.reversed:
            x: Transform = self.memory["X", step.joint]
            force = -columnwise(x.force_back, force)
        return force

    # -- at the root ------------------------------------------------------------------------------

    def _at_root(self, step: Step) -> None:
        """Do a step at a root: mobilities from inertias, inertias from mobilities."""
        match step:
            case do.InvertRoot():
                factors = self.state.factorize(self.memory["IA", step.link], step.link - 1)
                phi = self._inverse(factors)
                self.memory[step.block] = phi
                self.memory[step.bias] = -matrix_times(phi, self.memory["pA", step.link])
            case do.SolveRoot():
                factors = self.state.factorize(self.memory["IA", step.link], step.link - 1)
                self.memory["a", step.link] = factors.solve(-self.memory["pA", step.link])
            case do.SolveMobility():
                self.memory["a", step.link] = self._under_mobility(step)
            case do.HoldMobility():
                self._hold(step)
            case do.LoadRoot():
                inertia, p = self.memory["IA", step.link], self.memory["pA", step.link]
                load = matrix_times(inertia, self.memory["a", step.link]) + p
                self.memory["load", step.link] = load if step.held else -load
            case do.AccelerateRoot():
                phi, b = self.memory[step.block], self.memory[step.bias]
                load = self.memory["load", step.link]
                self.memory["a", step.link] = b + matrix_times(phi, load)
            case _:
                raise AssertionError(f"no meaning for {step}")

    def _inverse(self, factors: Factors) -> Array:
        """The inverse of a symmetric matrix by its factors, shape (6, 6)."""
        half = factors.forward(self.state.constants(np.eye(6)))
        over = factors.scaled(half)
        inverse = self.state.zeros(6, 6)
        for i in range(6):
            for k in range(i, 6):
                inverse[i, k] = inverse[k, i] = total(half[:, i] * over[:, k])
        return inverse

    def _hold(self, step: do.HoldMobility) -> None:
        """Phi^-1 and -Phi^-1 b, if no pivot of Phi is small beside the largest of its kind."""
        phi, b = self.memory[step.block], self.memory[step.bias]
        factors, least = factorize(phi), LEAST_PIVOT[self.state.plan.scalar]
        for rows in _HALVES:
            most = self._largest(phi, rows) * least
            for k in rows:
                check = Check(factors.pivots[k], most, step.link - 1, SINGULAR)
                self.state.checks.append(check)
        inverse = self._inverse(factors)
        self.memory["IA", step.link] = inverse
        self.memory["pA", step.link] = -matrix_times(inverse, b)

    def _largest(self, matrix: Array, rows: Sequence[int]) -> Expression:
        """The largest of three entries of the diagonal."""
        first, second, third = (matrix[k, k] for k in rows)
        return self.state.graph.larger(self.state.graph.larger(first, second), third)  # type: ignore[no-any-return]

    def _under_mobility(self, step: do.SolveMobility) -> Array:
        """The a of (1 + Phi I) a = b - Phi p, shape (6, columns).

        Phi and I may both be singular, and rows would have to be exchanged by size: reflections
        are as stable and need not look.
        """
        inertia, p = self.memory["IA", step.link], self.memory["pA", step.link]
        phi, b = self.memory[step.block], self.memory[step.bias]
        held = matrix_times(phi, inertia)
        for k in range(6):
            held[k, k] = held[k, k] + 1
        return solve_by_reflections(held, b - matrix_times(phi, p))


def _mirrored(matrix: Array) -> Array:
    """A matrix that is symmetric but for rounding, from its upper triangle."""
    result = matrix.copy()
    for i in range(len(matrix)):
        for k in range(i):
            result[i, k] = result[k, i]
    return result
