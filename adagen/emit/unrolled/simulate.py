"""Lets all processes of a plan run over expressions."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import accumulate, chain
from typing import Any

from adagen.emit.unrolled.align import aligned, unlike
from adagen.emit.unrolled.lanes import fit_for_lanes, steps_in_order
from adagen.emit.unrolled.machine import Machine
from adagen.graph import Operations, count_operations
from adagen.model.kinds import KINDS
from adagen.plan import Plan
from adagen.plan.abreast import Limbs, limbs_abreast, more_alike
from adagen.plan.types import Process

_MOST_FREEDOMS = 24
_MOST_FREEDOMS_IN_LANES = 512
_MOST_EACH_IN_LANES = 450
_MOST_OPERATIONS = 3000  # of one process: about 20 kB of code
_MOST_EACH = 250  # products and sums for each degree of freedom
_MOST_EACH_ABREAST = 325  # the same, limbs that loops pass side by side being counted once


@dataclass(frozen=True)
class Simulated:
    """A process after all its steps.

    Attributes:
        machine: its graph and what is wanted of it.
        ends: number of nodes in the graph after each step.
    """

    machine: Machine
    ends: tuple[int, ...]

    @cached_property
    def operations(self) -> Operations:
        """What an evaluation costs this process."""
        return count_operations(self.machine.graph, self.machine.roots())


Grouping = tuple[tuple[Limbs, ...], ...]
"""The limbs that share straight-line code, for each process."""


def grouping_of(plan: Plan) -> Grouping:
    """Return the limbs that go together: those of shape kernels, or others that are more alike."""
    if plan.form != "segment":
        return tuple(() for _ in plan.processes)
    return tuple(fit_for_lanes(plan, _alike(plan, process)) for process in plan.processes)


def _alike(plan: Plan, process: Process) -> list[Limbs]:
    found = limbs_abreast(plan, process)
    return more_alike(plan, process, found, lambda limbs: unlike(plan, limbs))


def straight_line(plan: Plan, *, lanes: bool = True) -> tuple[Simulated, ...]:
    """Return the plan's processes as a straight line is emitted: in lanes where that is less work.

    Args:
        plan: the plan.
        lanes: whether limbs may share code at all.

    Raises:
        RuntimeError: the plan deadlocks.
    """
    alone, grouping = simulate(plan), grouping_of(plan)
    if not lanes or not any(grouping):
        return alone
    together = simulate(plan, grouping)
    return min(alone, together, key=lambda line: max(one.operations.instructions for one in line))


@lru_cache(maxsize=4)  # a plan is judged, priced and emitted one after the other
def simulate(plan: Plan, grouping: Grouping | None = None) -> tuple[Simulated, ...]:
    """Return the plan's processes, each after all its steps; nobody may change them.

    Args:
        plan: the plan.
        grouping: which limbs share code, one in each lane; None for none.

    Raises:
        RuntimeError: the plan deadlocks.
    """
    mail: dict[int, list[Any]] = {}
    limbs = grouping or tuple(() for _ in plan.processes)
    robot = aligned(plan, chain.from_iterable(limbs))
    machines = [Machine(robot, mail, own) for own in limbs]
    orders = [
        steps_in_order(plan, process, own)
        for process, own in zip(plan.processes, limbs, strict=True)
    ]
    done = [0] * len(machines)
    ends = [[0] * len(process.steps) for process in plan.processes]
    moved = True
    while moved:
        moved = False
        for p, (machine, process) in enumerate(zip(machines, plan.processes, strict=True)):
            while done[p] < len(orders[p]):
                place = orders[p][done[p]]
                machine.graph.mark = place
                if not machine.step(process.steps[place]):
                    break
                ends[p][place] = len(machine.graph.nodes)
                done[p] += 1
                moved = True
    for p, (process, order) in enumerate(zip(plan.processes, orders, strict=True)):
        if done[p] < len(order):
            raise RuntimeError(f"process {p} waits for ever at {process.steps[order[done[p]]]}")
    return tuple(
        Simulated(machine, tuple(accumulate(own, max)))
        for machine, own in zip(machines, ends, strict=True)
    )


def pays_unrolled(plan: Plan) -> bool:
    """Return whether a straight line is expected to be the fastest shape (docs/code_shapes.md).

    It wins by what structure saves: few operations for each degree of freedom, and code that stays
    in the first-level cache. Loops win by what lies side by side.
    """
    freedoms = _freedoms(plan)
    if freedoms > _MOST_FREEDOMS:
        return False
    work = [one.operations.arithmetic for one in simulate(plan)]
    most = min(_MOST_EACH * freedoms, _MOST_EACH_ABREAST * (freedoms - _saved_abreast(plan)))
    return max(work) <= _MOST_OPERATIONS and sum(work) <= most


def pays_unrolled_in_lanes(plan: Plan) -> bool:
    """Return whether a straight line is expected to be the best shape for batches.

    Its code is fetched once for all lanes, so that it wins on large robots, too, if structure saves
    something (docs/code_shapes.md); with more freedoms it takes a compiler minutes.
    """
    freedoms = _freedoms(plan)
    if freedoms > _MOST_FREEDOMS_IN_LANES:
        return False
    work = sum(one.operations.arithmetic for one in simulate(plan))
    return work <= _MOST_EACH_IN_LANES * freedoms


def _freedoms(plan: Plan) -> int:
    return sum(KINDS[joint.kind].nv for joint in plan.joints)


def _saved_abreast(plan: Plan) -> int:
    """Freedoms of limbs that shape kernels passes beside others, as no step of their own."""
    return sum(
        KINDS[plan.joints[j].kind].nv
        for process in plan.processes
        for limbs in limbs_abreast(plan, process)
        for row in limbs.rows
        for j in row[1:]
    )
