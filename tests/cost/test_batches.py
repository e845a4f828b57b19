"""Batches are priced by registers of which each lane holds a state."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import pytest

from adagen.calibrate.robots import chain, hollow, robot, rubbing
from adagen.cost import state_time, timeline
from adagen.cost.batches import batch_features, states_at_once
from adagen.cost.straight import straight_stretches
from adagen.emit import program_of
from adagen.emit.shapes import chosen_shape
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.certificate import certified
from adagen.program import Program
from adagen.schedule import CostProfile, load_profile
from adagen.search import best_schedule
from tests.models import serial_chain

DEFAULT = load_profile("default")


def plan_of(model: Model, scalar: str = "double") -> Plan:
    return make_plan(model, best_schedule(model, 1, DEFAULT), scalar=scalar)


def priced(**prices: float) -> CostProfile:
    """The default profile with other prices of batches."""
    costs = DEFAULT.measured
    table = {**costs.table, **{f"batch.{name}": price for name, price in prices.items()}}
    return replace(DEFAULT, steps=replace(costs, table=table))


def test_a_straight_line_is_priced_by_operations_angles_and_numbers() -> None:
    plan = plan_of(serial_chain(6))
    program = program_of(plan, "unrolled", batch=True)
    ((part,),) = straight_stretches(program, inf)
    found = batch_features(program)
    assert found == {
        "batch.operation": part.features["unrolled.operation"],
        "batch.sine": 6,  # no angle is free where each is a register full
        "batch.number": 24,  # q, v, tau, qdd
    }
    assert timeline(program, DEFAULT).makespan == pytest.approx(DEFAULT.measured.total(found))


def test_loops_are_priced_by_their_joints() -> None:
    kinds = ["revolute", "revolute", "spherical"]
    program = program_of(plan_of(robot("r", chain(6), kinds)), "kernels", batch=True)
    assert batch_features(program) == {
        "batch.revolute": 4,
        "batch.spherical": 2,
        "batch.number": 4 * 4 + 2 * 13,  # a ball joint's q has four
    }


def test_loops_are_priced_by_certificates_and_own_axes() -> None:
    plan = plan_of(serial_chain(6))
    found = batch_features(program_of(certified(plan), "kernels", batch=True))
    assert found == {"batch.revolute": 6, "batch.weighed": 6, "batch.number": 24}
    light = hollow(robot("r", chain(7), ["revolute"]))
    found = batch_features(program_of(plan_of(light), "kernels", batch=True))
    assert found == {"batch.revolute": 7, "batch.turned": 7, "batch.number": 28}


@pytest.mark.parametrize("shape", ["kernels", "unrolled"])
def test_friction_is_priced_by_its_tangents(shape: str) -> None:
    model = robot("r", [0, 1, 2, 2], ["floating", "revolute", "spherical", "prismatic"])
    plain, rough = (
        batch_features(program_of(plan_of(each), shape, batch=True))
        for each in (model, rubbing(model))
    )
    assert rough.pop("batch.tangent") == 2  # of the hinge and of the slider
    if shape == "unrolled":
        assert rough.pop("batch.operation") > plain.pop("batch.operation")
    assert rough == plain


@pytest.mark.parametrize("shape", ["kernels", "unrolled"])
def test_operations_share_the_price_and_states_share_the_register(shape: str) -> None:
    program = program_of(plan_of(serial_chain(5)), shape, batch=True)
    line = timeline(program, DEFAULT)
    assert all(interval.end >= interval.start for interval in line.intervals)
    assert line.busy(0) == pytest.approx(line.makespan)
    assert state_time(program, DEFAULT) == pytest.approx(line.makespan / 8)
    narrow = program_of(plan_of(serial_chain(5), "float"), shape, batch=True)
    assert [states_at_once(each, 64) for each in (program, narrow)] == [8, 16]
    assert states_at_once(alone(program), 64) == 1


def alone(program: Program) -> Program:
    """The same for one state after the other."""
    return replace(program, batch=False)


def test_the_cheaper_shape_is_emitted() -> None:
    plan = plan_of(serial_chain(6))
    free = dict.fromkeys(("operation", "sine"), 0.0)
    assert chosen_shape(plan, batch=True, profile=priced(**free)) == "unrolled"
    assert chosen_shape(plan, batch=True, profile=priced(revolute=0.0)) == "kernels"
    assert chosen_shape(plan, batch=True, profile=DEFAULT) == "unrolled"
