"""Form `segment` of a robot with closed loops: what process 0 does, all others being idle.

Swept is as in a tree. Joints of a closure (closures.py) are held back, or carry its rows; at its
top they are eliminated. Limbs that no loop goes through are swept first on the way inwards, and
last on the way outwards, so that they can share code, one in each SIMD lane.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from adagen.model.kinds import KINDS
from adagen.model.loops import LOOP_KINDS
from adagen.plan.ada import AdaPlanner
from adagen.plan.closures import LARGE, Choice, Closure
from adagen.plan.edges import is_free_base
from adagen.plan.steps import (
    Accelerate,
    AccelerateHeld,
    Articulate,
    CarryRows,
    CloseCoupling,
    CloseLoop,
    Eliminate,
    FreeAcceleration,
    FreeBase,
    HoldBack,
    Kinematics,
    Release,
    SolveRoot,
    StartLink,
    Step,
)
from adagen.plan.types import Message, PlanCoupling, PlanJoint, PlanLoop, Process, bound_by_loops
from adagen.schedule import Schedule

LARGEST = 1e4
"""Entries of G beyond which a pose counts as singular: twice as many digits may be lost."""


@dataclass(frozen=True)
class _Unknowns:
    """A closure with its unknowns numbered: freedoms by entries of v, forces by rows."""

    closure: Closure
    freedoms: dict[int, int]
    forces: dict[int, int]

    @staticmethod
    def of(closure: Closure, joints: Sequence[PlanJoint]) -> _Unknowns:
        entries = [joints[j].v + k for j in closure.held for k in range(KINDS[joints[j].kind].nv)]
        freedoms = {entry: number for number, entry in enumerate(entries)}
        forces = {row: number for number, row in enumerate(closure.rows, start=len(freedoms))}
        return _Unknowns(closure, freedoms, forces)

    def eliminate(self, number: int, choice: Choice, limit: float, *, recovers: bool) -> Eliminate:
        """Return the step that eliminates them by a choice of what follows."""
        return Eliminate(
            self.closure.top,
            number,
            tuple(self.freedoms[entry] for entry in choice.moved),
            tuple(self.forces[row] for row in choice.rows),
            choice.scales,
            tuple(force for row, force in self.forces.items() if row not in choice.rows),
            tuple(k for entry, k in self.freedoms.items() if entry not in choice.moved),
            limit,
            recovers,
        )


class ClosedPlanner(AdaPlanner):
    """Builds the process that solves a robot with closed loops.

    Args:
        joints: the robot's joints.
        schedule: says how many processes there are; all joints are process 0's.
        closures: its closures.
        loops: its loop joints.
        couplings: its couplings.
    """

    def __init__(
        self,
        joints: tuple[PlanJoint, ...],
        schedule: Schedule,
        closures: Sequence[Closure],
        loops: Sequence[PlanLoop],
        couplings: Sequence[PlanCoupling],
    ) -> None:
        super().__init__(joints, schedule)
        self.closures, self.loops, self.couplings = closures, loops, couplings
        self.closure_of = {j: k for k, one in enumerate(closures) for j in one.path}
        self.firsts = [0]
        for loop in loops:
            self.firsts.append(self.firsts[-1] + LOOP_KINDS[loop.kind].rows)
        for _ in couplings:
            self.firsts.append(self.firsts[-1] + 1)
        self.open_limbs = self._joints_beside_loops()

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps; there are no messages."""
        ways = self._ways()
        runs = [
            tuple(self._steps(way, LARGEST if last else LARGE, recovers=not last))
            for way, last in zip(ways, [*[False] * (len(ways) - 1), True], strict=True)
        ]
        steps, *others = runs
        every = tuple(range(len(self.joints)))
        idle = [Process((), (), ()) for _ in range(self.schedule.processes - 1)]
        recovery = others[0] if others else ()
        return (Process(steps, every, every, (), recovery, tuple(others[1:])), *idle), ()

    def _ways(self) -> list[tuple[Choice, ...]]:
        """Which choices closures go by: all by their first ones, by their second ones, ..."""
        most = max((len(one.choices) for one in self.closures), default=1)
        return [
            tuple(one.choices[min(k, len(one.choices) - 1)] for one in self.closures)
            for k in range(most)
        ]

    def _joints_beside_loops(self) -> list[int]:
        """Joints with neither loops at them nor beyond them, ascending."""
        bound = bound_by_loops(self.joints, self.loops, self.couplings)
        every = range(len(self.joints))
        return [j for j in every if j not in bound and not is_free_base(self.joints[j])]

    def _steps(self, choices: Iterable[Choice], limit: float, *, recovers: bool) -> Iterator[Step]:
        rows = [_Unknowns.of(one, self.joints) for one in self.closures]
        yield from (Kinematics(j) for j in range(len(self.joints)))
        yield from (StartLink(j + 1) for j in range(len(self.joints)))
        for number, own in enumerate(rows):
            yield from self._constraints(number, own)
        aside = set(self.open_limbs)
        yield from (Articulate(j, reversed=False) for j in reversed(self.open_limbs))
        by_top: dict[int, list[Step]] = {}
        for number, (own, choice) in enumerate(zip(rows, choices, strict=True)):
            step = own.eliminate(number, choice, limit, recovers=recovers)
            by_top.setdefault(own.closure.top, []).append(step)
        for j in reversed(range(len(self.joints))):
            if j not in aside:
                yield from by_top.get(j + 1, ())
                yield from self._inwards(j, rows)
        yield from by_top.get(0, ())
        yield from (Release(0, k) for k, one in enumerate(self.closures) if one.top == 0)
        for j in range(len(self.joints)):
            if j not in aside:
                yield from self._outwards(j)
                yield from (
                    Release(j + 1, k) for k, one in enumerate(self.closures) if one.top == j + 1
                )
        yield from (Accelerate(j, reversed=False) for j in self.open_limbs)

    def _constraints(self, number: int, own: _Unknowns) -> Iterator[Step]:
        for k in own.closure.loops:
            first, end = self.firsts[k], self.firsts[k + 1]
            kept = [row for row in own.forces if first <= row < end]
            start = own.forces[kept[0]] if kept else 0
            yield CloseLoop(k, number, tuple(row - first for row in kept), start)
        for k in own.closure.couplings:
            yield CloseCoupling(k, number, own.forces.get(self.firsts[len(self.loops) + k]))

    def _inwards(self, j: int, rows: Sequence[_Unknowns]) -> Iterator[Step]:
        number = self.closure_of.get(j)
        if number is None:
            if is_free_base(self.joints[j]):
                yield FreeBase(j)
                yield SolveRoot(j + 1)
            else:
                yield Articulate(j, reversed=False)
        elif j in rows[number].closure.held:
            yield HoldBack(j, number, rows[number].freedoms[self.joints[j].v])
        else:
            yield Articulate(j, reversed=False)
            yield CarryRows(j, number)

    def _outwards(self, j: int) -> Iterator[Step]:
        number = self.closure_of.get(j)
        if number is not None and j in self.closures[number].held:
            yield AccelerateHeld(j, number)
        elif number is None and is_free_base(self.joints[j]):
            yield FreeAcceleration(j)
        else:
            yield Accelerate(j, reversed=False)
