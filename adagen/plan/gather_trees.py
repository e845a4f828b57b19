"""Layouts of gathering processes: root, core and owners of branches for each tree of moving links.

See adagen/plan/gather.py for their use.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from adagen.model.kinds import KINDS
from adagen.plan.edges import Edge, edges_from, is_free_base, joints_at
from adagen.plan.robot import PlanJoint

HELD_FREEDOMS = 8
"""Freedoms between the ground and a link whose mobility becomes an inertia: 6 make it regular
in general, a few more keep it so in most poses."""


@dataclass(frozen=True)
class Tree:
    """Connected moving links, and how their processes meet.

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
        hold: the link on the way to the ground from which on the ground is treated as a body; 0
            where the root shows its mobility.
    """

    links: Sequence[int]
    joints: Sequence[int]
    base: int | None
    root: int = 0
    edges: Sequence[Edge] = ()
    owner: Mapping[int, int] = field(default_factory=dict)
    core: frozenset[int] = frozenset()
    core_owner: int = 0
    grounded: int | None = None
    hold: int = 0

    @property
    def own_root(self) -> int:
        """The root if one process sweeps it: a floating base, or the ground."""
        return 0 if self.base is None else self.base + 1

    @cached_property
    def participants(self) -> list[int]:
        """Processes that have joints in it, ascending."""
        return sorted({self.core_owner, *self.owner.values()})

    @cached_property
    def core_links(self) -> set[int]:
        """Links of the core, the root among them."""
        return {self.root, *(edge.far for edge in self.core_edges)}

    @cached_property
    def core_edges(self) -> list[Edge]:
        """Joints of the core, outwards from the root."""
        return [edge for edge in self.edges if edge.joint in self.core]

    @cached_property
    def ground_side(self) -> list[Edge]:
        """Joints that are swept from the ground, seen from the root: those up to the link held."""
        if self.grounded is None:
            return []
        found, reached = [], {self.hold or self.root}
        for edge in self.edges:
            if edge.near in reached and self.owner.get(edge.joint) == self.grounded:
                found.append(edge)
                if edge.far > 0:
                    reached.add(edge.far)
        return found

    @cached_property
    def _branches(self) -> dict[int, list[Edge]]:
        hidden = {edge.joint for edge in self.ground_side}
        found: dict[int, list[Edge]] = {}
        for edge in self.edges:
            if edge.joint in self.owner and edge.joint not in hidden:
                found.setdefault(self.owner[edge.joint], []).append(edge)
        return found

    def branches(self, process: int) -> list[Edge]:
        """Return a process's own joints outwards from the root, without the ground's side."""
        return self._branches.get(process, [])

    def link_owner(self, link: int) -> int:
        """Return the process that adds a link's own inertia."""
        if link == self.root and self.grounded is not None:
            return self.grounded
        if link in self.core_links:
            return self.core_owner
        return next(self.owner[edge.joint] for edge in self.edges if edge.far == link)


def laid_out_trees(
    joints: Sequence[PlanJoint], assigned: Mapping[int, int], first: Mapping[int, int]
) -> list[Tree]:
    """Return a robot's trees of moving links, each with the root that makes its core smallest.

    Args:
        joints: the robot's joints.
        assigned: the process of each joint that one process assembles with all below it in the
            schedule; all others are where processes meet.
        first: the first process of every joint.
    """
    return [_laid_out(tree, joints, assigned, first) for tree in moving_trees(joints)]


