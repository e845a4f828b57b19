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
from dataclasses import dataclass, field, replace

from adagen.model.kinds import KINDS
from adagen.plan.ada import Chain
from adagen.plan.segment import Component, Edge, SegmentPlanner
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
from adagen.plan.types import Message, PlanJoint, PlanWrench, Process
from adagen.schedule import postorder

SMALL_CORE = 8
"""A core is small with at most one joint in so many."""

HELD_FREEDOMS = 8
"""Freedoms between the ground and a link whose mobility is taken for an inertia: 6 make it regular
in general, a few more keep it so in most poses."""


def why_not_gather(joints: Sequence[PlanJoint], wrenches: Sequence[PlanWrench]) -> str | None:
    """Return why processes of a robot cannot gather, None where they can.

    What gathers is emitted in shape kernels, which does not know everything.
    """
    if wrenches:
        return f'an outer force acts on link "{wrenches[0].name}"'
    for joint in joints:
        if joint.mimic is not None:
            return f'joint "{joint.name}" is slaved to another'
        if joint.prescribed:
            return f'the motion of joint "{joint.name}" is prescribed'
        own = joint.damping or joint.friction or joint.stiffness or joint.rotor_inertia
        if own and KINDS[joint.kind].nv > 1:
            return f'joint "{joint.name}" has several freedoms and effects of its own'
    return None


@dataclass
class Tree:
    """Links that move together, and how their processes meet.

    Attributes:
        links: its links.
        joints: its joints, those on the ground that do not float among them.
        base: the floating joint on the ground that holds it, if any.
        root: the link that all inertias are swept to; 0 is the ground.
        edges: its joints outwards from the root.
        owner: the process of each joint that is not in the core.
        core: joints of the core.
        core_owner: the process that adds what belongs to the core itself.
        grounded: the process whose branch holds the ground beyond the root, if any.
        hold: the link on the way to the ground from which on the ground is taken for a body; 0
            where the root shows its mobility.
    """

    links: list[int]
    joints: list[int]
    base: int | None
    root: int = 0
    edges: list[Edge] = field(default_factory=list)
    owner: dict[int, int] = field(default_factory=dict)
    core: set[int] = field(default_factory=set)
    core_owner: int = 0
    grounded: int | None = None
    hold: int = 0

    @property
    def participants(self) -> list[int]:
        """Processes that have joints in it, ascending."""
        return sorted({self.core_owner, *self.owner.values()})

    @property
    def core_links(self) -> set[int]:
        """Links of the core, the root among them."""
        return {self.root, *(edge.far for edge in self.edges if edge.joint in self.core)}


