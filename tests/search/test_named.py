"""Schedules with a name: what they are, that they are sound, and that none beats the search."""

from __future__ import annotations

from typing import Any, get_args

import pytest
from hypothesis import given, settings

from adagen.errors import InputError, UsageError
from adagen.schedule import (
    CostProfile,
    Schedule,
    Topology,
    load_profile,
    postorder,
    preorder,
    validate,
)
from adagen.schedule.tree import Named
from adagen.search import find_schedule, named_schedule
from tests.paper.test_search import profiles, topologies

PAPER = load_profile("paper")
NAMES: tuple[Named, ...] = get_args(Named)


def height(schedule: Schedule) -> int:
    found: dict[int, int] = {}
    for node in postorder(schedule.root):
        found[node.joint] = 1 + max((found[child.joint] for child in node.children), default=0)
    return found[schedule.root.joint]


@settings(max_examples=40)
@given(topologies(10), profiles())
def test_sound_and_never_better_than_the_search(topology: Topology, profile: CostProfile) -> None:
    for processes in (1, 2, 3, 4):
        # Named ranges are halves, rounded down where P is odd: one way among those searched.
        best = find_schedule(topology, processes, profile=profile)
        for name in NAMES:
            schedule = named_schedule(name, topology, processes, profile=profile)
            validate(schedule, topology)
            assert schedule.strategy == name and schedule.processes == processes
            assert schedule.lower_bound <= best.makespan <= schedule.makespan
            if schedule.verdict == "optimal":
                assert schedule.makespan == best.makespan
    one = find_schedule(topology, 1, profile=profile).makespan
    assert named_schedule("sequential", topology, 1, profile=profile).makespan == one
    assert named_schedule("middle-out", topology, 1, profile=profile).makespan == one


@pytest.mark.parametrize(("joints", "levels"), [(1, 1), (7, 3), (15, 4), (200, 8), (1000, 10)])
def test_balanced_is_as_flat_as_can_be(joints: int, levels: int) -> None:
    schedule = named_schedule("balanced", Topology.serial(joints), 4, profile=PAPER)
    assert height(schedule) == levels


def test_sequential_is_a_path_from_the_ground() -> None:
    schedule = named_schedule("sequential", Topology.serial(50), 2, profile=PAPER)
    assert [node.joint for node in preorder(schedule.root)] == list(range(50))
    assert {node.processes for node in preorder(schedule.root)} == {(0, 2)}
    assert schedule.makespan == find_schedule(Topology.serial(50), 1, profile=PAPER).makespan


@pytest.mark.parametrize("joints", [16, 32, 64])
def test_middle_out_is_the_best_for_a_chain_on_two_processes(joints: int) -> None:
    topology = Topology.serial(joints)
    best = find_schedule(topology, 2, profile=PAPER, tie="lex")
    schedule = named_schedule("middle-out", topology, 2, profile=PAPER)
    assert (schedule.root.joint, schedule.makespan) == (best.root.joint, best.makespan)
    inward = [node.joint for node in preorder(schedule.root) if node.processes == (0, 1)]
    assert inward == list(range(best.root.joint - 1, -1, -1))


def test_balanced_cuts_a_branched_robot_where_its_halves_are() -> None:
    """Joint 5 leads to the upper half, whatever the order in which the joints are numbered."""
    topology = Topology.bare((0, 1, 2, 3, 4, 0, 6, 6, 8, 9, 10))
    assert named_schedule("balanced", topology, 2, profile=PAPER).root.joint == 5


def test_a_deep_chain_needs_no_recursion() -> None:
    topology = Topology.serial(3000)
    for name in NAMES:
        validate(named_schedule(name, topology, 8, profile=PAPER), topology)


def test_arguments_are_checked() -> None:
    wrong: Any = "best"
    with pytest.raises(UsageError, match="expected balanced, sequential, middle-out"):
        named_schedule(wrong, Topology.serial(3), 2, profile=PAPER)
    with pytest.raises(UsageError, match="1 to 1024"):
        named_schedule("balanced", Topology.serial(3), 0, profile=PAPER)
    with pytest.raises(InputError, match="no movable joint"):
        named_schedule("balanced", Topology((), (), ()), 2, profile=PAPER)
