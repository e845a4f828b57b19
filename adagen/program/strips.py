"""Long runs computed outwards in strips, one in each lane of the widest registers.

See templates/include/adagen/kernels/strips.hpp.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, pairwise

from adagen.plan import Plan
from adagen.plan.parts import strips_of
from adagen.plan.robot import PlanJoint
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Kinematics, Traverse
from adagen.program.runs import Run, outward_units
from adagen.schedule.costs import StepCosts

LANES = {"double": 8, "float": 16}
"""Numbers in the widest registers."""

KINDS = frozenset({"revolute", "spherical"})
"""Kinds of joints that are passed in strips."""

_FEWEST_ROWS = 2  # in which strips are passed: one after the other is no strip


def runs_in_strips(plan: Plan, limbs: Sequence[Sequence[Limbs]], costs: StepCosts) -> list[Run]:
    """Return the runs that all processes compute outwards in strips.

    Args:
        plan: what is carried out.
        limbs: those that each process takes side by side; their joints are left out.
        costs: what joints take in strips and one by one.
    """
    taken = {j for own in limbs for each in own for j in each.members()}
    passed = [run for p, own in enumerate(limbs) for run in _outward(plan, p, own)]
    whole = {j for first, last in _traversed(plan) for j in range(first + 1, last + 1)}
    ends = sorted({end for run in passed for end in _ends(plan, run)} - whole)
    pieces = {
        Run(first, beyond - 1)
        for run in passed
        for first, beyond in pairwise(end for end in ends if run.first <= end <= run.last + 1)
    }
    return sorted(
        (
            run
            for run in pieces
            if pays_strips(plan.joints, run, plan.scalar, costs)
            and taken.isdisjoint(range(run.first, run.last + 1))
        ),
        key=lambda run: run.first,
    )


def _ends(plan: Plan, run: Run) -> Iterator[int]:
    """Yield where a run begins, where it ends, and where kinds that strips take meet others."""
    fits = [plan.joints[j].kind in KINDS for j in run.joints()]
    yield run.first
    yield run.last + 1
    yield from (run.first + k for k in range(1, len(fits)) if fits[k] != fits[k - 1])


def fits_strips(joints: Sequence[PlanJoint], run: Run, scalar: str) -> bool:
    """Whether a run has kinds of joints that all lanes can share, and is long enough."""
    kinds = {joint.kind for joint in joints[run.first : run.last + 1]}
    return run.length >= _FEWEST_ROWS * LANES[scalar] and kinds <= KINDS


def pays_strips(joints: Sequence[PlanJoint], run: Run, scalar: str, costs: StepCosts) -> bool:
    """Whether a run is cheaper in strips than joint by joint."""
    if not fits_strips(joints, run, scalar):
        return False
    kinds = [joint.kind for joint in joints[run.first : run.last + 1]]
    alone, strips = (
        sum(costs[f"{group}.{kind}"] for kind in kinds) + costs[f"{group}.run"]
        for group in ("kinematics", "kinematics_strips")
    )
    return strips < alone


def _outward(plan: Plan, p: int, limbs: Sequence[Limbs]) -> Iterator[Run]:
    """Yield the runs that a process computes outwards, joint by joint."""
    process = plan.processes[p]
    for kind, steps in groupby(process.steps, type):
        if kind is Kinematics:
            joints = [step.joint for step in steps if isinstance(step, Kinematics)]
            for unit in outward_units(plan.joints, joints, limbs, process.treated):
                if not isinstance(unit, Limbs):
                    yield unit.run


def _traversed(plan: Plan) -> set[tuple[int, int]]:
    """Runs whose passages are computed, which are not divided."""
    return {(step.passage.first, step.passage.last) for step in plan.steps_of(Traverse)}


def slots_of(run: Run, lanes: int) -> list[int]:
    """Return the slots of a run's joints, from its first one on: rows of the strips' k-th joints.

    The last strips may be a joint shorter than the first.
    """
    strips = strips_of(range(run.first, run.last + 1), lanes)
    return [row * lanes + lane for lane, strip in enumerate(strips) for row in range(len(strip))]


def split(run: Run, in_strips: Iterable[Run]) -> list[tuple[Run, bool]]:
    """Divide a run into parts in strips and the rest."""
    found: list[tuple[Run, bool]] = []
    next_ = run.first
    for own in in_strips:
        if not (next_ <= own.first and own.last <= run.last):
            continue
        if own.first > next_:
            found.append((Run(next_, own.first - 1), False))
        found.append((own, True))
        next_ = own.last + 1
    if next_ <= run.last:
        found.append((Run(next_, run.last), False))
    return found
