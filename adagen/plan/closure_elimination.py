"""Steps that eliminate a robot's closures with one choice of independent accelerations."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from adagen.model.kinds import KINDS
from adagen.plan import steps as do
from adagen.plan.closures import Choice, Closure
from adagen.plan.edges import is_free_base
from adagen.plan.robot import PlanCoupling, PlanJoint, PlanLoop, first_rows
from adagen.plan.steps import Step


@dataclass(frozen=True)
class _Unknowns:
    """A closure with its unknowns numbered: freedoms by entries of v, forces by rows."""

    closure: Closure
    choice: Choice
    freedoms: dict[int, int]
    forces: dict[int, int]

    @staticmethod
    def of(closure: Closure, choice: Choice, joints: Sequence[PlanJoint]) -> _Unknowns:
        moving = [joints[j] for j in closure.held if not joints[j].prescribed]
        entries = [joint.v + k for joint in moving for k in range(KINDS[joint.kind].nv)]
        freedoms = {entry: number for number, entry in enumerate(entries)}
        forces = {row: number for number, row in enumerate(closure.rows, start=len(freedoms))}
        return _Unknowns(closure, choice, freedoms, forces)


class ClosureElimination:
    """Closures, each with the choice by which it is eliminated.

    Args:
        joints: the robot's joints.
        loops: its loop joints.
        couplings: its couplings.
        closures: its closures, each with a choice of what follows.
        limit: on the size of G, beyond which a pose is refused.
        recovers: whether there is another way to fall back on.
    """

    def __init__(
        self,
        joints: Sequence[PlanJoint],
        loops: Sequence[PlanLoop],
        couplings: Sequence[PlanCoupling],
        closures: Sequence[tuple[Closure, Choice]],
        limit: float,
        *,
        recovers: bool,
    ) -> None:
        self.joints, self.loops = joints, loops
        self.limit, self.recovers = limit, recovers
        self.closures = [closure for closure, _ in closures]
        self._own = [_Unknowns.of(*each, joints) for each in closures]
        self._of_joint = {j: k for k, one in enumerate(self.closures) for j in one.path}
        self._firsts = first_rows(loops, couplings)

    def closure_of(self, j: int) -> int | None:
        """Return the number of the closure whose path contains a joint, if any."""
        return self._of_joint.get(j)

    def constraints(self, number: int) -> Iterator[Step]:
        """Yield the steps of a closure's constraint rows."""
        own = self._own[number]
        for k in own.closure.loops:
            rows = range(self._firsts[k], self._firsts[k + 1])
            yield do.CloseLoop.of(k, number, rows, own.forces)
        for k in own.closure.couplings:
            yield do.CloseCoupling(k, number, own.forces.get(self._firsts[len(self.loops) + k]))

    def eliminate(self, number: int) -> do.Eliminate:
        """Return the step that eliminates the unknowns of a closure."""
        own = self._own[number]
        choice, held = own.choice, own.closure.top > 0 and self._on_ground(own.closure)
        return do.Eliminate(
            own.closure.top,
            number,
            tuple(own.freedoms[entry] for entry in choice.moved),
            tuple(own.forces[row] for row in choice.rows),
            choice.scales,
            tuple(force for row, force in own.forces.items() if row not in choice.rows),
            tuple(k for entry, k in own.freedoms.items() if entry not in choice.moved),
            self.limit,
            self.recovers,
            held,
        )

    def _on_ground(self, closure: Closure) -> bool:
        """Whether one of a closure's loops ends on the ground."""
        return any(0 in self.loops[k].links for k in closure.loops)

    def inwards(self, j: int) -> Iterator[Step]:
        """Yield the inward steps of a joint, seen from the ground."""
        number = self.closure_of(j)
        if number is None:
            if is_free_base(self.joints[j]):
                yield do.FreeBase(j)
                yield do.SolveRoot(j + 1)
            else:
                yield do.Articulate(j, reversed=False)
        elif j in self.closures[number].held:
            freedoms = self._own[number].freedoms  # none where its acceleration is prescribed
            yield do.HoldBack(j, number, freedoms.get(self.joints[j].v, 0))
        else:
            yield do.Articulate(j, reversed=False)
            yield do.CarryRows(j, number)

    def outwards(self, j: int) -> Step:
        """Return the step of the accelerations of a joint and of the link beyond."""
        number = self.closure_of(j)
        if number is not None and j in self.closures[number].held:
            return do.AccelerateHeld(j, number)
        if number is None and is_free_base(self.joints[j]):
            return do.FreeAcceleration(j)
        return do.Accelerate(j, reversed=False)
