"""Runs of joints, each on the link of the one before: the loops of shape kernels."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import lru_cache
from itertools import groupby

from adagen.executor.lanes import Grouping
from adagen.plan.edges import is_base
from adagen.plan.order import Ends, Unit, ends_of, inward_order, outward_order
from adagen.plan.own_axes import OwnAxes, own_axes_of_units
from adagen.plan.robot import PlanJoint
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Accelerate, Articulate, Deliver, Step
from adagen.plan.types import Plan
from adagen.schedule.costs import StepCosts

OF_ONE_FREEDOM = ("revolute", "prismatic")


@dataclass(frozen=True)
class Run:
    """Joints ``first`` .. ``last``, each on the link of the one before, in one direction."""

    first: int
    last: int
    reversed: bool = False

    @property
    def length(self) -> int:
        """How many joints it has."""
        return self.last - self.first + 1

    def joints(self) -> range:
        """Its joints by number: outwards, unless it is reversed."""
        return range(self.first, self.last + 1)

    def inwards(self) -> range:
        """Its joints in the order of the inward sweep."""
        return self.joints() if self.reversed else self.joints()[::-1]


def runs(joints: Sequence[PlanJoint], order: Iterable[int]) -> list[Run]:
    """Return the runs of joints in an outward order."""
    found: list[Run] = []
    for j in order:
        if found and found[-1].last == j - 1 and joints[j].parent == j:
            found[-1] = Run(found[-1].first, j)
        else:
            found.append(Run(j, j))
    return found


@dataclass(frozen=True)
class Outward:
    """A run of the outward sweep: its own joints, or joints on the path to these."""

    run: Run
    treated: bool


def outward_units(
    joints: Sequence[PlanJoint],
    passed: Sequence[int],
    limbs: Sequence[Limbs],
    treated: Iterable[int],
) -> Iterator[Limbs | Outward]:
    """Limbs side by side, and the runs between them, in outward order.

    What floats on the ground is left out: its frame is its own.

    Args:
        joints: the plan's joints.
        passed: those that are passed, in an order.
        limbs: those that may be computed side by side.
        treated: joints that are treated later.
    """
    sweep = {j: ends_of(joints, j) for j in passed if not is_base(joints[j])}
    later = frozenset(treated)
    left = {joints[j].parent for j in sweep if joints[j].parent != j}
    for part in parts_of(outward_order(sweep, limbs)):
        if isinstance(part, Limbs):
            yield part
        else:
            yield from _outward_runs(joints, part, later, left)


def _outward_runs(
    joints: Sequence[PlanJoint],
    passed: list[int],
    treated: frozenset[int],
    left: Set[int],
) -> Iterator[Outward]:
    """Runs of joints, which end at links that others leave: others of a run are not kept."""
    for run in runs(joints, passed):
        first = run.first
        for j in range(run.first, run.last + 1):
            ends = j == run.last or (j in treated) != (j + 1 in treated) or j + 1 in left
            if ends and j not in treated:
                yield Outward(Run(first, j), treated=False)
            elif j == run.last or (ends and j + 1 not in treated):
                yield Outward(Run(first, j), treated=True)
            else:
                continue
            first = j + 1


def swept(
    joints: Sequence[PlanJoint], steps: Sequence[Articulate | Accelerate | Deliver]
) -> list[Run]:
    """Return the runs of a sweep, in its order; a sweep is either inwards or outwards.

    A joint of prescribed motion is a run by itself.
    """
    found: list[list[int]] = []  # first, last, reversed
    for step in steps:
        j = step.joint
        if found and found[-1][2] == step.reversed:
            first, last, _ = found[-1]
            if not (joints[j].prescribed or joints[first].prescribed):
                if j == last + 1 and joints[j].parent == j:
                    found[-1][1] = j
                    continue
                if j == first - 1 and joints[first].parent == first:
                    found[-1][0] = j
                    continue
        found.append([j, j, step.reversed])
    return [Run(first, last, bool(backwards)) for first, last, backwards in found]


def ends_of_run(joints: Sequence[PlanJoint], run: Run) -> tuple[int, int]:
    """The near and the far link of a run."""
    parent, child = joints[run.first].parent, run.last + 1
    return (child, parent) if run.reversed else (parent, child)


def links_of_run(joints: Sequence[PlanJoint], run: Run) -> list[int]:
    """Return the links of a run, its ends included."""
    return [joints[run.first].parent, *range(run.first + 1, run.last + 2)]


def pays_columns(joints: Sequence[PlanJoint], run: Run, costs: StepCosts) -> bool:
    """Whether a run is cheaper by columns than number by number, conversions included.

    By columns a joint of one freedom takes a few instructions for each column; spherical ones are
    less work number by number, and prescribed ones have no other way. See
    templates/include/adagen/kernels/inward_columns.hpp.
    """
    own = joints[run.first : run.last + 1]
    kinds = [joint.kind for joint in own]
    if not any(kind in OF_ONE_FREEDOM for kind in kinds) or any(j.prescribed for j in own):
        return False
    alone, columns = (
        sum(costs[f"{group}.{kind}"] for kind in kinds) + costs[f"{group}.run"]
        for group in ("articulate", "articulate_columns")
    )
    return columns < alone


def parts_of(units: Iterable[Unit]) -> Iterable[Limbs | list[int]]:
    """Limbs, and the single joints between them."""
    for limbs, group in groupby(units, lambda unit: isinstance(unit, Limbs)):
        if limbs:
            yield from (unit for unit in group if isinstance(unit, Limbs))
        else:
            yield [unit for unit in group if isinstance(unit, int)]


Order = Callable[[Mapping[int, Ends], Iterable[Limbs]], Iterable[Unit]]
"""``inward_order`` or ``outward_order`` of adagen.plan.order."""


def units_of_sweep(
    joints: Sequence[PlanJoint],
    steps: Sequence[Articulate | Accelerate],
    limbs: Sequence[Limbs],
    order: Order,
) -> Iterable[Limbs | Run]:
    """Limbs side by side, and the runs between them, in the order in which they are swept."""
    by_joint = {step.joint: step for step in steps}
    sweep = {s.joint: ends_of(joints, s.joint, s.reversed) for s in steps}
    for part in parts_of(order(sweep, limbs)):
        if isinstance(part, Limbs):
            yield part
        else:
            yield from swept(joints, [by_joint[j] for j in part])


def spans(joints: Iterable[int]) -> list[tuple[int, int]]:
    """Joints as ranges first .. last."""
    found: list[tuple[int, int]] = []
    for j in sorted(joints):
        if found and found[-1][1] == j - 1:
            found[-1] = (found[-1][0], j)
        else:
            found.append((j, j))
    return found


def parts_in(steps: Iterable[Step]) -> list[Run]:
    """Return the runs that a parted run's steps are of, outwards along their chain."""
    sweep = (step for step in steps if isinstance(step, Articulate | Accelerate))
    return [Run(*span) for span in spans(step.joint for step in sweep)]


@lru_cache(maxsize=16)  # of one program it is asked for each process, and again to print it
def own_axes_in_loops(plan: Plan, limbs: Grouping, batch: bool = False) -> OwnAxes:
    """Return the joints of a plan that loops sweep in their own axes.

    Args:
        plan: a plan of form segment.
        limbs: those that each process takes side by side.
        batch: whether SIMD lanes are for states: one of them loses digits too often for a sweep to
            be repeated for all.
    """
    rows = [row for own in limbs for each in own for row in each.rows]
    found = own_axes_of_units(plan, rows, _units(plan, limbs))
    return OwnAxes(found.always | found.if_lost, frozenset()) if batch else found


def _units(plan: Plan, limbs: Grouping) -> Iterator[frozenset[int]]:
    """The joints that are swept at once."""
    for process, own in zip(plan.processes, limbs, strict=True):
        for steps, together in ((process.steps, own), (process.recovery, ())):
            swept = [step for step in steps if isinstance(step, Articulate)]
            for unit in units_of_sweep(plan.joints, swept, together, inward_order):
                yield frozenset(unit.members() if isinstance(unit, Limbs) else unit.joints())
