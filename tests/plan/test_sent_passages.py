"""Processes that receive the passage of the run of joints before their own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.errors import InputError
from adagen.model import Model
from adagen.model.kinds import REVOLUTE, SPHERICAL, JointKind
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.plan.steps import Arrive, Kinematics, Send, Traverse
from adagen.program import check
from adagen.program.lower import lower
from adagen.schedule import Schedule
from adagen.schedule.tree import Gathered
from tests.emit.test_messages import unguarded
from tests.emitted import kernels_of
from tests.models import random_tree, serial_chain
from tests.plan.test_gather import bent_arm_error, by_process, error


def two_halves(model: Model, root: int, *, told: bool = True) -> Schedule:
    """Return a schedule by which process 1 has all joints beyond a link of a chain."""
    owners = tuple(int(j >= root) for j in range(len(model.joints)))
    alone = replace(by_process(model, 1), processes=2)
    return replace(alone, meeting="gather", gathered=Gathered((root,), owners, told))


def motions(plan: Plan, process: int) -> list[type]:
    """Return the kinds of the steps up to the first joint that a process places."""
    kinds = [type(step) for step in plan.processes[process].steps]
    return kinds[: kinds.index(Kinematics)]


@pytest.mark.parametrize(
    ("joints", "root", "kind"), [(40, 21, REVOLUTE), (12, 3, REVOLUTE), (9, 4, SPHERICAL)]
)
def test_a_receiver_computes_no_joints_of_others(joints: int, root: int, kind: JointKind) -> None:
    model = serial_chain(joints, kind=kind)
    plan = make_plan(model, two_halves(model, root))
    for alternative in plan.alternatives:
        for shape in ("kernels", "unrolled"):
            check(lower(alternative, shape))
        assert error(model, alternative) < 1e-8
        assert unguarded(alternative) == []
    assert [process.reads for process in plan.processes] == [p.owns for p in plan.processes]
    assert [message.sweep for message in plan.messages].count("kinematics") == len(
        plan.alternatives
    )
    assert plan_from_json(plan_to_json(plan)) == plan


def test_the_one_at_the_ground_tells_before_it_places_its_own_links() -> None:
    model = serial_chain(40)
    plan = make_plan(model, two_halves(model, 21))
    assert motions(plan, 0) == [Traverse, Send]
    assert motions(plan, 1)[0] is Traverse and motions(plan, 1)[-1] is Arrive
    text = kernels_of(plan)
    assert "starts_0 = traverse_in_strips<0, 20>" in text and "outward_traversed<0, 20>" in text
    assert "starts_21 = traverse_in_strips<21, 39>" in text and "pass_outward" not in text


@pytest.mark.parametrize("bend", [0.0, 1e-8, 1.0])
def test_a_straight_arm_is_computed_again_with_the_passage(bend: float) -> None:
    model = serial_chain(30, axes="xy")
    plan = make_plan(model, two_halves(model, 15))
    assert all(process.recovery for process in plan.processes)
    assert bent_arm_error(model, plan, bend) < 1e-8


def test_branching_joints_have_no_passage() -> None:
    model = random_tree(np.random.default_rng(3), 12, branching=0.9)
    owners = tuple(int(j > 5) for j in range(12))
    schedule = replace(
        two_halves(model, 6), gathered=Gathered((0,), tuple(None for _ in owners), told=True)
    )
    with pytest.raises(InputError, match='leave "told" out'):
        make_plan(model, schedule)
