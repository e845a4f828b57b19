"""What a scene saves, counted from plans."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from adagen.model import Model
from adagen.plan import make_plan
from adagen.plan.operations import operations
from adagen.plan.steps import Join
from adagen.plan.types import Plan
from adagen.scene import apply_scene, read_scene
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule, named_schedule
from adagen.urdf import read_robot
from tests.models import binary, serial_chain
from tests.scene.held import held
from tests.scene.texts import reduced

MODELS = Path(__file__).resolve().parents[2] / "generated_examples" / "models"
HELD = ("neck_", "_shoulder_", "_elbow", "_wrist_")


def plan_of(model: Model, processes: int, form: str = "segment") -> Plan:
    profile = load_profile("default")
    if form == "ada":
        profile = profile.joins_only()
    schedule = find_schedule(Topology.of(model), processes, profile=profile)
    return make_plan(model, schedule, form=form)


def steps(plan: Plan) -> list[Counter[str]]:
    return [Counter(type(step).__name__ for step in process.steps) for process in plan.processes]


@pytest.mark.parametrize("form", ["segment", "ada"])
@pytest.mark.parametrize("processes", [1, 2])
def test_locked_arms_cost_what_no_arm_joints_cost(
    form: str, processes: int, tmp_path: Path
) -> None:
    """A humanoid with locked arms and neck has the steps of one whose arms are rigid."""
    lines = (MODELS / "humanoid.urdf").read_text().split("\n")
    rigid = [
        line.replace('type="revolute"', 'type="fixed"') if any(h in line for h in HELD) else line
        for line in lines
    ]
    (tmp_path / "rigid.urdf").write_text("\n".join(rigid))
    whole = read_robot(MODELS / "humanoid.urdf", floating=True).model
    without = read_robot(tmp_path / "rigid.urdf", floating=True).model
    small = apply_scene(whole, read_scene(MODELS / "humanoid_legs.toml")).model
    assert len(without.joints) == len(small.joints) == 16
    locked, never, full = (plan_of(m, processes, form) for m in (small, without, whole))
    assert steps(locked) == steps(never)
    assert operations(locked) == operations(never) < 0.65 * operations(full)


def test_a_left_out_limb_costs_nothing(tmp_path: Path) -> None:
    model = binary(3)
    small = reduced(model, tmp_path, 'accelerations = ["blll"]\n').model
    assert len(small.joints) * 2 == len(model.joints)
    whole = operations(plan_of(model, 1))
    every = replace(small, wanted=())
    assert operations(plan_of(every, 1)) * 2 == whole
    assert operations(plan_of(small, 1)) * 2 < whole  # nor are accelerations of its other branches


def test_a_joint_of_prescribed_motion_is_not_solved_for() -> None:
    """It has no inertia to be divided by; a body of known motion takes nothing of its joint."""
    model = serial_chain(10)
    free = operations(plan_of(model, 1))
    assert operations(plan_of(held(model, [5]), 1)) < free
    assert operations(plan_of(held(model, range(1, 10)), 1)) < 0.95 * free


def test_operations_grow_with_the_chain_not_faster() -> None:
    counts = [operations(plan_of(serial_chain(n), 1)) for n in (10, 20, 30)]
    assert counts[2] - counts[1] == counts[1] - counts[0] > 0


def test_every_step_of_a_plan_is_counted() -> None:
    """Two processes and the paper's form need more arithmetic than the serial algorithm."""
    model = serial_chain(60)
    topology, profile = Topology.of(model), load_profile("default")
    halves = make_plan(model, named_schedule("balanced", topology, 2, profile=profile))
    one, two = operations(plan_of(model, 1)), operations(halves)
    paper = plan_of(model, 1, "ada")
    assert one < two < operations(paper)
    assert any(isinstance(step, Join) for step in paper.processes[0].steps)
