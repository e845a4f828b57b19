"""Schedules of form segment under measured costs: exact against enumeration, and as the plan."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import product
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.calibrate.schedules import random_schedule
from adagen.model.kinds import KINDS
from adagen.plan import make_plan
from adagen.schedule import CostProfile, Topology, load_profile, makespan_of, preorder, validate
from adagen.schedule.chains import WHOLE, Chain, Chains
from adagen.schedule.tree_draft import Draft
from adagen.search import find_schedule
from adagen.search.schedules import segment_bound
from tests.cost.costs import step_by_step, step_profile
from tests.models import human_figure, random_tree, serial_chain, star
from tests.scene.held import held

DEFAULT = load_profile("default")
PROFILE = step_profile((), process__evaluation=0.05, root__invert=0.08, join__revolute=0.15)


class Cut(NamedTuple):
    """Where a chain is cut, and for either side its processes and how it is cut in turn."""

    position: int
    on_root: tuple[int, int]
    on_end: tuple[int, int]
    root: Cut | None
    end: Cut | None


def ways(chains: Chains, chain: Chain, first: int, last: int) -> Iterator[Cut | None]:
    """Yield every way to cut a chain for processes first .. last - 1: positions with ranges."""
    yield None
    for position in chains.positions(chain):
        root, end = chains.split(chain, position)
        if not (chains.positions(root) and chains.positions(end)):
            continue
        for middle in range(first + 1, last):
            halves = (first, middle), (middle, last)
            for a, b in (halves, halves[::-1]):
                for x, y in product(ways(chains, root, *a), ways(chains, end, *b)):
                    yield Cut(position, a, b, x, y)


def build(draft: Draft, chains: Chains, chain: Chain, way: Cut | None, own: tuple[int, int]) -> int:
    if way is None:
        order = [chains.original[p] for p in reversed(chains.positions(chain))]
        for joint in order:
            draft.ranges[joint] = own
        return draft.contract(chains.topology, order)
    position, a, b, x, y = way
    joint = chains.original[position]
    root, end = chains.split(chain, position)
    draft.ranges[joint] = own
    draft.root_child[joint] = build(draft, chains, root, x, a)
    draft.end_child[joint] = build(draft, chains, end, y, b)
    return joint


def brute(topology: Topology, profile: CostProfile, processes: int) -> float:
    """Return the least makespan of all schedule trees with all assignments to processes."""
    chains = Chains(topology, profile)
    best = float("inf")
    for way in ways(chains, WHOLE, 0, processes):
        draft = Draft(len(topology))
        draft.root = build(draft, chains, WHOLE, way, (0, processes))
        best = min(best, makespan_of(draft.finish(topology, profile)))
    return best


COSTS = st.floats(0, 0.5).map(lambda x: round(x, 4))


@settings(max_examples=60)
@given(st.data())
def test_the_search_is_exact(data: st.DataObject) -> None:
    """Against every schedule tree, for random trees, costs, processes and speeds of cores."""
    joints = data.draw(st.integers(2, 7))
    parents = tuple(data.draw(st.integers(0, j)) for j in range(joints))
    kinds = tuple(data.draw(st.sampled_from(["revolute", "spherical"])) for _ in range(joints))
    if data.draw(st.booleans()):
        kinds = ("floating", *kinds[1:])
    prescribed = data.draw(st.sets(st.integers(0, joints - 1), max_size=2))
    topology = Topology(
        parents,
        tuple(KINDS[k].nv for k in kinds),
        tuple("abcdefg"[:joints]),
        kinds,
        frozenset(prescribed),
    )
    processes = data.draw(st.integers(1, 4 if joints < 6 else 3))
    speeds = st.lists(st.sampled_from([0.5, 1.0, 1.3]), max_size=4).map(tuple)
    dear = ["kinematics__revolute", "articulate__revolute", "join__revolute", "root__invert"]
    dear += ["articulate__prescribed", "join__prescribed"]
    changes = {name: data.draw(COSTS) for name in dear}
    profile = step_profile(data.draw(speeds), **changes)
    found = find_schedule(topology, processes, profile=profile)
    validate(found, topology)
    assert found.makespan == makespan_of(found.root)
    least = brute(topology, profile, processes)
    assert segment_bound(topology, profile, processes) <= found.makespan
    assert profile.steps is not None
    if processes > 2 and len({profile.steps.speed(p) for p in range(processes)}) > 1:
        assert found.lower_bound - 1e-9 <= least <= found.makespan + 1e-9  # not proven there
        return
    assert found.verdict == "optimal"
    assert found.makespan == pytest.approx(least, abs=1e-9)


MISSED = {
    **dict.fromkeys(("articulate__revolute", "join__revolute", "root__invert"), 0.0),
    **dict.fromkeys(("articulate__prescribed", "join__prescribed", "kinematics__step"), 0.0),
    "kinematics__revolute": 0.5,
    "kinematics__spherical": 0.032,
    "join__spherical": 0.038,
    "join__ground": 0.042,
    "join__coupling_a": 0.043,
    "join__block": 0.045,
    "disassemble__ground": 0.047,
    "disassemble__spherical": 0.049,
    "disassemble__coupling": 0.053,
    "articulate__spherical": 0.056,
    "articulate__ground": 0.06,
    "propagate__revolute": 0.064,
    "propagate__ground": 0.07,
    "propagate__spread": 0.072,
    "deliver__revolute": 0.073,
    "deliver__load": 0.08,
    "accelerate__revolute": 0.081,
    "accelerate__spherical": 0.083,
    "link__start": 0.143,
    "root__accelerate": 0.146,
    "process__evaluation": 0.157,
}
"""Costs by which the search misses the best schedule, all that matter there."""


def test_nothing_is_called_optimal_that_is_not_on_cores_of_unequal_speed() -> None:
    """The search misses the best schedule here, and says that it has not proven its own."""
    kinds = ("revolute", "spherical", "revolute", "revolute", "spherical", "revolute")
    dofs = tuple(KINDS[kind].nv for kind in kinds)
    topology = Topology((0, 0, 1, 2, 2, 5), dofs, tuple("abcdef"), kinds, frozenset())
    profile = step_profile((1.0, 1.3), **MISSED)
    found = find_schedule(topology, 3, profile=profile)
    least = brute(topology, profile, 3)
    assert found.lower_bound <= least <= found.makespan < 1.01 * least
    assert found.verdict == "gap" or found.makespan == pytest.approx(least, abs=1e-9)


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("processes", [2, 3, 5, 8])
@pytest.mark.parametrize("cores", [(), (0.5, 1.0, 1.0, 2.0)])
@pytest.mark.parametrize("prescribed", [(), (0, 3, 4)])
def test_the_plan_takes_what_the_tree_says(
    seed: int, processes: int, cores: tuple[float, ...], prescribed: tuple[int, ...]
) -> None:
    """The prices follow the plan: kinematics, reversed roots, couplings, messages, waiting."""
    model = random_tree(np.random.default_rng(seed), 10 + 2 * seed, floating=seed % 3 == 0)
    model = held(model, prescribed)
    profile = step_profile(cores)
    schedule = random_schedule(Topology.of(model), processes, profile, seed)
    line = step_by_step(make_plan(model, schedule), profile)
    assert line.makespan == pytest.approx(makespan_of(schedule.root), abs=1e-5)


def test_slow_cores_get_less_to_do() -> None:
    topology = Topology.serial(24)
    found = find_schedule(topology, 2, profile=step_profile((1.0, 0.4)))
    counts = Counter(node.processes[0] for node in preorder(found.root))
    assert counts[0] > 1.3 * counts[1] > 0
    alike = find_schedule(topology, 2, profile=step_profile())
    assert found.makespan > alike.makespan
    other_way = find_schedule(topology, 2, profile=step_profile((0.4, 1.0)))
    counts = Counter(node.processes[0] for node in preorder(other_way.root))
    assert counts[1] > 1.3 * counts[0] > 0


@pytest.mark.parametrize("processes", [1, 2, 4, 6, 8])
def test_the_plan_never_takes_less_than_is_proven(processes: int) -> None:
    for model in (human_figure(), serial_chain(20), star(6, 3), serial_chain(12, floating=True)):
        found = find_schedule(Topology.of(model), processes, profile=PROFILE, expansions=500)
        line = step_by_step(make_plan(model, found), PROFILE)
        assert line.makespan >= found.lower_bound - 1e-5
        assert line.makespan == pytest.approx(found.makespan, abs=1e-5)


def test_fewer_expansions_leave_a_gap_that_is_told() -> None:
    topology = Topology.serial(40)
    found = find_schedule(topology, 4, profile=PROFILE, expansions=3)
    best = find_schedule(topology, 4, profile=PROFILE)
    assert best.verdict == "optimal"
    assert found.verdict == "gap" and found.lower_bound <= best.makespan <= found.makespan
    assert found.gap == pytest.approx(found.makespan / found.lower_bound - 1)


def test_joints_that_must_not_be_cut_are_not() -> None:
    topology = Topology.serial(16)
    free = find_schedule(topology, 2, profile=PROFILE)
    allowed = [j != free.root.joint for j in range(16)]
    found = find_schedule(topology, 2, profile=PROFILE, cuttable=allowed)
    assert found.root.joint != free.root.joint and found.makespan >= free.makespan
    none = find_schedule(topology, 2, profile=PROFILE, cuttable=[False] * 16)
    assert {node.processes[0] for node in preorder(none.root)} == {0}


@pytest.mark.parametrize("expansions", [64, 1000])
def test_long_chains_are_shared_by_all_processes(expansions: int) -> None:
    """The outermost segment carries no mobility: one process passes more joints than those within.

    Few expansions find that, as guesses know of it.
    """
    model = serial_chain(1200)
    found = find_schedule(Topology.of(model), 8, profile=DEFAULT, expansions=expansions)
    validate(found, Topology.of(model))
    sizes = sorted(len(process.owns) for process in make_plan(model, found).processes)
    assert sizes[0] > 0 and sizes[-1] > 1.5 * sizes[-2]


def test_small_robots_leave_processes_idle() -> None:
    dear = step_profile((), join__revolute=3.0, disassemble__revolute=3.0)
    found = find_schedule(Topology.serial(6), 4, profile=dear)
    assert found.makespan == find_schedule(Topology.serial(6), 1, profile=dear).makespan


@pytest.mark.parametrize("choice", [{"strategy": "astar"}, {"strategy": "paper"}, {"split": "any"}])
def test_what_is_searched_by_joins_says_so(choice: dict[str, Any]) -> None:
    found = find_schedule(Topology.serial(12), 2, profile=PROFILE, **choice)
    assert found.profile == "Eq. (11) of the steps"
    joins = find_schedule(Topology.serial(12), 2, profile=PROFILE.joins_only(), **choice)
    assert found.makespan == joins.makespan and joins.profile == "steps"
