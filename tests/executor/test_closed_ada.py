"""Form ada of robots with closed loops: joint by joint, loops solved for at the end."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from adagen.errors import UsageError
from adagen.executor import interpret
from adagen.model import LOOP_KINDS, Model
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.program import check
from adagen.program.lower import lower
from adagen.reference.closed import closed_forward_dynamics
from adagen.schedule import load_profile
from adagen.search import best_schedule
from tests.emitted import QUICK, Builder
from tests.executor.test_closures import worst
from tests.mechanisms import MECHANISMS, four_bar, looped_tree, quadruped, states_of


def ada_plan(model: Model, processes: int, *, loop_forces: bool = False) -> Plan:
    """Return the plan of form ada."""
    schedule = best_schedule(model, processes, load_profile("default"), form="ada")
    return make_plan(model, schedule, form="ada", loop_forces=loop_forces)


@pytest.mark.parametrize("processes", [1, 2])
@pytest.mark.parametrize("name", sorted(set(MECHANISMS) - {"four-bar with a massless coupler"}))
def test_mechanisms_move_as_dense_algebra_says(name: str, processes: int) -> None:
    model = MECHANISMS[name]()
    plan = ada_plan(model, processes)
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states_of(model, 4)) < 1e-10
    assert plan_from_json(plan_to_json(plan)) == plan


@pytest.mark.parametrize("kind", LOOP_KINDS)
@pytest.mark.parametrize("floating", [False, True])
def test_loops_of_every_kind_between_processes(kind: str, floating: bool) -> None:
    model = looped_tree(kind, 4, joints=9, floating=floating)
    plan = ada_plan(model, 3)
    assert sum(bool(process.owns) for process in plan.processes) > 1
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states_of(model, 3)) < 1e-10


@pytest.mark.parametrize(
    "make", [quadruped, four_bar, lambda: looped_tree("universal", 4, joints=9)]
)
def test_forces_are_those_of_form_segment(make: Callable[[], Model]) -> None:
    model = make()
    schedule = best_schedule(model, 1, load_profile("default"))
    segment = make_plan(model, schedule, loop_forces=True)
    states = states_of(model, 3, seed=5)
    for processes in (1, 2):
        plan = ada_plan(model, processes, loop_forces=True)
        for q, v, tau in zip(states.q, states.v, states.tau, strict=True):
            found, expected = (interpret(one, q, v, tau, once=True) for one in (plan, segment))
            assert np.abs(found - expected).max() < 1e-9 * np.abs(expected).max()


def test_what_cannot_be_inverted_is_refused() -> None:
    with pytest.raises(UsageError, match="links whose inertia cannot be inverted"):
        ada_plan(four_bar(massless=True), 1)


def test_emitted_for_two_processes(builder: Builder, tmp_path: Path) -> None:
    model = quadruped()
    plan = ada_plan(model, 2)
    solver = builder.solver(plan, QUICK, name="ada")
    states = states_of(model, 3)
    found = solver.solve(model, states, tmp_path)
    rows = zip(states.q, states.v, states.tau, strict=True)
    truth = np.array([closed_forward_dynamics(model, *row) for row in rows])
    assert np.abs(found - truth).max() < 1e-10 * np.abs(truth).max()
