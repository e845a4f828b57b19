"""Joints with passive forces, as processes compute them before all else."""

from __future__ import annotations

from dataclasses import replace

import pytest

from adagen.calibrate.robots import chain, robot, rubbing
from adagen.cost import timeline
from adagen.emit import program_of
from adagen.model import Model, Passive
from adagen.plan import Plan, make_plan
from adagen.plan.passive import loaded, tangents
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule

PROFILE = load_profile("default")


def with_passive(model: Model, **passive: Passive) -> Model:
    """Return a robot with passive forces of some joints, by their names."""
    joints = [replace(j, passive=passive.get(j.name, j.passive)) for j in model.joints]
    return replace(model, joints=tuple(joints))


def planned(model: Model, processes: int) -> Plan:
    """Return a plan in which each process has its part."""
    schedule = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    return make_plan(model, schedule)


def test_joints_with_friction_come_first() -> None:
    model = with_passive(
        robot("r", chain(6), ["revolute"]),
        j1=Passive(damping=0.1),
        j2=Passive(rotor_inertia=0.1),
        j3=Passive(friction=0.1),
        j4=Passive(stiffness=3.0),
        j5=Passive(friction=0.1, damping=0.2),
    )
    plan = planned(model, 1)
    (process,) = plan.processes
    assert loaded(plan, process) == [3, 5, 1, 4]
    assert tangents(plan, process) == 2


def test_each_process_takes_those_of_its_own_joints() -> None:
    plan = planned(rubbing(robot("r", chain(12), ["revolute"])), 2)
    for process in plan.processes:
        assert loaded(plan, process) == sorted((*process.owns, *process.shares, *process.spares))
    assert sum(tangents(plan, process) for process in plan.processes) >= 12


@pytest.mark.parametrize("shape", ["kernels", "unrolled"])
def test_tangents_are_taken_before_a_process_begins(shape: str) -> None:
    model = robot("r", chain(12), ["revolute"])
    plain, rough = (
        timeline(program_of(planned(each, 2), shape), PROFILE).calls
        for each in (model, rubbing(model))
    )
    price = PROFILE.measured["process.tangent"]
    plan = planned(rubbing(model), 2)
    for process, before, after in zip(plan.processes, plain, rough, strict=True):
        assert after.end - before.end == pytest.approx(price * tangents(plan, process))
