"""Lets all processes of a plan run over expressions."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

from adagen.emit.unrolled.machine import Machine
from adagen.graph import Operations, count_operations
from adagen.model.kinds import KINDS
from adagen.plan import Plan
from adagen.plan.abreast import limbs_abreast

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


@lru_cache(maxsize=2)  # a plan is judged, priced and emitted one after the other
def simulate(plan: Plan) -> tuple[Simulated, ...]:
    """Return the plan's processes, each after all its steps; nobody may change them.

    Raises:
        RuntimeError: the plan deadlocks.
    """
    mail: dict[int, list[Any]] = {}
    machines = [Machine(plan, mail) for _ in plan.processes]
    ends: list[list[int]] = [[] for _ in machines]
    moved = True
    while moved:
        moved = False
        for machine, process, reached in zip(machines, plan.processes, ends, strict=True):
            while len(reached) < len(process.steps):
                machine.graph.mark = len(reached)
                if not machine.step(process.steps[len(reached)]):
                    break
                reached.append(len(machine.graph.nodes))
                moved = True
    for p, (process, reached) in enumerate(zip(plan.processes, ends, strict=True)):
        if len(reached) < len(process.steps):
            raise RuntimeError(f"process {p} waits for ever at {process.steps[len(reached)]}")
    return tuple(Simulated(*pair) for pair in zip(machines, map(tuple, ends), strict=True))


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
