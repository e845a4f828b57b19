"""Families of candidates, compared at the price that is played, and what is proven of the best.

* ``alone``: one process does everything.
* ``gathered``: processes gather at a core (layouts.py), searched by branch and bound.
* ``joined``: processes are joined at cuts: what the search by steps finds (adagen/schedule) at its
  own prices, and at those that are played (joined.py).

The bound is the least of what each family can do.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from adagen.emit.predicted import predict
from adagen.model import Model
from adagen.plan import make_plan
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.fold import Fold
from adagen.search.bounds import Bounds
from adagen.search.floors import Floors
from adagen.search.gathered import GatheredSearch, Spent
from adagen.search.joined import LONG, JoinedFloor
from adagen.search.layouts import Layout, LayoutPrices
from adagen.search.limbs import Robot
from adagen.search.price import Pricing, played
from adagen.search.trees import schedule_of

_USUAL = 128  # joints up to which a robot gets all expansions
_PLAYED = 32  # the same where chains are priced as they are played
_FEWEST = 64  # expansions that any robot gets
_JOINTS = 20
"""Joints that may be priced in shares of processes for each expansion."""

_ROUNDED = 1e-5  # microseconds that sums of rounded times may be off


def scaled(expansions: int, joints: int) -> int:
    """Return how many expansions a robot gets, each of which costs as much as it has joints."""
    return min(expansions, max(_FEWEST, expansions * _USUAL // joints))


class Families:
    """The best candidate so far, of all families that were looked at.

    Args:
        model: the robot.
        seen: the robot as cuts see it.
        processes: P.
        profile: a profile with the costs of steps.
        expansions: what each search may spend, for a robot of some tens of joints.
    """

    def __init__(
        self, model: Model, seen: Fold, processes: int, profile: CostProfile, expansions: int
    ) -> None:
        assert profile.steps is not None  # as the caller has made sure
        self.model, self.seen, self.processes = model, seen, processes
        self.profile, self.costs = profile, profile.steps
        self.most, self.expansions = expansions, scaled(expansions, len(model.joints))
        self.topology = Topology.of(model)
        self.best: Schedule | None = None
        self.least = float("inf")
        self.names: list[str] = []
        self.candidates = self.expanded = 0
        self.bounds: list[float] = []
        self.fastest: dict[str, Schedule] = {}  # of each family, with its time as loops
        self._priced: Pricing | None = None

    def consider(self, schedule: Schedule, family: str) -> None:
        """Play a schedule of a family, and keep it if none was as fast."""
        self._name(family)
        self.candidates += 1
        self.expanded += schedule.expanded
        time = played(self.model, schedule, self.profile)
        self._keep(family, schedule, time)

    def _keep(self, family: str, schedule: Schedule, time: float) -> None:
        """Keep the fastest of a family, and of all."""
        known = self.fastest.get(family)
        if known is None or time < known.makespan:
            self.fastest[family] = replace(schedule, makespan=time)
        if time < self.least:
            self.best, self.least = schedule, time

    def _name(self, family: str) -> None:
        if family not in self.names:
            self.names.append(family)

    def gather(self, cuttable: Sequence[bool], pattern: Schedule) -> None:
        """Search the layouts whose processes gather.

        Args:
            cuttable: for each joint whether mobilities may meet there without losing digits. Only a
                root with the ground beyond it shows a mobility; elsewhere inertias are added.
            pattern: a schedule whose facts (tie, split and so on) are taken over.
        """
        pricing = self._pricing(pattern)
        robot = Robot(pricing.joints)
        floors = Floors(robot, self.costs)
        bounds = Bounds(robot, floors, self.processes, self.costs, pricing.channel)
        floating = [robot.trees[robot.tree_of[j]].base is not None for j in range(len(cuttable))]
        roots = [False, *(f or c for f, c in zip(floating, cuttable, strict=True))]

        def tree(layout: Layout) -> Schedule | None:
            return schedule_of(layout, robot, self.topology, pattern, self.profile)

        search = GatheredSearch(
            LayoutPrices(robot, pricing),
            bounds,
            roots,
            self.least,
            Spent(_JOINTS * self.most),
            lambda layout: tree(layout) is not None,
        )
        search.run()
        self._name("gathered")
        self.candidates += search.candidates
        self.expanded += search.spent.expanded
        self.bounds.append(search.lower)
        if search.layout is not None and (found := tree(search.layout)) is not None:
            self._keep("gathered", found, played(self.model, found, self.profile))

    def bound_joined(self, cuttable: Sequence[bool]) -> None:
        """Bound what processes can do that are joined, and look at what may be faster.

        Args:
            cuttable: for each joint of the folded robot whether processes may meet there.
        """
        assert self.best is not None  # one process comes first
        tie = self.best.tie
        floor = JoinedFloor(
            self.model, self.seen, self.processes, self.profile, self._pricing(self.best), cuttable
        )
        most = min(self.expansions, max(_FEWEST, self.most * _PLAYED // len(self.topology)))
        lower, spent, made = floor.lower(self.least, most, tie)
        self.expanded += spent
        self.bounds.append(lower)
        if lower < self.least:
            if len(self.topology) > LONG:
                made = floor.found(tie, self.expansions)
            if made is not None:
                self.consider(made, "joined")

    def _pricing(self, schedule: Schedule) -> Pricing:
        if self._priced is None:
            self._priced = Pricing(make_plan(self.model, schedule), self.profile)
        return self._priced

    def _exchange(self) -> float:
        """The least that processes take which exchange anything, in any shape; microseconds."""
        fastest = max(self.costs.speed(p) for p in range(self.processes))
        begin = min(self.costs["process.evaluation"], self.costs["unrolled.evaluation"]) / fastest
        return begin + self.costs.channel("auto").latency

    def taken(self) -> Schedule:
        """Return the candidate that is emitted the fastest, with what is known of it.

        Candidates are searched as loops, and bounds are of loops. The best one of each family is
        then priced in the shape in which it is emitted: straight lines may be faster.
        """
        assert self.best is not None  # one process can do everything
        lower = min([self.least, *self.bounds])
        if lower > self.least - _ROUNDED:
            lower = self.least
        emitted = {
            name: predict(make_plan(self.model, each), self.profile).makespan
            for name, each in self.fastest.items()
        }
        name = min(emitted, key=emitted.__getitem__)
        best, time = self.fastest[name], emitted[name]
        if name == "alone" and time <= self._exchange():
            best, lower = replace(best, makespan=time), time  # whatever the shape
        return replace(
            best,
            lower_bound=lower,
            expanded=self.expanded,
            families=tuple(self.names),
            candidates=self.candidates,
        )
