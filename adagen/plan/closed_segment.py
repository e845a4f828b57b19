"""Form `segment` of a robot with closed loops.

The sweeps are those of a tree. Joints of a closure (closures.py) stay unknowns, or carry its
constraint rows; they are eliminated at the closure's top. Limbs without loops are swept first
inwards and last outwards, so that they can share code, one in each SIMD lane.

Several processes gather (gather.py). Each closure belongs to one process, and links above its top
are not affected. But separate trees (separate_trees.py) may belong to different processes: these
exchange the contributions of their trees to the rows of the loops between them, and each
eliminates the closure. In poor poses, each process computes everything for itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from adagen.errors import InputError
from adagen.plan import steps as do
from adagen.plan.ada import AdaPlanner
from adagen.plan.closure_elimination import ClosureElimination
from adagen.plan.closures import Closure
from adagen.plan.edges import Edge, is_free_base
from adagen.plan.gather import exchange, sides_of, trees_of
from adagen.plan.gather_steps import ProcessSteps
from adagen.plan.gather_trees import Tree
from adagen.plan.independent_coordinates import LARGE
from adagen.plan.messages import Message
from adagen.plan.robot import PlanCoupling, PlanJoint, PlanLoop, bound_by_loops
from adagen.plan.steps import SideOfLoops, Step
from adagen.plan.types import Process
from adagen.schedule import Schedule
from adagen.schedule.tree import Gathered

LARGEST = 1e4
"""Entries of G beyond which a pose counts as singular: twice as many digits may be lost."""


class ClosedPlanner(AdaPlanner):
    """Builds the processes that solve a robot with closed loops.

    Args:
        joints: the robot's joints.
        schedule: says where processes gather; without that, all joints are process 0's.
        closures: its closures.
        early: the same, those that reach the ground ending before it; none where none can.
        apart: the same, those between trees that float apart holding nothing back; none likewise.
        loops: its loop joints.
        couplings: its couplings.
    """

    def __init__(
        self,
        joints: tuple[PlanJoint, ...],
        schedule: Schedule,
        closures: Sequence[Closure],
        early: Sequence[Closure],
        apart: Sequence[Closure],
        loops: Sequence[PlanLoop],
        couplings: Sequence[PlanCoupling],
    ) -> None:
        super().__init__(joints, schedule)
        self.closures, self.early, self.apart = closures, early, apart
        self.loops, self.couplings = loops, couplings
        self.open_limbs = self._joints_beside_loops()

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps, and the messages between them.

        Raises:
            InputError: processes cannot gather as the schedule has it.
        """
        ways = self._ways()
        every = tuple(range(len(self.joints)))
        gathered = self.schedule.gathered
        if gathered is not None:
            return self._shared(gathered, ways[0], ways[1:] or ways)
        steps, *others = (tuple(self._steps(way)) for way in ways)
        idle = [Process((), (), ()) for _ in range(self.schedule.processes - 1)]
        recovery = others[0] if others else ()
        return (Process(steps, every, every, (), recovery, tuple(others[1:])), *idle), ()

    def gathered(self) -> Gathered | None:
        """Return the layout of gathering processes; None where one process has everything."""
        return self.schedule.gathered

    def line(self) -> tuple[Step, ...]:
        """Return the steps of one process, whose straight line several processes may share."""
        return tuple(self._steps(self._ways()[0]))

    def _ways(self) -> list[ClosureElimination]:
        """Eliminations to try: the cheapest, then all closures' first choices, second, ..."""
        most = max((len(one.choices) for one in self.closures), default=1)
        found = [
            [(one, one.choices[min(k, len(one.choices) - 1)]) for one in self.closures]
            for k in range(most)
        ]
        if self.early:  # where these are poor, an orthogonal basis loses nothing
            found = [[(one, one.choices[0]) for one in self.early], *(found[1:] or found)]
        elif self.apart:
            found.insert(0, [(one, one.choices[0]) for one in self.apart])
        return [
            ClosureElimination(
                self.joints,
                self.loops,
                self.couplings,
                way,
                LARGEST if k == len(found) else LARGE,
                recovers=k < len(found),
            )
            for k, way in enumerate(found, start=1)
        ]

    def _joints_beside_loops(self) -> list[int]:
        """Joints without loops at them or beyond them, ascending."""
        bound = bound_by_loops(self.joints, self.loops, self.couplings)
        every = range(len(self.joints))
        return [j for j in every if j not in bound and not is_free_base(self.joints[j])]

    def _steps(self, way: ClosureElimination) -> Iterator[Step]:
        """All steps of one process."""
        yield from (do.Kinematics(j) for j in range(len(self.joints)))
        yield from (do.StartLink(j + 1) for j in range(len(self.joints)))
        for number in range(len(way.closures)):
            yield from way.constraints(number)
        aside = set(self.open_limbs)
        yield from (do.Articulate(j, reversed=False) for j in reversed(self.open_limbs))
        at_top: dict[int, list[int]] = {}
        for number, closure in enumerate(way.closures):
            at_top.setdefault(closure.top, []).append(number)
        for j in reversed(range(len(self.joints))):
            if j not in aside:
                yield from map(way.eliminate, at_top.get(j + 1, ()))
                yield from way.inwards(j)
        yield from map(way.eliminate, at_top.get(0, ()))
        yield from (do.Release(0, k) for k in at_top.get(0, ()))
        for j in range(len(self.joints)):
            if j not in aside:
                yield way.outwards(j)
                yield from (do.Release(j + 1, k) for k in at_top.get(j + 1, ()))
        yield from (do.Accelerate(j, reversed=False) for j in self.open_limbs)
        if self.coupled():
            yield from (do.SolveCoupling(), do.ApplyCoupling())

    # -- several processes ------------------------------------------------------------------------

    def _shared(
        self, gathered: Gathered, way: ClosureElimination, others: Sequence[ClosureElimination]
    ) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Steps of several processes, and those of each by itself where the shared ones fail."""
        trees = trees_of(self.joints, gathered)
        _refuse_divided(trees, way, self.loops)
        recovery: tuple[tuple[Step, ...], ...] = ()
        if way.recovers or any(tree.hold for tree in trees):
            recovery = tuple(tuple(self._steps(other)) for other in others)
        messages = (*exchange(trees), *_between(trees, way))
        processes = []
        for p, sides in enumerate(sides_of(messages, self.schedule.processes)):
            steps = _ClosedSteps(self.joints, trees, p, way)
            process = steps.process_of(steps.evaluation(*sides))
            processes.append(_recovering(process, recovery, len(self.joints)))
        return tuple(processes), messages


def _recovering(process: Process, ways: Sequence[tuple[Step, ...]], count: int) -> Process:
    """A process that computes everything by itself, by several eliminations in turn."""
    if not process.owns or not ways:
        return process
    every = tuple(range(count))
    spares = tuple(j for j in every if j not in process.treated)
    first, *others = ways
    return replace(process, reads=every, recovery=first, others=tuple(others), spares=spares)


def _refuse_divided(
    trees: Sequence[Tree], way: ClosureElimination, loops: Sequence[PlanLoop]
) -> None:
    """Refuse a layout in which several processes have joints of one closure below its top."""
    owner = {j: p for tree in trees for j, p in tree.owner.items()}
    against = {e.joint for tree in trees for e in tree.edges if e.reversed}
    against |= {e.joint for tree in trees for e in tree.ground_side}
    for closure in way.closures:
        if closure.apart:
            owner |= {base: tree.participants[0] for base, tree in _whole(trees).items()}
            if all(j in owner for j in closure.path) and against.isdisjoint(closure.path):
                continue
        owners = {owner.get(j) for j in closure.path}
        if len(owners) > 1 or None in owners or against.intersection(closure.path):
            names = ", ".join(f'"{loops[k].name}"' for k in closure.loops)
            raise InputError(
                f"processes cannot gather as the schedule has it: joints of loops {names} are not "
                "all of one process, or are beyond the root"
            )


def _whole(trees: Sequence[Tree]) -> dict[int, Tree]:
    """Floating trees of one process each, by their bases."""
    return {
        tree.base: tree
        for tree in trees
        if tree.base is not None and len(tree.participants) == 1 and tree.root == tree.base + 1
    }


def _between(trees: Sequence[Tree], way: ClosureElimination) -> Iterator[Message]:
    """Yield the messages between processes about separate trees."""
    owner = {j: tree.participants[0] for tree in trees for j in (*tree.joints, tree.base)}
    for number, closure in enumerate(way.closures):
        sides: dict[int, list[int]] = {}
        for j in closure.path if closure.apart else ():
            sides.setdefault(owner[j], []).append(j)
        for p, own in sides.items():
            side = SideOfLoops(number, tuple(own), len(closure.rows))
            others = (other for other in sides if other != p)
            yield from (Message(p, q, "assembly", own[0], sides=(side,)) for q in others)


class _ClosedSteps(ProcessSteps):
    """Steps of one process of a robot with loops.

    Args:
        joints: the robot's joints.
        trees: how processes meet.
        process: the process.
        way: how closures are eliminated; each is one process's.
    """

    def __init__(
        self,
        joints: Sequence[PlanJoint],
        trees: Sequence[Tree],
        process: int,
        way: ClosureElimination,
    ) -> None:
        super().__init__(joints, trees, process)
        self.way = way
        own = set(self.owns())
        self.numbers = [k for k, one in enumerate(way.closures) if not own.isdisjoint(one.path)]
        self._left = {k: len(way.closures[k].path) for k in self.numbers}
        self._released: set[int] = set()
        paths = [one.path for one in way.closures if one.apart]
        self._apart = {j for path in paths for j in path if joints[j].parent == 0}

    def looks_at(self) -> Iterable[int]:
        """Return the joints of its closures: rows need the poses of both of their links."""
        return (j for number in self.numbers for j in self.way.closures[number].path)

    def tells_of(self, tree: Tree) -> bool:
        """Return whether others wait for data of a tree, or of a separate tree."""
        return super().tells_of(tree) or tree.base in self._apart

    def evaluation(self, sends: Iterable[int], receives: Iterable[int]) -> list[Step]:
        """Return its steps without kinematics; the rows of its loops come first."""
        rows = [step for number in self.numbers for step in self.way.constraints(number)]
        return [*rows, *super().evaluation(sends, receives)]

    def _inwards(self, tree: Tree) -> Iterator[Step]:
        """Steps of the inward sweep; a base that carries rows is eliminated like other joints."""
        base = tree.base if tree.base in self._apart else None
        yield from (
            step
            for step in super()._inwards(tree)
            if base is None or not isinstance(step, do.FreeBase)
        )
        if base is not None:
            yield from self.way.inwards(base)

    def _solve(self, tree: Tree) -> Iterator[Step]:
        if tree.base is None or tree.base not in self._apart:
            yield from super()._solve(tree)
            return
        number = self.way.closure_of(tree.base)
        assert number is not None  # which is apart
        if number not in self._released:
            yield self.way.eliminate(number)
            self._released.add(number)
            yield do.Release(0, number)
        yield self.way.outwards(tree.base)

    def _outwards_again(self, tree: Tree) -> Iterator[Step]:
        """Steps of accelerations; that of a base which carries rows is known by then."""
        base = tree.base in self._apart
        again = super()._outwards_again(tree)
        return (step for step in again if not (base and isinstance(step, do.FreeAcceleration)))

    def swept(self, own: Sequence[Edge]) -> Iterator[Step]:
        """Yield the inward steps of its joints; a closure ends with its last joint."""
        for edge in reversed(own):
            number = self.way.closure_of(edge.joint)
            if number is None:
                yield do.Articulate(edge.joint, edge.reversed)
                continue
            yield from self.way.inwards(edge.joint)
            self._left[number] -= 1
            if not self._left[number] and not self.way.closures[number].apart:
                yield self.way.eliminate(number)

    def accelerated(self, own: Sequence[Edge]) -> Iterator[Step]:
        """Yield the steps of the accelerations of its joints."""
        for edge in own:
            number = self.way.closure_of(edge.joint)
            if number is None:
                yield do.Accelerate(edge.joint, edge.reversed)
                continue
            if number not in self._released:
                self._released.add(number)
                yield do.Release(self.way.closures[number].top, number)
            yield self.way.outwards(edge.joint)
