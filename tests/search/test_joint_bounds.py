"""The least that a process takes for its limbs, beside what it is priced at."""

from __future__ import annotations

from itertools import chain, combinations

import pytest

from adagen.model import REVOLUTE, Model
from adagen.plan.constants import joints_of
from adagen.schedule import load_profile
from adagen.search.joint_bounds import JointBounds
from adagen.search.layouts import MeetingPlace
from adagen.search.limbs import Robot
from adagen.search.whole_limb_bounds import SweepBound
from tests.cost.costs import step_profile
from tests.models import Part, assemble, rod, some_rubbing, vector
from tests.search.test_layout_search import Case
from tests.slow import all_but, spread

PROFILES = {"default": load_profile("default"), "others": step_profile()}


def hand(fingers: tuple[int, ...], wrist: int = 2) -> Model:
    """Return two fingers on a palm that stands on the ground, and an arm with others at its end."""
    body, place = rod(0.5, vector(0.0, 0.0, 0.2)), vector(0.0, 0.0, 0.2)
    parts = [Part("palm", None, REVOLUTE, body, place)]
    lengths = {"a": wrist, "b": fingers[0], "c": fingers[-1]}
    names = dict.fromkeys(lengths, "palm")
    end = f"a{wrist - 1}"
    for k, length in enumerate(fingers):
        lengths[f"f{k}"], names[f"f{k}"] = length, end
    for name, length in lengths.items():
        above = names[name]
        for k in range(length):
            parts.append(Part(f"{name}{k}", above, REVOLUTE, body, place))
            above = f"{name}{k}"
    return assemble("hand", parts)


HANDS = {
    "fingers and thumbs": hand((3, 3, 1, 2)),
    "short ones": hand((1, 1, 1, 1, 1)),
    "with friction": some_rubbing(hand((2, 2, 1)), 1),
}


@pytest.mark.parametrize("profile", spread(PROFILES, 1))
@pytest.mark.parametrize("name", all_but(HANDS, "fingers and thumbs"))
def test_no_set_of_limbs_is_priced_below_its_floor(name: str, profile: str) -> None:
    """Pairs of limbs, and all limbs but one, of each core that has at least three."""
    case = Case(HANDS[name], 2, PROFILES[profile])
    joint_bounds, seen = case.bounds.joint_bounds, 0
    for core in case.all_cores():
        if len(core) != 1 or core[0].root == 0:
            continue
        place = MeetingPlace(core, case.robot.limbs(core))
        if len(place.limbs) < 3:
            continue
        numbers = range(len(place.limbs))
        sets = chain.from_iterable(combinations(numbers, n) for n in (2, len(numbers) - 1))
        for own in sets:
            piece = case.prices.piece(place, own, frozenset())
            if piece is None:
                continue
            works = (joint_bounds.work(place.limbs[k]) for k in own)
            bound = SweepBound(*map(sum, zip(*works, strict=True)))
            share = piece.share
            inwards = share.least_kinematics + share.inwards
            assert bound.inwards <= inwards + 1e-12
            assert bound.outwards <= share.outwards + 1e-12
            assert bound.both <= inwards + share.between + share.outwards + 1e-12
            seen += 1
    assert seen > 20


def test_limbs_pay_for_being_passed_together_and_the_more_the_shorter_they_are() -> None:
    steps = PROFILES["default"].steps
    assert steps is not None
    robot = Robot(joints_of(hand((5, 1, 1, 5))))
    whole, parted = JointBounds(robot, steps, whole=True), JointBounds(robot, steps)
    last = {name: j for j, name in enumerate(joint.name for joint in hand((5, 1, 1, 5)).joints)}
    more = {
        name: whole.of_row(last[name], 4).inwards - parted.of_row(last[name], 4).inwards
        for name in ("f00", "f10")
    }
    assert 0.0 < more["f00"] < more["f10"]
