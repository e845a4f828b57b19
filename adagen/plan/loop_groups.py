"""Joints that each loop or coupling connects, and groups of loops that share joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from adagen.model import Model
from adagen.model.paths import path_to_ground


def _parted(model: Model, links: Sequence[int]) -> tuple[int, set[int]]:
    """The last common link on the paths to some links, and the joints beyond it."""
    ways = [path_to_ground(model.joints, link) for link in links]
    shared = set(ways[0]).intersection(*ways[1:])
    return max((j + 1 for j in shared), default=0), set().union(*ways) - shared


def loop_paths(model: Model) -> list[tuple[int, set[int]]]:
    """Return for each loop, then each coupling, its last common link and the joints beyond."""
    found = [_parted(model, loop.links) for loop in model.loops]
    for coupling in model.couplings:
        joints = [j for j, _ in coupling.terms]
        top, path = _parted(model, [model.joints[j].parent for j in joints])
        found.append((top, path.union(joints)))
    return found


@dataclass(frozen=True)
class LoopGroup:
    """Loops and couplings that are solved together.

    Attributes:
        top: the link at which they are eliminated.
        members: numbers of its loops, then of its couplings behind all loops.
        path: joints beyond the top that they tie.
    """

    top: int
    members: tuple[int, ...]
    path: tuple[int, ...]


def connected(
    model: Model, tied: Sequence[tuple[int, set[int]]], wanted: Sequence[int] | None = None
) -> list[LoopGroup]:
    """Group loops and couplings that share joints; the innermost tops come first.

    Args:
        model: the robot.
        tied: of each of them, the link where it closes, and the joints beyond.
        wanted: which of them count; all if not given.
    """
    groups: list[tuple[set[int], set[int]]] = []
    tops = [top for top, _ in tied]
    for number in range(len(tied)) if wanted is None else wanted:
        members, joints = {number}, set(tied[number][1])
        for other in [group for group in groups if group[1] & joints]:
            groups.remove(other)
            members, joints = members | other[0], joints | other[1]
        groups.append((members, joints))
    found = []
    for members, joints in groups:
        top, between = _parted(model, [tops[k] for k in sorted(members)])
        found.append(LoopGroup(top, tuple(sorted(members)), tuple(sorted(joints | between))))
    return sorted(found, key=lambda one: (-one.top, one.members))


def rows_of(model: Model) -> list[range]:
    """The rows of each loop, then of each coupling."""
    counts = [loop.kind.rows for loop in model.loops] + [1] * len(model.couplings)
    ends = np.cumsum([0, *counts])
    return [range(a, b) for a, b in zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True)]


def freedoms_of(model: Model, joints: Sequence[int]) -> list[int]:
    """Entries of v of joints that are unknowns; prescribed accelerations are not."""
    return [
        model.v_start[j] + k
        for j in joints
        for k in range(0 if model.joints[j].prescribed else model.joints[j].kind.nv)
    ]
