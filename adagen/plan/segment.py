"""Form `segment`: the articulated-body algorithm inside a process, joins only at the cuts.

A segment is what one process assembles alone: a maximal subtree of the schedule. Its order of
assembly needs no search (III-D): articulated-body inertias are swept towards the segment's root
with exact projection. If the segment has more handles than its root, the mobility is carried
outwards along the paths to them, by products and sums alone. Nothing is subtracted, so light links
cost no digits, and only links at the cuts need an invertible inertia. With one process this is the
serial articulated-body algorithm.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property

from adagen.plan import steps as do
from adagen.plan.ada import AdaPlanner, Chain, bare
from adagen.plan.edges import Edge, edges_from, is_free_base, joints_at, ways_to
from adagen.plan.fusions import Run
from adagen.plan.parts import pairs_of, parts_of, released_first, swept_first
from adagen.plan.robot import PlanJoint
from adagen.plan.steps import Bias, Block, Force, Spread, Step
from adagen.schedule import Node, Schedule, postorder, preorder
from adagen.schedule.segment_costs import carried_couplings


@dataclass
class Component:
    """Joints of a segment that move together: connected other than through the ground.

    Attributes:
        root: the link that inertias are swept to; 0 is the ground.
        edges: outwards from the root.
        handles: links with joints outside the segment.
    """

    root: int
    edges: list[Edge]
    handles: list[int]

    @cached_property
    def path(self) -> list[Edge]:
        """Edges on the way from the root to a handle, outwards."""
        return ways_to(self.handles, self.root, self.edges)


@dataclass
class Segment:
    """The joints that one process assembles alone.

    Attributes:
        joint: names it.
        free: floating joints on the ground.
        components: its other joints, by what moves together.
    """

    joint: int
    free: list[int]
    components: list[Component]

    def inwards(self) -> tuple[list[Step], list[set[tuple[int, int]]]]:
        """Return the steps of the first sweep, and the links that they couple in each component."""
        steps: list[Step] = []
        for component in self.components:
            if component.root > 0:
                steps.append(do.StartLink(component.root))
            steps.extend(do.StartLink(edge.far) for edge in component.edges)
        steps.extend(do.FreeBase(j) for j in self.free)
        couplings = []
        for component in self.components:
            steps.extend(do.Articulate(e.joint, e.reversed) for e in reversed(component.edges))
            more, coupled = mobility_steps(self.joint, component)
            steps += more
            couplings.append(coupled)
        return steps, couplings

    def outwards(self, forces: Mapping[int, Force]) -> list[Step]:
        """Return the steps of the second sweep.

        Args:
            forces: those on handles, by link.
        """
        steps: list[Step] = []
        for component in self.components:
            handles = set(component.handles)
            loaded = dict.fromkeys(edge.near for edge in component.path)
            loaded.update(dict.fromkeys(component.handles))
            steps.extend(
                do.Load(link, forces.get(link) if link in handles else None)
                for link in loaded
                if link > 0
            )
            steps.extend(do.Deliver(e.joint, e.reversed) for e in reversed(component.path))
            if component.root > 0 and component.handles:
                block = Block(self.joint, component.root, component.root)
                bias = Bias(self.joint, component.root)
                steps.append(do.AccelerateRoot(component.root, block, bias))
        for component in self.components:
            steps.extend(do.Accelerate(e.joint, e.reversed) for e in component.edges)
        steps.extend(do.FreeAcceleration(j) for j in self.free)
        return steps


class SegmentPlanner(AdaPlanner):
    """Builds the processes and messages of form `segment` from joints and a schedule."""

    def __init__(
        self, joints: tuple[PlanJoint, ...], schedule: Schedule, runs: Sequence[Run] = ()
    ) -> None:
        super().__init__(joints, schedule, runs)
        self.inside: set[int] = set()
        # Nodes with all below them on one process, which may be treated as one.
        self.members: dict[int, Node] = {}
        for node in postorder(schedule.root):
            whole = all(
                child.joint in self.members and child.processes[0] == node.processes[0]
                for child in node.children
            )
            if whole and self._belongs(node):
                self.members[node.joint] = node
        self.fusions.leave_to(self.members)
        for node in preorder(schedule.root):
            if node.joint in self.members or node.joint in self.inside:
                self.inside.update(child.joint for child in node.children)

    def _belongs(self, node: Node) -> bool:  # noqa: ARG002 (see plan/clusters.py)
        """Whether a node may be in one segment with those below it."""
        return True

    def _inside(self, node: Node) -> bool:
        return node.joint in self.inside

    def _segment(self, node: Node) -> Chain | None:
        if node.joint not in self.members:
            return None
        members = {below.joint for below in preorder(node)}
        strips = [] if self.asked else parts_of(self.joints, members, self._parts_of(node))
        if strips:
            return self._in_parts(strips, members, node.processes[0])
        return self._whole(node.joint, members, node.processes[0])

    def _parts_of(self, node: Node) -> int:
        """In how many parts a segment is to be; 0: none.

        Of processes that are joined, some place a cut's joint with their own: then parts would not
        be the strips in which links are placed.
        """
        return self.schedule.parts if node is self.schedule.root else 0

    def _in_parts(self, strips: Sequence[range], members: set[int], process: int) -> Chain:
        """Join the parts of a chain, each by its first joint: as a tree, in lanes.

        A joined chain has a handle at both ends wherever more is joined there. Outwards from the
        ground it would have one only, but each join would wait for the one before. What all become
        is joined last to what the chain hangs on: other joints of the segment, a floating base for
        one, or the ground. Loops do not join the ground at all: they begin with what it leaves of
        the first part's mobility.
        """
        parts = [self._whole(strip[1], set(strip[1:]), process) for strip in strips]
        for near, far in pairs_of(len(parts)):
            parts[near] = self._join((strips[far].start,), process, parts[near], parts[far])
        first = strips[0].start
        before = {j for j in members if j < first}
        if before:
            near_side = self._whole(min(before), before, process)
        elif self.joints[first].parent > 0:
            return parts[0]
        else:
            near_side = bare(0, process)
        return self._join((first,), process, near_side, parts[0])

    def _whole(self, name: int, members: set[int], process: int) -> Chain:
        """Assemble joints without any join."""
        for j in members:
            self.open[self.joints[j].parent] -= 1
            self.open[j + 1] -= 1
        handles = {link for link, count in enumerate(self.open) if count > 0}
        segment = segment_of(self.joints, name, members, handles, self.asked)
        steps, couplings = segment.inwards()
        self.steps[process] += steps
        chain = Chain(name, process, segment=segment)
        for component, coupled in zip(segment.components, couplings, strict=True):
            self._show(component, chain, coupled)
        return chain

    def _assemble(self) -> Chain:
        top = super()._assemble()
        if self.schedule.parts:
            self.steps = [swept_first(steps) for steps in self.steps]
        return top

    def _disassemble(self, top: Chain) -> None:
        super()._disassemble(top)
        if self.schedule.parts:
            self.steps = [released_first(steps) for steps in self.steps]

    @staticmethod
    def _show(component: Component, chain: Chain, couplings: set[tuple[int, int]]) -> None:
        """Record the blocks and biases of a component at its handles."""
        name = chain.joint
        for k, g in enumerate(component.handles):
            chain.blocks[g, g] = Block(name, g, g)
            chain.biases[g] = Bias(name, g)
            for h in component.handles[k + 1 :]:
                if (g, h) in couplings:
                    chain.blocks[g, h] = Block(name, g, h)

    def _release(self, chain: Chain, forces: dict[int, Force]) -> None:
        segment = chain.segment
        assert isinstance(segment, Segment)
        self.steps[chain.process] += segment.outwards(forces)


def segment_of(
    joints: Sequence[PlanJoint],
    name: int,
    members: Set[int],
    handles: Container[int],
    asked: Container[int] = (),
) -> Segment:
    """Find the components of a segment, their roots, and the paths to its handles.

    What floats is swept to its base where no joint has to follow, also if the mobility of another
    link is asked for. Swept to that link, the whole robot would be taken out of, say, a shank
    at the knee: of a stretched leg's D four digits are lost there.

    Args:
        joints: the robot's joints.
        name: the joint that names the segment.
        members: its joints.
        handles: links with joints that are neither in the segment nor done with.
        asked: links whose mobility is asked for; they are handles, too.
    """
    free = [j for j in sorted(members) if is_free_base(joints[j])]
    links = set(joints_at(joints, members))
    at = joints_at(joints, sorted(set(members).difference(free)))
    components: list[Component] = []
    left = set(links)
    for start in (0, *sorted(links - {0})):
        if start not in left or (start == 0 and not at.get(0)):
            left.discard(start)
            continue
        together = {start, *(edge.far for edge in edges_from(start, joints, at))}
        left -= together
        own = sorted(h for h in together if h > 0 and (h in handles or h in asked))
        root = start if start == 0 else min((h for h in own if h in handles), default=start)
        components.append(Component(root, edges_from(root, joints, at), own))
    return Segment(name, free, components)


def mobility_steps(name: int, component: Component) -> tuple[list[Step], set[tuple[int, int]]]:
    """Return the steps for Phi and b at handles: inversion at the root, elsewhere outwards.

    Args:
        name: the joint that names the segment.
        component: its joints that move together.

    Returns:
        The steps, and the pairs of links whose coupling they set, the smaller one first.
    """
    couplings: set[tuple[int, int]] = set()
    if component.root > 0 and not component.handles:
        return [do.SolveRoot(component.root)], couplings
    steps: list[Step] = []
    if component.root > 0:
        block, bias = Block(name, component.root, component.root), Bias(name, component.root)
        steps.append(do.InvertRoot(component.root, block, bias))
    ends = [(edge.near, edge.far) for edge in component.path]
    carried = carried_couplings(ends, component.root, set(component.handles))
    for edge, kept in zip(component.path, carried, strict=True):
        couplings.update((min(g, edge.far), max(g, edge.far)) for g in kept)
        ground = edge.near == 0
        steps.append(
            do.Propagate(
                edge.joint,
                edge.reversed,
                Block(name, edge.far, edge.far),
                None if ground else Block(name, edge.near, edge.near),
                Bias(name, edge.far),
                None if ground else Bias(name, edge.near),
                tuple(_spread(name, edge, g) for g in kept),
            )
        )
    return steps, couplings


def _spread(name: int, edge: Edge, g: int) -> Spread:
    """The coupling of a link with an earlier one, carried outwards over an edge."""
    near = (min(g, edge.near), max(g, edge.near))
    far = Block(name, min(g, edge.far), max(g, edge.far))
    return Spread(g, far, edge.far > g, Block(name, *near), near[0] != edge.near)
