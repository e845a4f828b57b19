"""The least for limbs that one process has as a whole, beside the prices of processes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, combinations, product
from typing import get_args

import numpy as np
import pytest

from adagen.model import Model
from adagen.paper.restricted import joined_between_processes
from adagen.plan.clusters import fold_of
from adagen.plan.constants import joints_of
from adagen.schedule import CostProfile, Topology, load_profile
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.profile import TICKS
from adagen.schedule.tree import Named
from adagen.search.hub_bound import Hubs
from adagen.search.joined import JoinedBound
from adagen.search.layouts import MeetingPlace
from adagen.search.limbs import Robot
from adagen.search.named import named_schedule
from adagen.search.price import played
from adagen.search.whole_limb_bounds import WholeLimbBounds
from tests.cost.costs import step_profile
from tests.models import random_tree, some_rubbing
from tests.search.test_joint_bounds import hand
from tests.search.test_layout_search import Case
from tests.search.test_meeting_places import with_hands
from tests.slow import spread

PROFILES = {"default": load_profile("default"), "others": step_profile()}
HANDS = {
    "alike": hand((3, 3, 3, 3), wrist=3),
    "unequal": hand((4, 4, 4, 1, 1)),
    "thumb": hand((3, 3, 3, 2, 1)),
    "pairs": hand((4, 4, 2)),
    "with friction": some_rubbing(hand((3, 2, 2)), 1),
    **{f"tree {k}": random_tree(np.random.default_rng(k), 9, branching=0.6) for k in range(3)},
}


@pytest.mark.parametrize("profile", spread(PROFILES, 1))
@pytest.mark.parametrize("name", spread(HANDS, 3))
def test_a_process_takes_no_less_than_each_of_its_limbs(name: str, profile: str) -> None:
    """Every limb of each core of one link, alone and beside others: up to three, or all."""
    case, seen = Case(HANDS[name], 2, PROFILES[profile]), 0
    for core in case.all_cores():
        if len(core) != 1 or core[0].joints:
            continue
        place = MeetingPlace(core, case.robot.limbs(core))
        numbers = range(len(place.limbs))
        sets = chain.from_iterable(combinations(numbers, n) for n in {1, 2, 3, len(numbers)})
        for own in sets:
            piece = case.prices.piece(place, own, frozenset())
            if piece is None:
                continue
            share = piece.share
            inwards = share.kinematics + share.inwards
            for k in own:
                if place.limbs[k].tree == core[0].tree:
                    bound = case.bounds.joint_bounds.longest(place.limbs[k])
                    assert bound.inwards <= inwards + 1e-12
                    assert bound.outwards <= share.outwards + 1e-12
                    assert bound.both <= inwards + share.between + share.outwards + 1e-12
                    seen += 1
    assert seen > 20


def joined_bound(model: Model, profile: CostProfile) -> JoinedBound:
    """Return the bound of joined schedules, whose chains may be cut anywhere."""
    case, seen = Case(model, 2, profile), fold_of(model, "segment")
    everywhere = [True] * len(model.joints)
    return JoinedBound(model, seen, 2, profile, case.prices.pricing, everywhere)


def parts(bound: JoinedBound, whole: Chain, cuts: int) -> Iterator[Chain]:
    """Yield a chain and what is left of it after so many cuts at most."""
    yield whole
    chains = bound.costs.chains
    for position in chains.positions(whole) if cuts else ():
        for part in chains.split(whole, position):
            if chains.positions(part):
                yield from parts(bound, part, cuts - 1)


@pytest.mark.parametrize("profile", spread(PROFILES, 1))
@pytest.mark.parametrize("name", spread(HANDS, 2))
def test_no_chain_is_assembled_sooner_than_its_rows_are_passed(name: str, profile: str) -> None:
    bound = joined_bound(HANDS[name], PROFILES[profile])
    found = set(parts(bound, WHOLE, 2))
    for each in found:
        positions = bound.costs.chains.positions(each)
        inwards, _ = bound._segment(positions)
        assert bound._whole_limbs(positions) <= inwards + 1
    assert len(found) > 20


def test_fingers_of_unequal_length_take_more_than_those_that_fill_rows() -> None:
    costs = PROFILES["default"].measured
    both = {}
    for fingers in ((2, 2, 2, 2), (5, 1, 1, 1)):
        robot = Robot(joints_of(hand(fingers, wrist=1)))
        wrist = next(j for j, joint in enumerate(robot.joints) if joint.name == "a0")
        both[fingers] = WholeLimbBounds(robot, costs).beyond(range(len(robot.joints)))[wrist].both
    assert both[2, 2, 2, 2] < both[5, 1, 1, 1]


def test_a_hand_is_divided_in_the_way_that_takes_least() -> None:
    """Two fingers of two joints: a group of two rows, or two runs, one of which has the wrist."""
    costs = PROFILES["default"].measured
    robot = Robot(joints_of(hand((2, 2), wrist=1)))
    own = {joint.name: j for j, joint in enumerate(robot.joints)}
    start, once = costs["link.start"], costs["kinematics.run"]
    each = costs["articulate.run"], costs["articulate.revolute"]
    columns = costs["articulate_columns.run"], costs["articulate_columns.revolute"]
    pose, two = costs["kinematics.revolute"], costs["limbs.two"]

    def run(length: int) -> float:
        sweep = min(first + length * row for first, row in (each, columns))
        return once + sweep + length * (pose + start)

    row = costs["kinematics_two.revolute"] + costs["articulate_two.revolute"] + 2 * start
    wrist = min(pose + min(each[1], columns[1]), row - 2 * start) + start
    apart = two + 2 * row + min(run(1), two + row - start)
    found = WholeLimbBounds(robot, costs).beyond(range(len(robot.joints)))[own["a0"]].inwards
    assert found == pytest.approx(min(apart, 2 * run(2) + wrist))


TWO_HANDS = with_hands(2, 3, 2, floating=True), with_hands(2, 4, 1, floating=True)
HUBS = {
    **HANDS,
    **{f"two hands {k}": model for k, model in enumerate(TWO_HANDS)},
    "two hands with friction": some_rubbing(TWO_HANDS[1], 2),
}


@pytest.mark.parametrize("profile", spread(PROFILES, 1))
@pytest.mark.parametrize("name", spread(HUBS, 4))
def test_no_joined_schedule_takes_less_than_its_hubs_let_it(name: str, profile: str) -> None:
    """Schedules by name, as played in loops."""
    model, costs = HUBS[name], PROFILES[profile]
    bound = joined_bound(model, costs)
    hubs = Hubs(bound.costs, bound._rows, max(bound.speeds))
    topology, seen = Topology.of(model), 0
    for processes, each in product((2, 3, 4), get_args(Named)):
        found = named_schedule(each, topology, processes, profile=costs)
        if joined_between_processes(found.root):
            assert hubs.least(processes) <= played(model, found, costs) * TICKS + 1
            seen += 1
    assert seen
    assert hubs.least(2) > 0 or "hand" not in name
