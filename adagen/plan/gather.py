"""Form `segment` with one exchange: every process's articulated bodies gathered at a small core.

A root link is chosen for each tree of moving links. Joints with two or more processes beyond them,
seen from the root, are its *core*; all else is branches of one process each. A process sweeps its
branches onto the core's links and tells the others what it found there: inertias and bias forces,
27 numbers for each link. Then each sweeps the core for itself, solves for the root's acceleration
and goes outwards, through the core and its own branches. With two processes and one cut the core is
a single link, and the work is the serial algorithm's, shared out, with one handshake. Inertias are
only added, so nothing needs to be inverted at a cut.

Where the ground is beyond the root, its side is swept outwards from the ground: the mobility of the
first link that enough joints hold is inverted, and from there on the ground is a body like others.
In a pose where that mobility is all but singular, the evaluation is done again without: then the
root shows its mobility Phi and bias b, and (1 + Phi I) a = b - Phi p is solved.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from adagen.plan.ada import Chain
from adagen.plan.edges import Edge, edges_from, joints_at
from adagen.plan.gather_trees import Tree, laid_out_trees
from adagen.plan.segment import Component, SegmentPlanner
from adagen.plan.steps import (
    Accelerate,
    Articulate,
    Bias,
    Block,
    Deliver,
    FreeAcceleration,
    FreeBase,
    HoldMobility,
    Kinematics,
    Load,
    LoadRoot,
    Receive,
    Send,
    SolveMobility,
    SolveRoot,
    StartEmpty,
    StartLink,
    Step,
)
from adagen.plan.types import Message, PlanJoint, Process
from adagen.schedule import postorder

SMALL_CORE = 8
"""A core is small with at most one joint in so many."""


def why_not_gather(joints: Sequence[PlanJoint]) -> str | None:
    """Return why processes of a robot cannot gather, None where they can.

    What gathers is emitted in shape kernels, which does not know everything.
    """
    for joint in joints:
        if joint.mimic is not None:
            return f'joint "{joint.name}" is slaved to another'
        own = joint.damping or joint.friction or joint.stiffness or joint.rotor_inertia
        if own and joint.kind in ("planar", "floating"):
            return f'joint "{joint.name}" has several freedoms and effects of its own'
    return None


class GatherPlanner(SegmentPlanner):
    """Builds the processes and messages of form `segment` with one exchange."""

    def suits(self) -> bool:
        """Whether gathering pays: a small core, and work of its own for every process."""
        trees = self.trees()
        core = sum(len(tree.core) for tree in trees)
        left = {p for tree in trees for p in tree.owner.values()}
        busy = {node.processes[0] for node in postorder(self.schedule.root)}
        return core * SMALL_CORE <= len(self.joints) and left == busy

    def trees(self) -> list[Tree]:
        """Return the trees of links that move together, laid out for the schedule's processes."""
        assigned: dict[int, int] = {}  # process of each joint inside a segment
        first: dict[int, int] = {}  # of every joint
        for node in postorder(self.schedule.root):
            first[node.joint] = node.processes[0]
            if node.joint in self.members:
                assigned[node.joint] = node.processes[0]
        return laid_out_trees(self.joints, assigned, first)

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps, and the messages between them."""
        trees = self.trees()
        shares: list[set[int]] = [set() for _ in self.steps]
        for tree in trees:
            for joint, p in tree.owner.items():
                self.owns[p].append(joint)
            self.owns[tree.core_owner] += sorted(tree.core)
            if tree.base is not None:
                self.owns[tree.link_owner(tree.base + 1)].append(tree.base)
            for p in tree.participants:
                shares[p] |= tree.core
        steps = self._evaluation(trees)
        recovery: list[list[Step]] = [[] for _ in steps]
        if any(tree.hold for tree in trees):
            recovery = self._evaluation([replace(tree, hold=0) for tree in trees])
        processes = []
        for p, (owns, shared) in enumerate(zip(self.owns, shares, strict=True)):
            reads = self._reads([*owns, *shared])
            kinematics = [Kinematics(j) for j in reads]
            again = (*kinematics, *recovery[p]) if recovery[p] else ()
            extra = tuple(sorted(shared - set(owns)))
            own = tuple(sorted(owns))
            processes.append(Process((*kinematics, *steps[p]), reads, own, extra, again))
        return tuple(processes), tuple(self.messages)

    def _evaluation(self, trees: list[Tree]) -> list[list[Step]]:
        """Return the steps of every process but for kinematics; messages are added."""
        self.steps = [[] for _ in self.steps]
        first = len(self.messages)
        apart = [tree for tree in trees if len(tree.participants) > 1]
        for tree in apart:
            self._inwards(tree)
        for tree in apart:
            self._exchange(tree)
        for tree in trees:
            if tree not in apart:
                self._inwards(tree)
        for number, message in enumerate(self.messages[first:], start=first):
            self.steps[message.target].append(Receive(number))
        for tree in trees:
            self._solve(tree)
            self._outwards_again(tree)
        return self.steps

    def _inwards(self, tree: Tree) -> None:
        shared = len(tree.participants) > 1
        for p in tree.participants:
            own, steps = tree.branches(p), self.steps[p]
            steps.extend(StartLink(edge.far) for edge in own if edge.far > 0)
            for link in sorted(tree.core_links - {0}):
                mine = tree.link_owner(link) == p
                if mine:
                    steps.append(StartLink(link))
                elif shared:
                    steps.append(StartEmpty(link))
            if tree.grounded == p:
                steps.extend(StartLink(e.far) for e in tree.ground_side if e.far > 0)
            if tree.base is not None and tree.link_owner(tree.base + 1) == p:
                steps.append(FreeBase(tree.base))
            if tree.grounded == p and tree.hold:
                self._from_ground_to(tree, tree.hold)
                steps.append(HoldMobility(tree.hold, *self._shown(tree.hold)))
            steps.extend(Articulate(e.joint, e.reversed) for e in reversed(own))
            if tree.grounded == p and not tree.hold:
                self._from_ground_to(tree, tree.root)
                steps.append(StartEmpty(tree.root))  # from now on: what the others add

    def _from_ground_to(self, tree: Tree, link: int) -> None:
        """Phi and b of a link with all between it and the ground, swept from the ground."""
        component = self._from_ground(tree, link)
        assert tree.grounded is not None
        steps = self.steps[tree.grounded]
        steps.extend(Articulate(e.joint, e.reversed) for e in reversed(component.edges))
        self._mobility(component, Chain(link - 1, tree.grounded))

    @staticmethod
    def _shown(link: int) -> tuple[Block, Bias]:
        return Block(link - 1, link, link), Bias(link - 1, link)

    def _from_ground(self, tree: Tree, link: int) -> Component:
        """The ground's side as a component whose root is the ground and whose handle is a link."""
        at = joints_at(self.joints, (edge.joint for edge in tree.ground_side))
        return Component(0, edges_from(0, self.joints, at), [link])

    def _exchange(self, tree: Tree) -> None:
        """Tell each other what was found at the core."""
        for p in tree.participants:
            shown: set[int] = {
                edge.near
                for edge in tree.edges
                if tree.owner.get(edge.joint) == p and edge.near in tree.core_links
            }
            shown |= {link for link in tree.core_links if tree.link_owner(link) == p}
            blocks: tuple[Block, ...] = ()
            biases: tuple[Bias, ...] = ()
            if tree.grounded == p and not tree.hold:
                shown.discard(tree.root)
                block, bias = self._shown(tree.root)
                blocks, biases = (block,), (bias,)
            inertias = tuple(sorted(shown - {0}))
            if not (inertias or blocks):
                continue
            for other in tree.participants:
                if other != p:
                    number = len(self.messages)
                    joint = self._about(tree)
                    self.messages.append(
                        Message(p, other, "assembly", joint, blocks, biases, inertias=inertias)
                    )
                    self.steps[p].append(Send(number))

    def _about(self, tree: Tree) -> int:
        """The joint that stands for a tree's root in messages."""
        return tree.root - 1 if tree.root > 0 else tree.joints[0]

    def _solve(self, tree: Tree) -> None:
        for p in tree.participants:
            steps = self.steps[p]
            steps.extend(Articulate(e.joint, e.reversed) for e in reversed(tree.core_edges))
            if tree.grounded is not None and not tree.hold:
                steps.append(SolveMobility(tree.root, *self._shown(tree.root)))
            elif tree.root > 0:
                steps.append(SolveRoot(tree.root))

    def _outwards_again(self, tree: Tree) -> None:
        for p in tree.participants:
            own, steps = tree.branches(p), self.steps[p]
            steps.extend(self._accelerated(tree.core_edges))
            if tree.grounded == p and tree.hold:
                steps.extend(self._accelerated(own))
            if tree.grounded == p:
                link = tree.hold or tree.root
                component = self._from_ground(tree, link)
                steps.extend(Load(e.near, None) for e in component.path if e.near > 0)
                steps.append(LoadRoot(link, held=tree.hold > 0))
                steps.extend(Deliver(e.joint, e.reversed) for e in reversed(component.path))
                steps.extend(self._accelerated(component.edges))
            if not (tree.grounded == p and tree.hold):
                steps.extend(self._accelerated(own))
            if tree.base is not None and tree.link_owner(tree.base + 1) == p:
                steps.append(FreeAcceleration(tree.base))

    @staticmethod
    def _accelerated(edges: Iterable[Edge]) -> list[Accelerate]:
        return [Accelerate(edge.joint, edge.reversed) for edge in edges]
