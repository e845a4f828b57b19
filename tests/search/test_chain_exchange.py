"""Long serial chains whose processes exchange pair by pair."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np
import pytest

from adagen.cost import Timeline, timeline
from adagen.emit.shapes import priced_program
from adagen.errors import InputError
from adagen.model import Mimic, Model
from adagen.plan import make_plan
from adagen.program import Program
from adagen.schedule import (
    CostProfile,
    Schedule,
    Topology,
    load_profile,
    schedule_to_json,
    validate,
)
from adagen.schedule.tree import preorder
from adagen.search import best_schedule, schedule_from_json
from adagen.search.chain_exchange import ChainExchange, Play, numbers_of_processes
from adagen.search.price import played
from tests.models import binary, serial_chain, some_rubbing
from tests.plan.test_parts import hung
from tests.slow import slow

PROFILE = load_profile("default")


def player(model: Model, profile: CostProfile = PROFILE) -> Play:
    """Return what plays a schedule of a robot as loops."""

    def play(schedule: Schedule) -> tuple[Program, Timeline]:
        program = priced_program(make_plan(model, schedule), "kernels", profile)
        return program, timeline(program, profile)

    return play


def exchanged(joints: int, processes: int, cuttable: list[bool] | None = None) -> Schedule:
    model = serial_chain(joints)
    topology = Topology.of(model)
    chains = ChainExchange(topology, PROFILE, cuttable or [True] * joints, "work")

    play = player(model)
    found = chains.best(processes, processes, play)
    assert found is not None
    validate(found, topology)
    assert chains.least(processes, processes) <= play(found)[1].makespan
    return found


@pytest.mark.parametrize(("joints", "processes"), [(300, 2), (600, 4), slow(700, 8), slow(900, 16)])
def test_parts_are_as_long_as_each_other(joints: int, processes: int) -> None:
    """Moving a cut by a tenth of a part makes no schedule of a chain faster."""
    found = exchanged(joints, processes)
    plan = make_plan(serial_chain(joints), found)
    parts = [len(process.owns) for process in plan.processes]
    assert sum(parts) == joints and min(parts) > 0
    # Outer parts wait for the passages of inner ones, level by level: none is longer than these.
    # The outermost one is: it carries no wrenches through itself. Cuts are at whole joints, so that
    # parts of the same time differ by one. The last one of each group first puts the passage of all
    # of them together, for those beyond: the one behind it may be longer by what that takes.
    behind = [joint % found.fan == 0 for joint in range(1, processes - 1)]
    longer = zip(pairwise(parts[:-1]), behind, strict=True)
    assert all(outer <= inner + 1 + after for (inner, outer), after in list(longer)[1:])
    assert max(parts[2:-1], default=0) <= parts[0]  # it has all of its joints outwards, too
    assert processes == 2 or parts[-1] > parts[-2]
    ends = np.cumsum(parts)[:-1]
    best = played(serial_chain(joints), found, PROFILE)
    for k in (0, len(ends) - 1):
        for by in (-parts[k] // 10, parts[k] // 10):
            moved = [joint + by * (i == k) for i, joint in enumerate(ends.tolist())]
            allowed = [j in moved for j in range(joints)]
            other = played(serial_chain(joints), exchanged(joints, processes, allowed), PROFILE)
            assert best <= other


@pytest.mark.parametrize("allowed", [(10, 11, 12), (100, 101, 399), (1, 2, 300)])
def test_no_part_is_empty(allowed: tuple[int, ...]) -> None:
    """The joint of a cut is in neither part: two cuts have a joint between them."""
    model = serial_chain(400)
    cuttable = [j in allowed for j in range(400)]
    chains = ChainExchange(Topology.of(model), PROFILE, cuttable, "work")

    assert chains.best(4, 4, player(model)) is None


def test_only_joints_that_may_be_cut_are() -> None:
    allowed = [j % 7 == 3 for j in range(400)]
    found = exchanged(400, 4, allowed)
    cuts = [
        node.joint for node in preorder(found.root) if node.processes[1] - node.processes[0] > 1
    ]
    assert len(cuts) == 3 and all(allowed[j] for j in cuts)


@pytest.mark.slow
@pytest.mark.parametrize("processes", [4, slow(8)])
def test_long_chains_exchange_where_that_is_the_fastest(processes: int) -> None:
    model = serial_chain(900)
    found = best_schedule(model, processes, PROFILE)
    assert found.meeting == "exchange" and "exchanged" in found.families
    assert found.makespan == pytest.approx(played(model, found, PROFILE))
    assert found.lower_bound <= found.makespan


def numbers(model: Model, processes: int, parts: int = 0) -> list[int]:
    return numbers_of_processes(Topology.of(model), processes, parts)


def test_parts_have_two_joints_and_trees_are_not_asked_to_exchange() -> None:
    assert numbers(serial_chain(900), 16) == [16, 8, 4, 2]
    assert numbers(serial_chain(11), 8) == [4, 2]
    assert numbers(serial_chain(10), 4) == [2]
    assert numbers(serial_chain(4), 4) == []
    assert numbers(binary(6), 4) == []
    assert numbers(serial_chain(100), 8, parts=8) == [4, 2]
    assert numbers(serial_chain(6001), 4, parts=8) == [4]  # more joints take long to assess
    assert numbers(serial_chain(9000), 8, parts=8) == [8, 4]


def test_chains_with_a_slaved_joint_do_not_exchange_and_have_a_schedule() -> None:
    model = serial_chain(200)
    slaved = replace(model.joints[90], mimic=Mimic(20, 0.5, 0.1))
    model = replace(model, joints=(*model.joints[:90], slaved, *model.joints[91:]))
    found = best_schedule(model, 4, PROFILE)
    assert "exchanged" not in found.families
    assert list(make_plan(model, found).slaved) == [90]


@pytest.mark.parametrize(("joints", "processes"), [(5, 2), (8, 2), (11, 4), (17, 4), (23, 8)])
def test_the_bound_holds_for_short_chains(joints: int, processes: int) -> None:
    exchanged(joints, processes)


@pytest.mark.parametrize(
    ("base", "joints", "processes", "parts"),
    [
        *(("revolute", 6, 2, 0), ("revolute", 11, 4, 0), ("floating", 9, 2, 0)),
        *(("prismatic", 9, 2, 0), ("spherical", 8, 2, 0), ("revolute", 10, 3, 0)),
        *(("revolute", 50, 2, 8), ("floating", 51, 2, 8)),
        *(slow("revolute", 14, 4, 0), slow("revolute", 23, 8, 0), slow("revolute", 98, 4, 8)),
    ],
)
@pytest.mark.parametrize(
    ("name", "friction"), [("default", False), ("xeon", False), ("default", True)]
)
def test_no_cut_takes_less_than_the_bound(
    base: str, joints: int, processes: int, parts: int, name: str, friction: bool
) -> None:
    """All cuts, all ways to put passages together: the least is at least the bound."""
    model, profile = hung(base, joints, seed=3), load_profile(name)
    model = some_rubbing(model, 1) if friction else model
    topology, play = Topology.of(model), player(model, profile)
    chains = ChainExchange(topology, profile, [True] * joints, "work", parts)
    bounds = [chains.least(processes, processes)]
    chains.best(processes, processes, play)
    bounds.append(chains.least(processes, processes))
    # Two joints beside the one of the cut; of parts, three for each lane, that one among them.
    own = 3 * parts if parts else 2
    least = min(
        play(schedule)[1].makespan
        for cuts in combinations(range(own, joints - 1), processes - 1)
        if all(
            beyond - first >= own + (not parts and first > 0)
            for first, beyond in pairwise((0, *cuts, joints))
        )
        for schedule in ways(model, profile, cuts, parts)
    )
    assert bounds[0] <= bounds[1] <= least


def ways(model: Model, profile: CostProfile, cuts: Sequence[int], parts: int) -> Iterator[Schedule]:
    """Yield the schedules that cut a chain at some joints, for each way to tell passages."""
    allowed = [j in cuts for j in range(len(model.joints))]
    chains = ChainExchange(Topology.of(model), profile, allowed, "work", parts)
    found = chains.best(len(cuts) + 1, len(cuts) + 1, player(model, profile))
    assert found is not None
    for fan in (2, 4, 8)[: len(cuts).bit_length()]:
        yield replace(found, fan=fan)


@pytest.mark.parametrize("processes", [2, slow(8)])
def test_bounds_of_long_chains_in_parts_are_close(processes: int) -> None:
    """Nearly all that processes take beside their own joints is in the bound."""
    model, profile = serial_chain(1000), load_profile("xeon")
    chains = ChainExchange(Topology.of(model), profile, [True] * 1000, "work", 8)
    play = player(model, profile)
    found = chains.best(processes, processes, play)
    assert found is not None
    assert chains.least(processes, processes) > play(found)[1].makespan / 1.15


def test_processes_that_an_exchange_leaves_idle_are_in_its_file() -> None:
    model, processes = serial_chain(150), 8
    topology, found = Topology.of(model), best_schedule(model, processes, PROFILE)
    assert found.meeting == "exchange" and found.root.processes == (0, 4)
    validate(found, topology)
    text = schedule_to_json(found, topology)
    read = schedule_from_json(text, topology, PROFILE)
    validate(read, topology)
    assert read.processes == processes
    trees = ([(n.joint, n.processes) for n in preorder(s.root)] for s in (read, found))
    assert next(trees) == next(trees)
    assert played(model, read, PROFILE) == played(model, found, PROFILE)
    fewer = text.replace('"processes": 8', '"processes": 3', 1)
    assert fewer != text
    with pytest.raises(InputError, match="no fewer than those of the root"):
        schedule_from_json(fewer, topology, PROFILE)


@pytest.mark.parametrize(("forbidden", "full"), [(None, True), (48, False)])
def test_processes_in_parts_fill_their_rows(forbidden: int | None, full: bool) -> None:
    """All but the last have as many joints in each part; where that is not allowed, nearly."""
    joints = 120
    model = serial_chain(joints)
    cuttable = [j != forbidden for j in range(joints)]
    chains = ChainExchange(Topology.of(model), PROFILE, cuttable, "work", parts=8)
    found = chains.best(2, 2, player(model))
    assert found is not None
    owned = [len(process.owns) for process in make_plan(model, found).processes]
    assert sum(owned) == joints and min(owned) >= 3 * 8
    assert (set(chains.cuts) <= set(range(0, joints, 8))) == full
    assert owned[0] % 8 == 0 or not full
