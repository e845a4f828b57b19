"""Handing out the limbs of a frame, process by process, by branch and bound.

The next process takes the heaviest limb that is left, and some of the others. Limbs of one kind
that follow each other are interchangeable, and processes of equal speed are alike.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import groupby

from adagen.search.bounds import Around
from adagen.search.incumbent import LOOK, Incumbent
from adagen.search.layouts import Frame

Counts = tuple[int, ...]
"""How many limbs of each class of interchangeable ones."""


@dataclass(frozen=True)
class _Block:
    """What one process takes, by itself.

    Attributes:
        counts: its limbs.
        own: their numbers in the frame.
        before: until it sends; microseconds on the fastest core, as are the others.
        after: from the exchange on.
        total: all of it, without waiting.
        trees: those that it has limbs of.
    """

    counts: Counts
    own: tuple[int, ...]
    before: float
    after: float
    total: float
    trees: frozenset[int]


@dataclass
class HandOut:
    """Handing out the limbs of a frame.

    Attributes:
        found: the best layout so far, and the budget.
        frame: the frame.
        bound: on all its layouts.
        left: on those that were not looked at.
    """

    found: Incumbent
    frame: Frame
    bound: float
    left: float = field(init=False)

    def __post_init__(self) -> None:
        limbs = self.frame.limbs
        self.left = self.found.best
        self.classes = [
            [k for k, _ in group]
            for _, group in groupby(enumerate(limbs), key=lambda pair: pair[1].kind)
        ]
        bounds = self.found.bounds
        self.work = [bounds.floors.work(limb) for limb in limbs]
        self.long = [bounds.floors.longest(limb) for limb in limbs]
        self.weights = [self.work[own[0]].both for own in self.classes]
        self.longest = [self.long[own[0]].both for own in self.classes]
        self.cores = [(core, bounds.around(core)) for core in self.frame.cores]
        # Where there is one tree, all take part in its exchange.
        self.around: Around | None = None
        if len(self.found.bounds.robot.trees) == 1 and self.cores:
            self.around = self.cores[0][1]
        self.blocks: dict[Counts, _Block | None] = {}

    def run(self) -> float:
        """Look for faster layouts; return a bound on those that were not looked at."""
        counts = tuple(len(own) for own in self.classes)
        self._next(counts, [], self.found.bounds.processes)
        return self.left

    def _next(self, remaining: Counts, blocks: list[_Block], processes: int) -> None:
        """Hand out what remains to so many processes."""
        found = self.found
        if not any(remaining):
            found.spent.on(len(blocks) ** 2)  # as many messages
            found.consider(self.frame, self._shares(blocks))
            return
        if processes == 0:
            return
        lead = max((c for c, n in enumerate(remaining) if n), key=lambda c: self.weights[c])
        before = blocks[-1].counts if blocks and blocks[-1].counts[lead] else None
        if before is not None and any(n for c, n in enumerate(before) if self._leads(c, lead)):
            before = None
        for counts in self._takes(remaining, lead, processes == 1):
            if before is not None and counts > before:
                continue
            rest = tuple(a - b for a, b in zip(remaining, counts, strict=True))
            bound = max(self._bound(rest, blocks, processes - 1, more=True), self._least(counts))
            if bound >= found.best:
                continue
            cost = LOOK if counts in self.blocks else found.share
            if not found.spent.on(cost):
                self.left = min(self.left, max(bound, self.bound))
                return
            block = self._block(counts)
            if block is None:
                continue
            bound = self._bound(rest, [*blocks, block], processes - 1)
            if bound < found.best:
                self._next(rest, [*blocks, block], processes - 1)

    def _least(self, counts: Counts) -> float:
        """The least that a process takes for so many limbs, without a look at them together."""
        bounds = self.found.bounds
        most = total = 0.0
        for n, work, long in zip(counts, self.weights, self.longest, strict=True):
            total += n * work
            most = max(most, long if n else 0.0)
        return bounds.start + max(most, total) / bounds.fastest

    def _leads(self, c: int, lead: int) -> bool:
        """Whether limbs of a class are handed out before those of another."""
        return (-self.weights[c], c) < (-self.weights[lead], lead)

    @staticmethod
    def _takes(remaining: Counts, lead: int, everything: bool) -> Iterator[Counts]:
        """What the next process may take, one limb of a class at least; more before less."""
        if everything:
            yield remaining
            return
        found: list[Counts] = [()]
        for c, count in enumerate(remaining):
            least = 1 if c == lead else 0
            found = [(*own, n) for own in found for n in range(count, least - 1, -1)]
        yield from found

    def _block(self, counts: Counts) -> _Block | None:
        """What a process takes that has so many limbs of each class; None where it cannot."""
        if counts not in self.blocks:
            own = tuple(sorted(k for c, n in enumerate(counts) for k in self.classes[c][:n]))
            piece = self.found.prices.piece(self.frame, own, frozenset())
            self.blocks[counts] = None
            if piece is not None:
                share, fastest = piece.share, self.found.bounds.fastest
                before = (share.least_kinematics + share.inwards) / fastest
                after = share.outwards / fastest
                total = before + share.between / fastest + after
                trees = frozenset(self.frame.limbs[k].tree for k in own)
                self.blocks[counts] = _Block(counts, own, before, after, total, trees)
        return self.blocks[counts]

    def _bound(
        self, remaining: Counts, blocks: list[_Block], processes: int, *, more: bool = False
    ) -> float:
        """The least that layouts take which begin with some blocks, the rest shared by others.

        With ``more`` there is one block that is not among them yet.
        """
        bounds = self.found.bounds
        alone = max((block.total for block in blocks), default=0.0)
        limbs = [k for own, n in zip(self.classes, remaining, strict=True) for k in own[:n]]
        if limbs and not processes:
            return float("inf")
        messages = bounds.telling + bounds.taking if self.around is not None else 0.0
        least = bounds.start + alone + messages * bool(blocks)
        if limbs:
            work = sum(self.work[k].both for k in limbs) / processes
            least = max(least, bounds.start + work / bounds.fastest)
        for core, around in self.cores:
            before = self._slowest(core.tree, around, limbs, blocks, processes)
            floor = (around.after + bounds.outwards) / bounds.fastest
            known = [block.after for block in blocks]
            after = min([*known, *([floor] if limbs or more or not known else [])])
            waited = bounds.telling + bounds.taking + bounds.latency
            least = max(least, bounds.start + before + waited + after)
        return least

    def _slowest(
        self,
        tree: int,
        around: Around,
        limbs: Sequence[int],
        blocks: Sequence[_Block],
        processes: int,
    ) -> float:
        """What the slowest process of a tree takes before the exchange."""
        bounds = self.found.bounds
        own = [k for k in limbs if self.frame.limbs[k].tree == tree]
        least = 0.0
        for k in own:
            way = 0.0 if self.frame.limbs[k].up else around.way
            least = max(least, self.long[k].inwards + way)
        if own and self.around is not None:
            up = any(self.frame.limbs[k].up for k in own)
            work = sum(self.work[k].inwards for k in own)
            least = max(least, (work + around.way * (processes - up)) / processes)
        if own:
            least = (least + around.before) / bounds.fastest
        return max([least, *(block.before for block in blocks if tree in block.trees)])

    def _shares(self, blocks: Sequence[_Block]) -> list[tuple[int, ...]]:
        """The limbs of each block, by their numbers, those of a class one after the other."""
        given = [0] * len(self.classes)
        shares = []
        for block in blocks:
            own: list[int] = []
            for c, n in enumerate(block.counts):
                own += self.classes[c][given[c] : given[c] + n]
                given[c] += n
            shares.append(tuple(sorted(own)))
        return shares
