"""One process: the closed form and its order against a subset program; the literal rule."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given, settings

from adagen.paper.one_process import SingleProcess
from adagen.schedule import CostProfile, Topology, load_profile, validate
from adagen.schedule.chains import WHOLE, Chain, Chains
from adagen.schedule.profile import TICKS
from adagen.search import find_schedule
from benchmarks.paper.literal_rule import literal_rule
from tests.paper.brute import Brute
from tests.paper.test_search import profiles, topologies

PAPER = load_profile("paper")


def cost_of(brute: Brute, chain: frozenset[int], order: list[int]) -> Fraction:
    """Return the cost of an order of assembly: its last joint cuts the chain, and so on."""
    if not chain:
        return Fraction(0)
    assert sorted(order) == sorted(chain)
    last = order[-1]
    sides = brute.sides(chain, last)
    below = [cost_of(brute, side, [j for j in order if j in side]) for side in sides]
    return brute.cost(chain, last) + sum(below)


def all_chains(chains: Chains) -> list[Chain]:
    found, stack = {WHOLE}, [WHOLE]
    while stack:
        chain = stack.pop()
        for p in chains.positions(chain):
            for side in chains.split(chain, p):
                if side not in found and chains.positions(side):
                    found.add(side)
                    stack.append(side)
    return sorted(found)


@settings(max_examples=60)
@given(topologies(8), profiles())
def test_closed_form_and_order_of_every_partial_chain(
    topology: Topology, profile: CostProfile
) -> None:
    chains, brute = Chains(topology, profile), Brute(topology, profile)
    single = SingleProcess(chains)
    for chain in all_chains(chains):
        joints = frozenset(chains.original[p] for p in chains.positions(chain))
        assert chains.boundary(chain) == len(brute.boundary(joints))
        best = brute.one(joints)
        assert single.work(chain) == best * TICKS
        assert cost_of(brute, joints, single.order(chain)) == best
        rule = cost_of(brute, joints, literal_rule(chains, chain))
        assert rule >= best
        if chains.boundary(chain) <= 1:
            assert rule == best


def test_counterexample_to_the_literal_rule() -> None:
    """scheduling.md: the rule of III-D, read literally, costs 52.6 where 43.6 is possible."""
    topology = Topology.bare((0, 1, 2, 1, 2, 4, 3, 5, 5, 7, 7))
    chains, brute = Chains(topology, PAPER), Brute(topology, PAPER)
    joints = frozenset({6, 9})
    chain = next(
        c for c in all_chains(chains) if {chains.original[p] for p in chains.positions(c)} == joints
    )
    assert {chains.original[p] for p in chain.cuts} | {2} == {2, 10} == brute.boundary(joints)
    assert cost_of(brute, joints, literal_rule(chains, chain)) == Fraction("52.6")
    assert SingleProcess(chains).work(chain) == 43_600_000


def test_a_very_long_chain_needs_no_recursion() -> None:
    topology = Topology.serial(5000)
    schedule = find_schedule(topology, 1, profile=PAPER)
    validate(schedule, topology)
    assert schedule.makespan == round(13.4 + 4999 * 16, 6)
    assert schedule.root.joint == 0 and schedule.verdict == "optimal"
