"""The program of least predicted time for a plan in one shape: choice of limbs in SIMD lanes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache

from adagen.cost.features import operation_features, step_features
from adagen.executor import chosen_grouping
from adagen.plan import Plan
from adagen.plan.simd_groups import Limbs, simd_groupings
from adagen.plan.steps import (
    Accelerate,
    Articulate,
    Deliver,
    Join,
    Kinematics,
    Load,
    Propagate,
    Step,
    Traverse,
)
from adagen.plan.tip_mobility import Mentions, mentions
from adagen.plan.types import Process
from adagen.program import Operation, Program, lower
from adagen.program.loops import Loops
from adagen.program.lower import LOOPS
from adagen.program.runs import runs
from adagen.program.slots import Slots
from adagen.schedule import CostProfile, step_costs
from adagen.schedule.costs import StepCosts


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
    return lower(plan, shape, limbs=chosen_grouping(plan, costs), costs=costs)


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
    """The loops of least time among some groupings."""
    named = mentions(plan, plan.processes[0])
    bounds = _least(plan, offers, costs) if len(offers) > 1 else [0.0]
    best: tuple[float, int, OneProcess] | None = None
    for place in sorted(range(len(offers)), key=bounds.__getitem__):
        if best is not None and bounds[place] > best[0] * _ROUNDED:
            break  # the others take longer, too
        found = _loops(plan, offers[place], costs, named)
        if best is None or (found.time, place) < best[:2]:
            best = found.time, place, found
    assert best is not None  # no limbs at all are offered first
    return best[2]


_ROUNDED = 1 + 1e-9  # sums of times are rounded


def _least(plan: Plan, offers: Sequence[tuple[Limbs, ...]], costs: StepCosts) -> list[float]:
    """The least that the only process of a plan takes in each grouping, microseconds.

    That is what its limbs in lanes take, and all else step by step, each in its fastest way.
    Nothing is known of processes that join, as they may sweep in parts, or traverse runs.
    """
    (process,) = plan.processes
    if plan.wanted or plan.outputs or any(process.steps_of(Join, Traverse)):
        return [0.0] * len(offers)
    longest = {j: run.length for run in runs(plan.joints, process.reads) for j in run.joints()}
    steps = [
        (joint, _fastest(step, plan, costs, longest.get(joint, 1)))
        for step in process.steps
        for joint in [getattr(step, "joint", -1)]
    ]
    found = []
    for limbs in offers:
        in_lanes = {j for each in limbs for j in each.members()}
        rows = (Operation(does, each, "lanes", (), 0) for each in limbs for does in _SWEEPS)
        total = sum(costs.total(operation_features(row, plan.joints)) for row in rows)
        found.append(total + sum(least for joint, least in steps if joint not in in_lanes))
    return found


_SWEEPS = (Kinematics.does, Articulate.does, Accelerate.does)


def _fastest(step: Step, plan: Plan, costs: StepCosts, longest: int) -> float:
    """The least that a step takes, whatever loop it is in, microseconds.

    Args:
        step: of a process.
        plan: its plan.
        costs: the machine's coefficients.
        longest: joints of the longest run that its joint may be in.
    """
    if isinstance(step, Load):
        return 0.0
    alone = costs.total(step_features(step, plan.joints))
    match step:
        case Propagate(joint):
            return min(alone, costs.carried(plan.joints[joint].kind))
        case Deliver():
            return min(alone, costs["deliver.along"])
        case Kinematics(j):
            kind = plan.joints[j].kind
            strips = min(
                costs[f"{group}.{kind}"] for group in ("kinematics_strips", "passing_strips")
            )
            ways = {"kinematics": costs[f"kinematics.{kind}"], "kinematics_strips": strips}
        case Articulate(j):
            columns = costs[f"articulate_columns.{plan.joints[j].kind}"]
            ways = {"articulate": alone, "articulate_columns": columns}
        case Accelerate(j):
            ways = {"accelerate": alone}
        case _:
            return alone
    if plan.joints[j].parent == 0:  # a run by itself is none there
        return min(ways.values())
    return min(price + costs[f"{group}.run"] / longest for group, price in ways.items())


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
