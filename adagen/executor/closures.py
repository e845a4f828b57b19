"""The steps of closed loops (adagen/plan/steps/closed.py).

A closure is the stationary point of a quadratic function of its links' accelerations a and its
unknowns w (accelerations of joints and constraint forces): a^T I^A a / 2 + a^T p^A + w^T (C^T a)
+ w^T E w / 2 + w^T e. Every elimination leaves such a function of the remaining variables. C has a
column for each pair of a link and an unknown that are coupled.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.arm_lanes import CouplingColumn
from adagen.executor.constraints import Constraints
from adagen.executor.elimination import Elimination
from adagen.executor.frames import Transform, columnwise
from adagen.executor.front import Front
from adagen.executor.loop_forces import forces_of_kept, give_forces
from adagen.graph import matrix_times, total
from adagen.plan import steps as do
from adagen.plan.closure_steps import is_rigid
from adagen.plan.steps import ClosedStep

Array = NDArray[Any]


class Closures(Constraints):
    """Executes the steps of closed loops on a process's memory."""

    def step(self, step: ClosedStep) -> None:
        """Do one step."""
        if step.closure not in self.fronts:
            self.fronts[step.closure] = Front(arms=self.arms.get(step.closure, ()))
        front = self.fronts[step.closure]
        match step:
            case do.CloseLoop():
                self._close_loop(step, front)
            case do.CloseCoupling():
                self._close_coupling(step, front)
            case do.HoldBack():
                self._hold_back(step, front)
            case do.CarryRows():
                self._carry(step, front)
            case do.Eliminate():
                front.end_waiting()
                self._look_at_rates(front)
                lanes = [lane.eliminate for lane in self.lanes(step.closure)]
                lanes = self.rod_halves.without(lanes, step.closure)
                Elimination(self.state, lanes, front).run()
            case do.Release():
                self._release(step, front)
            case do.AccelerateHeld():
                front.outwards.append(step)
                self._accelerate_known(front)

    # -- inwards ----------------------------------------------------------------------------------

    def _hold_back(self, step: do.HoldBack, front: Front) -> None:
        """Inward sweep through a joint whose acceleration becomes an unknown: its C, E and e."""
        j, parent = step.joint, self.state.plan.joints[step.joint].parent
        joints, free = self.arm_lanes.holds.get(j, (j,)), list(self.state.kind(j).free)
        inertia, p = self.memory["IA", j + 1], self.memory["pA", j + 1]
        columns = self.arm_lanes.take_columns(front, joints)
        drift = self.motion.drift(j)
        if drift is not None:
            p = p + matrix_times(inertia, drift)
            for wide_unknown, column, _ in columns:
                self.arm_lanes.add_bias(
                    front, wide_unknown, matrix_times(column[None, :], drift)[0]
                )
        if self.rod_halves.at(j):
            front.first[j] = step.first
            self._pass(step, front, inertia, p, columns)
            return
        pull, (_, speeds) = self.state.torques(j), self.state.configuration(j)
        rotor = self.state.rotor(j)
        held = self.alone[step.closure].held
        firsts = [step.first, *(held[each] for each in joints[1:])]
        front.first.update(zip(joints, firsts, strict=True))
        unknowns = [tuple(first + k for first in firsts) for k in range(len(free))]
        for k, row in enumerate(free):
            own = unknowns[k]
            self.arm_lanes.add_bias(front, own, p[row] - pull[k])
            for m, other in enumerate(free[k:], start=k):
                value = inertia[row, other]
                if m == k and rotor is not None:
                    value = value + rotor
                self.arm_lanes.add(front, own, unknowns[m], value)
            for wide_unknown, column, _ in columns:
                self.arm_lanes.add(front, own, wide_unknown, column[row])
            for unknown, factor in front.ties.get(j, []):
                front.add(own[0], unknown, factor)
            front.places.update(zip(own, joints, strict=True))
            front.speeds.update(zip(own, self.arm_lanes.each(speeds[k], len(own)), strict=True))
        if parent > 0:
            freed = [
                CouplingColumn(own, inertia[:, row])
                for own, row in zip(unknowns, free, strict=True)
            ]
            self._pass(step, front, inertia, p, [*freed, *columns])

    def _pass(
        self,
        step: do.HoldBack,
        front: Front,
        inertia: Array,
        p: Array,
        columns: Sequence[CouplingColumn],
    ) -> None:
        """Pass inertia, bias force and columns to the near link; those for the top are stored."""
        j, joints = step.joint, self.arm_lanes.holds.get(step.joint, (step.joint,))
        parents = [self.state.plan.joints[each].parent for each in joints]
        x: Transform = self.memory["X", j]
        for each in columns:
            wide_unknown, column, point = each.passed(x)
            self.arm_lanes.add_columns(front, parents, wide_unknown, column, point)
        held = {each for lane in self.lanes(step.closure) for each in lane.held}
        rigid = all(is_rigid(self.state.plan, each, held) for each in self.state.rows.own(j))
        passed = {"IA": (x.rigid_inertia if rigid else x.inertia)(inertia)}
        passed["pA"] = self.state.handed(j, columnwise(x.force, p))
        for name, value in passed.items():
            if parents[0] == self._top(step.closure):
                front.hand(name, self.state.rows.sum_of(value, len(joints)))
            else:
                self.state.rows.hand_on(name, j, value)

    def _look_at_rates(self, front: Front) -> None:
        """Check that loops do not open: J v of all rows is zero."""
        zero = self.state.graph.constant(0)
        for opening in front.opening:
            rates = list(opening.turning)
            freedoms = self.arm_lanes.freedoms(front, len(opening.rows[0]) if opening.rows else 1)
            for forces in opening.rows:
                terms = []
                for wide_unknown in freedoms:
                    pairs = zip(wide_unknown, forces, strict=True)
                    entries = [front.entry(own, force) for own, force in pairs]
                    if any(entry is not None for entry in entries):
                        there = [zero if entry is None else entry for entry in entries]
                        speeds = [front.speeds[own] for own in wide_unknown]
                        terms.append(self.state.rows.joined(there) * self.state.rows.joined(speeds))
                if terms:
                    rates.append(total(terms))
            if rates:
                rate = total([x * x for x in rates])
                self._refuse_torn(opening.place, rate, opening.fastest)

    def _carry(self, step: do.CarryRows, front: Front) -> None:
        """Carry C through an eliminated joint, C - U D^-1 S^T C, and add its effect on E and e."""
        j, parent = step.joint, self.state.plan.joints[step.joint].parent
        kind = self.state.kind(j)
        free, constrained = list(kind.free), list(kind.constrained)
        x: Transform = self.memory["X", j]
        body = self.memory["articulated", j]
        columns = front.columns.pop(j + 1, {})
        front.points.pop(j + 1, None)
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
            passed = column.copy()
            passed[free] = self.state.zeros(len(free))
            for row in constrained:
                terms = [-(body.scaled[k, row] * moved[k]) for k in range(len(free))]
                passed[row] = total([column[row], *terms])
            if drift is not None:
                front.add_bias(unknown, matrix_times(passed[None, :], drift)[0])
            if parent > 0:
                front.add_column(parent, unknown, x.force(passed))

    # -- outwards ---------------------------------------------------------------------------------

    def _release(self, step: do.Release, front: Front) -> None:
        """Compute w from the top's acceleration, and its effect on eliminated joints."""
        rows = self.state.rows
        for solved in reversed(front.solved):
            found = solved.bias
            if step.link:
                found = found + matrix_times(solved.across, self._acceleration(step))
            if solved.others:
                others = [rows.together([front.found[u] for u in own]) for own in solved.others]
                found = found + matrix_times(solved.more, np.array(others, dtype=object))
            for wide_unknown, value in zip(solved.unknowns, found, strict=True):
                front.found.update(
                    zip(wide_unknown, rows.each(value, len(wide_unknown)), strict=True)
                )
        near = self._acceleration(step) if step.link else None
        if self.state.plan.loop_forces:
            give_forces(self.state, front, near)
        if self.state.plan.weighed:
            front.forces = forces_of_kept(self.state, front, near)
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

    def _acceleration(self, step: do.Release) -> Array:
        """The acceleration of the top, shape (6, columns)."""
        tops = [lane.eliminate.link for lane in self.lanes(step.closure)]
        return self.state.rows.of_links("a", tops, self.state.zeros(6, self.state.columns))

    def _accelerate_known(self, front: Front) -> None:
        """Accelerate the joints whose unknowns are known now."""
        waiting: list[do.AccelerateHeld] = []
        for step in front.outwards:
            half = self.rod_halves.at(step.joint)
            if half is None or half.find(front):
                self._accelerate(step, front)
            else:
                waiting.append(step)
        again = len(waiting) < len(front.outwards) and bool(waiting)
        front.outwards = waiting
        if again:
            self._accelerate_known(front)

    def _accelerate(self, step: do.AccelerateHeld, front: Front) -> None:
        j, free, x = (
            step.joint,
            list(self.state.kind(step.joint).free),
            self.memory["X", step.joint],
        )
        near = self.state.rows.near_motion(j)
        a = self.state.zeros(6, self.state.columns)
        if near is not None:
            a = columnwise(x.motion, near)
        drift = self.motion.drift(j)
        if drift is not None:
            a = a + drift
        firsts = [front.first[each] for each in self.arm_lanes.holds.get(j, (j,))]
        found = [[front.found[first + k] for first in firsts] for k in range(len(free))]
        qdd = np.array([self.state.rows.together(each) for each in found], dtype=object)
        far = a.copy()
        for k, row in enumerate(free):
            far[row] = a[row] + qdd[k]
        self.memory["a", j + 1] = far
        self.state.accelerate(j, qdd)
