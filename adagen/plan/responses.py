"""Runs from the ground whose mobility is asked for at their last link only.

It is the sum of what each freedom of the run makes that link do: no mobility of the links before is
needed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass

from adagen.plan.steps import Block, HoldMobility, Propagate
from adagen.plan.types import Plan, Process


def responses(
    plan: Plan, process: Process, steps: Sequence[Propagate]
) -> Iterator[Sequence[Propagate]]:
    """Part steps that follow each other into runs of which the last one's mobility is asked for.

    A run leads outwards from the ground, each joint on the link of the one before, and what is
    beyond is held by its last link's mobility, which then has digits to lose; any other step is a
    part by itself.

    Args:
        plan: the plan.
        process: the process that has the steps.
        steps: some of its steps, in order.
    """
    mentions: Counter[Block] = Counter()
    if len(steps) > 1 and any(isinstance(step, HoldMobility) for step in process.steps):
        mentions.update(_blocks((*process.steps, *plan.messages)))
    first = 0
    for k, step in enumerate(steps):
        if k + 1 < len(steps) and _goes_on(plan, mentions, step, steps[k + 1], k == first):
            continue
        yield steps[first : k + 1]
        first = k + 1


def _goes_on(
    plan: Plan, mentions: Mapping[Block, int], step: Propagate, after: Propagate, begins: bool
) -> bool:
    """Whether a step's mobility serves the next one alone.

    ``mentions``: how often steps and messages name each block, where the ground is held at all.
    """
    if begins and step.near is not None:
        return False
    for each in (step, after):
        if each.reversed or each.spreads or plan.joints[each.joint].prescribed:
            return False
    follows = plan.joints[after.joint].parent == step.joint + 1 == after.joint
    return follows and after.near == step.block and mentions.get(step.block) == 2


def _blocks(of: object) -> Iterator[Block]:
    if isinstance(of, Block):
        yield of
    elif isinstance(of, tuple):
        for each in of:
            yield from _blocks(each)
    elif is_dataclass(of):
        for field in fields(of):
            yield from _blocks(getattr(of, field.name))
