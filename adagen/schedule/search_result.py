"""The result of a search, and the schedule made from it."""

from __future__ import annotations

from dataclasses import dataclass

from adagen.schedule.profile import TICKS, CostProfile
from adagen.schedule.sweeps import loads_of, makespan_of
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Named, Schedule, Split, Strategy, Tie
from adagen.schedule.tree_draft import Draft


@dataclass(frozen=True)
class Found:
    """The result of a search; times in ticks.

    Attributes:
        draft: the best schedule tree found.
        lower: proven lower bound on the makespan.
        expanded: states or nodes expanded.
        tie_proven: whether the preference among equals is met for certain.
    """

    draft: Draft
    lower: int
    expanded: int
    tie_proven: bool = False

    def schedule(
        self,
        topology: Topology,
        processes: int,
        profile: CostProfile,
        tie: Tie,
        strategy: Strategy | Named = "exact",
        split: Split = "always",
    ) -> Schedule:
        """Return the schedule, priced.

        Args:
            topology: the robot.
            processes: P.
            profile: what to price its nodes with.
            tie: the preference among equals that was asked for.
            strategy: that found it.
            split: how ranges were divided.
        """
        root = self.draft.finish(topology, profile)
        makespan = makespan_of(root)
        return Schedule(
            root=root,
            processes=processes,
            makespan=makespan,
            lower_bound=min(self.lower / TICKS, makespan),
            profile=profile.name,
            tie=tie,
            tie_proven=self.tie_proven,
            strategy=strategy,
            split=split,
            expanded=self.expanded,
            loads=loads_of(root, processes),
        )
