"""Steps of one process where processes gather, from the layout of the trees alone (gather.py).

They depend on other processes only through the core and the set of processes that share a tree, so
a search can price the work of one process by itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from adagen.plan import steps as do
from adagen.plan.edges import Edge, edges_from, joints_at, on_the_way
from adagen.plan.gather_trees import Tree
from adagen.plan.messages import Message
from adagen.plan.robot import PlanJoint
from adagen.plan.segment import Component, mobility_steps
from adagen.plan.steps import Bias, Block, Step
from adagen.plan.types import Process


@dataclass(frozen=True)
class Contribution:
    """The data that a process sends to all others of a tree.

    Attributes:
        blocks: the mobility that it found at the root, where the ground shows one.
        biases: the root's bias, likewise.
        inertias: links of the core whose I^A and p^A, as far as it knows them, it sends.
    """

    blocks: tuple[Block, ...]
    biases: tuple[Bias, ...]
    inertias: tuple[int, ...]

    def message(self, source: int, target: int, joint: int) -> Message:
        """Return the message to one of the others."""
        return Message(
            source,
            target,
            "assembly",
            joint,
            blocks=self.blocks,
            biases=self.biases,
            inertias=self.inertias,
        )


def contribution(tree: Tree, process: int) -> Contribution | None:
    """Return the data that a process sends to the others of a tree; None for nothing."""
    shown: set[int] = {
        edge.near
        for edge in tree.edges
        if tree.owner.get(edge.joint) == process and edge.near in tree.core_links
    }
    shown |= {link for link in tree.core_links if tree.link_owner(link) == process}
    blocks: tuple[Block, ...] = ()
    biases: tuple[Bias, ...] = ()
    if tree.grounded == process and not tree.hold:
        shown.discard(tree.root)
        block, bias = _shown(tree.root)
        blocks, biases = (block,), (bias,)
    inertias = tuple(sorted(shown - {0}))
    return Contribution(blocks, biases, inertias) if inertias or blocks else None


def about(tree: Tree) -> int:
    """Return the joint that names a tree's root in messages."""
    return tree.root - 1 if tree.root > 0 else tree.joints[0]


