"""Paths from links to the ground, of a robot's joints or a plan's."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol


class HasParent(Protocol):
    """A joint that hangs on a link; joint j moves link j + 1, and link 0 is the ground."""

    @property
    def parent(self) -> int:
        """The link that it hangs on."""


def joints_on_links(joints: Sequence[HasParent]) -> tuple[tuple[int, ...], ...]:
    """Return the joints that hang on each link, the ground first, ascending."""
    found: list[list[int]] = [[] for _ in range(len(joints) + 1)]
    for j, joint in enumerate(joints):
        found[joint.parent].append(j)
    return tuple(map(tuple, found))


def last_beyond(joints: Sequence[HasParent]) -> list[int]:
    """Return the last joint beyond each one, itself included; joints are in depth-first order."""
    last = list(range(len(joints)))
    for j in reversed(range(len(joints))):
        near = joints[j].parent - 1
        if near >= 0:
            last[near] = max(last[near], last[j])
    return last


def path_to_ground(joints: Sequence[HasParent], link: int) -> list[int]:
    """Return the joints from a link inwards to the ground."""
    found = []
    while link > 0:
        found.append(link - 1)
        link = joints[link - 1].parent
    return found


def paths_to_ground(joints: Sequence[HasParent], wanted: Iterable[int]) -> set[int]:
    """Return the joints from the ground down to some joints, these included."""
    found: set[int] = set()
    for joint in wanted:
        while joint >= 0 and joint not in found:
            found.add(joint)
            joint = joints[joint].parent - 1
    return found


def common_link(joints: Sequence[HasParent], links: Iterable[int]) -> int:
    """Return the last link that the paths to some links have in common; 0 is the ground."""
    shared = set[int].intersection(*(set(path_to_ground(joints, link)) for link in links))
    return max(shared, default=-1) + 1
