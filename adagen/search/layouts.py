"""Layouts: owners of limbs, and the predicted time of each process.

The time of a layout is composed of its processes' shares (price.py), each priced once: a share is
known by the kinds of its limbs in their order, wherever else on the robot they are.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

from adagen.plan.gather_steps import ProcessSteps, contribution
from adagen.plan.gather_trees import Tree, least_busy
from adagen.plan.steps import Step
from adagen.schedule.tree import Gathered
from adagen.search.limbs import Core, Limb, Robot
from adagen.search.price import Pricing, Share

_HERE, _ELSEWHERE = 0, 1
_KEPT = 200_000
"""Joints in all of the shares whose prices are kept."""


@dataclass(frozen=True)
class MeetingPlace:
    """Where processes meet, and what hangs there.

    Attributes:
        cores: one for each tree that is shared.
        limbs: what is left, by first joints.
    """

    cores: tuple[Core, ...]
    limbs: tuple[Limb, ...]


@dataclass(frozen=True)
class Layout:
    """Who takes which limbs of a meeting place.

    Attributes:
        meeting place: where processes meet.
        shares: for each process the numbers of its limbs in the meeting place, ascending.
    """

    place: MeetingPlace
    shares: tuple[tuple[int, ...], ...]

    def taking_part(self, tree: int) -> list[int]:
        """Return the processes that have limbs of a tree, ascending."""
        limbs = self.place.limbs
        return [p for p, own in enumerate(self.shares) if any(limbs[k].tree == tree for k in own)]

    def core_owners(self, robot: Robot) -> tuple[int, ...]:
        """Return for each core the process that adds what belongs to it."""
        found = []
        for core in self.place.cores:
            base = robot.trees[core.tree].base
            counts: Counter[int] = Counter()
            for p, own in enumerate(self.shares):
                for k in own:
                    if (limb := self.place.limbs[k]).tree == core.tree:
                        holds = limb.up and base is not None
                        counts[p] += len(limb) - holds
            found.append(least_busy({p: n for p, n in counts.items() if n}))
        return tuple(found)

    def gathered(self, robot: Robot) -> Gathered:
        """Return the same as schedules say it: the roots of all trees, and the owners of joints."""
        roots = [tree.own_root for tree in robot.trees]
        owners: list[int | None] = [None] * len(robot.joints)
        for p, own in enumerate(self.shares):
            for k in own:
                for joint in self.place.limbs[k].joints:
                    owners[joint] = p
        for core, owner in zip(self.place.cores, self.core_owners(robot), strict=True):
            roots[core.tree] = core.root
            if robot.floats(core.tree, core.root):
                owners[core.root - 1] = owner
        return Gathered(tuple(roots), tuple(owners))


@dataclass(frozen=True)
class _Piece:
    """A share, and how many numbers its process tells in each shared tree that it has limbs of."""

    share: Share
    numbers: dict[int, int]


class LayoutPrices:
    """Prices of a robot's layouts.

    Args:
        robot: the robot's limbs.
        pricing: what processes take.

    Attributes:
        priced: how many shares have been priced.
    """

    def __init__(self, robot: Robot, pricing: Pricing) -> None:
        self.robot, self.pricing = robot, pricing
        self.priced = 0
        self._pieces: dict[object, _Piece | None] = {}
        self._parted = bool(robot.prolonging)

    def piece(
        self, place: MeetingPlace, own: Sequence[int], owned: frozenset[int]
    ) -> _Piece | None:
        """Return what a process takes; None where that cannot be emitted.

        Args:
            place: where processes meet.
            own: the numbers of its limbs.
            owned: the trees of whose cores it adds what belongs to them.
        """
        key = self._key(place, own, owned)
        if key not in self._pieces:
            self.priced += 1
            if self.priced % max(1, _KEPT // len(self.robot.joints)) == 0:
                self._pieces.clear()
            self._pieces[key] = self._priced(place, own, owned)
        return self._pieces[key]

    def knows(self, place: MeetingPlace, own: Sequence[int]) -> bool:
        """Return whether what a process takes that owns no core is at hand."""
        return self._key(place, own, frozenset()) in self._pieces

    def _key(self, place: MeetingPlace, own: Sequence[int], owned: frozenset[int]) -> object:
        """What the price of a share depends on; other trees' cores do not count."""
        mine = {place.limbs[k].tree for k in own}
        cores = tuple(core for core in place.cores if core.tree in mine)
        # Where processes part each other's runs, it matters which joints they have.
        if self._parted:
            return tuple(place.limbs[k].spans for k in own), cores, owned
        return tuple(place.limbs[k].kind for k in own), cores, owned

    def _priced(
        self, place: MeetingPlace, own: Sequence[int], owned: frozenset[int]
    ) -> _Piece | None:
        trees = self._trees(place, own, owned)
        numbers, messages = dict.fromkeys(trees, 0), []
        for core in place.cores:
            tree = trees.get(core.tree)
            found = contribution(tree, _HERE) if tree is not None else None
            if tree is None or found is None:
                continue
            message = found.message(_HERE, _ELSEWHERE, core.root - 1)
            numbers[core.tree] = self.pricing.numbers(message)
            # All links of the core are sent by some process, and added to what others know.
            links = tuple(sorted(tree.core_links - {0}))
            messages.append(replace(message, blocks=(), biases=(), inertias=links))
        each = tuple(range(len(messages)))
        steps = ProcessSteps(self.robot.joints, [trees[t] for t in sorted(trees)], _HERE)
        recovery: list[Step] = []
        if any(tree.hold for tree in trees.values()):
            again = [replace(trees[t], hold=0) for t in sorted(trees)]
            recovery = ProcessSteps(self.robot.joints, again, _HERE).evaluation(each, each)
        process = steps.process_of(steps.evaluation(each, each), recovery)
        share = self.pricing.share(process, tuple(messages))
        return None if share is None else _Piece(share, numbers)

    def _trees(
        self, place: MeetingPlace, own: Sequence[int], owned: frozenset[int]
    ) -> dict[int, Tree]:
        """The trees in which a process takes part, as far as it is concerned."""
        mine = {place.limbs[k].tree for k in own}
        shared = {core.tree: core for core in place.cores}
        owner = dict.fromkeys(range(len(self.robot.joints)), _ELSEWHERE)
        for k in own:
            owner.update(dict.fromkeys(place.limbs[k].joints, _HERE))
        return {
            tree: self.robot.laid_out(shared[tree], owner, _HERE if tree in owned else _ELSEWHERE)
            if tree in shared
            else self.robot.alone(tree, _HERE)
            for tree in sorted(mine)
        }

    def time(self, layout: Layout) -> float | None:
        """Return what a layout takes when it is played through; None where it cannot be emitted.

        That is ``predict`` of its plan, put together from shares.
        """
        place, owners = layout.place, layout.core_owners(self.robot)
        pieces: dict[int, _Piece] = {}
        for p, own in enumerate(layout.shares):
            if own:
                pairs = zip(place.cores, owners, strict=True)
                owned = frozenset(core.tree for core, owner in pairs if owner == p)
                piece = self.piece(place, own, owned)
                if piece is None:
                    return None
                pieces[p] = piece
        return max(self._played(layout, pieces))

    def _played(self, layout: Layout, pieces: dict[int, _Piece]) -> list[float]:
        """When each process is done."""
        costs, channel = self.pricing.costs, self.pricing.channel
        speed = {p: costs.speed(p) for p in pieces}
        kinematics = {p: piece.share.kinematics for p, piece in pieces.items()}
        if self._parted:
            found = self.pricing.kinematics([piece.share for piece in pieces.values()])
            kinematics = dict(zip(pieces, found, strict=True))
        clock = {
            p: (costs["process.evaluation"] + kinematics[p] + piece.share.inwards) / speed[p]
            for p, piece in pieces.items()
        }
        messages: list[tuple[int, float, float]] = []  # target, when it was sent, time to take it
        for core in layout.place.cores:
            together = layout.taking_part(core.tree)
            for p in together:
                numbers = pieces[p].numbers[core.tree] * channel.number / 2
                for other in together:
                    if other != p:
                        clock[p] += channel.send + numbers
                        messages.append((other, clock[p], numbers))
        for p, piece in pieces.items():
            clock[p] += piece.share.between / speed[p]
        for target, sent, numbers in messages:
            clock[target] = max(clock[target], sent + channel.latency) + numbers
        return [clock[p] + piece.share.outwards / speed[p] for p, piece in pieces.items()]
