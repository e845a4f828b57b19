"""Robots that float apart and are tied by loops: each carries the rows, and may be a process's."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from adagen.emit.shapes import predict
from adagen.errors import InputError
from adagen.executor import interpret
from adagen.model import FLOATING, REVOLUTE, Inertia, Model, Passive
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.plan.certificate import certified
from adagen.plan.closures import closures_of
from adagen.plan.constants import joints_of
from adagen.plan.gather_trees import moving_trees
from adagen.plan.refine import corrected
from adagen.plan.separate_trees import closures_between_trees
from adagen.plan.steps import CarryRows, Eliminate, HoldBack
from adagen.program import check
from adagen.program.lower import lower
from adagen.reference.closed import closed_forward_dynamics
from adagen.schedule import load_profile
from adagen.schedule.tree import Gathered
from adagen.search import best_schedule
from adagen.search.straight_layouts import whole_trees
from tests.emitted import QUICK, Builder, text_of
from tests.executor.plans import kinds_of
from tests.executor.test_closures import worst
from tests.mechanisms import between, states_of
from tests.models import Part, assemble, rod, vector

PROFILE = load_profile("xeon")


def robots(arms: int, count: int = 2, beside: bool = False) -> Model:
    """Return floating bodies with an arm each, whose links lie one on the other at zero."""
    parts, axes = [], ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    for name in "abc"[:count]:
        parts.append(Part(name, None, FLOATING, rod(5.0, vector(0.3, 0.1, 0.2))))
        above = name
        for k in range(arms):
            along = vector(0.1, 0.15 + 0.01 * k, -0.2)
            axis = vector(*axes[k % 3])
            parts.append(Part(f"{name}{k}", above, REVOLUTE, rod(0.6, along), along, axis=axis))
            above = f"{name}{k}"
        if beside:
            parts.append(Part(f"{name}_tail", name, REVOLUTE, rod(0.4, along), along))
    return assemble("robots", parts)


def carrying(kind: str, arms: int = 7, count: int = 2, beside: bool = True) -> Model:
    """Return robots whose last links are tied to each other, one after the other."""
    model = robots(arms, count, beside)
    names = [f"{name}{arms - 1}_link" for name in "abc"[:count]]
    pairs = pairwise(names)
    return between(model, *((kind, *pair) for pair in pairs))


def plan_of(model: Model, processes: int = 1) -> Plan:
    """Return the plan of a robot each of whose trees is a process's."""
    schedule = best_schedule(model, 1, PROFILE)
    if processes > 1:
        joints = joints_of(model)
        layouts = whole_trees(joints, moving_trees(joints), [1.0] * len(joints), processes)
        (*_, gathered) = layouts
        schedule = best_schedule(model, processes, PROFILE)
        schedule = replace(schedule, meeting="gather", gathered=gathered)
    return make_plan(model, schedule)


@pytest.mark.parametrize(
    ("kind", "processes"),
    [("point", 1), ("weld", 2), pytest.param("cylindrical", 2, marks=pytest.mark.slow)],
)
def test_each_robot_carries_the_rows(kind: str, processes: int) -> None:
    model = carrying(kind)
    plan, states = plan_of(model, processes), states_of(model, 3)
    assert CarryRows in kinds_of(plan)
    assert HoldBack not in kinds_of(plan)
    assert [len(process.owns) for process in plan.processes] == [18 // processes] * processes
    assert plan_from_json(plan_to_json(plan)) == plan
    for each in plan.alternatives:
        check(lower(each, "unrolled"))
        assert worst(model, each, states) < 1e-11
    assert [HoldBack in kinds_of(each) for each in plan.alternatives[:2]] == [False, True]


def test_a_side_is_a_few_numbers() -> None:
    plan = plan_of(carrying("weld"), 2)
    assert [(m.source, m.target) for m in plan.messages] == [(0, 1), (1, 0)]
    assert [m.numbers(1, plan.joints) for m in plan.messages] == [21 + 6, 21 + 6]
    assert [m.sides[0].joints for m in plan.messages] == [tuple(range(8)), tuple(range(9, 17))]
    assert all(Eliminate in {type(s) for s in process.steps} for process in plan.processes)


def test_processes_have_robots_where_that_pays() -> None:
    model = carrying("point", arms=20, beside=False)
    one, two = (best_schedule(model, processes, PROFILE) for processes in (1, 2))
    assert two.makespan < 0.7 * predict(make_plan(model, one), PROFILE).makespan
    assert [len(process.owns) for process in make_plan(model, two).processes] == [21, 21]


def test_three_robots_in_a_row() -> None:
    model = carrying("point", arms=5, count=3)
    plan = plan_of(model, 3)
    assert [len(process.owns) for process in plan.processes] == [7, 7, 7]
    assert len(plan.messages) == 6
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states_of(model, 2)) < 1e-12


def test_what_is_small_or_held_by_a_loop_alone_is_held_back() -> None:
    assert closures_between_trees(carrying("point", arms=2)) == ()
    model = carrying("point")
    assert closures_between_trees(model)
    links = (*model.links[:8], replace(model.links[8], inertia=Inertia.zero()), *model.links[9:])
    hidden = replace(model, links=links)
    assert closures_of(hidden)
    assert closures_between_trees(hidden) == ()
    rotor = replace(model.joints[3], passive=Passive(rotor_inertia=0.1))
    geared = replace(model, joints=(*model.joints[:3], rotor, *model.joints[4:]))
    assert closures_between_trees(geared) == ()


def test_certificates_and_corrections_hold_back() -> None:
    """Nothing bounds what carried rows lose; and no process alone sees both ends of a loop move."""
    model = carrying("point")
    assert HoldBack in kinds_of(certified(plan_of(model)))
    plan, (q, v, tau) = corrected(plan_of(model, 2), 1), (x[0] for x in _states(model))
    found, truth = interpret(plan, q, v, tau), closed_forward_dynamics(model, q, v, tau)
    assert np.abs(found - truth).max() < 1e-12 * np.abs(truth).max()


def _states(model: Model) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    states = states_of(model, 1)
    return states.parts


def test_a_robot_is_not_divided() -> None:
    model = carrying("point")
    schedule = best_schedule(model, 2, PROFILE)
    owners = [*[0] * 8, *[1] * 10]  # the tail of the first robot is the second's
    divided = replace(schedule, meeting="gather", gathered=Gathered((1, 10), tuple(owners)))
    with pytest.raises(InputError, match='joints of loops "loop0" are not all of one process'):
        make_plan(model, divided)


@pytest.mark.slow
def test_two_processes_have_a_robot_each(builder: Builder, tmp_path: Path) -> None:
    model = carrying("point", arms=4, beside=False)
    plan, states = plan_of(model, 2), states_of(model, 5)
    assert CarryRows in kinds_of(plan)
    solver = builder.solver(plan, QUICK, shape="unrolled")
    found = solver.solve(model, states, tmp_path)
    truth = np.array([closed_forward_dynamics(model, *row) for row in states.each])
    assert np.abs(found - truth).max() < 1e-11 * np.abs(truth).max()
    assert json.loads(solver.run("--check", "--json").stdout)["check"]["ok"]
    assert "each with trees of its own" in text_of(plan, shape="unrolled")
