"""The entry point of the stage: from a topology and a cost profile to a schedule."""

from __future__ import annotations

from adagen.errors import UsageError
from adagen.schedule.chains import WHOLE, Chains
from adagen.schedule.draft import Draft
from adagen.schedule.profile import TICKS, CostProfile
from adagen.schedule.single import SingleProcess
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Schedule, Split, Strategy, Tie, loads_of, makespan_of


def find_schedule(
    topology: Topology,
    processes: int,
    *,
    profile: CostProfile,
    tie: Tie = "work",
    strategy: Strategy = "exact",
    split: Split = "always",
) -> Schedule:
    """Return a schedule for a robot on P processes."""
    if processes != 1:
        raise UsageError("only one process is supported as yet")
    chains = Chains(topology, profile)
    single = SingleProcess(chains)
    draft = Draft(len(topology))
    draft.root = draft.contract(topology, single.order(WHOLE))
    draft.assign(draft.root, (0, processes))
    root = draft.finish(topology, profile)
    makespan = makespan_of(root)
    assert makespan == single.work(WHOLE) / TICKS
    return Schedule(
        root=root,
        processes=processes,
        makespan=makespan,
        verdict="optimal",
        gap=0.0,
        lower_bound=makespan,
        profile=profile.name,
        tie=tie,
        tie_proven=True,
        strategy=strategy,
        split=split,
        expanded=0,
        loads=loads_of(root, processes),
    )
