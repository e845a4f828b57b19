"""Assignment of the limbs of a meeting place to processes, by branch and bound.

The next process takes the heaviest limb that is left, and some of the others. Limbs of one kind
that follow each other are interchangeable, and processes of equal speed are alike.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate, groupby, product
from math import prod

from adagen.search.incumbent import LOOK, Incumbent
from adagen.search.layout_bounds import Around
from adagen.search.layouts import MeetingPlace
from adagen.search.whole_limb_bounds import SweepBound

Counts = tuple[int, ...]
"""How many limbs of each class of interchangeable ones."""


_SORTED = 2048
"""Ways to take limbs up to which the most promising come first."""


_ALIKE = 0.1
"""Share of a bound up to which another one is as promising."""


def _without(remaining: Counts, counts: Counts) -> Counts:
    return tuple(a - b for a, b in zip(remaining, counts, strict=True))


@dataclass(frozen=True)
class _Block:
    """What one process takes, by itself.

    Attributes:
        counts: its limbs.
        own: their numbers in the meeting place.
        before: until it sends; microseconds on the fastest core, as are the others.
        after: from the exchange on.
        total: all of it, without waiting; with messages where several trees may be shared.
        trees: those that it has limbs of; times are those of the trees that are shared.
    """

    counts: Counts
    own: tuple[int, ...]
    before: float
    after: float
    total: float
    trees: frozenset[int]


@dataclass(frozen=True)
class _Rest:
    """What limbs take at least that are not handed out; microseconds on the fastest core.

    Attributes:
        work: one of the processes that share them.
        before: the slowest of these until it sends, for each core.
    """

    work: float
    before: tuple[float, ...]


def _last(tree: int, blocks: Sequence[_Block], rest: float) -> float:
    """The least that it takes until the last block is done, each waiting for all others.

    Args:
        tree: that they share.
        blocks: those that are known.
        rest: what the slowest of the others takes before it sends; 0 if there are none.

    Returns:
        The time without messages.
    """
    own = [block for block in blocks if tree in block.trees]
    last = 0.0
    for k, block in enumerate(own):
        others = max([rest, *(other.before for i, other in enumerate(own) if i != k)])
        if others:
            last = max(last, others + block.after)
    return last


@dataclass
class Assignment:
    """Handing out the limbs of a meeting place.

    Attributes:
        found: the best layout so far, and the budget.
        meeting place: the meeting place.
        bound: on all its layouts; at first that on those of meeting places that come from it, too.
        left: on those that were not looked at.
    """

    found: Incumbent
    place: MeetingPlace
    bound: float
    left: float = field(init=False)

    def __post_init__(self) -> None:
        limbs = self.place.limbs
        self.left = self.found.best
        self.classes = [
            [k for k, _ in group]
            for _, group in groupby(enumerate(limbs), key=lambda pair: pair[1].kind)
        ]
        bounds = self.found.bounds
        self.work = [bounds.joint_bounds.work(limb) for limb in limbs]
        self.long = [bounds.joint_bounds.longest(limb) for limb in limbs]
        self.weights = [self.work[own[0]].both for own in self.classes]
        self.cores = [(core, bounds.around(core)) for core in self.place.cores]
        # Where there is one tree, all take part in its exchange.
        self.around: Around | None = None
        if len(self.found.bounds.robot.trees) == 1 and self.cores:
            self.around = self.cores[0][1]
        self.blocks: dict[Counts, _Block | None] = {}
        self._known: dict[Counts, _Block] = {}
        self._left: dict[tuple[Counts, int], _Rest] = {}
        self._looks = 0  # at limbs, that are not yet paid
        self.counts: Counts = tuple(len(own) for own in self.classes)
        self.bound = max(self.bound, self._whole())

    def run(self) -> float:
        """Look for faster layouts; return a bound on those that were not looked at."""
        self.left = self.found.best
        self._next(self.counts, [], self.found.bounds.processes)
        return self.left

    def _whole(self) -> float:
        """The least for all layouts: of those who share the limbs, and of who has the longest."""
        bounds, most = self.found.bounds, 0.0
        for k, long in enumerate(self.long):
            cores, messages = self._beside([k], 1)
            most = max(most, (long.both + cores) / bounds.fastest + messages)
        least = max(self._bound(self.counts, [], bounds.processes), bounds.start + most)
        for core, around in self.cores:
            own = [limb for limb in self.place.limbs if limb.tree == core.tree]
            many = min(bounds.processes, len(own))
            least = max(least, bounds.shared(around, own, many, min(many, 2), whole=True))
        return least

    def _next(self, remaining: Counts, blocks: list[_Block], processes: int) -> None:
        """Hand out what remains to so many processes."""
        found = self.found
        if not any(remaining):
            found.spent.on(len(blocks) ** 2)  # as many messages
            found.consider(self.place, self._shares(blocks))
            return
        if processes == 0:
            return
        lead = max((c for c, n in enumerate(remaining) if n), key=lambda c: self.weights[c])
        before = blocks[-1].counts if blocks and blocks[-1].counts[lead] else None
        if before is not None and any(n for c, n in enumerate(before) if self._leads(c, lead)):
            before = None
        for counts, bound, every in self._promising(remaining, blocks, lead, processes):
            looks, self._looks = self._looks, 0
            if looks and not found.spent.on(2 * looks):
                self.left = min(self.left, max(every, self.bound))
                return
            if bound >= found.best or (before is not None and counts > before):
                continue
            cost = LOOK if self._at_hand(counts) else found.share
            if not found.spent.on(cost):
                self.left = min(self.left, max(every, self.bound))
                return
            block = self._block(counts)
            if block is None:
                continue
            rest = _without(remaining, counts)
            bound = self._bound(rest, [*blocks, block], processes - 1)
            if bound < found.best:
                self._next(rest, [*blocks, block], processes - 1)

    def _promising(
        self, remaining: Counts, blocks: list[_Block], lead: int, processes: int
    ) -> Iterator[tuple[Counts, float, float]]:
        """What the next process may take, with a bound, and one on that and all that follows.

        The best comes first, unless there is too much; of what is equally good, that which leaves
        least to the others.
        """
        every = self._bound(remaining, blocks, processes)

        def bounded(counts: Counts) -> tuple[float, float]:
            own, rest = self._least(counts), _without(remaining, counts)
            return self._bound(rest, [*blocks, own], processes - 1), own.total

        takes = self._takes(remaining, lead, processes == 1)
        if processes > 1 and prod(n + 1 for n in remaining) > _SORTED:
            yield from ((counts, bounded(counts)[0], every) for counts in takes)
            return
        found = [(*bounded(counts), counts) for counts in takes]
        found.sort(key=lambda each: (int(each[0] / every / _ALIKE), -each[1]))
        least = reversed([*accumulate((bound for bound, _, _ in reversed(found)), min)])
        for (bound, _, counts), later in zip(found, least, strict=True):
            yield counts, bound, max(later, every)

    def _least(self, counts: Counts) -> _Block:
        """The least that a process takes for so many limbs, without a look at them together."""
        if counts not in self._known:
            self._looks += 1
            self._known[counts] = self._bounded(counts)
        return self._known[counts]

    def _bounded(self, counts: Counts) -> _Block:
        bounds = self.found.bounds
        limbs = [k for own, n in zip(self.classes, counts, strict=True) for k in own[:n]]
        every = self._work(limbs)
        most = max(self.long[k].both for k in limbs)
        cores, messages = self._beside(limbs, 1)
        total = (max(most, every.both) + cores) / bounds.fastest
        total += 0.0 if self.around is not None else messages
        before: list[float] = []
        after: list[float] = []
        for core, around in self.cores:
            own = [k for k in limbs if self.place.limbs[k].tree == core.tree]
            if own:
                known = self._work(own)
                way = 0.0 if any(self.place.limbs[k].up for k in own) else around.way
                inwards = max(known.inwards, *(self.long[k].inwards for k in own))
                before.append((inwards + way + around.before) / bounds.fastest)
                after.append((known.outwards + around.after) / bounds.fastest)
        trees = frozenset(self.place.limbs[k].tree for k in limbs)
        return _Block(counts, (), min(before, default=0), min(after, default=0), total, trees)

    def _work(self, limbs: Sequence[int]) -> SweepBound:
        """The least that limbs take, in rows as wide as the robot has them."""
        return SweepBound(*map(sum, zip(*(self.work[k] for k in limbs), strict=True)))

    def _beside(self, limbs: Sequence[int], processes: int) -> tuple[float, float]:
        """What processes that share limbs take besides, each on average at the least.

        Args:
            limbs: their numbers.
            processes: that share them, at most. Where the meeting place has one tree, each of
                them takes part in its exchange; else one at least in that of each core that has
                such a limb.

        Returns:
            The kinematics towards cores and all of the cores, on a core of speed 1, and messages.
        """
        bounds, total = self.found.bounds, 0.0
        shared = 0
        for core, around in self.cores:
            own = [self.place.limbs[k] for k in limbs if self.place.limbs[k].tree == core.tree]
            if own:
                count = processes if self.around is not None else 1
                up = any(limb.up for limb in own)
                total += count * (around.before + around.after) + (count - up) * around.way
                shared = count
        messages = shared * (bounds.sending_one + bounds.receiving_one)
        return total / processes, messages / processes

    def _leads(self, c: int, lead: int) -> bool:
        """Whether limbs of a class are distributed before those of another."""
        return (-self.weights[c], c) < (-self.weights[lead], lead)

    @staticmethod
    def _takes(remaining: Counts, lead: int, everything: bool) -> Iterator[Counts]:
        """What the next process may take, one limb of a class at least; more before less."""
        if everything:
            yield remaining
            return
        yield from product(*(range(n, -1 if c != lead else 0, -1) for c, n in enumerate(remaining)))

    def _limbs(self, counts: Counts) -> tuple[int, ...]:
        """The numbers of so many limbs of each class, ascending."""
        return tuple(sorted(k for c, n in enumerate(counts) for k in self.classes[c][:n]))

    def _at_hand(self, counts: Counts) -> bool:
        """Whether the price of so many limbs of each class is known."""
        if counts in self.blocks:
            return True
        return self.found.prices.knows(self.place, self._limbs(counts))

    def _block(self, counts: Counts) -> _Block | None:
        """What a process takes that has so many limbs of each class; None where it cannot."""
        if counts not in self.blocks:
            own = self._limbs(counts)
            piece = self.found.prices.piece(self.place, own, frozenset())
            self.blocks[counts] = None
            if piece is not None:
                share, fastest = piece.share, self.found.bounds.fastest
                before = (share.least_kinematics + share.inwards) / fastest
                after = share.outwards / fastest
                messages = 0.0 if self.around is not None else self._beside(own, 1)[1]
                total = before + share.between / fastest + after + messages
                trees = frozenset(self.place.limbs[k].tree for k in own)
                self.blocks[counts] = _Block(counts, own, before, after, total, trees)
        return self.blocks[counts]

    def _bound(self, remaining: Counts, blocks: list[_Block], processes: int) -> float:
        """The least that layouts take which begin with some blocks, the rest shared by others."""
        bounds, some = self.found.bounds, any(remaining)
        if some and not processes:
            return float("inf")
        alone = max((block.total for block in blocks), default=0.0)
        messages = bounds.sending_one + bounds.receiving_one if self.around is not None else 0.0
        rest = self._rest(remaining, processes)
        least = bounds.start + max(alone + messages * bool(blocks), rest.work)
        waited = bounds.start + bounds.sending_one + bounds.receiving_one + bounds.latency
        for (core, around), others in zip(self.cores, rest.before, strict=True):
            before = max([others, *(b.before for b in blocks if core.tree in b.trees)])
            bound = (around.after + bounds.outwards) / bounds.fastest
            known = [block.after for block in blocks]
            after = min([*known, *([bound] if some or not known else [])])
            least = max(least, waited + before + after, waited + _last(core.tree, blocks, others))
        return least

    def _rest(self, remaining: Counts, processes: int) -> _Rest:
        """What limbs take at least that are left to so many processes."""
        key = remaining, processes
        if key not in self._left:
            self._looks += 1
            limbs = [k for own, n in zip(self.classes, remaining, strict=True) for k in own[:n]]
            work = 0.0
            if limbs:
                bounds = self.found.bounds
                cores, messages = self._beside(limbs, processes)
                work = (self._work(limbs).both / processes + cores) / bounds.fastest + messages
            before = [
                self._slowest(core.tree, around, limbs, processes) for core, around in self.cores
            ]
            self._left[key] = _Rest(work, tuple(before))
        return self._left[key]

    def _slowest(self, tree: int, around: Around, limbs: Sequence[int], processes: int) -> float:
        """What the slowest process of a tree takes before the exchange that has some of the limbs.

        None is 0.

        Args:
            tree: which.
            around: what its core takes.
            limbs: numbers of those that are left, of all trees.
            processes: that share them.
        """
        bounds = self.found.bounds
        own = [k for k in limbs if self.place.limbs[k].tree == tree]
        if not own:
            return 0.0
        least = 0.0
        for k in own:
            way = 0.0 if self.place.limbs[k].up else around.way
            least = max(least, self.long[k].inwards + way)
        up = any(self.place.limbs[k].up for k in own)
        inwards = self._work(own).inwards
        least = max(least, (inwards + around.way * (processes - up)) / processes)
        return (least + around.before) / bounds.fastest

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
