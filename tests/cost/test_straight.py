"""Straight lines of statements are priced by their operations, where they are what is emitted."""

from __future__ import annotations

from itertools import pairwise
from math import inf

import numpy as np
import pytest

from adagen.calibrate.robots import chain, robot, squared, star
from adagen.cost import programmed
from adagen.cost.straight import straight_stretches
from adagen.emit.shapes import chosen_shape, predict, priced_program
from adagen.executor import simulate
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.stages import stages
from adagen.schedule import Schedule, Topology, load_profile
from adagen.schedule.costs import NAMES
from adagen.schedule.profile import parse_profile, profile_text
from adagen.search import choose_processes, find_schedule, predicted_time
from tests.cost.costs import step_costs, step_profile
from tests.models import serial_chain

DEFAULT = load_profile("default")


def arm(joints: int = 6) -> Model:
    return squared(robot("arm", chain(joints), ["revolute"], 3))


def plan_of(model: Model, processes: int = 1, form: str = "segment") -> Plan:
    schedule = find_schedule(Topology.of(model), processes, profile=load_profile("paper"))
    return make_plan(model, schedule, form=form)


def test_squared_robots_have_proper_frames_and_bodies() -> None:
    for joint in arm(7).joints:
        assert np.allclose(joint.rotation @ joint.rotation.T, np.eye(3))
        assert np.linalg.det(joint.rotation) == pytest.approx(1)
        assert np.count_nonzero(joint.translation) == 1
    for link in arm(7).links[1:]:
        moments = np.diag(link.inertia.tensor)
        assert np.count_nonzero(link.inertia.tensor) == 3
        assert (moments > 0).all() and (moments.sum() - 2 * moments > 0).all()


@pytest.mark.parametrize("model", [arm(), squared(robot("hand", star(3, 2), ["revolute"], 1))])
def test_it_is_what_auto_emits(model: Model) -> None:
    plan = plan_of(model)
    assert chosen_shape(plan) == "unrolled"
    line, other = predict(plan, DEFAULT), predict(plan, DEFAULT, "kernels")
    assert priced_program(plan).shape == "unrolled"
    assert priced_program(plan, "kernels").shape == "kernels"
    assert line.makespan < other.makespan  # or auto would be wrong
    (only,) = simulate(plan)
    ((part,),) = straight_stretches(programmed(plan, "unrolled"), 2500.0)
    found = part.features
    assert found["unrolled.sine"] == 0  # no more than registers take beside other work
    assert found["unrolled.operation"] == only.operations.arithmetic - only.operations.fused
    costs = step_costs(unrolled__held=2500.0)
    expected = costs["unrolled.evaluation"] + part.time(costs)
    profile = step_profile((), unrolled__held=2500.0)
    assert predict(plan, profile, "unrolled").makespan == pytest.approx(expected)


@pytest.mark.parametrize(("joints", "held", "counted"), [(8, 0, 0), (9, 0, 9), (8, inf, 8)])
def test_sines_that_fill_two_registers_are_free_but_in_batches(
    joints: int, held: float, counted: int
) -> None:
    program = programmed(plan_of(arm(joints)), "unrolled")
    ((part,),) = straight_stretches(program, held)
    assert part.features["unrolled.sine"] == counted


def test_its_stages_share_its_time_in_order() -> None:
    plan = plan_of(arm())
    line = predict(plan, DEFAULT)
    line = line.by_stage()
    assert [i.what for i in line.intervals] == [s.what for s in stages(plan.processes[0])]
    costs = DEFAULT.steps
    assert costs is not None
    assert line.intervals[0].start == pytest.approx(costs["unrolled.evaluation"])
    assert line.intervals[-1].end == pytest.approx(line.makespan) and line.exchanges == ()
    for before, after in pairwise(line.intervals):
        assert before.end == after.start
    lengths = [i.end - i.start for i in line.intervals]
    assert min(lengths) > 0 and lengths[1] == max(lengths)  # assembly is most of the work


def test_everything_else_goes_step_by_step() -> None:
    assert priced_program(plan_of(serial_chain(101))).shape == "kernels"
    assert priced_program(plan_of(arm(), 2, "ada"), "joints").shape == "joints"


def test_a_slow_core_and_dear_operations_take_longer() -> None:
    plan = plan_of(arm(9))
    base = predict(plan, step_profile(), "unrolled").makespan
    without = ("fetched", "held", "move", "fits", "cache", "ahead", "urgent")
    assert predict(plan, step_profile(cores=(0.5,)), "unrolled").makespan == pytest.approx(2 * base)
    for name in (
        name
        for name in NAMES
        if name.startswith("unrolled.") and name.removeprefix("unrolled.") not in without
    ):
        dearer = step_profile((), **{name.replace(".", "__"): 1.0})
        assert predict(plan, dearer, "unrolled").makespan > base
    assert predict(plan, step_profile((), join__revolute=1.0), "unrolled").makespan == base


def test_a_line_that_does_not_fit_is_fetched_as_a_whole() -> None:
    plan = plan_of(arm())
    ((part,),) = straight_stretches(programmed(plan, "unrolled"), 0.0)
    count = part.features["unrolled.operation"] + part.features["unrolled.move"]
    assert part.line == count

    def priced(fits: float, evicted: float) -> float:
        profile = step_profile((), unrolled__fits=fits, unrolled__evicted=evicted)
        return predict(plan, profile, "unrolled").makespan

    assert priced(count, 5.0) == priced(count, 0.0) == priced(count - 1, 0.0)
    assert priced(count - 1, 5.0) == pytest.approx(priced(count, 0.0) + 5 * count, rel=1e-2)


def test_profiles_without_long_lines_say_nothing_of_what_fits() -> None:
    text, file = profile_text("default")
    rows = [row for row in text.splitlines() if not row.startswith(("evicted", "fits"))]
    steps = parse_profile("\n".join(rows), file).steps
    assert steps is not None and DEFAULT.steps is not None
    assert steps["unrolled.evicted"] == 0 < DEFAULT.steps["unrolled.evicted"]


def test_processes_are_chosen_against_the_straight_line() -> None:
    model = arm()

    def schedule(processes: int) -> Schedule:
        return find_schedule(Topology.of(model), processes, profile=DEFAULT)

    best, *_ = choose_processes(model, DEFAULT, "segment", 2, schedule)
    assert best.processes == 1
    assert best.time == predict(make_plan(model, best.schedule), DEFAULT).makespan
    stepwise = predicted_time(model, best.schedule, DEFAULT, "segment", "kernels")
    assert best.time < stepwise
