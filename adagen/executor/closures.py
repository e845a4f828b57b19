"""What the steps of closed loops mean (adagen/plan/steps/closed.py).

A closure is the stationary point of a quadratic function of its links' accelerations a, and of its
unknowns w, accelerations held back and constraint forces: a^T I^A a / 2 + a^T p^A + w^T (C^T a)
+ w^T E w / 2 + w^T e. Whatever is eliminated leaves such a function of what is left. A column of C
is kept for each link and unknown that act on each other.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.executor.elimination import Elimination
from adagen.executor.frames import Transform, columnwise
from adagen.executor.front import Front
from adagen.executor.kinematics import Field, Motion
from adagen.executor.loop_forces import give_forces
from adagen.executor.loop_frames import LoopFrames
from adagen.executor.state import State
from adagen.graph import Expression, cross, dot, matrix_times, total
from adagen.plan.steps import (
    AccelerateHeld,
    CarryRows,
    CloseCoupling,
    CloseLoop,
    Eliminate,
    HoldBack,
    Release,
)

Array = NDArray[Any]
ClosedStep = CloseLoop | CloseCoupling | HoldBack | CarryRows | Eliminate | Release | AccelerateHeld

RATES = 10.0
"""1/s: how fast a loop may open, beside how far it may be open, where joints move by 1 rad/s."""


class Closures:
    """Executes the steps of closed loops on a process's memory."""

    def __init__(self, state: State, motion: Motion) -> None:
        self.state, self.motion = state, motion
        self.memory: dict[Any, Any] = state.memory
        self.fronts: dict[int, Front] = {}
        # Where loops are solved for at the end, each kept row has a right-hand side.
        first = 1 + len(state.plan.slaved)
        self.column_of = {u: first + k for k, u in enumerate(state.plan.tied_rows)}
        self.solves_at_end = state.plan.form == "ada"

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
                Elimination(self.state, step, front).run()
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
        front.loops[step.loop] = []
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
                    if unknown in self.column_of:
                        pushed = self.state.tied_links.setdefault(link, [])
                        pushed.append((self.column_of[unknown], column * sign))
            front.places[unknown] = place
            front.add_bias(unknown, self.state.column(np.array([bias], dtype=object))[0])
            in_frame = matrix_times(frames.two.axes.T, directions[1])
            if loop.turn2:
                in_frame = matrix_times(self.state.constants(loop.turn2), in_frame)
            front.loops[step.loop].append((unknown, linear, in_frame))

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
        front.couplings[step.coupling] = step.unknown
        if step.unknown is None:
            return
        front.places[step.unknown] = place
        front.add_bias(step.unknown, self.state.zeros(self.state.columns))
        for j, factor in coupling.terms:
            front.ties.setdefault(j, []).append((step.unknown, factor))
            if step.unknown in self.column_of:
                tied = self.state.tied_joints.setdefault(j, [])
                tied.append((self.column_of[step.unknown], factor))

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
        if self.state.plan.loop_forces:
            give_forces(self.state, front, step.link)
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
