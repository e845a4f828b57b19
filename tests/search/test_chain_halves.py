"""Long serial chains whose two processes gather."""

from __future__ import annotations

from dataclasses import replace

import pytest

from adagen.calibrate.robots import rubbing
from adagen.model import Model
from adagen.plan import make_plan
from adagen.schedule import CostProfile, Schedule, Topology, load_profile
from adagen.schedule.tree import Gathered
from adagen.search import best_schedule, find_schedule
from adagen.search.chain_halves import ChainHalves
from adagen.search.price import played
from tests.models import binary, serial_chain
from tests.search.test_chain_exchange import player
from tests.slow import slow

PROFILE = load_profile("default")


def halved(model: Model, profile: CostProfile = PROFILE) -> ChainHalves:
    topology = Topology.of(model)
    alone = find_schedule(topology, 2, profile=profile, cuttable=[False] * len(topology))
    return ChainHalves(topology, profile, [True] * len(topology), alone)


def best(joints: int, *, told: bool, profile: CostProfile = PROFILE) -> tuple[Schedule, float]:
    model = serial_chain(joints)
    play = player(model, profile)
    found = halved(model, profile).best(told, play)
    assert found is not None and found.gathered is not None and found.gathered.told == told
    return found, play(found)[1].makespan


def moved(schedule: Schedule, by: int) -> Schedule:
    assert schedule.gathered is not None
    root = schedule.gathered.roots[0] + by
    owners = tuple(int(j >= root) for j in range(len(schedule.gathered.owners)))
    return replace(schedule, gathered=Gathered((root,), owners, schedule.gathered.told))


@pytest.mark.parametrize("told", [True, False])
@pytest.mark.parametrize("joints", [200, slow(700)])
def test_no_link_nearby_is_better(joints: int, told: bool) -> None:
    found, time = best(joints, told=told)
    for by in (-joints // 20, -8, 8, joints // 20):
        assert time <= played(serial_chain(joints), moved(found, by), PROFILE)


@pytest.mark.parametrize("joints", [60, 200, slow(900)])
def test_the_bound_holds(joints: int) -> None:
    assert halved(serial_chain(joints)).least(2) <= best(joints, told=True)[1]


@pytest.mark.parametrize("name", ["default", "xeon"])
def test_who_has_many_joints_is_told_of_them(name: str) -> None:
    profile = load_profile(name)
    times = {told: best(900, told=told, profile=profile)[1] for told in (True, False)}
    assert times[True] < times[False]
    assert best(60, told=True)[1] > best(60, told=False)[1]  # a message takes longer than joints


@pytest.mark.parametrize("rough", [slice(0, 100), slice(100, 200), slice(0, 200)])
def test_friction_is_in_the_bound_and_counts_for_the_cut(rough: slice) -> None:
    """Some joints have friction: those of one process, of the other, or all."""
    model = serial_chain(200)
    joints = list(model.joints)
    joints[rough] = rubbing(model).joints[rough]
    model = replace(model, joints=tuple(joints))
    halves, play = halved(model), player(model)
    found = halves.best(True, play)
    assert found is not None
    time = play(found)[1].makespan
    assert halves.least(2) <= time
    assert halves.least(2) > halved(serial_chain(200)).least(2)
    for by in (-10, -3, 3, 10):
        assert time <= play(moved(found, by))[1].makespan


def test_the_search_takes_it() -> None:
    model = serial_chain(700)
    found = best_schedule(model, 2, PROFILE)
    assert found.meeting == "gather" and found.gathered is not None and found.gathered.told
    assert found.makespan == pytest.approx(played(model, found, PROFILE))
    assert found.lower_bound <= found.makespan


def test_short_chains_and_trees_are_left_to_layouts() -> None:
    assert not halved(binary(6)).fits
    assert halved(serial_chain(200)).fits and not halved(serial_chain(20)).fits


def test_a_prescribed_joint_is_passed_as_its_motion_cannot_be_told() -> None:
    model = serial_chain(200)
    given = replace(model.joints[30], prescribed=True)
    model = replace(model, joints=(*model.joints[:30], given, *model.joints[31:]))
    topology = Topology.of(model)
    alone = find_schedule(topology, 2, profile=PROFILE, cuttable=[False] * 200)
    assert not ChainHalves(topology, PROFILE, [True] * 200, alone).fits
    assert make_plan(model, best_schedule(model, 2, PROFILE)).processes[0].steps
