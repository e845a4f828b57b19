"""Joints that share straight-line code, one in each SIMD lane, and the order of their steps.

Similar limbs are computed together row by row: the k-th joints of all limbs are one joint whose
constants are wide. A row is named by the joint in its first lane. Lanes beyond the last limb repeat
that limb.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from itertools import groupby
from typing import TypeVar

from adagen.executor.closed_sweeps import closed_sweep
from adagen.plan import Plan
from adagen.plan import steps as do
from adagen.plan.arms import arms_among
from adagen.plan.closure_steps import closures_in, nature
from adagen.plan.order import ends_of, inward_order, outward_order
from adagen.plan.simd_groups import Limbs, sweep_of
from adagen.plan.similar_closures import side_by_side
from adagen.plan.steps import Step
from adagen.plan.types import Process

Grouping = tuple[tuple[Limbs, ...], ...]
"""The limbs that share straight-line code, for each process."""


@dataclass(frozen=True)
class Row:
    """Joints that are computed as one, one in each SIMD lane.

    Attributes:
        lanes: the joint in each lane; 2, 4 or 8.
        count: how many of them, from the first on, are joints of their own.
    """

    lanes: tuple[int, ...]
    count: int

    @property
    def width(self) -> int:
        """How many lanes there are."""
        return len(self.lanes)


Lane = TypeVar("Lane")


def in_lanes(own: Sequence[Lane]) -> tuple[Lane, ...]:
    """Return values by lanes: as many as a register has, idle lanes repeat the last."""
    width = 1 << (len(own) - 1).bit_length()
    return (*own, *[own[-1]] * (width - len(own)))


def row_of(joints: Sequence[int]) -> Row:
    """Return a row of at least two joints in as many lanes as they need."""
    return Row(in_lanes(joints), len(joints))


def rows_of(all_limbs: Iterable[Limbs]) -> dict[int, Row]:
    """Return the rows of limbs, by their first joint."""
    return {row[0]: row_of(row) for limbs in all_limbs for row in limbs.rows}


def fit_for_lanes(plan: Plan, process: Process, all_limbs: Iterable[Limbs]) -> tuple[Limbs, ...]:
    """Return the parts of limbs that can share straight-line code: rows from the outermost inwards.

    Joints of a row all move freely or all as prescribed, and the same passive torques and rotors
    act on them. None is slaved, none leads others, and none is a closure's, of which all joints go
    side by side or none (adagen/plan/similar_closures.py).
    """
    closed = {j for one in closures_in(process.steps).values() for j in one.path}
    sources = {source for _, source, _ in plan.following}
    found = []
    for limbs in all_limbs:
        rows: list[tuple[int, ...]] = []
        for row in reversed(limbs.rows):
            joints = [plan.joints[j] for j in row]
            if len({nature(joint) for joint in joints}) > 1:
                break
            if any(joint.mimic is not None for joint in joints) or not sources.isdisjoint(row):
                break
            if not closed.isdisjoint(row):
                break
            rows.insert(0, row)
        if rows:
            found.append(Limbs(tuple(rows)))
    return tuple(found)


def steps_in_order(plan: Plan, process: Process, all_limbs: Sequence[Limbs]) -> list[int]:
    """Return the indices of the steps in order; a row is represented by its first joint.

    Sweeps pass limbs as a whole, after what they hang on or what hangs on them.

    Raises:
        ValueError: limbs and closures that go side by side wait for each other.
    """
    places: list[int] = []
    hidden = {j for limbs in all_limbs for row in limbs.rows for j in row[1:]}
    closures = closures_in(process.steps) if all_limbs else {}
    together = side_by_side(plan, process.steps, all_limbs) if closures else {}
    lead_of = {lane.number: lead for lead, lanes in together.items() for lane in lanes}
    arms = arms_among(plan, closures.values(), all_limbs).values()
    wide_unknown = (own for each in arms for one in each for own in one.loops)
    loops = {step for own in wide_unknown for step in own[1:]}
    for kind, group in groupby(enumerate(process.steps), lambda pair: sweep_of(pair[1])):
        steps = list(group)
        if closures and kind in (do.Articulate, do.Accelerate):
            places += closed_sweep(
                plan, steps, closures, lead_of, all_limbs, inwards=kind is do.Articulate
            )
        elif all_limbs and kind in (do.Kinematics, do.Articulate, do.Accelerate):
            by_joint = {j: place for place, step in steps for j in [_joint_of(step)]}
            order = _swept(plan, [step for _, step in steps], all_limbs)
            places += [by_joint[j] for j in order]
        else:
            shown = (pair for pair in steps if not _hidden(pair[1], hidden, lead_of))
            places += [place for place, step in shown if step not in loops]
    return places


def _hidden(step: Step, joints: Set[int], lead_of: Mapping[int, int]) -> bool:
    """Whether another step represents this one, which belongs to no sweep."""
    if isinstance(step, do.CloseLoop | do.CloseCoupling):
        return lead_of.get(step.closure, step.closure) != step.closure
    return isinstance(step, do.StartLink) and step.link - 1 in joints


def _joint_of(step: Step) -> int:
    assert isinstance(step, do.Kinematics | do.Articulate | do.Accelerate)
    return step.joint


def _swept(plan: Plan, steps: Sequence[Step], all_limbs: Sequence[Limbs]) -> Iterator[int]:
    """Yield the joints of a sweep in its order, of rows the first."""
    turned = {s.joint for s in steps if isinstance(s, do.Articulate | do.Accelerate) and s.reversed}
    joints = [_joint_of(step) for step in steps]
    sweep = {j: ends_of(plan.joints, j, j in turned) for j in joints}
    inwards = isinstance(steps[0], do.Articulate)
    for unit in (inward_order if inwards else outward_order)(sweep, all_limbs):
        if isinstance(unit, Limbs):
            yield from (row[0] for row in (reversed(unit.rows) if inwards else unit.rows))
        else:
            yield unit
