"""Runs of joints whose mobility is needed at their last link only.

Unit wrenches at the last link are carried through the run to its first link or the ground, so the
mobilities of the links between are not computed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterator, Sequence
from dataclasses import is_dataclass

from adagen.plan.robot import PlanJoint
from adagen.plan.steps import Block, HoldMobility, Propagate
from adagen.plan.types import Plan, Process

Mentions = Counter[Block]
"""How often each block is named."""
_KINDS = ("revolute", "prismatic", "spherical", "planar")


def mentions(plan: Plan, process: Process) -> Mentions:
    """Return how often a process's steps and the messages name each block."""
    if not any(process.steps_of(Propagate)):
        return Counter()
    return Counter(_blocks((*process.steps, *plan.messages)))


def holds(process: Process) -> bool:
    """Whether a process inverts a mobility of the ground's side."""
    return any(process.steps_of(HoldMobility))


def can_carry_wrenches(joints: Sequence[PlanJoint], joint: int) -> bool:
    """Whether wrenches can be carried through a joint and the one before it in one run."""
    own, above = joints[joint], joints[joint - 1]
    if not 0 < joint == own.parent:
        return False
    return all(j.kind in _KINDS and not j.prescribed for j in (own, above))


def tip_mobility_runs(
    plan: Plan, steps: Sequence[Propagate], named: Mentions, apart: Container[int] = ()
) -> Iterator[Sequence[Propagate]]:
    """Group successive steps into runs of which only the last mobility is needed.

    A run leads outwards from a link or the ground, each joint on the link of the one before, and
    couples its links with the same handles throughout; any other step is a part by itself.

    Args:
        plan: the plan.
        steps: some of a process's steps, in order.
        named: that process's ``mentions``.
        apart: joints that are carried across one by one.
    """
    first = 0
    for k, step in enumerate(steps):
        if k + 1 < len(steps) and _goes_on(plan, named, apart, step, steps[k + 1]):
            continue
        yield steps[first : k + 1]
        first = k + 1


def _goes_on(
    plan: Plan, named: Mentions, apart: Container[int], step: Propagate, after: Propagate
) -> bool:
    """Whether only the next step uses a step's mobility and couplings."""
    if step.joint in apart or after.joint in apart:
        return False
    if step.reversed != after.reversed or after.near != step.block or named[step.block] != 2:
        return False
    upper, lower = (after, step) if step.reversed else (step, after)
    if upper.joint + 1 != lower.joint or not can_carry_wrenches(plan.joints, lower.joint):
        return False
    if [spread.handle for spread in step.spreads] != [spread.handle for spread in after.spreads]:
        return False
    return all(named[spread.target] == 2 for spread in step.spreads)


def _blocks(of: object) -> Iterator[Block]:
    if isinstance(of, Block):
        yield of
    elif isinstance(of, tuple):
        for each in of:
            yield from _blocks(each)
    elif is_dataclass(of):
        for value in vars(of).values():
            if not isinstance(value, int):
                yield from _blocks(value)
