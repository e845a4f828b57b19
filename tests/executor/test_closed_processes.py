"""Robots with closed loops on several processes: closures and limbs are shared out."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit.shapes import predict
from adagen.errors import InputError
from adagen.executor import chosen_grouping, interpret
from adagen.executor.solve import Run, SingularPoseError
from adagen.model import BASE, REVOLUTE, Model
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.plan.refine import corrected
from adagen.plan.steps import Eliminate, HoldMobility
from adagen.program import check
from adagen.program.lower import lower
from adagen.reference.closed import closed_forward_dynamics
from adagen.schedule import Topology, load_profile
from adagen.schedule.tree import Gathered
from adagen.search import best_schedule, schedule_from_json
from adagen.search.closed_loops import _layouts
from adagen.states import States
from tests.emitted import QUICK, Builder
from tests.executor.plans import kinds_of
from tests.executor.test_closures import worst
from tests.mechanisms import four_bar, looped_tree, quadruped, standing, states_of
from tests.models import Part, human_figure, rod, vector


def figure() -> Model:
    """Return a human figure on both feet."""
    return standing(human_figure(), "weld", "left_ankle_link", "right_ankle_link")


def owners_of(plan: Plan) -> list[int]:
    """Return how many joints each process gives."""
    return [len(process.owns) for process in plan.processes]


def divided(model: Model, processes: int, owners: list[int | None]) -> Plan:
    """Return a plan of a robot around its base, of which each process has the joints given."""
    schedule = best_schedule(model, processes, load_profile("default"))
    gathered = Gathered((1,), tuple(owners))
    return make_plan(model, replace(schedule, meeting="gather", gathered=gathered))


@pytest.mark.parametrize("processes", [2, pytest.param(3, marks=pytest.mark.slow)])
def test_feet_on_the_ground_are_shared_out(processes: int) -> None:
    model = figure()
    plan = divided(model, processes, [None, *[0] * 3, *[1] * 3, *[processes - 1] * 8])
    assert all(owners_of(plan))
    ends = [[s for s in p.steps if isinstance(s, Eliminate)] for p in plan.processes]
    assert list(map(len, ends))[:2] == [1, 1]
    states = states_of(model, 4)
    for each in plan.alternatives:
        check(lower(each, "unrolled"))
        assert worst(model, each, states) < 1e-10
    assert plan_from_json(plan_to_json(plan)) == plan


def test_a_chain_pinned_at_both_ends_is_shared_out_at_its_middle() -> None:
    model = looped_tree("spherical", 3, joints=44, whole=True)
    profile = load_profile("zen4")
    one, two = (best_schedule(model, processes, profile) for processes in (1, 2))
    alone, plan = make_plan(model, one), make_plan(model, two)
    assert two.makespan < 0.7 * predict(alone, profile).makespan
    assert min(owners_of(plan)) > 15
    assert HoldMobility in kinds_of(plan)
    states = states_of(model, 2)
    for each in plan.alternatives:
        check(lower(each, "unrolled"))
        for q, v, tau in states.each:
            expected = interpret(alone, q, v, tau, once=True)
            found = interpret(each, q, v, tau, once=True)
            assert np.abs(found - expected).max() < 1e-10 * np.abs(expected).max()


def test_answers_are_corrected_wherever_processes_meet() -> None:
    """Where that is in the middle of a floating robot, another process has the way to the base."""
    axes = (vector(1.0, 0.0, 0.0), vector(0.0, 1.0, 0.0), vector(0.0, 0.0, 1.0))
    spine = [
        Part(
            f"t{k}",
            f"t{k - 1}" if k else BASE,
            REVOLUTE,
            rod(1.0, vector(0.0, 0.1, 0.2)),
            vector(0.0, 0.05, 0.2),
            axis=axes[k % 3],
        )
        for k in range(8)
    ]
    model = four_bar(floating=True, beside=spine)
    states, schedule = states_of(model, 2), best_schedule(model, 2, load_profile("default"))
    found, _ = _layouts(model, make_plan(model, schedule), 2)
    roots: set[int] = set()
    for gathered in dict.fromkeys(found):
        plan = make_plan(model, replace(schedule, meeting="gather", gathered=gathered))
        assert worst(model, corrected(plan, 1), states) < 1e-12
        roots.update(gathered.roots)
    assert len(roots) > 1 and 1 in roots


def test_what_divides_a_closure_is_refused() -> None:
    model = four_bar()
    schedule = best_schedule(model, 2, load_profile("default"))
    divided = replace(schedule, meeting="gather", gathered=Gathered((2,), (0, 0, 1)))
    with pytest.raises(InputError, match='joints of loops "pin" are not all of one process'):
        make_plan(model, divided)


def poor_and_good(model: Model, plan: Plan, count: int) -> States:
    """Return closed states, in some of which all is done in another way, in some not."""
    states = states_of(model, 12 * count, seed=5)
    poor, good = [], []
    for k, row in enumerate(states.each):
        try:
            Run(plan, dict(zip(("q", "v", "tau"), row, strict=True)), once=True).check()
            good.append(k)
        except SingularPoseError:
            poor.append(k)
    assert len(poor) >= count <= len(good)
    chosen = sorted([*poor[:count], *good[:count]])
    return States(states.q[chosen], states.v[chosen], states.tau[chosen])


def test_processes_solve_poor_poses_each_for_itself(builder: Builder, tmp_path: Path) -> None:
    """Emitted, on two processes; one of them finds that the pose is poor, and all go again."""
    model = quadruped()
    plan = divided(model, 2, [None, *[0] * 6, *[1] * 6])
    assert owners_of(plan) == [7, 6]
    assert [len(limbs) for limbs in chosen_grouping(plan)] == [1, 1]  # two feet each, in lanes
    states = poor_and_good(model, plan, 2)
    solver = builder.solver(plan, QUICK, shape="unrolled")
    found = solver.solve(model, states, tmp_path)
    truth = np.array([closed_forward_dynamics(model, *row) for row in states.each])
    assert np.abs(found - truth).max() < 1e-10 * np.abs(truth).max()
    told = json.loads(solver.run("--check", "--json").stdout)["check"]
    assert told["ok"]


def test_a_layout_from_a_file() -> None:
    """The tree of a schedule whose processes gather is none that they are joined by."""
    model = figure()
    owners = [None, *[0] * 3, *[1] * 3, *[2] * 8]
    names = [joint.name for joint in model.joints]
    gathered = {"roots": names[:1], "owners": dict(zip(names, owners, strict=True))}
    text = json.dumps({"processes": 3, "meeting": "gather", "gathered": gathered})
    plan = make_plan(model, schedule_from_json(text, Topology.of(model), load_profile("default")))
    assert plan == divided(model, 3, owners)
