"""Joints seen from a root link: their order in a sweep, and their direction."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from adagen.model.paths import paths_to_ground
from adagen.plan.robot import PlanJoint


@dataclass(frozen=True)
class Edge:
    """A joint seen from a root link.

    Attributes:
        joint: its index.
        near: its link on the root's side.
        far: its other link.
        reversed: whether ``near`` is the joint's child link.
    """

    joint: int
    near: int
    far: int
    reversed: bool


def is_base(joint: PlanJoint) -> bool:
    """Return whether a joint is the floating base of a tree, free or prescribed."""
    return joint.parent == 0 and joint.kind == "floating"


def is_free_base(joint: PlanJoint) -> bool:
    """Return whether a joint is a floating base with free motion."""
    return is_base(joint) and not joint.prescribed


def joints_at(joints: Sequence[PlanJoint], members: Iterable[int]) -> dict[int, list[int]]:
    """Return the joints at each link, of ``members`` and in their order."""
    at: dict[int, list[int]] = {}
    for j in members:
        at.setdefault(joints[j].parent, []).append(j)
        at.setdefault(j + 1, []).append(j)
    return at


def on_the_way(joints: Sequence[PlanJoint], wanted: Iterable[int]) -> tuple[int, ...]:
    """Return some joints and those between them and the ground, ascending."""
    return tuple(sorted(paths_to_ground(joints, wanted)))


def edges_from(
    root: int, joints: Sequence[PlanJoint], at: Mapping[int, Sequence[int]]
) -> list[Edge]:
    """Return the joints connected to a root, each after those nearer to it.

    They are in depth-first order, so that joints that follow each other along a limb stay
    together: shape kernels sweeps them in one loop.

    Args:
        root: a link.
        joints: the robot's joints.
        at: the joints at each link that count (``joints_at``).
    """

    def beyond(near: int, came: int) -> list[Edge]:
        found = []
        for j in at.get(near, []):
            if j != came:
                down = joints[j].parent == near
                found.append(Edge(j, near, j + 1 if down else joints[j].parent, not down))
        return found

    edges: list[Edge] = []
    waiting = beyond(root, -1)[::-1]
    while waiting:
        edge = waiting.pop()
        edges.append(edge)
        waiting.extend(reversed(beyond(edge.far, edge.joint)))
    return edges


def ways_to(links: Iterable[int], root: int, edges: Sequence[Edge]) -> list[Edge]:
    """Return the ``edges`` between a root and some links, depth first."""
    wanted = set(links)
    for edge in reversed(edges):
        if edge.far in wanted:
            wanted.add(edge.near)
    below: dict[int, list[Edge]] = {}
    for edge in edges:
        if edge.far in wanted:
            below.setdefault(edge.near, []).append(edge)
    path: list[Edge] = []
    stack = list(reversed(below.get(root, [])))
    while stack:
        edge = stack.pop()
        path.append(edge)
        stack.extend(reversed(below.get(edge.far, [])))
    return path
