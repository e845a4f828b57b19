"""Schedule trees of layouts: how a schedule says who takes which limbs, and where processes meet.

A limb is assembled by its process; what joins limbs and core is assembled after them, by all. Which
links limbs hang on is told by the first joint: where several processes have limbs at a link, one of
them has the link with its limb, and the first joints of the others are among what joins. The plan
finds root and core from there on (adagen/plan/gather_trees.py), and it is made sure that it finds
those that are meant.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from adagen.plan.gather import GatherPlanner
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.draft import Draft
from adagen.schedule.sweeps import loads_of
from adagen.search.layouts import Layout
from adagen.search.limbs import Limb, Robot


def schedule_of(
    layout: Layout, robot: Robot, topology: Topology, pattern: Schedule, profile: CostProfile
) -> Schedule | None:
    """Return the schedule of a layout; None if no tree says the same.

    Args:
        layout: the layout.
        robot: the robot.
        topology: the same robot.
        pattern: a schedule whose facts (tie, split and so on) are taken over.
        profile: prices the tree.
    """
    root = _draft(layout, robot, topology).finish(topology, profile)
    loads = loads_of(root, pattern.processes)
    found = replace(pattern, root=root, meeting="gather", loads=loads)
    return found if _says(found, layout, robot) else None


def _draft(layout: Layout, robot: Robot, topology: Topology) -> Draft:
    """The tree: what is inside of limbs, their first joints, the cores, and what floats."""
    processes = len(layout.shares)
    draft = Draft(len(topology))
    draft.ranges = [(0, processes)] * len(topology)
    claims = _claims(layout, robot)
    inside: list[int] = []
    joining: list[tuple[int, int]] = []
    bases: list[int] = []
    for p, limb in _given(layout):
        base = robot.trees[limb.tree].base
        others = {hinge: claims[at] for at, hinge in _hinges(limb, robot) if claims[at] != p}
        last = _tells_last(limb, robot)
        for joint in limb.joints:
            if joint in others and joint == last:
                joining.append((min(p, others[joint]), joint))
            elif joint == base:
                bases.append(joint)
            elif joint in others:
                joining.append((0, joint))
            else:
                inside.append(joint)
                draft.ranges[joint] = (p, p + 1)
    cores = [joint for core in layout.frame.cores for joint in core.joints]
    for core in layout.frame.cores:
        if robot.floats(core.tree, core.root):
            bases.append(core.root - 1)
    later = [*sorted(joining, reverse=True), *((0, j) for j in (*cores, *bases))]
    for p, joint in later:
        draft.ranges[joint] = (p, processes)
    draft.root = draft.contract(topology, [*inside, *(joint for _, joint in later)])
    draft.ranges[draft.root] = (0, processes)
    return draft


def _given(layout: Layout) -> Iterator[tuple[int, Limb]]:
    """Limbs with their processes."""
    for p, own in enumerate(layout.shares):
        for k in own:
            yield p, layout.frame.limbs[k]


def _hinges(limb: Limb, robot: Robot) -> Iterator[tuple[int, int]]:
    """The links that a limb shares with others, and its joints there."""
    yield limb.link, limb.link - 1 if limb.up else limb.spans[0][0]
    if limb.up and robot.trees[limb.tree].base is None:
        yield 0, limb.spans[0][0]


def _tells_last(limb: Limb, robot: Robot) -> int | None:
    """The joint beyond which a limb has no other that could tell of its process."""
    if limb.up and robot.trees[limb.tree].base is None:
        return limb.spans[0][0]
    return limb.spans[0][0] if len(limb) == 1 else None


def _claims(layout: Layout, robot: Robot) -> dict[int, int]:
    """The process that has each link with a limb.

    What lies on the ground's side comes first: else the link before would serve as a root as well.
    Then those of one joint, which have no other place to tell of their process.
    """

    def rank(each: tuple[int, Limb]) -> tuple[bool, bool, int]:
        p, limb = each
        return not limb.up, _tells_last(limb, robot) is None, -p

    found: dict[int, int] = {}
    for p, limb in sorted(_given(layout), key=rank):
        for link, _ in _hinges(limb, robot):
            found.setdefault(link, p)
    return found


def _says(schedule: Schedule, layout: Layout, robot: Robot) -> bool:
    """Whether the plan of a schedule meets where a layout does, and shares out as it does."""
    owner = {joint: p for p, limb in _given(layout) for joint in limb.joints}
    cores = {core.tree: core for core in layout.frame.cores}
    owners = dict(zip(cores, layout.core_owners(robot), strict=True))
    for number, tree in enumerate(GatherPlanner(tuple(robot.joints), schedule).trees()):
        core = cores.get(number)
        own = owner.get(tree.base) if tree.base is not None else None
        if core is not None:
            meant = (core.root, frozenset(core.joints), owners[number])
            if (tree.root, tree.core, tree.core_owner) != meant:
                return False
        elif tree.core or len(tree.participants) > 1:
            return False
        if core is None and not tree.joints and tree.core_owner != own:
            return False
        if any(owner[joint] != p for joint, p in tree.owner.items()):
            return False
    return True
