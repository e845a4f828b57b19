"""Lower bounds on the time of a partial chain in form `segment`, before any search.

With m processes a chain falls into m segments under m - 1 joins. Every segment waits for the joins
above it, log2(m) of them on average at the least, and for the messages that are between it and the
root, (m - 1)/m on average at the least; so the time is at least the average segment, that many
joins and that much of a message.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate
from math import log2

import numpy as np
from numpy.typing import NDArray

from adagen.schedule.chains import Chain
from adagen.schedule.costs import block_rows
from adagen.schedule.profile import TICKS
from adagen.schedule.segment_costs import Price, SegmentCosts

Ints = NDArray[np.int64]
_ANY = 16  # processes up to which a range may be divided anyhow


@dataclass(frozen=True)
class Options:
    """Cuts with ways to divide P, by ascending bound; arrays of equal length, ticks.

    Attributes:
        total: least time of both sweeps.
        assembly: least time of the first one.
        disassembly: least time of the second one.
        position: of the joint that is cut.
        first: processes for the root side.
        guess: the time of both sweeps with what the bound leaves out, on average; ticks.
    """

    total: Ints
    assembly: Ints
    disassembly: Ints
    position: Ints
    first: Ints
    guess: Ints


def _rows(prices: list[Price]) -> Ints:
    """Return prices as rows: both sweeps, the first one, the second one."""
    table = [(price.total, price.assembly, price.disassembly) for price in prices]
    return np.array(table, dtype=np.int64).reshape(-1, 3).T


class SegmentBounds:
    """Lower bounds for the partial chains of one robot.

    Args:
        costs: prices.
        cuttable: per position, whether two processes may meet at its joint.
        speeds: of the cores of all processes.
    """

    def __init__(
        self, costs: SegmentCosts, cuttable: NDArray[np.bool_], speeds: tuple[float, ...]
    ) -> None:
        self.costs = costs
        self._cuttable = cuttable
        self._power = [0.0, *accumulate(sorted(speeds, reverse=True))]
        self._fastest = max(speeds)
        self._alike = min(speeds) == self._fastest
        self._arrays()
        self._links(costs)
        self._rates(costs)
        self._known_besides: dict[
            tuple[int, bool, bool], list[tuple[Ints, NDArray[np.float64]]]
        ] = {}

    def _arrays(self) -> None:
        costs, chains = self.costs, self.costs.chains
        self._end = np.array(chains.end, dtype=np.int64)
        self._parent = np.array(chains.parent, dtype=np.int64)
        self._kinematics = np.array(costs.kinematics, dtype=np.int64)
        self._sums = np.concatenate([[0], np.cumsum(self._kinematics[1:])])
        self._branch = np.array(costs.branch, dtype=np.int64)
        self._join = _rows(costs.join)
        self._least_join = self._join.min(axis=1) / self._fastest
        self._held = not any(costs.free)
        self._ground = [p for p, link in enumerate(chains.parent) if link == 0]
        no, load = Price(0, 0), costs.load
        bare = [no if free else Price(o.assembly, o.disassembly + load) for o, free in self._out()]
        rooted = [
            no if free else Price(o.assembly + costs.spread, o.disassembly + load)
            for o, free in self._out()
        ]
        self._alone = _rows(
            [
                Price(own + a.assembly, a.disassembly)
                for own, a in zip(costs.own, costs.alone, strict=True)
            ]
        )
        self._outward = {False: _rows(bare), True: _rows(rooted)}
        self._dearest = (self._alone + self._outward[True]).max(axis=1)
        self._before = np.pad(self._alone.cumsum(axis=1), ((0, 0), (1, 0)))

    def _out(self) -> zip[tuple[Price, bool]]:
        return zip(self.costs.outward, self.costs.free, strict=True)

    def _links(self, costs: SegmentCosts) -> None:
        """Sum up what it takes to carry mobility from the ground to each link."""
        self._way: dict[bool, Ints] = {}
        self._way_of_both: dict[bool, list[int]] = {}
        for rooted, out in self._outward.items():
            way = np.zeros((3, len(self._parent) + 1), dtype=np.int64)
            for p, above in enumerate(costs.chains.parent):
                way[:, p + 1] = way[:, above] + out[:, p]
            self._way[rooted] = way
            self._way_of_both[rooted] = way[0].tolist()
        self._furthest = self._way[True][0, 1:].copy()  # of all links beyond each joint
        for p in reversed(range(len(self._parent))):
            if (above := self._parent[p]) > 0:
                self._furthest[above - 1] = max(self._furthest[above - 1], self._furthest[p])
        self._root = _rows([costs.whole_root])[:, 0]
        self._start = np.array([costs.start, costs.start, 0])

    def _rates(self, costs: SegmentCosts) -> None:
        """Note what couplings cost at each joint, and what any message does."""
        table = costs.costs
        self._pairs = np.array([block_rows(kind) for kind in costs.priced_as])
        self._per_handle = [
            (table[name] * TICKS, table["disassemble.coupling"] * TICKS)
            for name in ("join.coupling_a", "join.coupling_b")
        ]
        self._per_pair = table["join.block"] * TICKS, table["join.across"] * TICKS
        handle = costs.message([1])
        one = [costs.coupled(p, *ab) for p in range(len(self._pairs)) for ab in ((1, 0), (0, 1))]
        self._one_handle = _rows(one).min(axis=1) / self._fastest
        self._away = _rows([Price(*handle.away)])[:, 0]
        self._handling = _rows([handle.handling])[:, 0]

    # --- area ------------------------------------------------------------------------------------

    def _area(self, work: Ints, base: Ints, processes: int, rooted: bool, lone: bool) -> list[Ints]:
        """Return the least times of chains on 1, 2, .. processes; arrays of shape (3, n).

        Args:
            work: least work on one process, apart from roots; shape (3, n).
            base: what every segment takes besides; shape (3, n).
            processes: the most.
            rooted: whether every segment has a root; else all but one.
            lone: whether parts may have nothing to tell each other.
        """
        found: list[Ints] = []
        for m, (roots, waits) in enumerate(self._besides(processes, rooted, lone), start=1):
            segments = np.maximum(0, work + roots[:, None]) + m * base
            least: Ints = (segments / self._power[m] + waits[:, None]).astype(np.int64)
            if lone:  # nobody may wait for most of them in either sweep
                least[1:] = 0
            found.append(np.minimum(found[-1], least) if found else least)
        return found

    def _besides(
        self, processes: int, rooted: bool, lone: bool
    ) -> list[tuple[Ints, NDArray[np.float64]]]:
        """What chains on 1, 2, .. processes take besides: their roots, and waiting for joins."""
        key = processes, rooted, lone
        if key in self._known_besides:
            return self._known_besides[key]
        found = self._known_besides[key] = []
        away = np.zeros(3) if lone or not self._alike else self._away
        join = 0 * self._least_join if lone else self._least_join + self._handling
        for m in range(1, processes + 1):
            roots = (m if rooted else m - 1) * self._root - (m - 1) * self._dearest
            joins = log2(m) if self._alike else min(1, m - 1)
            # All joins but that of the whole robot have a handle beside them.
            beside = 0 if lone else max(0, joins - (not rooted)) * self._one_handle
            found.append((roots, joins * join + beside + (m - 1) / m * away))
        return found

    def _lone(self, chain: Chain) -> bool:
        """Return whether parts of a chain may have nothing to tell: several joints on ground."""
        return chain.top == 0 and sum(p not in chain.cuts for p in self._ground) > 1

    def least(self, chain: Chain, processes: int) -> int:
        """Return a lower bound on both sweeps of a chain by its area, ticks."""
        rooted, lone = chain.top > 0, self._lone(chain)
        work = sum(self.costs.work(chain))
        if rooted or self._held:
            way = self._way_of_both[rooted]
            links = self.costs.handles(chain)
            work += max((0, *(way[link] - way[chain.top] for link in links)))
        base = int(self._start[0]) + self.costs.kinematics[chain.top]
        times = (
            int((max(0, work + int(roots[0])) + m * base) / self._power[m] + float(waits[0]))
            for m, (roots, waits) in enumerate(self._besides(processes, rooted, lone), start=1)
        )
        return min(times)

    # --- options ---------------------------------------------------------------------------------

    def options(self, chain: Chain, processes: int) -> Options:
        """Return the allowed cuts of a chain with joints on both sides, and all divisions of P."""
        at = np.concatenate([np.arange(a, b) for a, b in self.costs.chains.ranges(chain)])
        at, end, root, most = self._sides(chain, at)
        rooted = chain.top > 0
        lone = self._lone(chain)
        n = len(at)
        base = np.zeros((3, n), dtype=np.int64) + self._start[:, None]
        base_end = base.copy()
        base[:2] += self.costs.kinematics[chain.top]
        base_end[:2] += self._kinematics[at + 1]
        on_root = self._area(root, base, processes - 1, rooted, lone)
        on_end = self._area(end, base_end, processes - 1, True, False)
        cut = self._cut(chain, at)
        cut, away = cut + self._handling[:, None] * (not lone), self._away[:, None]
        found, guesses = [], []
        more_root, more_end = self._repeated(chain, at)
        spread = (self._way[True] - self._way[rooted])[0, self._parent[at]]
        # All segments of an end side but the outermost one carry mobility outwards.
        carried = self._furthest[at] - self._way[True][0, at + 1]
        for boundary in chain.cuts:
            carried[(at < boundary) & (boundary < self._end[at])] = 0  # it does, too
        ratio = 1 + carried / np.maximum(1, end[0])
        for p, q in _divisions(processes):
            a, b = on_root[p - 1], on_end[q - 1]
            if lone:  # the one that has nothing to tell does not wait for the join
                together = np.maximum(np.maximum(a, b), cut + np.minimum(a, b))
                together[1:] = 0
            else:
                together = cut + np.maximum(np.maximum(a, b), np.minimum(a, b) + away)
            found.append(together)
            more = end[0] * (ratio / (q - 1 + ratio) - 1 / q) / self._fastest
            on_root_side = a[0] + (p - 1) / p * (more_root + spread / p / self._fastest)
            on_both = on_root_side, b[0] + (q - 1) / q * more_end + more
            guess = np.maximum(*on_both)
            guesses.append(guess.astype(np.int64) + cut[0])
        bound = np.concatenate(found, axis=1)
        total = np.maximum(bound[0], bound[1] + bound[2])
        first = np.repeat([p for p, _ in _divisions(processes)], n)
        place = np.tile(at, len(found))
        # Processes of no use on one side are given to the other one while they are of use there.
        spare = (
            first - np.tile(most[0], len(found)),
            processes - first - np.tile(most[1], len(found)),
        )
        wasted = self._alike & ((spare[0] > 0) & (spare[1] < 0) | (spare[0] < 0) & (spare[1] > 0))
        order = np.argsort(total, kind="stable")
        order = order[~wasted[order]]
        return Options(
            total[order],
            bound[1][order],
            bound[2][order],
            place[order],
            first[order],
            np.concatenate(guesses)[order],
        )

    def _repeated(self, chain: Chain, at: Ints) -> tuple[Ints, Ints]:
        """Return the kinematics that segments repeat on average if they lie all over a side.

        For the root side and for the end side of each cut.
        """
        stop, sums = self._end[at], self._sums
        count, total = stop - at - 1, sums[stop] - sums[at + 1]
        first, last = self.costs.chains.span(chain)
        all_of_them, whole = last - first, sums[last] - sums[first]
        for cut in chain.cuts:
            below = self.costs.chains.end[cut]
            inside = (at < cut) & (cut < stop)
            count, total = (
                count - (below - cut) * inside,
                total - (sums[below] - sums[cut]) * inside,
            )
            all_of_them, whole = all_of_them - (below - cut), whole - (sums[below] - sums[cut])
        rest = np.maximum(1, all_of_them - count - 1)
        above = self._kinematics
        root = (whole - total - above[at + 1]) // rest - above[chain.top]
        return np.maximum(0, root), np.maximum(0, total // np.maximum(1, count) - above[at + 1])

    def _sides(self, chain: Chain, at: Ints) -> tuple[Ints, Ints, Ints, Ints]:
        """Return allowed cuts, the least work of their end and root sides, and processes of use.

        The works have the shape (3, n), the numbers of processes (2, n), root side first.
        """
        costs, chains = self.costs, self.costs.chains
        stop, before = self._end[at], self._before
        end = before[:, stop] - before[:, at + 1]
        size = stop - at - 1
        out, rooted = self._way[True], chain.top > 0
        out_root = self._way[rooted]
        held = rooted or self._held
        inner = np.zeros((3, len(at)), dtype=np.int64)  # from the end side's top to its handles
        outer = np.zeros((3, len(at)), dtype=np.int64)  # from the root side's top to its handles
        if held:
            outer += out_root[:, self._parent[at]] - out_root[:, [chain.top]]
        for cut in chain.cuts:
            inside = (at < cut) & (cut < stop)
            below = chains.end[cut]
            end -= (before[:, [below]] - before[:, [cut]]) * inside
            size -= (below - cut) * inside
            link = chains.parent[cut]
            np.maximum(inner, (out[:, [link]] - out[:, at + 1]) * inside, out=inner)
            if held:
                far = out_root[:, [link]] - out_root[:, [chain.top]]
                np.maximum(outer, far * ~inside, out=outer)
        work = costs.work(chain)
        whole = np.array([[sum(work)], [work[0] + work[1]], [work[2]]])
        root = whole - end - self._alone[:, at]
        sizes = np.stack([len(at) - 1 - size, size])
        good = self._cuttable[at] & (sizes > 0).all(axis=0)
        # A segment has a joint, and so has every cut between two of them.
        most = (sizes[:, good] + 1) // 2
        return at[good], (end + inner)[:, good], (root + outer)[:, good], most

    def _cut(self, chain: Chain, at: Ints) -> Ints:
        """Return what the joins of cuts cost, on the fastest core at least; shape (3, n)."""
        a = np.zeros(len(at), dtype=np.int64)
        b = np.zeros(len(at), dtype=np.int64)
        for link in self.costs.handles(chain):
            below = (at < link) & (link <= self._end[at])
            b += below
            near = (self._parent[at] > 0) & ~below
            a += near if chain.top else near & (self._branch[at + 1] == self._branch[link])
        block, across = self._per_pair
        pairs = self._pairs[at] * (block * (a * (a + 1) + b * (b + 1)) / 2 + across * a * b)
        (up_a, down_a), (up_b, down_b) = self._per_handle
        up, down = a * up_a + b * up_b + pairs, a * down_a + b * down_b
        extra = np.stack([up + down - 2, up - 1, down - 1])  # prices are rounded
        found: Ints = ((self._join[:, at] + np.maximum(0, extra)) / self._fastest).astype(np.int64)
        return found


def _divisions(processes: int) -> list[tuple[int, int]]:
    """Return the ways to divide P >= 2 processes: all of them up to 16, else in halves."""
    if processes > _ANY:
        return [(processes // 2, processes - processes // 2)]
    return [(p, processes - p) for p in range(1, processes)]
