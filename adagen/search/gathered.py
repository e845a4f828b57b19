"""Branch and bound over layouts: where processes meet, and who takes which limbs.

Frames are taken by their bounds, the smallest first, until none can be faster than the best layout
found. Within a frame limbs are handed out process by process: the next one takes the heaviest limb
that is left, and some of the others. Limbs of one kind that follow each other are interchangeable,
processes of equal speed are alike, and layouts that differ in their numbers only count as one.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import groupby, permutations

from adagen.search.bounds import Around, Bounds
from adagen.search.guess import Guess, evenly
from adagen.search.layouts import Frame, Layout, LayoutPrices
from adagen.search.limbs import Core

_LOOK = 2  # what a look at a frame or a layout costs
_FRAMES = 12  # frames in which layouts are guessed that bring nothing, before that ends
_MANY = 100  # times as many frames that are looked at for these
_ALL_NUMBERS = 3
"""Processes up to which all ways to number them are tried."""

Counts = tuple[int, ...]
"""How many limbs of each class of interchangeable ones."""


@dataclass
class Spent:
    """What a search may spend, and what it has spent.

    A frame, a layout or the share of a process is expanded once; the latter costs as much as the
    robot has joints, the others as much as a joint or two.

    Attributes:
        limit: what may be spent.
        spent: so much of it is.
        expanded: on so many.
    """

    limit: int
    spent: int = 0
    expanded: int = 0

    def on(self, cost: int) -> bool:
        """Spend something; return whether it was there."""
        if self.spent >= self.limit:
            return False
        self.spent += cost
        self.expanded += 1
        return True


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


class GatheredSearch:
    """The fastest layout.

    Args:
        prices: prices of layouts.
        bounds: lower bounds on them.
        roots: for each link whether processes may meet around it; length N + 1.
        known: a time that is to be beaten, microseconds.
        spent: the budget.
        accept: whether a layout can be said by a schedule.

    Attributes:
        best: the least time found, or what was known.
        layout: the layout that takes it; None where none beats what was known.
        lower: proven: no layout takes less, or it is no faster than the best.
        candidates: layouts that were priced.
    """

    def __init__(
        self,
        prices: LayoutPrices,
        bounds: Bounds,
        roots: Sequence[bool],
        known: float,
        spent: Spent,
        accept: Callable[[Layout], bool],
    ) -> None:
        self.prices, self.bounds, self.robot = prices, bounds, prices.robot
        self.roots, self.spent, self.accept = roots, spent, accept
        self.processes = bounds.processes
        costs = prices.pricing.costs
        self.speeds = [costs.speed(p) for p in range(self.processes)]
        self.best, self.lower = known, known
        self.layout: Layout | None = None
        self.candidates = 0
        joints = len(self.robot.joints)
        self.share = round(joints * (1 + min(1.0, joints / 1000)))  # what pricing one costs

    def run(self) -> None:
        """Search as far as the budget goes."""
        self._first()
        order = 0
        heap: list[tuple[float, int, Frame]] = []
        waiting = self._begun()
        left = self.best
        while True:
            for frame in waiting:
                bound = self.bounds.frame(frame.cores, frame.limbs)
                if bound < self.best:
                    heapq.heappush(heap, (bound, order, frame))
                    order += 1
            if not heap or heap[0][0] >= self.best or not self.spent.on(_LOOK):
                break
            bound, _, frame = heapq.heappop(heap)
            if self._meets(frame):
                left = min(left, _HandOut(self, frame, bound).run())
            waiting = self._after(frame)
        if heap:
            left = min(left, heap[0][0])
        self.lower = min(left, self.best)

    def _begun(self) -> list[Frame]:
        """The frames that all others come from."""
        return [self._frame(())] if len(self.robot.trees) > 1 else list(self._opened(()))

    def _after(self, frame: Frame) -> list[Frame]:
        """The frames that come from another one."""
        more = self._opened(frame.cores) if len(self.robot.trees) > 1 else ()
        return [*self._grown(frame.cores), *more]

    def _first(self) -> None:
        """Price some layouts that share out evenly what limbs take by themselves.

        The most promising of those frames that come first are looked at, as long as that helps.
        """
        floors, waiting = self.bounds.floors, self._begun()
        guesses: list[tuple[float, int, Frame, Guess]] = []
        for seen in range(_FRAMES * _MANY):
            if seen == len(waiting) or not self.spent.on(_LOOK):
                break
            frame = waiting[seen]
            if self.bounds.frame(frame.cores, frame.limbs) >= self.best:
                continue
            waiting += self._after(frame)
            if self._meets(frame):
                guess = evenly([floors.alone(limb) for limb in frame.limbs], self.processes)
                core = sum(floors.core(core.joints).both for core in frame.cores)
                guesses.append((guess.time + core, seen, frame, guess))
        waited = 0
        for _, _, frame, guess in sorted(guesses, key=lambda each: each[:2]):
            before = self.best
            if waited == _FRAMES or 4 * self.spent.spent > self.spent.limit:
                break
            self.spent.on(self.share * len(guess.shares))
            self.consider(frame, guess.shares)
            waited = 0 if self.best < before else waited + 1

    def _frame(self, cores: tuple[Core, ...]) -> Frame:
        return Frame(cores, self.robot.limbs(cores))

    def _opened(self, cores: tuple[Core, ...]) -> Iterator[Frame]:
        """Frames that share one more tree, one that comes after those shared."""
        if cores and any(core.joints for core in cores):
            return  # trees are shared first, then cores grow
        for number in range(cores[-1].tree + 1 if cores else 0, len(self.robot.trees)):
            for link in self.robot.trees[number].links:
                if self.roots[link]:
                    yield self._frame((*cores, Core(number, link)))

    def _grown(self, cores: tuple[Core, ...]) -> Iterator[Frame]:
        """Frames with one more stretch in a core, one that comes after those in it."""
        last = max((core.joints[-1] for core in cores if core.joints), default=-1)
        for place, core in enumerate(cores):
            up = not self.robot.floats(core.tree, core.root)
            if len(self.robot.at[core.root]) + up < 3:
                continue  # all that is not beyond the stretch would be of one process
            for link in (core.root, *(j + 1 for j in core.joints)):
                for joint in self.robot.at[link]:
                    if joint > last and (more := self.robot.stretch(joint)):
                        grown = Core(core.tree, core.root, (*core.joints, *more))
                        yield self._frame((*cores[:place], grown, *cores[place + 1 :]))

    def _meets(self, frame: Frame) -> bool:
        """Whether two processes or more can be on either side of each joint of the cores."""
        for core in frame.cores:
            beyond: dict[int, int] = {core.root: 0}
            ends = {
                core.root: core.root,
                **{j + 1: self.robot.joints[j].parent for j in core.joints},
            }
            inner = {ends[link] for link in ends if link != core.root}
            for limb in frame.limbs:
                if limb.tree == core.tree:
                    beyond[limb.link] = beyond.get(limb.link, 0) + 1
            leaves = [link for link in ends if link not in inner]
            if any(beyond.get(link, 0) < 2 for link in leaves):
                return False
            first = [j for j in core.joints if self.robot.joints[j].parent == core.root]
            if len(first) == 1 and beyond[core.root] < 2:
                return False
        return True

    def consider(self, frame: Frame, shares: Sequence[tuple[int, ...]]) -> float:
        """Price a layout in several ways to number its processes; return the least time."""
        least = float("inf")
        for numbered in self._numbered(frame, shares):
            layout = Layout(frame, numbered)
            if not self._in_place(layout):
                return least
            time = self.prices.time(layout)
            if time is None:
                return least
            least = min(least, time)
            if time < self.best and self.accept(layout):
                self.best, self.layout = time, layout
        self.candidates += 1
        return least

    def _numbered(
        self, frame: Frame, shares: Sequence[tuple[int, ...]]
    ) -> Iterator[tuple[tuple[int, ...], ...]]:
        """Ways to number processes, those with nothing to do last where all are alike."""
        idle = [()] * (self.processes - len(shares))
        alike = min(self.speeds) == max(self.speeds)
        if self.processes <= _ALL_NUMBERS or (len(shares) <= _ALL_NUMBERS and alike):
            given = shares if alike else [*shares, *idle]
            for order in dict.fromkeys(permutations(given)):
                yield (*order, *idle) if alike else order
            return

        def weight(own: tuple[int, ...]) -> float:
            return sum(self.bounds.floors.work(frame.limbs[k]).both for k in own)

        light_first = sorted(shares, key=weight)
        if alike:
            yield (*light_first, *idle)
            yield (*reversed(light_first), *idle)
            return
        ranked = sorted(range(self.processes), key=lambda p: -self.speeds[p])
        found: list[tuple[int, ...]] = [()] * self.processes
        for p, own in zip(ranked, reversed(light_first), strict=False):
            found[p] = own
        yield tuple(found)

    def _in_place(self, layout: Layout) -> bool:
        """Whether two processes or more are on either side of each joint of the cores."""
        of = {k: p for p, own in enumerate(layout.shares) for k in own}
        for core in layout.frame.cores:
            sides: dict[int, set[int]] = {}
            for k, limb in enumerate(layout.frame.limbs):
                if limb.tree == core.tree:
                    sides.setdefault(limb.link, set()).add(of[k])
            if len(set().union(*sides.values())) < 2:
                return False
            for joint in core.joints:
                span = range(joint + 1, self.robot.last[joint] + 2)
                far = [own for link, own in sides.items() if link in span]
                near = [own for link, own in sides.items() if link not in span]
                if len(set().union(*far)) < 2 or len(set().union(*near)) < 2:
                    return False
        return True


@dataclass
class _HandOut:
    """Handing out the limbs of a frame.

    Attributes:
        search: the search.
        frame: the frame.
        bound: on all its layouts.
    """

    search: GatheredSearch
    frame: Frame
    bound: float
    left: float = field(init=False)

    def __post_init__(self) -> None:
        limbs = self.frame.limbs
        self.left = self.search.best
        self.classes = [
            [k for k, _ in group]
            for _, group in groupby(enumerate(limbs), key=lambda pair: pair[1].kind)
        ]
        bounds = self.search.bounds
        self.work = [bounds.floors.work(limb) for limb in limbs]
        self.long = [bounds.floors.longest(limb) for limb in limbs]
        self.weights = [self.work[own[0]].both for own in self.classes]
        self.longest = [self.long[own[0]].both for own in self.classes]
        self.cores = [(core, bounds.around(core)) for core in self.frame.cores]
        # Where there is one tree, all take part in its exchange.
        self.around: Around | None = None
        if len(self.search.robot.trees) == 1 and self.cores:
            self.around = self.cores[0][1]
        self.blocks: dict[Counts, _Block | None] = {}

    def run(self) -> float:
        """Look for faster layouts; return a bound on those that were not looked at."""
        counts = tuple(len(own) for own in self.classes)
        self._next(counts, [], self.search.processes)
        return self.left

    def _next(self, remaining: Counts, blocks: list[_Block], processes: int) -> None:
        """Hand out what remains to so many processes."""
        search = self.search
        if not any(remaining):
            search.spent.on(len(blocks) ** 2)  # as many messages
            search.consider(self.frame, self._shares(blocks))
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
            if bound >= search.best:
                continue
            cost = _LOOK if counts in self.blocks else search.share
            if not search.spent.on(cost):
                self.left = min(self.left, max(bound, self.bound))
                return
            block = self._block(counts)
            if block is None:
                continue
            bound = self._bound(rest, [*blocks, block], processes - 1)
            if bound < search.best:
                self._next(rest, [*blocks, block], processes - 1)

    def _least(self, counts: Counts) -> float:
        """The least that a process takes for so many limbs, without a look at them together."""
        bounds = self.search.bounds
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
            piece = self.search.prices.piece(self.frame, own, frozenset())
            self.blocks[counts] = None
            if piece is not None:
                share, fastest = piece.share, self.search.bounds.fastest
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
        bounds = self.search.bounds
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
        bounds = self.search.bounds
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
