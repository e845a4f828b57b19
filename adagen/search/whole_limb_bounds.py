"""The least that one process takes for a limb that it has as a whole, beside whatever else it has.

Joints are passed in runs, one by one, or in rows with those of other limbs. Each run and each group
of rows costs something once, and a group holds the same limbs from its first row to its last. So
limbs of unequal length, such as the fingers of a hand, take more than as many joints in full rows.
What else the process has may be in the same rows, but makes none of them cheaper: the least over
all ways to divide a limb's own joints is a bound for any process that has the limb.

Limbs that part at one link are seen as chains, the longest way through each. Where a row holds
joints of several of them, its group ends at that link: what is before it bears all of them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations, product
from math import comb, inf, prod
from typing import Literal, NamedTuple, get_args

from adagen.schedule.costs import StepCosts
from adagen.search.limbs import Robot


class SweepBound(NamedTuple):
    """The least that a joint takes, microseconds.

    Attributes:
        inwards: kinematics and the sweep inwards.
        outwards: the sweep outwards.
        both: all of it; at least the sum of the two.
    """

    inwards: float
    outwards: float
    both: float

    def plus(self, other: SweepBound) -> SweepBound:
        """Return the sum of two."""
        return SweepBound(
            self.inwards + other.inwards, self.outwards + other.outwards, self.both + other.both
        )


NOTHING = SweepBound(0.0, 0.0, 0.0)


def longest_of(bounds: Iterable[SweepBound]) -> SweepBound:
    """Return the largest of each, 0 for none."""
    inwards = outwards = both = 0.0
    for bound in bounds:
        inwards = max(inwards, bound.inwards)
        outwards = max(outwards, bound.outwards)
        both = max(both, bound.both)
    return SweepBound(inwards, outwards, both)


Part = Literal["inwards", "both"]
"""Which of a bound's times is asked for: up to the end of the sweep inwards, or all."""

_KINDS = ("revolute", "prismatic")
"""Kinds of joints that are looked at."""
_MOST = 4
"""Chains in a row."""
_PAIR = 2
_LEFT = 10_000
"""Lengths that may be left of chains; where there are more, the shortest chains are left out."""


class _Prices:
    """What so many joints one after the other take at least, of one limb or several in lanes.

    Args:
        costs: the machine's coefficients.
        kinds: of the joints, one at least.
        strips: whether there are runs so long that they may be passed in strips.
        part: which of the times is asked for.
    """

    def __init__(self, costs: StepCosts, kinds: Sequence[str], strips: bool, part: Part) -> None:
        self.start = costs["link.start"]
        self._known: dict[tuple[int, int], float] = {}

        def each(kinematics: str, sweep: str, outwards: str) -> float:
            groups = (kinematics, sweep, *((outwards,) if part == "both" else ()))
            return min(sum(costs[f"{group}.{kind}"] for group in groups) for kind in kinds)

        moved = ("kinematics", "kinematics_strips") if strips else ("kinematics",)
        # By the lanes that there are: what is paid once, and row by row.
        self.ways = {
            1: [
                (costs[f"{a}.run"] + costs[f"{b}.run"], each(a, b, "accelerate"))
                for a, b in product(moved, ("articulate", "articulate_columns"))
            ],
        }
        for lanes, name in ((2, "two"), (4, "four")):
            groups = (f"{group}_{name}" for group in ("kinematics", "articulate", "accelerate"))
            self.ways[lanes] = [(costs[f"limbs.{name}"], each(*groups))]
        self.row = self.start + min(row for ways in self.ways.values() for _, row in ways)

    def of(self, chains: int, rows: int) -> float:
        """Return what so many chains take which are in lanes for so many rows, or in a run."""
        if (chains, rows) not in self._known:
            least = min(
                once + rows * row
                for lanes, ways in self.ways.items()
                for once, row in ways
                if lanes >= chains
            )
            self._known[chains, rows] = least + chains * rows * self.start
        return self._known[chains, rows]

    def share(self, rows: int) -> float:
        """Return the least of a joint where three joints or more go together for some rows."""
        return self.start + min(
            (once / rows + row if count > _PAIR else row) / count
            for lanes, ways in self.ways.items()
            for once, row in ways
            for count in range(1, lanes + 1)
        )


class WholeLimbBounds:
    """Bounds of joints that hang together.

    Args:
        robot: the robot.
        costs: the machine's coefficients.

    Attributes:
        plain: for each joint whether it is looked at.
    """

    def __init__(self, robot: Robot, costs: StepCosts) -> None:
        self.plain = [
            joint.parent > 0 and joint.kind in _KINDS and not joint.prescribed
            for joint in robot.joints
        ]
        inwards, both = (
            _WholeLimbBounds(robot, self.plain, costs, part) for part in get_args(Part)
        )
        self._inwards, self._both = inwards, both
        self._tangents = [costs["process.tangent"] * joint.tangents for joint in robot.joints]
        self._parents = [joint.parent for joint in robot.joints]

    def run(self, length: int) -> SweepBound:
        """Return the least for so many joints one after the other, none beside another."""
        return SweepBound(self._inwards.prices.of(1, length), 0.0, self._both.prices.of(1, length))

    def beside(self, chains: Sequence[int], way: int) -> float:
        """Return the least for chains that hang on one link, and the joints before it, both ways.

        Args:
            chains: how many plain joints each has.
            way: how many there are one after the other that end at the link; no more than those
                that the process has.

        Returns:
            Microseconds.
        """
        return self._both.beside(chains, way)

    def share(self, rows: int) -> float:
        """Return the least that a joint takes both ways, with its share of what is paid once.

        Args:
            rows: no three chains or more can go side by side that are longer.

        Returns:
            Microseconds.
        """
        return self._both.prices.share(rows)

    def inwards(self, joints: Sequence[int]) -> float:
        """Return the least for joints that hang on one link or on each other, inwards; ascending.

        Microseconds.
        """
        return self._inwards.whole(joints) + sum(self._tangents[j] for j in joints)

    def beyond(self, joints: Sequence[int]) -> dict[int, SweepBound]:
        """Return the least for each of some joints and those of them that hang on it.

        Joints on the ground and others that are not looked at are left out of it.

        Args:
            joints: ascending.
        """
        inwards, both = self._inwards.beyond(joints), self._both.beyond(joints)
        tangents: dict[int, float] = {}  # by links: of all that hangs there
        for j in reversed(joints):
            own = tangents[j + 1] = tangents.get(j + 1, 0.0) + self._tangents[j]
            tangents[self._parents[j]] = tangents.get(self._parents[j], 0.0) + own
        return {
            j: SweepBound(inwards[j] + tangents[j + 1], 0.0, both[j] + tangents[j + 1])
            for j in joints
        }


