"""Constraint rows of loops and couplings, and their biases.

Loops and couplings in SIMD lanes (adagen/plan/similar_closures.py) are treated as one.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from adagen.executor.arm_lanes import ArmLanes
from adagen.executor.checks import Check
from adagen.executor.front import End, Front, Opening
from adagen.executor.kinematics import Field, Motion
from adagen.executor.lanes import in_lanes
from adagen.executor.loop_frames import LoopFrames
from adagen.executor.split_rods import RodHalves
from adagen.executor.state import State
from adagen.graph import Expression, cross, dot, matrix_times, total
from adagen.plan.arms import WideUnknown, arms_among
from adagen.plan.closure_steps import ClosureSteps, closures_in
from adagen.plan.robot import PlanLoop
from adagen.plan.similar_closures import side_by_side
from adagen.plan.split_rods import PLACES
from adagen.plan.steps import (
    CloseCoupling,
    CloseLoop,
    Step,
)

Array = NDArray[Any]

RATES = 10.0
"""1/s: how fast a loop may open, beside how far it may be open, where joints move by 1 rad/s."""


class _Closing(NamedTuple):
    """A loop while it is closed, in each lane.

    Attributes:
        loops: the plan's.
        frames: where its ends are.
        fields: how the links at both ends move.
        held: what its rows hold at both ends.
    """

    loops: list[PlanLoop]
    frames: LoopFrames
    fields: list[Field]
    held: list[End]


class Constraints:
    """Executes the steps that close loops and couplings on a process's memory.

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
        self.arm_lanes = ArmLanes(state.rows, list(chain.from_iterable(self.arms.values())))
        leads = {lane.number: lanes[0].number for lanes in self.together.values() for lane in lanes}
        own = [one for number, one in self.alone.items() if leads.get(number, number) == number]
        in_arms = {j for arms in self.arms.values() for one in arms for j in one.limbs.members()}
        self.rod_halves = RodHalves(state, motion, own, in_arms, self._plan_loops)
        self.memory: dict[Any, Any] = state.memory
        self.fronts: dict[int, Front] = {}
        # Where loops are solved for at the end, each kept row has a right-hand side.
        first = 1 + len(state.plan.slaved)
        self.column_of = {u: first + k for k, u in enumerate(state.plan.tied_rows)}
        self.solves_at_end = state.plan.form == "ada"

    # -- lanes ------------------------------------------------------------------------------------

    def lanes(self, number: int) -> tuple[ClosureSteps, ...]:
        """Return the steps of similar closures, lane by lane; idle lanes repeat the last."""
        if number not in self.together:
            return (self.alone[number],)
        return in_lanes(self.together[number])

    def _loops(self, step: CloseLoop) -> list[int]:
        """Loops of similar closures, by lanes."""
        if step in self.arm_lanes.closing:
            return [each.loop for each in in_lanes(self.arm_lanes.closing[step])]
        if step.closure not in self.together:
            return [step.loop]
        place = self.together[step.closure][0].loops.index(step)
        return [lane.loops[place].loop for lane in self.lanes(step.closure)]

    def _plan_loops(self, step: CloseLoop) -> list[PlanLoop]:
        """The same loops of the plan, their links in matching order."""
        plan, numbers = self.state.plan, self._loops(step)
        if step.closure not in self.together:
            return [plan.loops[number] for number in numbers]
        lanes = zip(self.lanes(step.closure), numbers, strict=True)
        return [one.loop(plan, number) for one, number in lanes]

    def _couplings(self, step: CloseCoupling) -> list[int]:
        """Couplings of similar closures, by lanes."""
        if step.closure not in self.together:
            return [step.coupling]
        place = self.together[step.closure][0].couplings.index(step)
        return [lane.couplings[place].coupling for lane in self.lanes(step.closure)]

    def _named(self, numbers: Sequence[int], first: int) -> int:
        """Numbers by which a failure names loops or couplings in lanes."""
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
        frames = LoopFrames(self.state, loops)
        place = self._named(numbers, len(self.state.plan.joints))
        joints = (*frames.one.joints, *frames.two.joints)
        tolerance = self._packed([one.tolerance for one in loops])
        fastest = self._refuse_open(place, frames.gap(), joints, tolerance)
        half = self.rod_halves.by(step)
        count = len(step.rows) if half is None else PLACES
        if half is not None:
            half.look_at(place)
        if self._moves_by_rows(step):
            forces = tuple(self.arm_lanes.forces(step, row) for row in range(count))
            turning = () if half is None else tuple(half.turning_apart())
            front.opening.append(Opening(place, fastest, forces, turning))
        else:
            self._refuse_torn(place, frames.rate(), fastest)
        ends_of = [[one.links[k] for one in loops] for k in (0, 1)]
        fields = [self.motion.field_of_all(links) for links in ends_of]
        front.lanes[place] = tuple(dict.fromkeys(numbers))
        front.loops[step.loop] = []
        lanes = len(front.lanes[place])
        held = [
            End(tuple(links), lanes, {}, arm)
            for links, arm in zip(ends_of, frames.arms, strict=True)
        ]
        front.ends += [end for end in held if any(end.links)]
        closing = _Closing(loops, frames, fields, held)
        for row, number in enumerate(step.rows[:count]):
            wide_unknown = self.arm_lanes.forces(step, row)
            beyond = len(self.state.plan.joints)
            front.places.update(
                (u, beyond + n) for u, n in zip(wide_unknown, numbers, strict=False)
            )
            self._add_row(step, front, closing, step.first + row, wide_unknown, number)

    def _add_row(
        self,
        step: CloseLoop,
        front: Front,
        closing: _Closing,
        unknown: int,
        wide_unknown: WideUnknown,
        number: int,
    ) -> None:
        """Add a row of a loop to its closure: its columns at both ends, and its bias.

        Args:
            step: closes the loop.
            front: the closure.
            closing: the loop.
            unknown: number of the row's force.
            wide_unknown: forces of the same row in all lanes.
            number: of the row in its loop.
        """
        loops, frames, fields, held = closing
        linear, *directions = frames.row(number)
        bias = frames.turned(number, fields[0].omega, fields[1].omega)
        ends = zip(loops[0].links, fields, directions, frames.arms, strict=True)
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
                held[k].columns[wide_unknown] = column * sign
                point = arm if linear and not frames.kind.sliding else None
                self.arm_lanes.add_columns(front, held[k].links, wide_unknown, column * sign, point)
                if unknown in self.column_of:
                    pushed = self.state.tied_links.setdefault(link, [])
                    pushed.append((self.column_of[unknown], column * sign))
        if self.state.left is not None:
            bias = self._apart(
                front, wide_unknown, self.state.left.of_row(bias, held, wide_unknown)
            )
        column = self.state.column(np.array([bias], dtype=object))[0]
        if self._may_be_shared(step):
            front.waiting[unknown], column = column, self.state.zeros(len(column))
        self.arm_lanes.add_bias(front, wide_unknown, column)
        in_frame = matrix_times(frames.two.axes.T, directions[1])
        if loops[0].turn2:
            turn = self._packed([one.turn2 for one in loops])
            in_frame = matrix_times(turn, in_frame)
        front.loops[step.loop].append((wide_unknown, linear, in_frame))

    def _may_be_shared(self, step: CloseLoop) -> bool:
        """Whether other processes may contribute to a loop's rows, the only unknowns then."""
        one = self.alone.get(step.closure)
        return one is not None and not (one.held or one.eliminate.moved)

    def _moves_by_rows(self, step: CloseLoop) -> bool:
        """Whether the opening rate of a loop follows from its rows and the speeds of unknowns."""
        one = self.alone.get(step.closure)
        if one is None or one.eliminate.grounded or len(one.held) < len(one.path):
            return False
        return not any(self.state.plan.joints[j].prescribed for j in one.path)

    def _refuse_open(
        self, place: int, gap: Expression, joints: Sequence[int], tolerance: Array
    ) -> Expression:
        """Check that a constraint is satisfied, given its squared gap.

        Returns the square of how fast it may open: the faster its joints move, the faster.
        """
        speeds = total([v * v for j in joints for v in self.state.configuration(j)[1]])
        tolerated: Expression = tolerance.item()
        most = tolerated * tolerated
        zero: Expression = self.state.graph.constant(0)
        self.state.checks.append(Check(most - gap, zero, place, "kLoopOpen"))
        return (speeds + 1.0) * (most * RATES**2)

    def _refuse_torn(self, place: int, rate: Expression, fastest: Expression) -> None:
        """Check that a constraint stays satisfied, given its squared rate."""
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

    def _apart(self, front: Front, wide_unknown: WideUnknown, gap: Expression) -> Expression:
        """The residual of a row for the answer; certificates use it separately."""
        if not self.state.plan.certified:
            return gap
        front.gaps[wide_unknown] = gap
        return self.state.graph.constant(0)  # type: ignore[no-any-return]

    def _packed(self, values: Sequence[Any]) -> Array:
        """Numbers as constants, one for each lane."""
        return self.state.rows.packed([self.state.constants(value) for value in values])
