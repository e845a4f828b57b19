"""Meeting places (root and core of a layout), one after another, the simplest first.

Trees are shared first, then their cores grow, from where limbs part to where they part next: each
meeting place comes from one other.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from adagen.search.layouts import Layout, MeetingPlace
from adagen.search.limbs import Core, Robot


class MeetingPlaces:
    """The meeting places of a robot.

    Args:
        robot: the robot.
        roots: for each link whether processes may meet around it; length N + 1.

    Of limbs and trees that follow each other and are alike, one stands for all: roots are in the
    first one, and cores grow into the first ones.
    """

    def __init__(self, robot: Robot, roots: Sequence[bool]) -> None:
        self.robot, self.roots = robot, roots
        self._mirrored = {
            j
            for own in robot.at
            for before, first in pairwise(own)
            if self._beside(before, first)
            for j in range(first, robot.last[first] + 1)
        }

    def first(self) -> list[MeetingPlace]:
        """Return the meeting places that all others come from."""
        return [self._place(())] if len(self.robot.trees) > 1 else list(self._opened(()))

    def after(self, place: MeetingPlace) -> list[MeetingPlace]:
        """Return the meeting places that come from another one."""
        more = self._opened(place.cores) if len(self.robot.trees) > 1 else ()
        return [*self._grown(place.cores), *more]

    def _place(self, cores: tuple[Core, ...]) -> MeetingPlace:
        return MeetingPlace(cores, self.robot.limbs(cores))

    def _opened(self, cores: tuple[Core, ...]) -> Iterator[MeetingPlace]:
        """Meeting places that share one more tree, one that comes after those shared."""
        if cores and any(core.joints for core in cores):
            return  # trees are shared first, then cores grow
        trees = self.robot.trees
        shared = {core.tree: core.root - trees[core.tree].links[0] for core in cores}
        for number in range(cores[-1].tree + 1 if cores else 0, len(trees)):
            links, first = trees[number].links, 0
            if number > 0 and self._alike(trees[number - 1].links, links):
                # The first of them are shared, at links in ascending order.
                first = shared.get(number - 1, len(links))
            for link in links[first:]:
                if self.roots[link] and link - 1 not in self._mirrored:
                    yield self._place((*cores, Core(number, link)))

    def _alike(self, one: Sequence[int], other: Sequence[int]) -> bool:
        """Whether it makes no difference to exchange links with others and all on them.

        Args:
            one: links in a row, of which all others hang on the first.
            other: likewise.
        """
        if self.robot.kind(one[0] - 1) != self.robot.kind(other[0] - 1):
            return False
        return [self.roots[k] for k in one] == [self.roots[k] for k in other]

    def _grown(self, cores: tuple[Core, ...]) -> Iterator[MeetingPlace]:
        """Those with the joints up to where limbs part next in a core, after those in it."""
        last = max((core.joints[-1] for core in cores if core.joints), default=-1)
        for place, core in enumerate(cores):
            up = not self.robot.floats(core.tree, core.root)
            if len(self.robot.at[core.root]) + up < 3:
                continue  # all that is not beyond these would be of one process
            for link in (core.root, *(j + 1 for j in core.joints)):
                for before, joint in pairwise((-1, *self.robot.at[link])):
                    if before >= 0 and before not in core.joints and self._beside(before, joint):
                        continue  # the first one of those that are alike grows first
                    if joint > last and (more := self.robot.unbranched(joint)):
                        grown = Core(core.tree, core.root, (*core.joints, *more))
                        yield self._place((*cores[:place], grown, *cores[place + 1 :]))

    def _beside(self, joint: int, other: int) -> bool:
        """Whether it makes no difference to exchange all on a joint with all on another."""
        last = self.robot.last
        own, others = (range(j + 1, last[j] + 2) for j in (joint, other))
        return self._alike(own, others)

    def meets(self, place: MeetingPlace) -> bool:
        """Return whether two processes or more can be on either side of each joint of the cores."""
        for core in place.cores:
            beyond: dict[int, int] = {core.root: 0}
            ends = {
                core.root: core.root,
                **{j + 1: self.robot.joints[j].parent for j in core.joints},
            }
            inner = {ends[link] for link in ends if link != core.root}
            for limb in place.limbs:
                if limb.tree == core.tree:
                    beyond[limb.link] = beyond.get(limb.link, 0) + 1
            leaves = [link for link in ends if link not in inner]
            if any(beyond.get(link, 0) < 2 for link in leaves):
                return False
            first = [j for j in core.joints if self.robot.joints[j].parent == core.root]
            if len(first) == 1 and beyond[core.root] < 2:
                return False
        return True


def in_place(layout: Layout, robot: Robot) -> bool:
    """Return whether two processes or more are on either side of each joint of the cores.

    Elsewhere a smaller core, or another root, does as well.
    """
    of = {k: p for p, own in enumerate(layout.shares) for k in own}
    for core in layout.place.cores:
        sides: dict[int, set[int]] = {}
        for k, limb in enumerate(layout.place.limbs):
            if limb.tree == core.tree:
                sides.setdefault(limb.link, set()).add(of[k])
        if len(set().union(*sides.values())) < 2:
            return False
        for joint in core.joints:
            span = range(joint + 1, robot.last[joint] + 2)
            far = [own for link, own in sides.items() if link in span]
            near = [own for link, own in sides.items() if link not in span]
            if len(set().union(*far)) < 2 or len(set().union(*near)) < 2:
                return False
    return True
