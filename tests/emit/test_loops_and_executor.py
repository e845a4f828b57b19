"""Loops answer as the executor does, to some units in the last place.

Both solve the same equations, loops in axes of the base, the executor in the joints' own, so that
no sum has the same last digits. Relative to the energy norm sqrt(t^T H t) of the true answer t,
articulated bodies keep some units in the last place, also where inertias differ by many decades;
a ground that is passed on as a mobility loses more, in any axes. So the two may differ by ``UNITS``
times what the executor itself errs by, or what rounding every number once brings, if that is more.
What loses digits of large inertias into small ones exceeds that: 5e4 units for the graded chain
with columns that are not kept symmetric, 1e11 for the slender tool in axes of the base.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from adagen.emit.kernels import why_not
from adagen.executor import interpret
from adagen.model import Model
from adagen.model.kinds import PRISMATIC, REVOLUTE, SPHERICAL
from adagen.plan import Plan, make_plan
from adagen.reference import joint_space_inertia
from adagen.schedule import load_profile
from adagen.search.objective import schedule_for
from adagen.states import States, random_states
from adagen.studies.stability import robots
from tests.emitted import EXACT, Builder, Solver, kernels_of, plan_of, truth_of
from tests.executor.plans import ADA, CASES, anything
from tests.executor.test_bits import ALGEBRAS
from tests.models import Part, assemble, human_figure, random_tree, rod, serial_chain, vector
from tests.slow import all_but, spread

UNITS = 32.0
ROUNDED = 16.0  # units in the last place
KINDS = (REVOLUTE, REVOLUTE, PRISMATIC, SPHERICAL)
DRAWN = (
    *("joined by two", "joined by three", "joined by four"),
    *("gathered by two", "gathered by three", "gathered by four", "gathered on the ground"),
    "gathered on a ground that is held",
)
"""Cases whose like are among the random robots of each run; the last one compiles for long."""


def tool(radius: float) -> Model:
    """Return three axes, the last one along a slender tool."""
    links = [robots.rod(), robots.rod(), robots.rod(radius=radius)]
    return robots.chain("tool", links, axes="xyz")


def tree(n: int, floating: bool) -> Model:
    """Return a random tree of n joints."""
    return random_tree(np.random.default_rng(n), n, KINDS, floating=floating)


def wheels() -> Model:
    """Return four wheels on a platform that is held: limbs of one joint each."""
    rim = rod(1.2, vector(0.0, 0.0, 0.1))
    parts = [Part(f"wheel{k}", None, REVOLUTE, rim, vector(0.2 * k, 0.0, 0.0)) for k in range(4)]
    return assemble("wheels", parts)


def require_last_places(plan: Plan, states: States, model: Model, solver: Solver, to: Path) -> None:
    """Run loops and the executor, and hold their difference against what the executor errs by."""
    found, truth = solver.solve(model, states, to), truth_of(model, states)
    eps = {"double": 2.0**-53, "float": 2.0**-24}[plan.scalar]
    rows = zip(states.q, states.v, states.tau, found, truth, strict=True)
    for q, v, tau, qdd, true in rows:
        other = interpret(plan, q, v, tau, ALGEBRAS[plan.scalar])
        inertia = joint_space_inertia(model, q)
        apart, own, size = (np.sqrt(x @ inertia @ x) for x in (qdd - other, other - true, true))
        assert apart <= UNITS * max(own, ROUNDED * eps * size)


ROBOTS: dict[str, tuple[Callable[[], Model], int, str, str]] = {
    "slender": (lambda: tool(2e-6), 1, "double", "inward_turned<"),
    "slender, float": (lambda: tool(5e-3), 1, "float", "inward_turned<"),
    "graded": (lambda: robots.graded(30, 1e8), 1, "double", "inward_in_columns<"),
    "three axes": (lambda: robots.three_axis(3), 1, "double", "inward_turned<"),
    "tree": (lambda: tree(20, False), 1, "double", "inward"),
    "tree, floating": (lambda: tree(20, True), 2, "double", "inward"),
    "lanes": (human_figure, 1, "double", "inward_group<"),
    "strips": (lambda: serial_chain(64, axes="xyz"), 1, "double", "outward_in_strips<"),
}


@pytest.mark.parametrize("name", all_but(ROBOTS, "tree, floating", "slender"))
def test_loops_differ_from_the_executor_in_last_places(
    name: str, builder: Builder, tmp_path: Path
) -> None:
    make, processes, scalar, kernel = ROBOTS[name]
    model = make()
    plan = plan_of(model, processes, scalar=scalar)
    assert kernel in kernels_of(plan)
    solver = builder.solver(plan, EXACT, name="agree", shape="kernels")
    require_last_places(plan, random_states(model, 6, seed=1), model, solver, tmp_path)


@pytest.mark.parametrize(
    ("name", "scalar"),
    [
        pytest.param(
            name, scalar, marks=pytest.mark.slow if scalar == "float" or name in DRAWN else ()
        )
        for name, case in CASES.items()
        for scalar in ("double", "float")
        if case.options != ADA
    ],
)
def test_so_they_do_in_every_family(
    name: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    case = CASES[name]
    plan = case.plan(scalar)
    solver = builder.solver(plan, EXACT, name="agree", shape="kernels")
    require_last_places(plan, random_states(case.model, 3, seed=4), case.model, solver, tmp_path)


@pytest.mark.parametrize("k", spread(range(22), 2))
def test_so_they_do_for_random_robots(k: int, builder: Builder, tmp_path: Path) -> None:
    """Others at each run: the seed is printed where one fails."""
    seed, plan = secrets.randbits(32), None
    while plan is None or why_not(plan) is not None:
        seed += 1
        model, plan = anything(seed, "gather" if k % 2 else "join")
    print(f"seed {seed}")
    solver = builder.solver(plan, EXACT, name="agree", shape="kernels")
    states = random_states(model, 3, seed=seed % 1000)
    require_last_places(plan, states, model, solver, tmp_path)


def test_so_they_do_where_a_process_has_nothing_to_do(builder: Builder, tmp_path: Path) -> None:
    """Its memory is empty: every joint lies at its own number, and more room behind them."""
    model = wheels()
    plan = make_plan(model, schedule_for("both", model, 2, load_profile("default")))
    assert [len(process.owns) for process in plan.processes] == [4, 0]
    assert "inward_group<" in kernels_of(plan)
    solver = builder.solver(plan, EXACT, name="agree", shape="kernels")
    require_last_places(plan, random_states(model, 3, seed=1), model, solver, tmp_path)


@pytest.mark.slow
def test_forces_on_links_that_share_a_block_all_act(builder: Builder, tmp_path: Path) -> None:
    """Links of a core and of a limb in one block of lanes, set up with outer forces on both."""
    model, plan = anything(7, "gather")
    assert len({wrench.link for wrench in model.wrenches}) == 2
    solver = builder.solver(plan, EXACT, name="agree", shape="kernels")
    require_last_places(plan, random_states(model, 3, seed=1), model, solver, tmp_path)
