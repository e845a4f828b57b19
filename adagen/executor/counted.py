"""Straight lines that are counted and not printed: what was computed before is not computed again.

A search prices many plans of one robot whose processes have most of their joints in common. They
all compute in one graph here. A step that has the constants, lanes and operands of an earlier one
has its results, too, and is not done.

The numbers of operations are those of a graph of the process's own: equal expressions are one in
either, and a value belongs to the first of the process's steps that asks for it. One rule of a
graph depends on what was asked for before: b - a is the negative of a - b where that is known.
Where a process would owe that to others, it is done in a graph of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from threading import local
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.executor.checks import Check
from adagen.executor.lane_frames import aligned
from adagen.executor.lanes import Grouping
from adagen.executor.machine import Machine
from adagen.executor.run import Lines, Simulated
from adagen.graph import Expression, Graph
from adagen.plan import steps as do
from adagen.plan.simd_groups import Limbs
from adagen.plan.steps import Step
from adagen.plan.types import Plan

_MOST = 600_000
"""Values of a graph beyond which a new one is begun."""
_KEPT = (
    do.Articulate,
    do.FreeBase,
    do.InvertRoot,
    do.Kinematics,
    do.Propagate,
    do.StartEmpty,
    do.StartLink,
)
"""Steps whose results are kept: those that depend on nothing but constants, lanes and operands."""


def may_share(plan: Plan) -> bool:
    """Return whether a plan's steps are those whose results are kept, or change nothing else."""
    plain = plan.form == "segment" and not (plan.reproducible or plan.closed or plan.outputs)
    return plain and not plan.weighed


class _Memory(dict[Any, Any]):
    """A memory that notes what is read and set."""

    def __init__(self) -> None:
        super().__init__()
        self.read: dict[Any, Any] = {}
        self.written: dict[Any, Any] = {}

    def begin(self) -> None:
        """Note what is read and set from now on."""
        self.read, self.written = {}, {}

    def __getitem__(self, name: Any) -> Any:
        value = super().__getitem__(name)
        if name not in self.written:
            self.read[name] = value
        return value

    def get(self, name: Any, default: Any = None) -> Any:
        """Return what is stored under a name, or something else."""
        value = super().get(name)
        if name not in self.written:
            self.read[name] = value
        return default if value is None else value

    def __setitem__(self, name: Any, value: Any) -> None:
        self.written[name] = value
        super().__setitem__(name, value)


@dataclass(frozen=True)
class _Asked:
    """Nodes that a step asked for, and differences that others had to ask for before."""

    nodes: NDArray[np.intp]
    relied: tuple[int, ...]


@dataclass(frozen=True)
class _Done:
    """A step that was done: what it read, and all that it changed."""

    read: tuple[tuple[Any, Any], ...]
    written: dict[Any, Any]
    checks: tuple[Check, ...]
    lengths: tuple[tuple[Expression, int], ...]
    angles: tuple[tuple[Expression, ...], ...]
    asked: _Asked


class _Common:
    """What the plans of a robot share: a graph, and steps that were done in it.

    Args:
        robot: a plan without processes.
    """

    def __init__(self, robot: Plan) -> None:
        self.robot, self.graph = robot, Graph()
        self.done: dict[Any, list[_Done]] = {}
        self._aligned: dict[tuple[Limbs, ...], Plan] = {}
        self._variants: list[list[Any]] = [[] for _ in robot.joints]
        self._attached: list[Any] = []

    def turned(self, plan: Plan, limbs: Grouping) -> Plan:
        """Return a plan with link frames turned for limbs in lanes."""
        every = tuple(one for own in limbs for one in own)
        if every not in self._aligned:
            self._aligned[every] = aligned(self.robot, every) if every else self.robot
        robot = self._aligned[every]
        return replace(
            robot, processes=plan.processes, messages=plan.messages, schedule=plan.schedule
        )

    def numbered(self, robot: Plan) -> list[int]:
        """Return a number for the constants of each joint and its link, and for all others."""
        pairs = zip(robot.joints, robot.links[1:], strict=True)
        found = [_place(own, pair) for own, pair in zip(self._variants, pairs, strict=True)]
        others = robot.wrenches, robot.parameters
        return [*found, _place(self._attached, others)]


def _place(known: list[Any], value: Any) -> int:
    """The place of a value in a list, behind all others if it is new."""
    if value not in known:
        known.append(value)
    return known.index(value)


