"""Serial chains on two processes that gather: their cut, and whether a passage is sent.

The search of layouts (layout_search.py) looks at one link after the other, and its budget ends long
before a chain of a thousand joints does. Here the link follows from what joints take, so that both
processes are done with their first sweep at once; that takes a few plays. The outer process passes
the other's joints, or is told how they move its own (adagen/plan/sent_passages.py).
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate

from adagen.cost import Timeline
from adagen.plan.sent_passages import PASSED
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.tree import Gathered
from adagen.search.chain_exchange import Play, first_sweep, passed_and_placed, passing, tangents

_PLAYS = 4


class ChainHalves:
    """Schedules of a serial chain on two of its processes.

    Args:
        topology: the robot.
        profile: a profile with the costs of steps.
        cuttable: for each joint whether mobilities may meet there.
        like: any schedule of the robot, whose tree stands for nothing.
    """

    def __init__(
        self, topology: Topology, profile: CostProfile, cuttable: Sequence[bool], like: Schedule
    ) -> None:
        self.costs, self.like = profile.measured, like
        self.latency = self.costs.window.latency
        self.count = len(topology)
        self.kinds = [topology.kind(j) for j in range(self.count)]
        self.roots = [j + 1 for j in range(self.count - 1) if cuttable[j]]
        rates = tangents(topology, self.costs)
        own = [self._first_sweep(kind) + rate for kind, rate in zip(self.kinds, rates, strict=True)]
        self.sums = [0.0, *accumulate(own)]
        kinds = {topology.priced_as(j) for j in range(self.count)}
        self.told = topology.is_chain and kinds <= PASSED

    @property
    def fits(self) -> bool:
        """Whether the robot is a chain with passages that take longer than a message.

        This family is defined by that: of fewer joints, each process passes all that it needs.
        """
        if not self.told:
            return False
        return sum(passing(self.costs, kind) for kind in self.kinds) > self.latency

    def least(self, processes: int) -> float:
        """Return a lower bound on the time of such schedules with a passage, microseconds.

        Each of the two is done no sooner than both are on average.

        Args:
            processes: P.
        """
        costs = self.costs
        whole = self.sums[-1] + sum(costs[f"accelerate.{kind}"] for kind in self.kinds)
        spared = max(0.0, self._first_sweep(self.kinds[0]) - costs["articulate.ground"])
        fastest = max(costs.speeds(processes))
        return (costs["process.evaluation"] + (whole - spared) / 2) / fastest

    def best(self, told: bool, play: Play) -> Schedule | None:
        """Return the fastest schedule found; None where there is nowhere to meet.

        Args:
            told: whether the outer process is told of the other's joints.
            play: plans and plays a schedule.
        """
        found: list[tuple[float, int, Schedule]] = []
        late = 0.0  # how much later than its joints explain the outer process is ready
        tried: set[int] = set()
        for turn in range(_PLAYS if self.roots else 0):
            root = self._meeting((self.sums[-1] + late) / 2)
            if root in tried:
                break
            tried.add(root)
            schedule = self._schedule(root, told)
            _, line = play(schedule)
            found.append((line.makespan, turn, schedule))
            inner, outer = _ready(line)  # the inner one goes outwards for longer: it is not to wait
            late = outer + self.latency - inner - (self.sums[-1] - 2 * self.sums[root])
        return min(found)[2] if found else None

    def _first_sweep(self, kind: str) -> float:
        return passed_and_placed(self.costs, kind) + first_sweep(self.costs, kind, outermost=True)

    def _meeting(self, inner: float) -> int:
        """The root up to which joints take so long, as near as there is one."""
        place = bisect_left(self.roots, bisect_left(self.sums, inner))
        return self.roots[min(place, len(self.roots) - 1)]

    def _schedule(self, root: int, told: bool) -> Schedule:
        owners = tuple(int(j >= root) for j in range(self.count))
        gathered = Gathered((root,), owners, told)
        return replace(self.like, meeting="gather", gathered=gathered)


def _ready(line: Timeline) -> tuple[float, float]:
    """Time at which each of the two has sent its articulated bodies, its last message."""
    first, second = (max(e.sent for e in line.exchanges if e.sender == p) for p in (0, 1))
    return first, second