class ProcessSteps:
    """Steps of one process in trees of a known layout.

    Args:
        joints: the robot's joints.
        trees: how processes meet in each tree of moving links; those in which the process takes no
            part may be left out.
        process: the process.
    """

    def __init__(self, joints: Sequence[PlanJoint], trees: Sequence[Tree], process: int) -> None:
        self.joints, self.process = joints, process
        self.trees = [tree for tree in trees if process in tree.participants]

    def owns(self) -> tuple[int, ...]:
        """Return the joints whose acceleration the process gives, ascending."""
        p, found = self.process, []
        for tree in self.trees:
            found += [joint for joint, owner in tree.owner.items() if owner == p]
            found += tree.core if tree.core_owner == p else ()
            if tree.base is not None and self._has_base(tree):
                found.append(tree.base)
        return tuple(sorted(found))

    def _has_base(self, tree: Tree) -> bool:
        return tree.base is not None and tree.link_owner(tree.base + 1) == self.process

    def looks_at(self) -> Iterable[int]:
        """Return further joints whose motion it needs."""
        return ()

    def tells_of(self, tree: Tree) -> bool:
        """Return whether others wait for this process's data about a tree."""
        return len(tree.participants) > 1

    def process_of(self, evaluation: Sequence[Step], recovery: Sequence[Step] = ()) -> Process:
        """Return the process.

        Args:
            evaluation: its steps but for kinematics.
            recovery: what it does instead where no mobility can be treated as a body; nothing where
                that is never done.
        """
        owns = self.owns()
        shared = {joint for tree in self.trees for joint in tree.core}
        reads = on_the_way(self.joints, (*owns, *shared, *self.looks_at()))
        kinematics = [do.Kinematics(joint) for joint in reads]
        again = (*kinematics, *recovery) if recovery else ()
        extra = tuple(sorted(shared.difference(owns)))
        return Process((*kinematics, *evaluation), reads, owns, extra, again)

    def evaluation(self, sends: Iterable[int], receives: Iterable[int]) -> list[Step]:
        """Return its steps without kinematics.

        Args:
            sends: the numbers of the messages that it sends.
            receives: the numbers of those that it takes.
        """
        apart = [tree for tree in self.trees if self.tells_of(tree)]
        alone = [tree for tree in self.trees if not self.tells_of(tree)]
        steps = self._all_inwards(apart)
        steps += map(do.Send, sends)
        steps += self._all_inwards(alone)
        steps += map(do.Receive, receives)
        for tree in self.trees:
            steps += self._solve(tree)
            steps += self._outwards_again(tree)
        return steps

    def _all_inwards(self, trees: Sequence[Tree]) -> list[Step]:
        """Inward steps of some trees, sweep after sweep, so that they can share lanes.

        For that all links are started first.
        """
        steps = [step for tree in trees for step in self._started(tree)]
        return steps + [step for tree in trees for step in self._inwards(tree)]

    def _started(self, tree: Tree) -> Iterator[Step]:
        """The links that a process sweeps, and core links to which it contributes."""
        own, shared = tree.branches(self.process), len(tree.participants) > 1
        yield from (do.StartLink(edge.far) for edge in own if edge.far > 0)
        for link in sorted(tree.core_links - {0}):
            if tree.link_owner(link) == self.process:
                yield do.StartLink(link)
            elif shared:
                yield do.StartEmpty(link)
        if tree.grounded == self.process:
            yield from (do.StartLink(e.far) for e in tree.ground_side if e.far > 0)

    def _inwards(self, tree: Tree) -> Iterator[Step]:
        """Steps of the sweep to the core, and of the core itself."""
        own, grounded = tree.branches(self.process), tree.grounded == self.process
        if tree.base is not None and self._has_base(tree):
            yield do.FreeBase(tree.base)
        if grounded and tree.hold:
            yield from self._from_ground_to(tree, tree.hold)
            yield do.HoldMobility(tree.hold, *_shown(tree.hold))
        yield from self.swept(own)
        if grounded and not tree.hold:
            yield from self._from_ground_to(tree, tree.root)
            yield do.StartEmpty(tree.root)  # from now on: what the others add

    def swept(self, own: Sequence[Edge]) -> Iterator[Step]:
        """Yield the inward steps of the process's own joints, which are given outwards."""
        return (do.Articulate(edge.joint, edge.reversed) for edge in reversed(own))

    def accelerated(self, own: Sequence[Edge]) -> Iterator[Step]:
        """Yield the acceleration steps of the process's own joints."""
        return _accelerated(own)

    def _from_ground_to(self, tree: Tree, link: int) -> Iterator[Step]:
        """Phi and b of a link with all joints between it and the ground, from the ground."""
        component = self._from_ground(tree, link)
        yield from (do.Articulate(e.joint, e.reversed) for e in reversed(component.edges))
        yield from mobility_steps(link - 1, component)[0]

    def _from_ground(self, tree: Tree, link: int) -> Component:
        """The ground's side as a component whose root is the ground and whose handle is a link."""
        at = joints_at(self.joints, (edge.joint for edge in tree.ground_side))
        return Component(0, edges_from(0, self.joints, at), [link])

    def _solve(self, tree: Tree) -> Iterator[Step]:
        yield from (do.Articulate(e.joint, e.reversed) for e in reversed(tree.core_edges))
        if tree.grounded is not None and not tree.hold:
            yield do.SolveMobility(tree.root, *_shown(tree.root))
        elif tree.root > 0:
            yield do.SolveRoot(tree.root)

    def _outwards_again(self, tree: Tree) -> Iterator[Step]:
        own = tree.branches(self.process)
        grounded = tree.grounded == self.process
        yield from _accelerated(tree.core_edges)
        if grounded and tree.hold:
            yield from self.accelerated(own)
        if grounded:
            link = tree.hold or tree.root
            component = self._from_ground(tree, link)
            yield from (do.Load(e.near, None) for e in component.path if e.near > 0)
            yield do.LoadRoot(link, held=tree.hold > 0)
            yield from (do.Deliver(e.joint, e.reversed) for e in reversed(component.path))
            yield from _accelerated(component.edges)
        if not (grounded and tree.hold):
            yield from self.accelerated(own)
        if tree.base is not None and self._has_base(tree):
            yield do.FreeAcceleration(tree.base)


def _shown(link: int) -> tuple[Block, Bias]:
    return Block(link - 1, link, link), Bias(link - 1, link)


def _accelerated(edges: Iterable[Edge]) -> Iterator[Step]:
    return (do.Accelerate(edge.joint, edge.reversed) for edge in edges)
