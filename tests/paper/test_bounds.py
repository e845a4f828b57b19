"""Bounds against the optimum, on every kind of partial chain that a search comes by."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.paper.bounds import Rules
from adagen.paper.successors import Space
from adagen.schedule import CostProfile, Topology
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.profile import TICKS
from adagen.schedule.tree import Split
from tests.paper.brute import Brute
from tests.paper.test_search import profiles, topologies


@st.composite
def pairs_of_hubs(draw: st.DrawFn) -> Topology:
    """Two links where limbs meet, and joints between them."""
    parents: list[int] = []
    hub = 0
    for limbs in (draw(st.integers(2, 3)), 2):
        for _ in range(limbs):
            at = hub
            for _ in range(draw(st.integers(1, 2))):
                parents.append(at)
                at = len(parents)
        if hub == 0:
            for _ in range(draw(st.integers(1, 2))):
                parents.append(hub)
                hub = len(parents)
    return Topology.bare(tuple(parents))


def chains_of(space: Space) -> list[Chain]:
    """Return the whole robot and what one or two cuts leave of it, bare links left out."""
    found: dict[Chain, None] = {WHOLE: None}
    for _ in range(2):
        for chain in list(found):
            for p in space.chains.positions(chain):
                found.update(dict.fromkeys(space.chains.split(chain, p)))
    return [chain for chain in found if space.size(chain)]


@settings(max_examples=60)
@given(
    topologies(9) | pairs_of_hubs(),
    profiles(),
    st.sampled_from(["always", "free", "any"]),
    st.sampled_from([2, 3, 4, 4, 5, 8]),
)
def test_no_bound_exceeds_the_optimum(
    topology: Topology, profile: CostProfile, split: Split, processes: int
) -> None:
    space = Space(topology, profile, Rules.of(processes, split))
    brute = Brute(topology, profile)
    halving = space.rules.halving
    for chain in chains_of(space):
        joints = frozenset(space.chains.original[p] for p in space.chains.positions(chain))
        best = brute.best(joints, processes, halving, split != "always") * TICKS
        work = space.single.work(chain)
        assert space.bounds.meeting(chain, processes) <= best
        if chain != WHOLE:
            assert space.bounds.spread(work, processes) <= best
    assert (
        space.bounds.whole(processes)
        <= brute.best(brute.whole, processes, halving, split != "always") * TICKS
    )