class _WholeLimbBounds:
    """The same for one of the times.

    Args:
        robot: the robot.
        plain: for each joint whether it is looked at.
        costs: the machine's coefficients.
        part: which of the times is asked for.
    """

    def __init__(self, robot: Robot, plain: Sequence[bool], costs: StepCosts, part: Part) -> None:
        self._joints, self._plain = robot.joints, plain
        kinds = {joint.kind for joint, own in zip(robot.joints, plain, strict=True) if own}
        self.prices = _Prices(costs, sorted(kinds) or _KINDS, bool(robot.long), part)
        self._divided: dict[tuple[int, ...], tuple[float, float]] = {(): (0.0, inf)}

    def whole(self, joints: Sequence[int]) -> float:
        """Return the least for joints that hang on one link or on each other."""
        inside = set(joints)
        least, reach = self._all(joints)
        first = [j for j in joints if self._joints[j].parent - 1 not in inside]
        apart, along, one = self._parted(first, least, reach)
        return max(min(apart, along), one)

    def beside(self, chains: Sequence[int], way: int) -> float:
        """Return the least for chains that hang on one link, and joints before it."""
        apart, along = self._chains(self._few(sorted(filter(None, chains), reverse=True)))
        run = self.prices.of(1, way) if way else 0.0
        return min(apart + run, along + way * self.prices.row)

    def beyond(self, joints: Sequence[int]) -> dict[int, float]:
        """Return the least for each joint and what hangs on it."""
        return self._all(joints)[0]

    def _all(self, joints: Sequence[int]) -> tuple[dict[int, float], dict[int, int]]:
        """The least for what begins with each joint, and plain joints on the longest way there."""
        at: dict[int, list[int]] = {}
        least: dict[int, float] = {}
        reach: dict[int, int] = {}
        # By links at which limbs part: the least for these, in two ways, and for one of them.
        parted: dict[int, tuple[float, float, float]] = {}
        ends: dict[int, tuple[int, int]] = {}  # of joints: where limbs part next, and how far on
        for j in reversed(joints):
            limbs = at.get(j + 1, ())
            reach[j] = self._plain[j] + max((reach[k] for k in limbs), default=0)
            end, length = j + 1, 0
            if len(limbs) == 1 and self._plain[limbs[0]]:
                end, length = ends[limbs[0]]
            elif limbs:
                parted[end] = self._parted(limbs, least, reach)
            length += self._plain[j]
            ends[j] = end, length
            alone = self.prices.of(1, length) if length else 0.0
            if end in parted:
                apart, along, one = parted[end]
                way = length * self.prices.row
                alone = max(min(apart + alone, along + way), one + way)
            least[j] = alone
            at.setdefault(self._joints[j].parent, []).append(j)
        return least, reach

    def _parted(
        self, limbs: Sequence[int], least: Mapping[int, float], reach: Mapping[int, int]
    ) -> tuple[float, float, float]:
        """The least for limbs that part at a link: all of them, and one of them.

        Returns:
            Of all where none goes on towards the base in its run or its lanes, and where one may;
            the less of both for that if nothing is known of some.
        """
        chains = sorted((reach[k] for k in limbs if self._plain[k]), reverse=True)
        apart, along = self._chains(self._few(chains))
        if not all(self._plain[k] for k in limbs):
            along = min(apart, along)
        return apart, along, max(least[k] for k in limbs)

    @staticmethod
    def _few(chains: list[int]) -> tuple[int, ...]:
        """The longest chains: so many that all that may be left of them can be looked at."""
        found: list[int] = []
        for length in chains:
            counts = Counter([*found, length])
            if prod(comb(each + count, count) for each, count in counts.items()) > _LEFT:
                break
            found.append(length)
        return tuple(found)

    def _chains(self, left: tuple[int, ...]) -> tuple[float, float]:
        """The least for what is left of chains, the longest first; by all ways to divide them.

        Returns:
            Where none of them goes on towards the base in its run or its lanes, and where one may.
        """
        if left not in self._divided:
            apart = along = inf
            first, others = left[0], left[1:]
            for rows in range(1, first + 1):
                fit = [length for length in others if length >= rows]
                for beside in range(min(len(fit), _MOST - 1) + 1):
                    price = self.prices.of(1 + beside, rows)
                    for chosen in set(combinations(fit, beside)):
                        after = [n - rows for n in (first, *chosen) if n > rows]
                        rest = list(others)
                        for length in chosen:
                            rest.remove(length)
                        none, one = self._chains(tuple(sorted(rest + after, reverse=True)))
                        if beside:
                            apart, along = min(apart, price + none), min(along, price + one)
                        else:
                            along = min(along, price + min(none, one))
            self._divided[left] = apart, along
        return self._divided[left]
