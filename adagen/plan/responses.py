"""Runs from the ground whose mobility is asked for at their last link only.

It is the sum of what each freedom of the run makes that link do: no mobility of the links before is
needed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import is_dataclass

from adagen.plan.steps import Block, HoldMobility, Propagate
from adagen.plan.types import Plan, Process

_KINDS = ("revolute", "prismatic", "spherical")


def mentions(plan: Plan, process: Process) -> Counter[Block]:
    """Return how often a process's steps and the messages name each block.

    It is empty where the process takes no mobility for an inertia, and there are no responses.
    """
    if not any(isinstance(step, HoldMobility) for step in process.steps):
        return Counter()
    return Counter(_blocks((*process.steps, *plan.messages)))


def responses(
    plan: Plan, steps: Sequence[Propagate], named: Counter[Block]
) -> Iterator[Sequence[Propagate]]:
    """Part steps that follow each other into runs of which the last one's mobility is asked for.

    A run leads outwards from the ground, each joint on the link of the one before, and what is
    beyond is held by its last link's mobility, which then has digits to lose; any other step is a
    part by itself.

    Args:
        plan: the plan.
        steps: some of a process's steps, in order.
        named: that process's ``mentions``.
    """
    first = 0
    for k, step in enumerate(steps):
        if named and k + 1 < len(steps) and _goes_on(plan, named, step, steps[k + 1], k == first):
            continue
        yield steps[first : k + 1]
        first = k + 1


def _goes_on(
    plan: Plan, named: Counter[Block], step: Propagate, after: Propagate, begins: bool
) -> bool:
    """Whether a step's mobility serves the next one alone."""
    if begins and step.near is not None:
        return False
    for each in (step, after):
        joint = plan.joints[each.joint]
        if each.reversed or each.spreads or joint.prescribed or joint.kind not in _KINDS:
            return False
    follows = plan.joints[after.joint].parent == step.joint + 1 == after.joint
    return follows and after.near == step.block and named[step.block] == 2


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
