"""Form `segment`: inside one process the articulated-body algorithm, joins only at the cuts.

A segment is what one process assembles without anyone else: a maximal subtree of the schedule.
Inside it no order needs to be searched (III-D): articulated-body inertias are swept towards the
segment's root with exact projection, and where the segment has more handles than its root, the
mobility is carried outwards along the paths to them, by products and sums alone. Nothing is
subtracted, so that light links cost no digits, and only links at the cuts need an invertible
inertia. With one process this is the serial articulated-body algorithm.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from adagen.plan.ada import AdaPlanner, Chain
from adagen.plan.fusions import Run
from adagen.plan.steps import (
    Accelerate,
    AccelerateRoot,
    Articulate,
    Bias,
    Block,
    Deliver,
    Force,
    FreeAcceleration,
    FreeBase,
    InvertRoot,
    Load,
    Propagate,
    SolveRoot,
    Spread,
    StartLink,
)
from adagen.plan.types import PlanJoint
from adagen.schedule import Node, Schedule, postorder, preorder


@dataclass(frozen=True)
class Edge:
    """A joint of a component, seen from its root."""

    joint: int
    near: int
    far: int
    reversed: bool


@dataclass
class Component:
    """Joints of a segment that move together: connected other than through the ground.

    Attributes:
        root: the link that inertias are swept to; 0 is the ground.
        edges: outwards from the root.
        handles: links with joints outside the segment.
        path: edges on the way from the root to a handle, outwards.
    """

    root: int
    edges: list[Edge] = field(default_factory=list)
    handles: list[int] = field(default_factory=list)
    path: list[Edge] = field(default_factory=list)


@dataclass
class _Segment:
    joint: int  # names it: the topmost joint of its schedule
    free: list[int]  # floating joints on the ground
    components: list[Component]


class SegmentPlanner(AdaPlanner):
    """Builds the processes and messages of form `segment` from joints and a schedule."""

    def __init__(
        self, joints: tuple[PlanJoint, ...], schedule: Schedule, runs: Sequence[Run] = ()
    ) -> None:
        super().__init__(joints, schedule, runs)
        self.members: dict[int, list[int]] = {}  # joints below a node that are all on one process
        self.inside: set[int] = set()
        for node in postorder(schedule.root):
            parts = [self.members.get(child.joint) for child in node.children]
            same = all(child.processes[0] == node.processes[0] for child in node.children)
            if same and None not in parts and self._belongs(node):
                self.members[node.joint] = [
                    node.joint,
                    *(j for part in parts if part for j in part),
                ]
        self.fusions.leave_to(self.members)
        for node in preorder(schedule.root):
            if node.joint in self.members or node.joint in self.inside:
                self.inside.update(child.joint for child in node.children)

    def _belongs(self, node: Node) -> bool:  # noqa: ARG002 (see plan/clusters.py)
        """Whether a node may be in one segment with those below it, process and all else equal."""
        return True

    def _inside(self, node: Node) -> bool:
        return node.joint in self.inside

    def _segment(self, node: Node) -> Chain | None:
        if node.joint not in self.members:
            return None
        members = set(self.members[node.joint])
        for j in members:
            self.open[self.joints[j].parent] -= 1
            self.open[j + 1] -= 1
        segment = self._laid_out(node.joint, members)
        process = node.processes[0]
        chain = Chain(node.joint, process, segment=segment)
        steps = self.steps[process]
        for component in segment.components:
            if component.root > 0:
                steps.append(StartLink(component.root))
            steps.extend(StartLink(edge.far) for edge in component.edges)
        steps.extend(FreeBase(j) for j in segment.free)
        for component in segment.components:
            steps.extend(Articulate(e.joint, e.reversed) for e in reversed(component.edges))
            self._mobility(component, chain)
        return chain

    def _laid_out(self, name: int, members: set[int]) -> _Segment:
        """Find the components of a segment, a root for each, and the paths to its handles."""
        free = [j for j in sorted(members) if self._is_free(j)]
        at: dict[int, list[int]] = {}
        links: set[int] = set()
        for j in sorted(members):
            links.update({self.joints[j].parent, j + 1})
            if j not in free:
                at.setdefault(self.joints[j].parent, []).append(j)
                at.setdefault(j + 1, []).append(j)
        components: list[Component] = []
        left = set(links)
        for start in (0, *sorted(links - {0})):
            if start not in left or (start == 0 and not at.get(0)):
                left.discard(start)
                continue
            handles = sorted(h for h in self._reach(start, at) if h > 0 and self.open[h] > 0)
            root = start if start == 0 or not handles else handles[0]
            component = Component(root, self._outwards(root, at), handles)
            left -= {root, *(edge.far for edge in component.edges)}
            component.path = self._path(component)
            components.append(component)
        return _Segment(name, free, components)

    def _is_free(self, j: int) -> bool:
        joint = self.joints[j]
        return joint.parent == 0 and joint.kind == "floating" and not joint.prescribed

    def _reach(self, start: int, at: dict[int, list[int]]) -> list[int]:
        return [start, *(edge.far for edge in self._outwards(start, at))]

    def _outwards(self, root: int, at: dict[int, list[int]]) -> list[Edge]:
        """The joints of a component, each after those between it and the root, depth first.

        So joints that follow each other along a limb stay together: shape kernels sweeps them in
        one loop.
        """

        def beyond(near: int, came: int) -> list[Edge]:
            found = []
            for j in at.get(near, []):
                if j != came:
                    down = self.joints[j].parent == near
                    found.append(Edge(j, near, j + 1 if down else self.joints[j].parent, not down))
            return found

        edges: list[Edge] = []
        waiting = beyond(root, -1)[::-1]
        while waiting:
            edge = waiting.pop()
            edges.append(edge)
            waiting.extend(reversed(beyond(edge.far, edge.joint)))
        return edges

    @staticmethod
    def _path(component: Component) -> list[Edge]:
        """Depth-first from the root, the edges that lead to a handle."""
        wanted = set(component.handles)
        for edge in reversed(component.edges):
            if edge.far in wanted:
                wanted.add(edge.near)
        below: dict[int, list[Edge]] = {}
        for edge in component.edges:
            if edge.far in wanted:
                below.setdefault(edge.near, []).append(edge)
        path: list[Edge] = []
        stack = list(reversed(below.get(component.root, [])))
        while stack:
            edge = stack.pop()
            path.append(edge)
            stack.extend(reversed(below.get(edge.far, [])))
        return path

    def _mobility(self, component: Component, chain: Chain) -> None:
        """Phi and b at the handles: at the root by inversion, elsewhere carried outwards."""
        name, steps = chain.joint, self.steps[chain.process]
        assert name is not None  # segments are named by a joint
        if component.root > 0 and not component.handles:
            steps.append(SolveRoot(component.root))
            return
        reached: list[int] = []  # links whose coupling with later ones is kept, in order
        if component.root > 0:
            block, bias = Block(name, component.root, component.root), Bias(name, component.root)
            steps.append(InvertRoot(component.root, block, bias))
            reached.append(component.root)
        anchors = self._anchors(component)
        couplings: set[tuple[int, int]] = set()
        for place, edge in enumerate(component.path):
            spreads = []
            for g in reached:
                near = (min(g, edge.near), max(g, edge.near))
                keep = g in component.handles or place < anchors.get(g, -1)
                if keep and (g == edge.near or near in couplings):
                    spreads.append(
                        Spread(
                            g,
                            Block(name, min(g, edge.far), max(g, edge.far)),
                            edge.far > g,
                            Block(name, *near),
                            near[0] != edge.near,
                        )
                    )
                    couplings.add((min(g, edge.far), max(g, edge.far)))
            ground = edge.near == 0
            steps.append(
                Propagate(
                    edge.joint,
                    edge.reversed,
                    Block(name, edge.far, edge.far),
                    None if ground else Block(name, edge.near, edge.near),
                    Bias(name, edge.far),
                    None if ground else Bias(name, edge.near),
                    tuple(spreads),
                )
            )
            if edge.far in component.handles or edge.far in anchors:
                reached.append(edge.far)
        for k, g in enumerate(component.handles):
            chain.blocks[g, g] = Block(name, g, g)
            chain.biases[g] = Bias(name, g)
            for h in component.handles[k + 1 :]:
                if (g, h) in couplings:
                    chain.blocks[g, h] = Block(name, g, h)

    @staticmethod
    def _anchors(component: Component) -> dict[int, int]:
        """Links where paths to handles part, and the place in the path of the last branch."""
        last: dict[int, int] = {}
        count: dict[int, int] = {}
        for place, edge in enumerate(component.path):
            last[edge.near] = place
            count[edge.near] = count.get(edge.near, 0) + 1
        return {link: place for link, place in last.items() if link > 0 and count[link] > 1}

    def _release(self, chain: Chain, forces: dict[int, Force]) -> None:
        segment = chain.segment
        assert isinstance(segment, _Segment)
        steps = self.steps[chain.process]
        for component in segment.components:
            loaded = dict.fromkeys(edge.near for edge in component.path)
            loaded.update(dict.fromkeys(component.handles))
            steps.extend(
                Load(link, forces.get(link) if link in component.handles else None)
                for link in loaded
                if link > 0
            )
            steps.extend(Deliver(e.joint, e.reversed) for e in reversed(component.path))
            if component.root > 0 and component.handles:
                name = segment.joint
                block = Block(name, component.root, component.root)
                steps.append(AccelerateRoot(component.root, block, Bias(name, component.root)))
        for component in segment.components:
            steps.extend(Accelerate(e.joint, e.reversed) for e in component.edges)
        steps.extend(FreeAcceleration(j) for j in segment.free)
