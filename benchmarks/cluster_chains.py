"""Long chains on the many processes of a cluster: predicted times.

The search for schedules weighs ways to meet against each other on one machine. Here chains are cut
for exchanges pair by pair alone, the way that long chains take, in SIMD parts or not, with every
message at the price of the levels that it passes.
"""

from __future__ import annotations

from dataclasses import dataclass

from adagen.cost import Timeline, timeline
from adagen.emit.shapes import priced_program
from adagen.model import Model
from adagen.plan import make_plan
from adagen.plan.cuts import cuttable_joints
from adagen.program import Program
from adagen.program.strips import LANES
from adagen.schedule import CostProfile, Schedule, Topology
from adagen.schedule.fat_tree import Links
from adagen.search import best_schedule
from adagen.search.chain_exchange import ChainExchange
from benchmarks.critical_path import Limits, limits


@dataclass(frozen=True)
class Beyond:
    """A chain on some processes of a cluster.

    Attributes:
        processes: how many.
        time: predicted microseconds.
        limits: what they consist of.
    """

    processes: int
    time: float
    limits: Limits


class Chain:
    """A serial chain whose evaluations are predicted.

    Args:
        model: the chain.
        profile: a profile with the costs of steps.
    """

    def __init__(self, model: Model, profile: CostProfile) -> None:
        self.model, self.profile = model, profile
        topology, cuttable = Topology.of(model), cuttable_joints(model)
        self._chains = [
            ChainExchange(topology, profile, cuttable, "work", parts)
            for parts in (0, LANES["double"])
        ]

    def alone(self) -> float:
        """Return what one process takes, microseconds."""
        return best_schedule(self.model, 1, self.profile, in_parts=True).makespan

    def on(self, processes: int, links: Links) -> Beyond | None:
        """Return how it goes on some processes; None where they are too many for its joints.

        Args:
            processes: at least 2.
            links: what messages cost between processes that share no memory.
        """
        found: list[tuple[float, Program, Timeline]] = []

        def play(schedule: Schedule) -> tuple[Program, Timeline]:
            program = priced_program(make_plan(self.model, schedule), "kernels", self.profile)
            line = timeline(program, self.profile, links)
            found.append((line.makespan, program, line))
            return program, line

        for chains in self._chains:
            chains.best(processes, processes, play)
        if not found:
            return None
        time, program, line = min(found, key=lambda each: each[0])
        return Beyond(processes, time, limits(program, line))
