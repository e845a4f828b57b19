"""Schedules whose processes gather, as they are tried one after the other."""

from __future__ import annotations

import pytest

from adagen.model import Model
from adagen.plan import make_plan
from adagen.plan.cuts import cuttable_joints
from adagen.predict import predict
from adagen.predict.limbs import PATIENCE, limb_schedules
from adagen.schedule import Schedule, Topology, find_schedule, load_profile
from tests.models import binary, human_figure, star

PROFILE = load_profile("default")
ROBOTS = {
    "figure": human_figure(),
    "tree": binary(4, floating=True),
    "star": star(6, 5, floating=True),
}


def tried(model: Model, processes: int) -> list[Schedule]:
    pattern = find_schedule(Topology.of(model), processes, profile=PROFILE)
    cuttable = cuttable_joints(model, "double")
    return list(limb_schedules(model, processes, PROFILE, pattern, cuttable))


@pytest.mark.parametrize("robot", ROBOTS)
def test_more_processes_are_not_slower(robot: str) -> None:
    model = ROBOTS[robot]
    times = [min(each.makespan for each in tried(model, p)) for p in (2, 3, 4, 8)]
    assert times[2] <= times[0]
    assert times[3] <= times[2]
    assert times[1] <= times[0]


@pytest.mark.parametrize("robot", ROBOTS)
def test_all_are_timed_as_predicted_and_gone_on_with_while_faster_ones_turn_up(robot: str) -> None:
    model = ROBOTS[robot]
    schedules = tried(model, 2)
    for each in schedules[:3]:
        assert each.makespan == predict(make_plan(model, each), PROFILE).makespan
    times = [each.makespan for each in schedules]
    assert len(times) <= times.index(min(times)) + 1 + PATIENCE