class _Counted(Machine):
    """A process in a graph with others.

    Attributes:
        common: what it shares with them.
        asked: in order, what steps asked for, by their places.
        astray: whether it owes something to others that it would not have by itself.
    """

    def __init__(
        self,
        common: _Common,
        robot: Plan,
        mail: dict[int, list[Any]],
        limbs: tuple[Limbs, ...],
        steps: Sequence[Step],
        plan: Plan,
    ) -> None:
        self.common = common
        self.asked: list[tuple[int, _Asked]] = []
        self.astray = False
        self._turned: list[tuple[Expression, ...]] = []  # angles that a step takes
        self._begin()
        super().__init__(robot, mail, None, common.graph, limbs, steps, plan)
        self._numbers = common.numbered(robot)
        self._note(0, self._end())

    def _empty_memory(self) -> dict[Any, Any]:
        return _Memory()

    def marks(self) -> dict[int, int]:
        """Return the place of the first step that asked for each node, in ascending order."""
        places = np.full(len(self.graph.nodes), -1)
        for place, asked in reversed(self.asked):
            places[asked.nodes] = place
        own = np.flatnonzero(places >= 0)
        return dict(zip(own.tolist(), places[own].tolist(), strict=True))

    def place_of_angles(self, own: tuple[Expression, ...]) -> int | str:
        """Return a name of angles in lanes that is the same in all processes."""
        super().place_of_angles(own)
        self._turned.append(own)
        return ",".join(str(angle.index) for angle in own)

    def step(self, step: Step) -> bool:
        """Execute one step, or take what it gave before."""
        place = self.graph.mark
        if isinstance(step, _KEPT):
            self._kept(place, step)
            return True
        self._begin()
        moved = super().step(step)
        self._note(place, self._end())
        return moved

    def _begin(self) -> None:
        graph = self.common.graph
        graph.again.clear()
        graph.relied.clear()
        self._first = len(graph.nodes)

    def _end(self) -> _Asked:
        graph, first = self.common.graph, self._first
        relied = {
            index
            for index, before in graph.relied
            if index < first and index not in graph.again[:before]
        }
        nodes = [*range(first, len(graph.nodes)), *graph.again]
        return _Asked(np.array(nodes, dtype=np.intp), tuple(relied))

    def _note(self, place: int, asked: _Asked) -> None:
        if any(all(k not in own.nodes for _, own in self.asked) for k in asked.relied):
            self.astray = True
        self.asked.append((place, asked))

    def _kept(self, place: int, step: Step) -> None:
        """Do a step, or what was done where it was done before."""
        known = self.common.done.setdefault((step, self._beside(step)), [])
        memory = self.memory
        assert isinstance(memory, _Memory)
        stored = super(_Memory, memory).get
        for done in known:
            if all(stored(name) is value for name, value in done.read):
                memory.update(done.written)
                self.checks += done.checks
                self.lengths += done.lengths
                for own in done.angles:
                    super().place_of_angles(own)
                self._note(place, done.asked)
                return
        checks, lengths = len(self.checks), len(self.lengths)
        self._turned = []
        memory.begin()
        self._begin()
        super().step(step)
        read, written = memory.read, memory.written
        memory.begin()
        asked = self._end()
        self._note(place, asked)
        known.append(
            _Done(
                tuple(read.items()),
                written,
                tuple(self.checks[checks:]),
                tuple(self.lengths[lengths:]),
                tuple(self._turned),
                asked,
            )
        )

    def _beside(self, step: Step) -> tuple[Any, ...]:
        """The constants and lanes that a step depends on."""
        joint = getattr(step, "joint", getattr(step, "link", 0) - 1)
        rows, own = self.rows, self.rows.lanes(joint)
        if isinstance(step, do.InvertRoot | do.StartEmpty):
            return ()
        near = tuple(rows.row_at(link) for link in rows.near_links(joint))
        numbers = tuple(self._numbers[j] for j in own)
        row = rows.rows.get(joint)
        return row, near, numbers, self._numbers[-1], self.turns_exactly(joint)


class _CountedLines(Lines):
    """The straight lines of a plan in a graph with those of others."""

    def __init__(self, plan: Plan, common: _Common) -> None:
        super().__init__(plan, None)
        self.common = common

    def turned(self, limbs: Grouping) -> Plan:
        """Return the plan with link frames turned for limbs in lanes."""
        return self.common.turned(self.plan, limbs)

    def machine(self, p: int, robot: Plan, mail: dict[int, Any], own: tuple[Limbs, ...]) -> Machine:
        """Return process p before its first step."""
        return _Counted(self.common, robot, mail, own, self.plan.processes[p].steps, self.plan)


class _Last(local):
    """What was priced last by a thread: the plan, and the robot."""

    lines: _CountedLines | None = None
    common: _Common | None = None


_last = _Last()


def _lines_of(plan: Plan) -> _CountedLines:
    """The lines of a plan, those that are known if it was the last one."""
    lines, common = _last.lines, _last.common
    if lines is not None and lines.plan == plan:
        return lines
    robot = replace(plan, schedule="", processes=(), messages=())
    if common is None or common.robot != robot or len(common.graph.nodes) > _MOST:
        common = _last.common = _Common(robot)
    lines = _last.lines = _CountedLines(plan, common)
    return lines


def counted(plan: Plan, limbs: Grouping) -> tuple[Simulated, ...] | None:
    """Return a plan's processes after their steps, to be counted: not as they are printed.

    None where that would not be what they compute by themselves.

    Args:
        plan: one that ``may_share``.
        limbs: those that share code, one in each lane, of each process.
    """
    lines = _lines_of(plan).in_lanes(limbs)
    astray = (one.machine.astray for one in lines if isinstance(one.machine, _Counted))
    return None if any(astray) else lines
