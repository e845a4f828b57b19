"""Runs whose mobility is asked for at the last link only."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.emit import emit
from adagen.model import KINDS, Model
from adagen.plan import Plan, make_plan
from adagen.plan.steps import Propagate
from adagen.plan.tip_mobility import mentions, tip_mobility_runs
from adagen.program import lower
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from tests.emitted import kernels_of, text_of
from tests.models import random_tree, serial_chain

PROFILE = load_profile("default")
KINDS_PASSED = [KINDS["revolute"], KINDS["prismatic"], KINDS["spherical"]]


def gathered(model: Model) -> Plan:
    schedule = named_schedule("balanced", Topology.of(model), 2, profile=PROFILE)
    return make_plan(model, schedule, meeting="gather")


def carried(plan: Plan) -> tuple[int, list[Propagate]]:
    """The process that carries mobilities from the ground on, and its steps that do."""
    for p, process in enumerate(plan.processes):
        steps = [step for step in process.steps if isinstance(step, Propagate)]
        if steps:
            return p, steps
    raise AssertionError("no process carries a mobility")


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_what_holds_a_chain_is_asked_for_at_one_link(seed: int) -> None:
    rng = np.random.default_rng(seed)
    plan = gathered(random_tree(rng, 20, KINDS_PASSED, branching=0.0))
    p, steps = carried(plan)
    (run,) = tip_mobility_runs(plan, steps, mentions(plan, plan.processes[p]))
    assert list(run) == steps
    assert len(steps) > 1
    text = kernels_of(plan)
    ends = f"{run[0].joint}, {run[-1].joint}"
    assert f" carry<false, {ends}>(w);" in text or f" inward_and_carry<{p}, {ends}, " in text


def test_wrenches_go_along_with_a_sweep_that_is_not_repeated() -> None:
    plan = gathered(serial_chain(20))
    once, again = kernels_of(plan), text_of(plan, shape="kernels", refine=1)
    assert "= inward_and_carry<" in once and " deliver_along<" in once
    assert " accelerate_along<" in once
    assert " carry<" not in once
    assert " carry<" in again and "_along<" not in again


def test_a_mobility_that_is_asked_for_is_computed() -> None:
    plan = gathered(serial_chain(20))
    p, steps = carried(plan)
    asked = steps[3].block  # say that a message tells it
    told = replace(plan.messages[0], blocks=(asked,))
    plan = replace(plan, messages=(told, *plan.messages[1:]))
    named = mentions(plan, plan.processes[p])
    found = [list(run) for run in tip_mobility_runs(plan, steps, named)]
    assert found == [steps[:4], steps[4:]]


def test_joints_that_are_told_apart_are_carried_one_by_one() -> None:
    plan = gathered(serial_chain(20))
    p, steps = carried(plan)
    named = mentions(plan, plan.processes[p])
    found = [list(run) for run in tip_mobility_runs(plan, steps, named, {steps[2].joint})]
    assert found == [steps[:2], steps[2:3], steps[3:]]


def joined(model: Model, processes: int) -> Plan:
    schedule = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    return make_plan(model, schedule)


@pytest.mark.parametrize("floating", [False, True])
def test_a_segment_inside_of_a_chain_is_one_run(floating: bool) -> None:
    plan = joined(serial_chain(40, floating=floating), 4)
    program = lower(plan, "kernels")
    runs = [
        operation
        for process in program.processes
        for operation in process.operations
        if operation.does == "propagate"
    ]
    assert {operation.method for operation in runs} == {"along"}
    assert any(isinstance(s, Propagate) and s.spreads for op in runs for s in op.steps)
    text = emit(plan, name="chain", shape="kernels")["chain_p4.cpp"]
    assert "propagate<" not in text.split("// ---- processes")[1]
    loads = [line for line in text.splitlines() if "w.loads[" in line and "Zero()" in line]
    assert len(loads) < 8  # none for the links inside of runs
