"""Robots in which runs or clusters of joints are joined as one, as the scheduler sees them.

A run that is joined as one is one joint to the search, and a cluster of links is one link. The
schedule that is found is unfolded to one of all joints.
"""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from itertools import pairwise

from adagen.schedule.profile import CostProfile
from adagen.schedule.sweeps import loads_of, makespan_of
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Node, Schedule, preorder
from adagen.schedule.tree_draft import Draft


@dataclass(frozen=True)
class Fold:
    """A robot, and the folded robot that the search sees.

    Attributes:
        full: the robot.
        topology: with one joint for each run and one link for each cluster.
        joints: for each joint of ``topology`` those that it stands for, outwards.
        inner: for each link of ``topology`` the joints inside of it, in depth-first order.
    """

    full: Topology
    topology: Topology
    joints: tuple[tuple[int, ...], ...]
    inner: tuple[tuple[int, ...], ...]

    @property
    def trivial(self) -> bool:
        """Whether every joint is a place to join at, by itself."""
        return len(self.topology) == len(self.full)

    def unfold(self, schedule: Schedule, profile: CostProfile) -> Schedule:
        """Return a schedule of ``topology`` as one of all joints.

        What is inside a link is assembled by the first process that has a joint at it.
        """
        if self.trivial:
            return schedule
        draft = Draft(len(self.full))
        for node in preorder(schedule.root):
            self._unfold_node(draft, node)
        draft.root = self._top(schedule.root)
        root = draft.finish(self.full, profile)
        makespan = makespan_of(root)
        lower = min(schedule.lower_bound, makespan)
        return replace(
            schedule,
            root=root,
            makespan=makespan,
            lower_bound=lower,
            loads=loads_of(root, schedule.processes),
        )

    def _unfold_node(self, draft: Draft, node: Node) -> None:
        """Add a run's joints below each other, on the side of the process that joins them."""
        run, (first, _) = self.joints[node.joint], node.processes
        sides = [side.processes for side in node.children if side.processes[0] == first]
        for joint in run:
            draft.ranges[joint] = sides[0] if sides else node.processes
        draft.ranges[self._top(node)] = node.processes
        for above, below in pairwise(run):
            if self._top(node) == run[0]:
                draft.end_child[above] = below
            else:
                draft.root_child[below] = above
        parent = self.topology.parents[node.joint]
        draft.root_child[run[0]] = self._side(draft, node, node.root_side, parent)
        draft.end_child[run[-1]] = self._side(draft, node, node.end_side, node.joint + 1)

    def _top(self, node: Node) -> int:
        """The joint of a node's run that is above the others in the schedule of all joints."""
        run, root_side = self.joints[node.joint], node.root_side
        beyond = root_side is not None and root_side.processes[0] != node.processes[0]
        return run[0] if beyond else run[-1]

    def _side(self, draft: Draft, node: Node, side: Node | None, link: int) -> int:
        """The top joint of one side of a node, -1 for a bare link."""
        if side is not None:
            return self._top(side)
        inner = self.inner[link]
        if not inner:
            return -1
        for joint in inner:
            draft.ranges[joint] = node.processes
        return draft.contract(self.full, inner[::-1])


def fold(
    topology: Topology, runs: Sequence[tuple[int, ...]], inside: AbstractSet[int] = frozenset()
) -> Fold:
    """Return the folded robot for the search.

    Args:
        topology: the robot.
        runs: joints in rows, outwards, that are each to be joined as one.
        inside: joints that are no places to join at; runs among them are left alone.
    """
    run_of = {j: run for run in runs if inside.isdisjoint(run) for j in run}
    joints: list[tuple[int, ...]] = []
    inner: list[list[int]] = [[]]
    link_of = [0] * (len(topology) + 1)  # link of the fold that a link belongs to
    parents: list[int] = []
    for j, parent in enumerate(topology.parents):
        run = run_of.get(j, (j,))
        if j in inside:
            link_of[j + 1] = link_of[parent]
            inner[link_of[parent]].append(j)
        elif j == run[-1]:
            joints.append(run)
            parents.append(link_of[topology.parents[run[0]]])
            link_of[j + 1] = len(joints)
            inner.append([])
    dofs = tuple(min(6, sum(topology.dofs[j] for j in run)) for run in joints)
    return Fold(
        topology,
        Topology(
            tuple(parents),
            dofs,
            tuple("+".join(topology.names[j] for j in run) for run in joints),
            tuple(_kind(topology, run, n) for run, n in zip(joints, dofs, strict=True)),
            frozenset(k for k, run in enumerate(joints) if topology.prescribed.issuperset(run)),
            tuple(sum(map(topology.tangents_of, run)) for run in joints),
        ),
        tuple(joints),
        tuple(map(tuple, inner)),
    )


def _kind(topology: Topology, run: tuple[int, ...], dofs: int) -> str:
    """The kind whose costs come nearest to those of a run."""
    if len(run) == 1:
        return topology.kind(run[0])
    return "spherical" if dofs < 6 else "floating"
