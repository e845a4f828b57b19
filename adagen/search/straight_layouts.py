"""Layouts priced as straight lines: the limbs around a root, distributed among processes."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

from adagen.cost import timeline
from adagen.emit.shapes import priced_program
from adagen.errors import AdagenError
from adagen.executor.machine import Machine
from adagen.plan import Plan
from adagen.plan.edges import Edge, edges_from, joints_at
from adagen.plan.gather_trees import Tree, moving_trees
from adagen.plan.robot import PlanJoint
from adagen.plan.types import Process
from adagen.schedule import CostProfile, Schedule
from adagen.schedule.tree import Gathered
from adagen.search.even_shares import heaviest_first

_OPENED = 6
"""Limbs that are opened one after the other."""
_NUMBERS_PLAYED = 250_000
"""Numbers that the layouts which are played compute on one process, all together."""
_LEAST_PLAYED = 8
"""Layouts that are played, however long they are."""


def cheapest_of(
    alone: Schedule,
    layouts: Iterable[Gathered],
    weights: Sequence[float],
    profile: CostProfile,
    make: Callable[[Schedule], Plan],
    shape: str = "unrolled",
    *,
    lower: float = 0.0,
) -> Schedule:
    """Return the layout of least time; the schedule in which one process has it all is the first.

    Args:
        alone: that schedule.
        layouts: where processes gather instead; those that cannot be had are passed over.
        weights: of joints, numbers that are computed for them (``joint_weights``).
        profile: has costs of steps.
        make: makes the plan of a schedule, or raises an AdagenError where that cannot be had.
        shape: of the code (``priced_program``).
        lower: what processes are known to take which exchange anything, microseconds.
    """
    costs = profile.measured
    tried = [_played(alone, profile, make, shape)]
    for gathered in _promising(layouts, weights):
        found = replace(alone, meeting="gather", gathered=gathered, parts=0)
        with suppress(AdagenError):  # it would divide a closure, or is not certified
            tried.append(_played(found, profile, make, shape))
    best = min(tried, key=lambda schedule: schedule.makespan)
    # Whoever exchanges anything waits for a message.
    fastest = max(costs.speeds(alone.processes))
    exchange = costs["unrolled.evaluation"] / fastest + costs.channel("auto").latency
    return replace(
        best,
        lower_bound=min(best.makespan, max(exchange, lower)),
        families=("alone", "gathered"),
        candidates=len(tried),
    )


def _promising(layouts: Iterable[Gathered], weights: Sequence[float]) -> list[Gathered]:
    """Return the layouts that are played: the busiest process of the first computes least.

    All are, but for robots whose straight lines are so long that each takes seconds.
    """
    most = max(_LEAST_PLAYED, int(_NUMBERS_PLAYED / sum(weights)))
    return sorted(dict.fromkeys(layouts), key=lambda each: _busiest(each, weights))[:most]


def _busiest(layout: Gathered, weights: Sequence[float]) -> float:
    """The numbers that the process computes which has most, those of the core included."""
    core, shares = 0.0, dict.fromkeys(layout.owners, 0.0)
    for owner, weight in zip(layout.owners, weights, strict=True):
        if owner is None:
            core += weight
        else:
            shares[owner] += weight
    return core + max(shares.values())


def _played(
    schedule: Schedule, profile: CostProfile, make: Callable[[Schedule], Plan], shape: str
) -> Schedule:
    """A schedule with the time that its program is predicted to take."""
    plan = make(schedule)
    line = timeline(priced_program(plan, shape, profile), profile)
    loads = tuple(line.busy(p) for p in range(len(plan.processes)))
    return replace(schedule, makespan=line.makespan, lower_bound=0.0, loads=loads)


@dataclass(frozen=True)
class _Limb:
    """Joints that are distributed together.

    Attributes:
        first: its joints at the core.
        joints: these and all beyond.
        weight: numbers that are computed for them.
    """

    first: tuple[Edge, ...]
    joints: frozenset[int]
    weight: float


class _Around:
    """A robot seen from its roots.

    Args:
        joints: the robot's joints.
        roots: of each tree of links that move together.
        weights: of joints.
    """

    def __init__(
        self, joints: Sequence[PlanJoint], roots: Sequence[int], weights: Sequence[float]
    ) -> None:
        self.weights = weights
        edges: list[Edge] = []
        for tree, root in zip(moving_trees(joints), roots, strict=True):
            edges += edges_from(root, joints, joints_at(joints, tree.joints))
        self.below: dict[int, list[Edge]] = {}
        for edge in edges:
            self.below.setdefault(edge.near, []).append(edge)
        self.beyond: dict[int, frozenset[int]] = {}
        for edge in reversed(edges):
            further = (self.beyond[each.joint] for each in self._after(edge))
            self.beyond[edge.joint] = frozenset({edge.joint}).union(*further)
        self.limbs = [self.limb([edge]) for edge in edges if edge.near in roots]

    def _after(self, edge: Edge) -> list[Edge]:
        """Joints at the far link of another; nothing is beyond the ground."""
        return self.below.get(edge.far, []) if edge.far else []

    def limb(self, first: Iterable[Edge]) -> _Limb:
        """Return joints at the core with all beyond them."""
        own = tuple(first)
        members = frozenset[int]().union(*(self.beyond[edge.joint] for edge in own))
        return _Limb(own, members, sum(self.weights[j] for j in members))

    def opened(self, limb: _Limb) -> list[_Limb]:
        """Return the branches of a limb, its joints up to them left out; none if it has none."""
        if len(limb.first) > 1:
            return []
        (end,) = limb.first
        while len(self._after(end)) == 1:
            (end,) = self._after(end)
        return [self.limb([edge]) for edge in self._after(end)]

    def merged(self, limbs: list[_Limb], together: Iterable[Collection[int]]) -> list[_Limb]:
        """Return limbs, those that something ties made one."""
        for tied in together:
            touched = [each for each in limbs if not each.joints.isdisjoint(tied)]
            if len(touched) > 1:
                limbs = [each for each in limbs if each not in touched]
                limbs.append(self.limb(edge for each in touched for edge in each.first))
        return limbs


def layouts_at(
    joints: Sequence[PlanJoint],
    roots: Sequence[int],
    weights: Sequence[float],
    processes: int,
    together: Sequence[Collection[int]] = (),
) -> Iterator[Gathered]:
    """Yield layouts on as many processes and on two, from the limbs at the roots on inwards.

    Limbs are distributed, the heaviest first, each to who has least; then the heaviest one is
    opened: its joints up to where it branches become part of the core, its branches are
    distributed.

    Args:
        joints: the robot's joints.
        roots: of each tree of links that move together.
        weights: of joints.
        processes: P.
        together: joints that one process has to have.
    """
    around = _Around(joints, roots, weights)
    limbs = around.limbs
    for _ in range(_OPENED if limbs else 0):
        limbs = around.merged(limbs, together)
        for count in dict.fromkeys((2, min(processes, len(limbs)))):
            if 2 <= count <= min(processes, len(limbs)):
                owner = _owners(limbs, count)
                yield Gathered(tuple(roots), tuple(owner.get(j) for j in range(len(joints))))
        heavy = max(limbs, key=lambda each: (each.weight, -each.first[0].joint))
        branches = around.opened(heavy)
        if not branches:
            return
        limbs = [*(each for each in limbs if each != heavy), *branches]


def whole_trees(
    joints: Sequence[PlanJoint], trees: Sequence[Tree], weights: Sequence[float], processes: int
) -> Iterator[Gathered]:
    """Yield layouts in which each tree of links that move together is one process's.

    Args:
        joints: the robot's joints.
        trees: these.
        weights: of joints.
        processes: P.
    """
    roots = tuple(tree.own_root for tree in trees)
    limbs = []
    for tree in trees:
        own = frozenset((*tree.joints, *([] if tree.base is None else [tree.base])))
        first = Edge(min(own), 0, min(own) + 1, reversed=False)
        limbs.append(_Limb((first,), own, sum(weights[j] for j in own)))
    for count in range(2, min(processes, len(trees)) + 1):
        owner = _owners(limbs, count)
        yield Gathered(roots, tuple(owner[j] for j in range(len(joints))))


def _owners(limbs: Sequence[_Limb], count: int) -> dict[int, int]:
    """The process of each joint, limbs distributed among so many."""
    limbs = sorted(limbs, key=lambda each: each.first[0].joint)
    shares, _ = heaviest_first([each.weight for each in limbs], count)
    return {j: p for p, own in enumerate(shares) for k in own for j in limbs[k].joints}


def joint_weights(process: Process, machine: Machine) -> list[float]:
    """Return the numbers that one process computes for each joint.

    Args:
        process: which does everything.
        machine: it, after all its steps.
    """
    found = [0.0] * len(machine.plan.joints)
    for node in machine.graph.nodes:
        step = process.steps[node.mark]
        joint = getattr(step, "joint", getattr(step, "link", 1) - 1)
        own = machine.rows.own(joint)
        for j in own:
            found[j] += node.width / len(own)
    return found
