"""Paths from a segment's root to its handles, in the order of carried mobilities."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from adagen.schedule.chains import Chains, Outwards


class Way(NamedTuple):
    """From the root of a part of a segment to its handles; positions.

    Attributes:
        root: the link that inertias are swept to; 0 is the ground.
        path: joints between the root and a handle, outwards.
        turned: joints that have the root below them, whether on the path or not.
        spreads: how often a coupling between two links is carried across a joint.
        loads: links at which loads are collected on the way back.
    """

    root: int
    path: tuple[int, ...]
    turned: tuple[int, ...]
    spreads: int
    loads: int


def way_between(chains: Chains, root: int, handles: Sequence[int], above: int = -1) -> Way:
    """Return the way from a root to handles.

    Args:
        chains: the robot.
        root: a link that is above all handles, or one of them.
        handles: links, the root perhaps among them.
        above: the uppermost link of the part if the root may lie below it; -1 if not.
    """
    turned = tuple(chains.above(root, above)) if above >= 0 else ()
    if len(handles) <= 2 and above < 0 and root in handles:  # one path, every coupling carried once
        last = next((link for link in handles if link != root), root)
        path = tuple(chains.above(last, root))
        return Way(root, path[::-1], (), len(path), len(path) + 1)
    top = root
    for link in handles if above >= 0 else ():
        top = chains.meet(top, link)
    joints = {p for link in (*handles, root) for p in chains.above(link, top)}
    edges = chains.outwards(sorted(joints, key=lambda p: chains.original[p]), [root])
    loaded = {near for _, near, _ in edges} | set(handles)
    spreads = _spreads(edges, root, set(handles))
    return Way(root, tuple(p for p, _, _ in edges), turned, spreads, len(loaded - {0}))


def _spreads(edges: Sequence[Outwards], root: int, handles: set[int]) -> int:
    """Return how many couplings are carried outwards.

    Kept are those with handles, and with links where the path parts until its last branch.
    """
    last: dict[int, int] = {}
    count: dict[int, int] = {}
    for place, (_, near, _) in enumerate(edges):
        last[near] = place
        count[near] = count.get(near, 0) + 1
    anchors = {link: place for link, place in last.items() if link and count[link] > 1}
    reached = [root] if root else []
    coupled = {(g, g) for g in reached}
    spreads = 0
    for place, (_, near, far) in enumerate(edges):
        for g in reached:
            kept = g in handles or place < anchors.get(g, -1)
            if kept and (g == near or (g, near) in coupled):
                spreads += 1
                coupled |= {(g, far), (far, g)}
        if far in handles or far in anchors:
            reached.append(far)
    return spreads
