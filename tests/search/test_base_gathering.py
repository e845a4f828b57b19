"""Schedules of processes that gather at the base: reproducible and certified programs."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest

from adagen.emit.shapes import predict
from adagen.errors import AdagenError
from adagen.model import LINK_ACCELERATION, Frame, Output
from adagen.plan import make_plan
from adagen.plan.certificate import certified
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.search.base_gathering import (
    alone_schedule,
    certified_layouts,
    certified_schedule,
    reproducible_schedule,
)
from tests.models import binary, human_figure, serial_chain
from tests.slow import slow

PROFILE = load_profile("xeon")


def test_limbs_are_shared_where_that_pays() -> None:
    model = binary(5, floating=True)
    alone = reproducible_schedule(model, 1, PROFILE)
    both = reproducible_schedule(model, 2, PROFILE)
    assert both.meeting == "gather"
    assert both.gathered is not None
    assert {p for p in both.gathered.owners if p is not None} == {0, 1}
    plan = make_plan(model, both, reproducible=True)
    assert predict(plan, PROFILE, "unrolled").makespan == both.makespan
    one = make_plan(model, alone, reproducible=True)
    assert both.makespan < 0.8 * predict(one, PROFILE, "unrolled").makespan


def test_a_chain_is_done_by_one_process() -> None:
    found = reproducible_schedule(serial_chain(12, axes="xyz"), 3, PROFILE)
    plan = make_plan(serial_chain(12, axes="xyz"), found, reproducible=True)
    assert [bool(process.owns) for process in plan.processes] == [True, False, False]


def test_nothing_slower_than_one_process_is_taken() -> None:
    model = human_figure()
    for processes in (2, 3, 4):
        found = reproducible_schedule(model, processes, PROFILE)
        alone = make_plan(model, reproducible_schedule(model, 1, PROFILE), reproducible=True)
        assert found.makespan <= predict(alone, PROFILE, "unrolled").makespan
        assert found.lower_bound <= found.makespan


def test_certified_limbs_are_shared_where_that_pays() -> None:
    model = binary(5, floating=True)
    both = certified_schedule(model, 2, PROFILE, "double", "auto")
    plan = certified(make_plan(model, both))
    assert predict(plan, PROFILE).makespan == both.makespan
    one = certified(make_plan(model, certified_schedule(model, 1, PROFILE, "double", "auto")))
    assert both.makespan < 0.8 * predict(one, PROFILE).makespan
    assert all(process.steps for process in plan.processes)


@pytest.mark.parametrize("name", ["figure", slow("binary")])
def test_certified_processes_take_no_less_than_without_bounds_of_errors(name: str) -> None:
    model = human_figure() if name == "figure" else binary(5, floating=True)
    plain = best_schedule(model, 2, PROFILE)
    found = certified_schedule(model, 2, PROFILE, "double", "auto", plain)
    assert found.lower_bound == pytest.approx(min(plain.lower_bound, found.makespan))
    joints = make_plan(model, found).joints
    layouts, _ = certified_layouts(model, joints, alone_schedule(model, 2, PROFILE))
    for gathered in layouts:
        schedule = replace(found, meeting="gather", gathered=gathered)
        with suppress(AdagenError):  # it is not certified
            plan = certified(make_plan(model, schedule))
            assert found.lower_bound <= predict(plan, PROFILE, "kernels").makespan


def test_what_cannot_be_certified_by_several_is_done_by_one() -> None:
    model = serial_chain(100)
    plan = certified(make_plan(model, certified_schedule(model, 2, PROFILE, "double", "auto")))
    assert [bool(process.owns) for process in plan.processes] == [True, False]


@pytest.mark.slow
def test_certified_processes_gather_elsewhere_where_that_pays() -> None:
    model = serial_chain(100)
    plain = best_schedule(model, 2, PROFILE)
    assert plain.gathered is not None
    found = certified_schedule(model, 2, PROFILE, "double", "auto", plain)
    assert plain.lower_bound <= found.lower_bound <= found.makespan
    plan = certified(make_plan(model, found))
    assert all(process.owns for process in plan.processes)
    alone = certified(make_plan(model, certified_schedule(model, 1, PROFILE, "double", "auto")))
    assert found.makespan < 0.85 * predict(alone, PROFILE).makespan


def test_outputs_are_given_by_one_process() -> None:
    """Limbs of the ground are shared where that pays, but not with outputs of a scene."""
    model = binary(5, floating=True)
    shared = make_plan(model, reproducible_schedule(model, 2, PROFILE), reproducible=True)
    assert all(process.steps for process in shared.processes)
    output = Output(LINK_ACCELERATION, 3, Frame("", np.eye(3), np.zeros(3)), "link")
    asked = replace(model, outputs=(output,))
    plan = make_plan(asked, reproducible_schedule(asked, 2, PROFILE), reproducible=True)
    assert [bool(process.steps) for process in plan.processes] == [True, False]
