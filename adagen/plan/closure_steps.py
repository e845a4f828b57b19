"""The steps of a process for each of its closures."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from adagen.plan.robot import PlanJoint, PlanLoop
from adagen.plan.steps import CarryRows, CloseCoupling, CloseLoop, Eliminate, HoldBack, Step
from adagen.plan.types import Plan


@dataclass(frozen=True)
class ClosureSteps:
    """Inward steps of a process for one of its closures.

    Attributes:
        number: of the closure.
        loops: states their rows.
        couplings: likewise.
        path: its joints, ascending; where it goes beside another, in the order of that one's.
        held: those of them whose accelerations are held back, with their first unknowns.
        eliminate: how its unknowns are eliminated.
        exchanged: loops whose links are taken in the other order.
    """

    number: int
    loops: tuple[CloseLoop, ...]
    couplings: tuple[CloseCoupling, ...]
    path: tuple[int, ...]
    held: dict[int, int]
    eliminate: Eliminate
    exchanged: frozenset[int] = frozenset()

    def loop(self, plan: Plan, number: int) -> PlanLoop:
        """Return a loop of the plan, its links in the order of this closure."""
        loop = plan.loops[number]
        return loop.exchanged() if number in self.exchanged else loop


def closures_in(steps: Iterable[Step]) -> dict[int, ClosureSteps]:
    """Return the closures that steps eliminate, by number."""
    by_number: dict[int, list[Step]] = {}
    for step in steps:
        if isinstance(step, CloseLoop | CloseCoupling | HoldBack | CarryRows | Eliminate):
            by_number.setdefault(step.closure, []).append(step)
    found = {}
    for number, own in by_number.items():
        held = {s.joint: s.first for s in own if isinstance(s, HoldBack)}
        carried = {s.joint for s in own if isinstance(s, CarryRows)}
        for eliminate in own:
            if isinstance(eliminate, Eliminate):
                found[number] = ClosureSteps(
                    number,
                    tuple(s for s in own if isinstance(s, CloseLoop)),
                    tuple(s for s in own if isinstance(s, CloseCoupling)),
                    tuple(sorted(carried.union(held))),
                    held,
                    eliminate,
                )
    return found


def nothing_moves(plan: Plan) -> bool:
    """Return whether closures allow no motion of any joint, as in a truss."""
    rows = sum(len(one.eliminate.rows) for one in closures_in(list(plan.steps)).values())
    return plan.closed and rows == plan.nv


def is_rigid(plan: Plan, j: int, held: Collection[int]) -> bool:
    """Return whether all joints beyond a joint are unknowns: their links move as one body."""
    return all(c in held and is_rigid(plan, c, held) for c in plan.children[j + 1])


def nature(joint: PlanJoint) -> tuple[object, ...]:
    """Return the kind of a joint that all joints of a row must share."""
    effects = (joint.damping, joint.friction, joint.stiffness, joint.rotor_inertia + joint.lent)
    return (joint.kind, joint.prescribed, *map(bool, effects))
