"""What the steps of closed loops mean (adagen/plan/steps/closed.py).

A closure is the stationary point of a quadratic function of its links' accelerations a, and of its
unknowns w, accelerations held back and constraint forces: a^T I^A a / 2 + a^T p^A + w^T (C^T a)
+ w^T E w / 2 + w^T e. Whatever is eliminated leaves such a function of what is left. A column of C
is kept for each link and unknown that act on each other.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.executor.elimination import Elimination
from adagen.executor.frames import Transform, columnwise
from adagen.executor.front import End, Front, Opening
from adagen.executor.hung import HungLinks
from adagen.executor.kinematics import Motion
from adagen.executor.lanes import in_lanes
from adagen.executor.loop_forces import forces_of_kept, give_forces
from adagen.executor.loop_frames import LoopFrames
from adagen.executor.mates import MatesInLanes, Taken
from adagen.executor.state import State
from adagen.graph import Expression, cross, dot, matrix_times, total
from adagen.plan.alike import side_by_side
from adagen.plan.arms import Mates, arms_among
from adagen.plan.closure_steps import ClosureSteps, closures_in, is_rigid
from adagen.plan.hung import PLACES
from adagen.plan.robot import PlanLoop
from adagen.plan.steps import (
    AccelerateHeld,
    CarryRows,
    CloseCoupling,
    ClosedStep,
    CloseLoop,
    Eliminate,
    HoldBack,
    Release,
    Step,
)

Array = NDArray[Any]

RATES = 10.0
"""1/s: how fast a loop may open, beside how far it may be open, where joints move by 1 rad/s."""


class Closures:
    """Executes the steps of closed loops on a process's memory.

    Closures that go side by side are treated as one, whose values are wide: as the first of them.

    Args:
        state: whose process it is.
        motion: its kinematics.
        steps: all that the process does.
    """

    def __init__(self, state: State, motion: Motion, steps: Sequence[Step]) -> None:
        self.state, self.motion = state, motion
        closed = state.plan.closed
        self.alone = closures_in(steps) if closed else {}
        self.together = side_by_side(state.plan, steps, state.limbs) if closed else {}
        self.arms = arms_among(state.plan, self.alone.values(), state.limbs)
        self.mates = MatesInLanes(state.rows, list(chain.from_iterable(self.arms.values())))
        leads = {lane.number: lanes[0].number for lanes in self.together.values() for lane in lanes}
        own = [one for number, one in self.alone.items() if leads.get(number, number) == number]
        in_arms = {j for arms in self.arms.values() for one in arms for j in one.limbs.members()}
        self.hung = HungLinks(state, motion, own, in_arms, self._plan_loops)
        self.memory: dict[Any, Any] = state.memory
        self.fronts: dict[int, Front] = {}
        # Where loops are solved for at the end, each kept row has a right-hand side.
        first = 1 + len(state.plan.slaved)
        self.column_of = {u: first + k for k, u in enumerate(state.plan.tied_rows)}
        self.solves_at_end = state.plan.form == "ada"

    def step(self, step: ClosedStep) -> None:
        """Do one step."""
        if step.closure not in self.fronts:
            self.fronts[step.closure] = Front(arms=self.arms.get(step.closure, ()))
        front = self.fronts[step.closure]
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
                front.end_waiting()
                self._look_at_rates(front)
                lanes = [lane.eliminate for lane in self.lanes(step.closure)]
                lanes = self.hung.without(lanes, step.closure)
                Elimination(self.state, lanes, front).run()
            case Release():
                self._release(step, front)
            case AccelerateHeld():
                front.outwards.append(step)
                self._accelerate_known(front)

    # -- lanes ------------------------------------------------------------------------------------

    def lanes(self, number: int) -> tuple[ClosureSteps, ...]:
        """What is done for closures that go side by side, lane by lane; idle lanes repeat."""
        if number not in self.together:
            return (self.alone[number],)
        return in_lanes(self.together[number])

    def _loops(self, step: CloseLoop) -> list[int]:
        """Loops that are treated as one, by lanes."""
        if step in self.mates.closing:
            return [each.loop for each in in_lanes(self.mates.closing[step])]
        if step.closure not in self.together:
            return [step.loop]
        place = self.together[step.closure][0].loops.index(step)
        return [lane.loops[place].loop for lane in self.lanes(step.closure)]

    def _plan_loops(self, step: CloseLoop) -> list[PlanLoop]:
        """The same, their links in the order in which they are taken."""
        plan, numbers = self.state.plan, self._loops(step)
        if step.closure not in self.together:
            return [plan.loops[number] for number in numbers]
        lanes = zip(self.lanes(step.closure), numbers, strict=True)
        return [one.loop(plan, number) for one, number in lanes]

    def _couplings(self, step: CloseCoupling) -> list[int]:
        """Couplings likewise."""
        if step.closure not in self.together:
            return [step.coupling]
        place = self.together[step.closure][0].couplings.index(step)
        return [lane.couplings[place].coupling for lane in self.lanes(step.closure)]

    def _named(self, numbers: Sequence[int], first: int) -> int:
        """What is blamed for loops or couplings in lanes: numbers behind the first one."""
        places = tuple(dict.fromkeys(first + number for number in numbers))
        if len(numbers) > 1:
            self.state.rows.beyond_joints[places[0]] = places
        return places[0]

    def _top(self, number: int) -> int:
        """The link at which a closure is eliminated."""
        return self.alone[number].eliminate.link

    # -- constraints ------------------------------------------------------------------------------

    def _close_loop(self, step: CloseLoop, front: Front) -> None:
        numbers = self._loops(step)
        loops = self._plan_loops(step)
        loop = loops[0]
        frames = LoopFrames(self.state, loops)
        place = self._named(numbers, len(self.state.plan.joints))
        joints = (*frames.one.joints, *frames.two.joints)
        tolerance = self._packed([one.tolerance for one in loops])
        fastest = self._refuse_open(place, frames.gap(), joints, tolerance)
        hung = self.hung.by(step)
        count = len(step.rows) if hung is None else PLACES
        if hung is not None:
            hung.look_at(place)
        if self._moves_by_rows(step):
            forces = tuple(self.mates.forces(step, row) for row in range(count))
            turning = () if hung is None else tuple(hung.turning_apart())
            front.opening.append(Opening(place, fastest, forces, turning))
        else:
            self._refuse_torn(place, frames.rate(), fastest)
        ends_of = ([one.link1 for one in loops], [one.link2 for one in loops])
        fields = [self.motion.field_of_all(links) for links in ends_of]
        front.lanes[place] = tuple(dict.fromkeys(numbers))
        front.loops[step.loop] = []
        lanes = len(front.lanes[place])
        held = [
            End(tuple(getattr(one, link) for one in loops), lanes, {})
            for link in ("link1", "link2")
        ]
        front.ends += [end for end in held if any(end.links)]
        for row, number in enumerate(step.rows[:count]):
            unknown, mates = step.first + row, self.mates.forces(step, row)
            linear, *directions = frames.row(number)
            bias = frames.turned(number, fields[0].omega, fields[1].omega)
            ends = zip((loop.link1, loop.link2), fields, directions, frames.arms, strict=True)
            for k, (link, motion, direction, arm) in enumerate(ends):
                sign = 1.0 if k else -1.0  # of link 2 less of link 1
                if linear:
                    at_arm = [total([motion.a[i], *(motion.gradient[i] * arm)]) for i in range(3)]
                    part = frames.along(k, directions, np.array(at_arm, dtype=object))
                    column = np.concatenate([cross(arm, direction), direction])
                else:
                    part = dot(direction, motion.alpha)
                    column = np.concatenate([direction, self.state.zeros(3)])
                bias = bias + part * sign
                if link > 0:
                    held[k].columns[mates] = column * sign
                    point = arm if linear and not frames.kind.sliding else None
                    self.mates.add_columns(front, held[k].links, mates, column * sign, point)
                    if unknown in self.column_of:
                        pushed = self.state.tied_links.setdefault(link, [])
                        pushed.append((self.column_of[unknown], column * sign))
            beyond = len(self.state.plan.joints)
            front.places.update((u, beyond + n) for u, n in zip(mates, numbers, strict=False))
            if self.state.left is not None:
                bias = self._apart(front, mates, self.state.left.of_row(bias, held, mates))
            column = self.state.column(np.array([bias], dtype=object))[0]
            if self._told(step):
                front.waiting[unknown], column = column, self.state.zeros(len(column))
            self.mates.add_bias(front, mates, column)
            in_frame = matrix_times(frames.two.axes.T, directions[1])
            if loop.turn2:
                turn = self._packed([one.turn2 for one in loops])
                in_frame = matrix_times(turn, in_frame)
            front.loops[step.loop].append((mates, linear, in_frame))

    def _told(self, step: CloseLoop) -> bool:
        """Whether others may tell what they do to a loop's rows, the only unknowns then."""
        one = self.alone.get(step.closure)
        return one is not None and not (one.held or one.eliminate.moved)

    def _moves_by_rows(self, step: CloseLoop) -> bool:
        """Whether how fast a loop opens follows from what its rows do to what is held back."""
        one = self.alone.get(step.closure)
        if one is None or one.eliminate.grounded or len(one.held) < len(one.path):
            return False
        return not any(self.state.plan.joints[j].prescribed for j in one.path)

    def _refuse_open(
        self, place: int, gap: Expression, joints: Sequence[int], tolerance: Array
    ) -> Expression:
        """Check that a constraint holds; its gap is a square.

        Returns the square of how fast it may open: the faster its joints move, the faster.
        """
        speeds = total([v * v for j in joints for v in self.state.configuration(j)[1]])
        tolerated: Expression = tolerance.item()
        most = tolerated * tolerated
        zero: Expression = self.state.graph.constant(0)
        self.state.checks.append(Check(most - gap, zero, place, "kLoopOpen"))
        return (speeds + 1.0) * (most * RATES**2)

    def _refuse_torn(self, place: int, rate: Expression, fastest: Expression) -> None:
        """Check that a constraint goes on to hold; its rate is a square."""
        zero: Expression = self.state.graph.constant(0)
        self.state.checks.append(Check(fastest - rate, zero, place, "kLoopTorn"))

    def _close_coupling(self, step: CloseCoupling, front: Front) -> None:
        plan, numbers = self.state.plan, self._couplings(step)
        couplings = [plan.couplings[number] for number in numbers]
        joints = [j for j, _ in couplings[0].terms]
        states = [self.state.configuration(j) for j in joints]
        factors = self._packed([[factor for _, factor in one.terms] for one in couplings])
        gap = total([q[0] * x for (q, _), x in zip(states, factors, strict=True)])
        rate = total([v[0] * x for (_, v), x in zip(states, factors, strict=True)])
        gap = gap - self._packed([one.offset for one in couplings])[()]
        place = self._named(numbers, len(plan.joints) + len(plan.loops))
        tolerance = self._packed([one.tolerance for one in couplings])
        fastest = self._refuse_open(place, gap * gap, joints, tolerance)
        self._refuse_torn(place, rate * rate, fastest)
        front.lanes[place] = tuple(dict.fromkeys(numbers))
        front.couplings[step.coupling] = step.unknown
        if step.unknown is None:
            return
        front.places[step.unknown] = place
        front.add_bias(step.unknown, self.state.zeros(self.state.columns))
        if self.state.left is not None:
            moved = self.state.left.of_coupling(joints, factors)
            moved = self._apart(front, (step.unknown,), moved)
            front.add_bias(step.unknown, self.state.column(np.array([moved], dtype=object))[0])
        for j, factor in zip(joints, factors, strict=True):
            front.ties.setdefault(j, []).append((step.unknown, factor))
            known = plan.joints[j].prescribed and self.state.left is None
            if known and not self.solves_at_end:
                given = self.state.given(j) * factor
                front.add_bias(step.unknown, self.state.column(given)[0])
            if step.unknown in self.column_of:
                tied = self.state.tied_joints.setdefault(j, [])
                tied.append((self.column_of[step.unknown], factor))

    def _apart(self, front: Front, mates: Mates, gap: Expression) -> Expression:
        """How a row parts by the answer; in a certificate that is weighed by itself."""
        if not self.state.plan.certified:
            return gap
        front.gaps[mates] = gap
        return self.state.graph.constant(0)  # type: ignore[no-any-return]

    def _packed(self, values: Sequence[Any]) -> Array:
        """Numbers as constants, one for each lane."""
        return self.state.rows.packed([self.state.constants(value) for value in values])

    # -- inwards ----------------------------------------------------------------------------------

    def _hold_back(self, step: HoldBack, front: Front) -> None:
        """Pass a joint as if it were rigid; what its motion does to all else goes into C, E, e."""
        j, parent = step.joint, self.state.plan.joints[step.joint].parent
        joints, free = self.mates.holds.get(j, (j,)), list(self.state.kind(j).free)
        inertia, p = self.memory["IA", j + 1], self.memory["pA", j + 1]
        columns = self.mates.take_columns(front, joints)
        drift = self.motion.drift(j)
        if drift is not None:
            p = p + matrix_times(inertia, drift)
            for mates, column, _ in columns:
                self.mates.add_bias(front, mates, matrix_times(column[None, :], drift)[0])
        if self.hung.at(j):
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
            self.mates.add_bias(front, own, p[row] - pull[k])
            for m, other in enumerate(free[k:], start=k):
                value = inertia[row, other]
                if m == k and rotor is not None:
                    value = value + rotor
                self.mates.add(front, own, unknowns[m], value)
            for mates, column, _ in columns:
                self.mates.add(front, own, mates, column[row])
            for unknown, factor in front.ties.get(j, []):
                front.add(own[0], unknown, factor)
            front.places.update(zip(own, joints, strict=True))
            front.speeds.update(zip(own, self.mates.each(speeds[k], len(own)), strict=True))
        if parent > 0:
            freed = [Taken(own, inertia[:, row]) for own, row in zip(unknowns, free, strict=True)]
            self._pass(step, front, inertia, p, [*freed, *columns])

    def _pass(
        self,
        step: HoldBack,
        front: Front,
        inertia: Array,
        p: Array,
        columns: Sequence[Taken],
    ) -> None:
        """Hand what is beyond a joint inwards; what goes to the top waits for it."""
        j, joints = step.joint, self.mates.holds.get(step.joint, (step.joint,))
        parents = [self.state.plan.joints[each].parent for each in joints]
        x: Transform = self.memory["X", j]
        for each in columns:
            mates, column, point = each.passed(x)
            self.mates.add_columns(front, parents, mates, column, point)
        rigid = is_rigid(self.state.plan, j, self.alone[step.closure].held)
        passed = {"IA": (x.rigid_inertia if rigid else x.inertia)(inertia)}
        passed["pA"] = columnwise(x.force, p)
        for name, value in passed.items():
            if parents[0] == self._top(step.closure):
                front.hand(name, self.state.rows.sum_of(value, len(joints)))
            else:
                self.state.rows.hand_on(name, j, value)

    def _look_at_rates(self, front: Front) -> None:
        """Check that loops do not open: J v, of all rows that are any."""
        zero = self.state.graph.constant(0)
        for opening in front.opening:
            rates = list(opening.turning)
            mates_of = self.mates.freedoms(front, len(opening.rows[0]) if opening.rows else 1)
            for forces in opening.rows:
                terms = []
                for mates in mates_of:
                    pairs = zip(mates, forces, strict=True)
                    entries = [front.entry(own, force) for own, force in pairs]
                    if any(entry is not None for entry in entries):
                        there = [zero if entry is None else entry for entry in entries]
                        speeds = [front.speeds[own] for own in mates]
                        terms.append(self.mates.together(there) * self.mates.together(speeds))
                if terms:
                    rates.append(total(terms))
            if rates:
                rate = total([x * x for x in rates])
                self._refuse_torn(opening.place, rate, opening.fastest)

    def _carry(self, step: CarryRows, front: Front) -> None:
        """Take C through a joint that was articulated: C - U D^-1 S^T C, and what that does."""
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

    def _release(self, step: Release, front: Front) -> None:
        """Find w from the top's acceleration; joints that were articulated feel it, too."""
        rows = self.state.rows
        for solved in reversed(front.solved):
            found = solved.bias
            if step.link:
                found = found + matrix_times(solved.across, self._acceleration(step))
            if solved.others:
                others = [rows.together([front.found[u] for u in own]) for own in solved.others]
                found = found + matrix_times(solved.more, np.array(others, dtype=object))
            for mates, value in zip(solved.unknowns, found, strict=True):
                front.found.update(zip(mates, rows.each(value, len(mates)), strict=True))
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

    def _acceleration(self, step: Release) -> Array:
        """The acceleration of the top, shape (6, columns)."""
        tops = [lane.eliminate.link for lane in self.lanes(step.closure)]
        return self.state.rows.of_links("a", tops, self.state.zeros(6, self.state.columns))

    def _accelerate_known(self, front: Front) -> None:
        """Accelerate joints that wait for it; balls do for what they join."""
        waiting: list[AccelerateHeld] = []
        for step in front.outwards:
            hung = self.hung.at(step.joint)
            if hung is None or hung.find(front):
                self._accelerate(step, front)
            else:
                waiting.append(step)
        again = len(waiting) < len(front.outwards) and bool(waiting)
        front.outwards = waiting
        if again:
            self._accelerate_known(front)

    def _accelerate(self, step: AccelerateHeld, front: Front) -> None:
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
        firsts = [front.first[each] for each in self.mates.holds.get(j, (j,))]
        found = [[front.found[first + k] for first in firsts] for k in range(len(free))]
        qdd = np.array([self.state.rows.together(each) for each in found], dtype=object)
        far = a.copy()
        for k, row in enumerate(free):
            far[row] = a[row] + qdd[k]
        self.memory["a", j + 1] = far
        self.state.accelerate(j, qdd)