class GatherPlanner(SegmentPlanner):
    """Builds the processes and messages of form `segment` with one exchange."""

    def plan(self) -> tuple[tuple[Process, ...], tuple[Message, ...]]:
        """Return every process's steps, and the messages between them."""
        trees = self.trees()
        shares: list[set[int]] = [set() for _ in self.steps]
        for tree in trees:
            for joint, p in tree.owner.items():
                self.owns[p].append(joint)
            self.owns[tree.core_owner] += sorted(tree.core)
            if tree.base is not None:
                self.owns[self._link_owner(tree, tree.base + 1)].append(tree.base)
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

    def suits(self) -> bool:
        """Whether gathering pays: a small core, and work of its own for every process."""
        trees = self.trees()
        core = sum(len(tree.core) for tree in trees)
        left = {p for tree in trees for p in tree.owner.values()}
        busy = {node.processes[0] for node in postorder(self.schedule.root)}
        return core * SMALL_CORE <= len(self.joints) and left == busy

    # --- layout --------------------------------------------------------------------------------

    def trees(self) -> list[Tree]:
        """Return the trees of links that move together, laid out for the schedule's processes."""
        assigned: dict[int, int] = {}  # process of each joint inside a segment
        first: dict[int, int] = {}  # of every joint
        for node in postorder(self.schedule.root):
            first[node.joint] = node.processes[0]
            if node.joint in self.members:
                assigned[node.joint] = node.processes[0]
        return [self._laid_out_tree(tree, assigned, first) for tree in self._moving()]

    def _moving(self) -> list[Tree]:
        trees: dict[int, Tree] = {}  # by the joint on the ground
        top = [0] * len(self.joints)
        for j, joint in enumerate(self.joints):
            top[j] = j if joint.parent == 0 else top[joint.parent - 1]
            if joint.parent == 0:
                trees[j] = Tree([j + 1], [], j) if self._is_free(j) else Tree([j + 1], [j], None)
            else:
                trees[top[j]].links.append(j + 1)
                trees[top[j]].joints.append(j)
        return list(trees.values())

    def _laid_out_tree(self, tree: Tree, assigned: dict[int, int], first: dict[int, int]) -> Tree:
        at: dict[int, list[int]] = {}
        for j in tree.joints:
            at.setdefault(self.joints[j].parent, []).append(j)
            at.setdefault(j + 1, []).append(j)
        involved = {assigned[j] for j in tree.joints if j in assigned}
        ground = 0 if tree.base is None else tree.base + 1
        candidates = [ground]
        if len(involved) > 1:
            apart = [j for j in tree.joints if j not in assigned]
            touched = {link for j in apart for link in (self.joints[j].parent, j + 1)}
            candidates += sorted(touched - {0, ground})
        best: Tree | None = None
        for root in candidates:
            found = self._rooted(tree, root, at, assigned, first)
            if found is not None and (best is None or len(found.core) < len(best.core)):
                best = found
        assert best is not None  # the ground, or the base, always serves as a root
        return best

    def _rooted(
        self,
        tree: Tree,
        root: int,
        at: dict[int, list[int]],
        assigned: dict[int, int],
        first: dict[int, int],
    ) -> Tree | None:
        """Return the tree with a root; None if processes other than one hold the ground beyond."""
        edges = self._outwards(root, at)
        beyond: dict[int, set[int]] = {}  # of each link: processes of the joints behind it
        owner: dict[int, int] = {}
        core: set[int] = set()
        for edge in reversed(edges):
            found = set(beyond.get(edge.far, set()))
            if edge.joint in assigned:
                found.add(assigned[edge.joint])
            if len(found) > 1:
                core.add(edge.joint)
            else:
                owner[edge.joint] = next(iter(found), first[edge.joint])
                found = {owner[edge.joint]}
            beyond.setdefault(edge.near, set()).update(found)
        grounded = None
        if root > 0 and tree.base is None:
            hold = next(edge.joint for edge in edges if edge.far == 0)
            if hold in core:
                return None
            grounded = owner[hold]
            if root - 1 in core:  # it would have to be passed before the ground is known
                return None
        counts = {p: list(owner.values()).count(p) for p in set(owner.values())}
        least = min(counts, key=lambda p: (counts[p], p)) if counts else first[tree.base or 0]
        result = Tree(tree.links, tree.joints, tree.base, root, edges, owner, core, least)
        result.grounded = grounded
        result.hold = self._hold(root) if grounded is not None else 0
        return result

    def _hold(self, root: int) -> int:
        """The link that enough joints hold to make its mobility regular; 0 if that is the root."""
        way, link = [], root
        while link > 0:
            way.append(link - 1)
            link = self.joints[link - 1].parent
        freedoms = 0
        for joint in reversed(way[1:]):
            freedoms += KINDS[self.joints[joint].kind].nv
            if freedoms >= HELD_FREEDOMS:
                return joint + 1
        return 0

    def _link_owner(self, tree: Tree, link: int) -> int:
        """The process that adds a link's own inertia."""
        if link == tree.root and tree.grounded is not None:
            return tree.grounded
        if link in tree.core_links:
            return tree.core_owner
        return next(tree.owner[edge.joint] for edge in tree.edges if edge.far == link)

    def _ground_side(self, tree: Tree) -> list[Edge]:
        """Joints that are swept from the ground, seen from the root: those up to the link held."""
        if tree.grounded is None:
            return []
        found, reached = [], {tree.hold or tree.root}
        for edge in tree.edges:
            if edge.near in reached and tree.owner.get(edge.joint) == tree.grounded:
                found.append(edge)
                if edge.far > 0:
                    reached.add(edge.far)
        return found

    # --- steps ---------------------------------------------------------------------------------

    def _inwards(self, tree: Tree) -> None:
        held = self._ground_side(tree)
        hidden = {edge.joint for edge in held}
        shared = len(tree.participants) > 1
        for p in tree.participants:
            own = [e for e in tree.edges if tree.owner.get(e.joint) == p and e.joint not in hidden]
            steps = self.steps[p]
            steps.extend(StartLink(edge.far) for edge in own if edge.far > 0)
            for link in sorted(tree.core_links - {0}):
                mine = self._link_owner(tree, link) == p
                if mine:
                    steps.append(StartLink(link))
                elif shared:
                    steps.append(StartEmpty(link))
            if tree.grounded == p:
                steps.extend(StartLink(e.far) for e in held if e.far > 0)
            if tree.base is not None and self._link_owner(tree, tree.base + 1) == p:
                steps.append(FreeBase(tree.base))
            if tree.grounded == p and tree.hold:
                self._from_ground_to(tree, tree.hold, held)
                steps.append(HoldMobility(tree.hold, *self._shown(tree.hold)))
            steps.extend(Articulate(e.joint, e.reversed) for e in reversed(own))
            if tree.grounded == p and not tree.hold:
                self._from_ground_to(tree, tree.root, held)
                steps.append(StartEmpty(tree.root))  # from now on: what the others add

    def _from_ground_to(self, tree: Tree, link: int, held: list[Edge]) -> None:
        """Phi and b of a link with all between it and the ground, swept from the ground."""
        component = self._from_ground(link, held)
        assert tree.grounded is not None
        steps = self.steps[tree.grounded]
        steps.extend(Articulate(e.joint, e.reversed) for e in reversed(component.edges))
        self._mobility(component, Chain(link - 1, tree.grounded))

    @staticmethod
    def _shown(link: int) -> tuple[Block, Bias]:
        return Block(link - 1, link, link), Bias(link - 1, link)

    def _from_ground(self, link: int, held: list[Edge]) -> Component:
        at: dict[int, list[int]] = {}
        for edge in held:
            at.setdefault(edge.near, []).append(edge.joint)
            at.setdefault(edge.far, []).append(edge.joint)
        component = Component(0, self._outwards(0, at), [link])
        component.path = self._path(component)
        return component

    def _exchange(self, tree: Tree) -> None:
        """Tell each other what was found at the core."""
        for p in tree.participants:
            shown: set[int] = {
                edge.near
                for edge in tree.edges
                if tree.owner.get(edge.joint) == p and edge.near in tree.core_links
            }
            shown |= {link for link in tree.core_links if self._link_owner(tree, link) == p}
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
        core = [edge for edge in tree.edges if edge.joint in tree.core]
        for p in tree.participants:
            steps = self.steps[p]
            steps.extend(Articulate(e.joint, e.reversed) for e in reversed(core))
            if tree.grounded is not None and not tree.hold:
                steps.append(SolveMobility(tree.root, *self._shown(tree.root)))
            elif tree.root > 0:
                steps.append(SolveRoot(tree.root))

    def _outwards_again(self, tree: Tree) -> None:
        held = self._ground_side(tree)
        hidden = {edge.joint for edge in held}
        for p in tree.participants:
            steps = self.steps[p]
            own = [e for e in tree.edges if tree.owner.get(e.joint) == p and e.joint not in hidden]
            steps.extend(self._accelerated(e for e in tree.edges if e.joint in tree.core))
            if tree.grounded == p and tree.hold:
                steps.extend(self._accelerated(own))
            if tree.grounded == p:
                link = tree.hold or tree.root
                component = self._from_ground(link, held)
                steps.extend(Load(e.near, None) for e in component.path if e.near > 0)
                steps.append(LoadRoot(link, held=tree.hold > 0))
                steps.extend(Deliver(e.joint, e.reversed) for e in reversed(component.path))
                steps.extend(self._accelerated(component.edges))
            if not (tree.grounded == p and tree.hold):
                steps.extend(self._accelerated(own))
            if tree.base is not None and self._link_owner(tree, tree.base + 1) == p:
                steps.append(FreeAcceleration(tree.base))

    @staticmethod
    def _accelerated(edges: Iterable[Edge]) -> list[Accelerate]:
        return [Accelerate(edge.joint, edge.reversed) for edge in edges]
