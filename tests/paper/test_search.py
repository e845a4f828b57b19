"""Every strategy against enumeration and subset dynamic programs."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen import paper
from adagen.errors import InputError, UsageError
from adagen.schedule import CostProfile, Topology, levels, load_profile, validate
from adagen.schedule.tree import Split, Strategy, Tie, preorder
from adagen.search import find_schedule
from tests.paper.brute import Brute

PAPER = load_profile("paper")
EXACT: tuple[Strategy, ...] = ("exact", "astar")
ALL: tuple[Strategy, ...] = ("exact", "astar", "paper")
TIES: tuple[Tie, ...] = ("work", "lex")
RUNS: tuple[tuple[Strategy, bool], ...] = (("paper", False), ("paper", True), ("astar", True))


@st.composite
def topologies(draw: st.DrawFn, most: int) -> Topology:
    n = draw(st.integers(1, most))
    parents = tuple(draw(st.integers(0, j)) for j in range(n))
    return Topology.bare(parents, tuple(draw(st.sampled_from([1, 3, 6])) for _ in range(n)))


@st.composite
def profiles(draw: st.DrawFn) -> CostProfile:
    if draw(st.booleans()):
        return PAPER
    tenths = st.integers(0, 30).map(lambda x: x / 10)
    gamma = draw(st.integers(-10, 10)) / 10
    return CostProfile("random", draw(tenths), draw(tenths), gamma, 6.5 + draw(tenths))


def ticks(value: Fraction) -> float:
    return float(value)


@settings(max_examples=30)
@given(topologies(6), profiles(), st.sampled_from([1, 2, 4, 8]))
def test_every_strategy_against_all_schedule_trees(
    topology: Topology, profile: CostProfile, p: int
) -> None:
    trees = Brute(topology, profile).enumerate(p)
    best = min(time for time, _, _ in trees)
    work = min(w for time, w, _ in trees if time == best)
    first = min(s for time, _, s in trees if time == best)
    for strategy in EXACT:
        s = find_schedule(topology, p, profile=profile, strategy=strategy, tie="work")
        validate(s, topology)
        assert (s.verdict, s.gap, s.makespan) == ("optimal", 0.0, ticks(best))
        total = round(sum(node.cost for node in preorder(s.root)), 6)
        assert s.tie_proven and total == ticks(work)
        s = find_schedule(topology, p, profile=profile, strategy=strategy, tie="lex")
        validate(s, topology)
        assert (s.verdict, s.makespan, s.tie_proven) == ("optimal", ticks(best), True)
        sequence = tuple(n.joint for n in levels(s.root) if n.processes[1] - n.processes[0] > 1)
        assert sequence == first
    for improved in (True, False):
        s = find_schedule(topology, p, profile=profile, strategy="paper", improved=improved)
        validate(s, topology)
        assert s.makespan >= ticks(best) >= s.lower_bound
        assert s.verdict == "gap" or s.makespan == ticks(best)


@settings(max_examples=30)
@given(topologies(9), profiles(), st.integers(1, 8), st.sampled_from(["always", "free", "any"]))
def test_exact_against_subset_program(
    topology: Topology, profile: CostProfile, p: int, split: Split
) -> None:
    brute = Brute(topology, profile)
    halving = p & (p - 1) == 0 and split != "any"
    best = brute.best(brute.whole, p, halving, split != "always")
    for tie in TIES:
        s = find_schedule(topology, p, profile=profile, tie=tie, split=split)
        validate(s, topology)
        assert (s.verdict, s.makespan) == ("optimal", ticks(best))
    if split == "always":
        s = find_schedule(topology, p, profile=profile, strategy="astar")
        assert (s.verdict, s.makespan) == ("optimal", ticks(best))


@settings(max_examples=40)
@given(topologies(9), profiles(), st.integers(2, 8), st.integers(0, 3))
def test_a_spent_budget_is_told_and_the_bound_holds(
    topology: Topology, profile: CostProfile, p: int, expansions: int
) -> None:
    brute = Brute(topology, profile)
    best = ticks(brute.best(brute.whole, p, p & (p - 1) == 0, False))
    for strategy in ALL:
        s = find_schedule(topology, p, profile=profile, strategy=strategy, expansions=expansions)
        validate(s, topology)
        assert s.lower_bound <= best <= s.makespan
        if s.verdict == "optimal":
            assert s.makespan == best
        else:
            assert s.gap == pytest.approx(s.makespan / s.lower_bound - 1) and s.gap > 0


@pytest.mark.parametrize("strategy", EXACT)
@pytest.mark.parametrize(
    ("joints", "two", "two_time", "four", "four_time"),
    [
        (16, 7, 141.4, [7, 3, 11], 94.8),
        (32, 15, 269.4, [15, 8, 22], 173.4),
        (64, 31, 525.4, [31, 17, 45], 317.4),
    ],
)
def test_table_1(
    strategy: Strategy, joints: int, two: int, two_time: float, four: list[int], four_time: float
) -> None:
    topology = Topology.serial(joints)
    s = find_schedule(topology, 2, profile=PAPER, tie="lex", strategy=strategy)
    assert (s.root.joint, s.makespan, s.verdict) == (two, two_time, "optimal")
    s = find_schedule(topology, 4, profile=PAPER, tie="lex", strategy=strategy)
    assert [n.joint for n in levels(s.root)][:3] == four
    assert (s.makespan, s.verdict) == (four_time, "optimal")


@pytest.mark.parametrize(("joints", "time"), [(32, 205.4), (64, 397.4)])
def test_three_processes(joints: int, time: float) -> None:
    s = find_schedule(Topology.serial(joints), 3, profile=PAPER)
    assert (s.makespan, s.verdict) == (time, "optimal")


@pytest.mark.parametrize(("joints", "p"), [(200, 8), (512, 16)])
def test_long_chains_are_proven(joints: int, p: int) -> None:
    topology = Topology.serial(joints)
    s = find_schedule(topology, p, profile=PAPER)
    validate(s, topology)
    assert s.verdict == "optimal" and s.expanded < 5000


def test_the_paper_estimate_can_miss_the_optimum() -> None:
    """Section III-B-3 claims an underestimate; this tree shows that it is none."""
    topology = Topology.bare((0, 0, 0, 0, 2, 1, 5, 5, 1, 9, 10, 8, 5, 12))
    paper = find_schedule(topology, 4, profile=PAPER, strategy="paper")
    exact = find_schedule(topology, 4, profile=PAPER)
    admissible = find_schedule(topology, 4, profile=PAPER, strategy="astar")
    assert (exact.verdict, exact.makespan) == ("optimal", 99.2)
    assert (admissible.verdict, admissible.makespan) == ("optimal", 99.2)
    assert (paper.verdict, paper.makespan) == ("gap", 103.8)
    assert paper.lower_bound <= 99.2


def test_improved_next_nodes_expands_less() -> None:
    topology = Topology.serial(8)
    counts = [
        find_schedule(topology, 4, profile=PAPER, strategy=strategy, improved=improved).expanded
        for strategy, improved in RUNS
    ]
    assert counts == sorted(counts, reverse=True) and counts[0] > counts[1] > counts[2]


def test_more_processes_than_useful_stay_idle() -> None:
    topology = Topology.bare((0, 1, 1))
    for p in (5, 8, 1024):
        s = find_schedule(topology, p, profile=PAPER)
        validate(s, topology)
        assert s.verdict == "optimal" and len(s.loads) == p


def test_isomorphic_branches_are_searched_once() -> None:
    parents = tuple(0 if j % 6 == 0 else j for j in range(36))
    s = find_schedule(Topology.bare(parents), 4, profile=PAPER)
    assert s.verdict == "optimal" and s.expanded < 1000


@pytest.mark.slow
def test_a_star_of_limbs_is_proven_at_once() -> None:
    """Where limbs meet, halving gives away three of them at most on eight processes."""
    parents = tuple(0 if j % 25 == 0 else j for j in range(200))
    topology = Topology.bare(parents)
    s = find_schedule(topology, 8, profile=PAPER, expansions=100)
    validate(s, topology)
    assert (s.verdict, s.makespan) == ("optimal", 2279.2)
    uneven = find_schedule(topology, 8, profile=PAPER, expansions=100, split="any")
    validate(uneven, topology)
    assert uneven.makespan == 743.2


def test_boundaries_with_many_branches_are_given_up_honestly() -> None:
    """A broad random tree whose cuts have more branch links than the exact merge is meant for."""
    parents = [0, *((j * 7919 + 13) % (j + 1) for j in range(1, 120))]
    s = find_schedule(Topology.bare(tuple(parents)), 8, profile=PAPER, expansions=300)
    validate(s, Topology.bare(tuple(parents)))
    assert s.lower_bound <= s.makespan


def test_arguments_are_checked() -> None:
    topology = Topology.serial(3)
    for wrong in (
        {"processes": 0},
        {"processes": 1025},
        {"tie": "any"},
        {"strategy": "file"},
        {"split": "free", "strategy": "astar"},
        {"split": "any", "strategy": "paper"},
        {"expansions": -1},
        {"time_budget": float("nan")},
    ):
        arguments: dict[str, Any] = {"processes": 2, "profile": PAPER, **wrong}
        with pytest.raises(UsageError):
            paper.find_schedule(topology, **arguments)
    with pytest.raises(InputError, match="no movable joint"):
        find_schedule(Topology((), (), ()), 2, profile=PAPER)
