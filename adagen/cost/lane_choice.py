"""The program of least predicted time for a plan in one shape: choice of limbs in SIMD lanes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache

from adagen.cost.features import operation_features
from adagen.executor import Grouping, chosen_grouping, counted_stretches, simulate
from adagen.plan import Plan
from adagen.plan.certificate import looped
from adagen.plan.simd_groups import Limbs, simd_groupings
from adagen.plan.steps import Certify
from adagen.plan.tip_mobility import Mentions, mentions
from adagen.plan.types import Process
from adagen.program import Operation, Program, lower
from adagen.program.loops import Loops
from adagen.program.lower import LOOPS
from adagen.program.slots import Slots
from adagen.schedule import CostProfile, step_costs
from adagen.schedule.costs import StepCosts

_VALUE, _MOVE, _LEFT = 6.2, 3.2, 8.0
"""Bytes of code for each value of a certified straight line, more for each move between lanes, and
for each number that it leaves in memory for a loop: the first two within 5 % of those of robots of
49 to 74 freedoms (docs/records/certificates.md)."""
_HELD = 0.98
"""Such bytes for each of the first instruction cache up to which it holds a line. The count is 5 %
too large for talos with its hands (68 thousand; a loop costs it 8 %) and 6 % too small for valkyrie
held fixed (66 thousand), which takes 1.7 times the plain answer without a loop and 1.4 with one."""
_AIMED_AT, _FUNCTION = 0.961, 2_000
"""Bytes for each of that cache that longer ones come to where a loop sweeps residuals, and those of
the loop."""
_LONGER = 1.03
"""How much longer than without a loop a line may be predicted to take that has one: it counts what
lines take that do not fit by statements, not by bytes (docs/records/certificates.md)."""
_IN_VAIN = 1.1
"""Bytes for each of that cache that a line may have with all rows in a loop, or it has none:
valkyrie with all that loops take is as fast with one (1.09), tiago_dual 7 % slower (1.20)."""


@lru_cache(maxsize=16)  # a plan is priced, checked, drawn and emitted one after the other
def programmed(
    plan: Plan,
    shape: str,
    profile: CostProfile | None = None,
    *,
    batch: bool = False,
    again: bool = False,
) -> Program:
    """Return the program of a plan in a shape, with the limbs in lanes that take least time.

    Args:
        plan: what each process computes.
        shape: "kernels", "unrolled", "joints" or a baseline; one that takes the plan.
        profile: prices limbs and methods; the shipped one where it prices joins alone, or none is
            given.
        batch: whether SIMD lanes are for states, and limbs are computed one by one.
        again: whether sweeps are done again, for what is left over (refinement).
    """
    costs = step_costs(profile)
    if batch or shape not in (LOOPS, "unrolled"):
        return lower(plan, shape, batch=batch, costs=costs)
    if shape == LOOPS:
        limbs = tuple(chosen_limbs(plan, process, costs) for process in plan.processes)
        return lower(plan, shape, limbs=limbs, costs=costs, again=again)
    limbs = chosen_grouping(plan, costs)
    within = _within_cache(plan, limbs, costs)
    return lower(within, shape, limbs=limbs, costs=costs)


def _within_cache(plan: Plan, limbs: Grouping, costs: StepCosts) -> Plan:
    """A plan with residuals that a loop sweeps, for as many rows as its line is too long.

    That is not done where it takes longer by the profile: on some machines lines that do not fit
    take less than a loop.
    """
    every, cache = looped(plan, len(plan.joints)), costs["unrolled.cache"]
    if every is None or any(step.looped for step in plan.steps_of(Certify)):
        return plan
    length = _length(plan, limbs)
    if length <= _HELD * cache:
        return plan
    swept = [line.machine.swept for line in simulate(every, limbs)]  # others are idle
    rows, least = sum(own.count for own in swept if own is not None), _length(every, limbs)
    if not rows or least + _FUNCTION > _IN_VAIN * cache:
        return plan
    saved = (length - least) / rows
    found = looped(plan, math.ceil((length + _FUNCTION - _AIMED_AT * cache) / saved))
    if found is None:
        return plan
    longer = _straight_time(found, limbs, costs) / _straight_time(plan, limbs, costs)
    return found if longer <= _LONGER else plan


def _straight_time(plan: Plan, limbs: Grouping, costs: StepCosts) -> float:
    """Predicted time of the longest straight line of a plan, microseconds."""
    lines = counted_stretches(plan, limbs, costs["unrolled.held"])
    return max(sum(part.time(costs) for part in parts) for parts in lines)


def _length(plan: Plan, limbs: Grouping) -> float:
    """Bytes of code of the longest straight line of a plan, about."""
    return max(
        _VALUE * len(line.alive)
        + _MOVE * line.operations.moves
        + _LEFT * (0 if line.machine.swept is None else len(line.machine.swept.left))
        for line in simulate(plan, limbs)
    )


@lru_cache(maxsize=4)
def with_recovery(program: Program, profile: CostProfile | None = None) -> Program:
    """Return a program with limbs in lanes in its recovery steps, too.

    No price depends on these: they are chosen for what is emitted alone.

    Args:
        program: the program.
        profile: prices limbs; the shipped one where it prices joins alone, or none is given.
    """
    plan = program.plan
    if program.shape != "unrolled" or program.batch or not plan.recovers:
        return program
    return replace(program, recovering=chosen_grouping(plan.recovering(), step_costs(profile)))


def chosen_limbs(plan: Plan, process: Process, costs: StepCosts) -> tuple[Limbs, ...]:
    """Return the limbs in lanes of least price for a process in loops.

    Args:
        plan: of form segment.
        process: one of its processes; others are of no influence.
        costs: the machine's coefficients.
    """
    offers = offered_limbs(plan, process, costs)
    if len(offers) == 1:
        return offers[0]
    alone = replace(plan, processes=(process,))
    (limbs,) = _cheapest(alone, offers, costs).slots.limbs
    return limbs


@dataclass(frozen=True)
class OneProcess:
    """Loops of the only process of a plan.

    Attributes:
        slots: where joints lie in memory, with the limbs in lanes.
        operations: what it does.
        time: what that is predicted to take, microseconds.
    """

    slots: Slots
    operations: tuple[Operation, ...]
    time: float


def cheapest_loops(plan: Plan, costs: StepCosts) -> OneProcess:
    """Return the loops of the only process of a plan of form segment, with the limbs chosen."""
    return _cheapest(plan, offered_limbs(plan, plan.processes[0], costs), costs)


def _cheapest(plan: Plan, offers: Sequence[tuple[Limbs, ...]], costs: StepCosts) -> OneProcess:
    """The loops of least time among some groupings, the first of them."""
    named = mentions(plan, plan.processes[0])
    found = (_loops(plan, limbs, costs, named) for limbs in offers)
    return min(found, key=lambda loops: loops.time)


def offered_limbs(plan: Plan, process: Process, costs: StepCosts) -> list[tuple[Limbs, ...]]:
    """Return the groupings of a process's limbs that are compared; the first is none."""

    @cache
    def saved(kinds: Sequence[str], count: int) -> float:
        rows = sum(count * costs.joint(kind) - costs.row(kind, count) for kind in kinds)
        return rows - costs["limbs.two" if count == 2 else "limbs.four"]

    found = simd_groupings(plan, process, saved)
    return list(dict.fromkeys([(), *map(tuple, found)]))


def _loops(plan: Plan, limbs: tuple[Limbs, ...], costs: StepCosts, named: Mentions) -> OneProcess:
    """Loops of the only process of a plan with its ``mentions``."""
    slots = Slots.of(plan, (limbs,), costs)
    loops = Loops(plan, plan.processes[0], slots, limbs, False, costs, named=named)
    found = loops.operations()
    time = sum(costs.total(operation_features(each, plan.joints)) for each in found)
    return OneProcess(slots, found, time)
