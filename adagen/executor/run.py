"""Runs all processes of a plan over expressions, messages included."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from itertools import accumulate, chain
from typing import Any

from adagen.executor.lane_frames import aligned
from adagen.executor.lanes import Grouping, steps_in_order
from adagen.executor.machine import Machine
from adagen.executor.state import Refining
from adagen.graph import Operations, count_operations, uses_of
from adagen.plan.messages import Message
from adagen.plan.own_axes import losing_joints
from adagen.plan.simd_groups import Limbs
from adagen.plan.turns import by_turns
from adagen.plan.types import Plan, Process


class PlanError(Exception):
    """A plan that cannot be executed: it deadlocks, or a step reads what nobody wrote."""


@dataclass(frozen=True)
class Simulated:
    """A process after all its steps.

    Attributes:
        machine: its graph and what is wanted of it.
        ends: number of nodes in the graph after each step and all before it.
        known: what was counted of it (``stretches``), by what that depends on.
    """

    machine: Machine
    ends: tuple[int, ...]
    known: dict[float, list[Any]] = field(default_factory=dict, compare=False)

    @cached_property
    def uses(self) -> list[int]:
        """How often each node of the graph is used by what is needed of the process."""
        return uses_of(self.machine.graph, self.machine.roots())

    @cached_property
    def alive(self) -> list[int]:
        """Indices of all its nodes that are needed, ascending."""
        return [index for index, used in enumerate(self.uses) if used]

    @cached_property
    def operations(self) -> Operations:
        """Number of operations of an evaluation in this process."""
        machine = self.machine
        return count_operations(machine.graph, machine.roots(), self.uses, self.alive)


def each_for_itself(
    plan: Plan, grouping: Grouping | None = None, refining: Refining = None
) -> tuple[Simulated, ...]:
    """Return the plan's processes after all their steps, each with a straight line of its own.

    Args:
        plan: the plan.
        grouping: which limbs share code, one in each lane; None for none. Link frames are then
            turned as these agree best (lane_frames.py).
        refining: what of iterative refinement is computed, if any.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    limbs = grouping or tuple(() for _ in plan.processes)
    return lines_of(plan, refining).in_lanes(limbs)


@lru_cache(maxsize=3)  # a plan is judged, priced and emitted one after the other
def lines_of(plan: Plan, refining: Refining = None) -> Lines:
    """Return the straight lines of a plan's processes, in whatever grouping they are asked for."""
    known = None if plan.weighed else _lines_of_robot(_without_processes(plan), refining)
    return Lines(plan, refining, known)


_Made = tuple[Process, tuple[tuple[int, Message], ...], tuple[Limbs, ...]]
"""What a line is made from beside the robot: steps, messages by number, and limbs in lanes."""
_MOST = 600_000
"""Values of known lines beyond which all are forgotten."""


def _without_processes(plan: Plan) -> Plan:
    """The robot of a plan, which other plans have, too."""
    return replace(plan, schedule="", processes=(), messages=(), line=())


@lru_cache(maxsize=2)  # a search tries many plans of one robot, which have processes in common
def _lines_of_robot(robot: Plan, refining: Refining) -> dict[_Made, _Line]:  # noqa: ARG001
    """The lines that are known of a robot's plans."""
    return {}


@dataclass(frozen=True)
class _Line:
    """A process's line, with what it was made from: constants of joints and links, and messages.

    Attributes:
        simulated: the process after all its steps.
        robot: the plan with link frames turned.
        losing: joints that may lose digits, whose inertias are turned exactly.
        heard: contents of the messages that it received, by number.
        told: of those that it sent.
    """

    simulated: Simulated
    robot: Plan
    losing: frozenset[int]
    heard: dict[int, Any]
    told: dict[int, Any]