def given_trees(
    joints: Sequence[PlanJoint], roots: Sequence[int], owners: Sequence[int | None]
) -> list[Tree]:
    """Return a robot's trees of moving links in a given layout.

    Args:
        joints: the robot's joints.
        roots: the root of each tree, in their order.
        owners: the process of each joint; None in a core.

    Raises:
        ValueError: processes cannot meet there; the message says why.
    """
    assigned = {j: p for j, p in enumerate(owners) if p is not None}
    first = {j: 0 if p is None else p for j, p in enumerate(owners)}
    trees = moving_trees(joints)
    if len(trees) != len(roots):
        raise ValueError(f"the robot has {len(trees)} trees of moving links, not {len(roots)}")
    found = []
    for tree, root in zip(trees, roots, strict=True):
        if root not in (0, *tree.links) or (root == 0 and tree.base is not None):
            raise ValueError(f"link {root} is no root of its tree")
        edges = edges_from(root, joints, joints_at(joints, tree.joints))
        own = {j: assigned[j] for j in tree.joints if j in assigned}
        laid_out = _rooted(tree, edges, root, own, first)
        if laid_out is None or any(laid_out.owner.get(j) != p for j, p in own.items()):
            raise ValueError(
                "a joint has joints of another process beyond it, seen from the root: "
                "leave it to the core"
            )
        if laid_out.grounded is not None:
            laid_out = replace(laid_out, hold=held_links(joints)[root])
        found.append(laid_out)
    return found


def moving_trees(joints: Sequence[PlanJoint]) -> list[Tree]:
    """Return a robot's trees of moving links, without a layout."""
    trees: dict[int, tuple[int | None, list[int]]] = {}  # base and joints by joint on the ground
    links: dict[int, list[int]] = {}
    top = [0] * len(joints)
    for j, joint in enumerate(joints):
        top[j] = j if joint.parent == 0 else top[joint.parent - 1]
        if joint.parent == 0:
            links[j] = []
            trees[j] = (j, []) if is_free_base(joint) else (None, [j])
        else:
            trees[top[j]][1].append(j)
        links[top[j]].append(j + 1)
    return [Tree(links[j], own, base) for j, (base, own) in trees.items()]


def _laid_out(
    tree: Tree,
    joints: Sequence[PlanJoint],
    assigned: Mapping[int, int],
    first: Mapping[int, int],
) -> Tree:
    at = joints_at(joints, tree.joints)
    involved = {assigned[j] for j in tree.joints if j in assigned}
    roots = [tree.own_root]
    if len(involved) > 1:
        apart = [j for j in tree.joints if j not in assigned]
        touched = {link for j in apart for link in (joints[j].parent, j + 1)}
        roots += sorted(touched - {0, tree.own_root})
    found = (_rooted(tree, edges_from(root, joints, at), root, assigned, first) for root in roots)
    # The ground, or the base, always serves as a root.
    best = min((tree for tree in found if tree is not None), key=lambda tree: len(tree.core))
    return best if best.grounded is None else replace(best, hold=held_links(joints)[best.root])


def _rooted(
    tree: Tree,
    edges: list[Edge],
    root: int,
    assigned: Mapping[int, int],
    first: Mapping[int, int],
) -> Tree | None:
    """Return the tree with a root; None if several processes have the ground's side."""
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
    least = least_busy(Counter(owner.values())) if owner else first[tree.base or 0]
    return Tree(
        tree.links, tree.joints, tree.base, root, edges, owner, frozenset(core), least, grounded
    )


def least_busy(counts: Mapping[int, int]) -> int:
    """Return the process that adds the core's own inertias: that with the fewest joints."""
    return min(counts, key=lambda p: (counts[p], p))


def held_links(joints: Sequence[PlanJoint]) -> list[int]:
    """Return for each link the one before it at which enough joints make the mobility regular.

    Args:
        joints: the robot's joints.

    Returns:
        Length N + 1: a link on the way from the ground; 0 if none before the link is held so.
    """
    freedoms = [0] * (len(joints) + 1)
    held = [0] * (len(joints) + 1)
    for j, joint in enumerate(joints):
        above = joint.parent
        freedoms[j + 1] = freedoms[above] + (0 if joint.prescribed else KINDS[joint.kind].nv)
        held[j + 1] = held[above] or (above if freedoms[above] >= HELD_FREEDOMS else 0)
    return held