class Lines:
    """The straight lines of a plan's processes, kept for as long as the plan is of interest.

    Where a grouping, or another plan, changes some processes only, the others' lines stay as they
    are, unless a link frame is turned, or a message has another structure, that they use.

    Args:
        plan: the plan.
        refining: what of iterative refinement is computed, if any.
        known: lines of this plan and others of its robot; those that are made are added.
    """

    def __init__(
        self, plan: Plan, refining: Refining, known: dict[_Made, _Line] | None = None
    ) -> None:
        self.plan, self.refining = plan, refining
        self.together: dict[Grouping, tuple[Simulated, ...]] = {}
        self._known = {} if known is None else known

    def in_lanes(self, limbs: Grouping) -> tuple[Simulated, ...]:
        """Return all processes after their steps, with limbs in lanes.

        Raises:
            PlanError: the plan deadlocks, or a step reads what its process does not have.
        """
        if limbs not in self.together:
            self.together[limbs] = self._all(limbs)
        return self.together[limbs]

    def _all(self, limbs: Grouping) -> tuple[Simulated, ...]:
        robot = aligned(self.plan, chain.from_iterable(limbs)) if any(limbs) else self.plan
        alike = {p: line for p, own in enumerate(limbs) if (line := self._alike(p, own, robot))}
        return self._beside(alike, limbs, robot) or self._beside({}, limbs, robot)

    def _made(self, p: int, own: tuple[Limbs, ...]) -> _Made:
        """What the line of a process with limbs in lanes is made from."""
        numbered = enumerate(self.plan.messages)
        messages = tuple((n, each) for n, each in numbered if p in (each.source, each.target))
        return self.plan.processes[p], messages, own

    def _alike(self, p: int, own: tuple[Limbs, ...], robot: Plan) -> _Line | None:
        """The line of a process with limbs in lanes, if its joints and links are still the same."""
        line = self._known.get(self._made(p, own))
        if line is None or self.plan.certified:  # bounds are of others' limbs, too
            return None
        process, before = self.plan.processes[p], line.robot
        joints = {*process.reads, *process.treated, *process.spares}
        same = all(
            robot.joints[j] == before.joints[j] and robot.links[j + 1] == before.links[j + 1]
            for j in joints
        )
        turned = joints & losing_joints(self.plan) == joints & line.losing
        return line if same and turned and _attached(robot) == _attached(before) else None

    def _beside(
        self, known: Mapping[int, _Line], limbs: Grouping, robot: Plan
    ) -> tuple[Simulated, ...]:
        """All processes after their steps, some as they are known; none if these hear other things.

        Raises:
            PlanError: the plan deadlocks, or a step reads what its process does not have.
        """
        plan, mail = self.plan, dict[int, Any]()
        for line in known.values():
            mail.update(line.told)
        machines = {
            p: Machine(robot, mail, self.refining, None, own, plan.processes[p].steps, plan)
            for p, own in enumerate(limbs)
            if p not in known
        }
        found = _after_all_steps(plan, machines)
        if any(line.heard != _part(mail, line.heard) for line in known.values()):
            return ()
        if sum(len(line.simulated.machine.graph.nodes) for line in self._known.values()) > _MOST:
            self._known.clear()
        for p, simulated in found.items():
            heard = [n for n, message in enumerate(plan.messages) if message.target == p]
            told = machines[p].sent
            exchanged = _part(mail, heard), _part(mail, told)
            line = _Line(simulated, robot, losing_joints(plan), *exchanged)
            self._known[self._made(p, limbs[p])] = line
        return tuple((found.get(p) or known[p].simulated) for p in range(len(limbs)))


def _part(mail: Mapping[int, Any], numbers: Iterable[int]) -> dict[int, Any]:
    """The contents of some messages."""
    return {number: mail[number] for number in numbers if number in mail}


def _attached(robot: Plan) -> tuple[Any, ...]:
    """What lies in frames of links beside joints and bodies."""
    return robot.wrenches, robot.loops, robot.outputs, robot.parameters


def after_all_steps(plan: Plan, machines: Sequence[Machine]) -> tuple[Simulated, ...]:
    """Run the steps of a plan's processes on machines that share their messages.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    return tuple(_after_all_steps(plan, dict(enumerate(machines))).values())


def _after_all_steps(plan: Plan, machines: Mapping[int, Machine]) -> dict[int, Simulated]:
    """The same for some processes, which find others' messages where those of all lie.

    Raises:
        PlanError: the plan deadlocks, or a step reads what its process does not have.
    """
    steps = {p: plan.processes[p].steps for p in machines}
    orders = {
        p: steps_in_order(plan, plan.processes[p], machine.limbs) for p, machine in machines.items()
    }
    ends = {p: [0] * len(own) for p, own in steps.items()}

    def advance(p: int, k: int) -> bool:
        machine, place = machines[p], orders[p][k]
        machine.graph.mark, step = place, steps[p][place]
        try:
            moved = machine.step(step)
        except KeyError as missing:
            lacks = f"{step} reads {missing}, which this process does not have"
            raise PlanError(lacks) from None
        if moved:
            ends[p][place] = len(machine.graph.nodes)
        return moved

    done = by_turns({p: len(order) for p, order in orders.items()}, advance)
    for p, order in orders.items():
        if done[p] < len(order):
            raise PlanError(f"process {p} waits for ever at {steps[p][order[done[p]]]}")
        own = plan.force_entries(plan.processes[p])
        machines[p].forces = {k: x for k, x in machines[p].forces.items() if k in own}
    return {
        p: Simulated(machine, tuple(accumulate(ends[p], max))) for p, machine in machines.items()
    }
