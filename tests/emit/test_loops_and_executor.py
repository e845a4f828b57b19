"""Loops answer as the executor does, to some units in the last place of the answer's energy norm.

Both solve the same equations, loops in axes of the base, the executor in the joints' own, so that
no sum has the same last digits. Articulated bodies lose nothing to the condition of H: relative to
the energy norm sqrt(t^T H t) of the answer t each keeps some units in the last place, also where
inertias differ by many decades. So the difference is bounded by UNITS eps sqrt(t^T H t). What loses
digits of large inertias into small ones exceeds that: 5e4 for the graded chain with columns that
are not kept symmetric, 1e11 for the slender tool in axes of the base.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from adagen.executor import interpret
from adagen.model import Model
from adagen.model.kinds import PRISMATIC, REVOLUTE, SPHERICAL
from adagen.reference import joint_space_inertia
from adagen.states import random_states
from adagen.studies.stability import robots
from tests.emitted import QUICK, Builder, kernels_of, plan_of
from tests.models import random_tree

UNITS = 1024.0  # measured: 1 to 200
EXACT = (*QUICK, "-ffp-contract=off")
KINDS = (REVOLUTE, REVOLUTE, PRISMATIC, SPHERICAL)


def tool(radius: float) -> Model:
    """Return three axes, the last one along a slender tool."""
    links = [robots.rod(), robots.rod(), robots.rod(radius=radius)]
    return robots.chain("tool", links, axes="xyz")


def tree(n: int, floating: bool) -> Model:
    """Return a random tree of n joints."""
    return random_tree(np.random.default_rng(n), n, KINDS, floating=floating)


CASES: dict[str, tuple[Callable[[], Model], int, str, str]] = {
    "slender": (lambda: tool(2e-6), 1, "double", "inward_turned<"),
    "slender, float": (lambda: tool(5e-3), 1, "float", "inward_turned<"),
    "graded": (lambda: robots.graded(30, 1e8), 1, "double", "inward_in_columns<"),
    "three axes": (lambda: robots.three_axis(3), 1, "double", "inward_turned<"),
    "tree": (lambda: tree(20, False), 1, "double", "inward"),
    "tree, floating": (lambda: tree(20, True), 2, "double", "inward"),
}


@pytest.mark.parametrize("case", CASES)
def test_loops_differ_from_the_executor_in_last_places(
    case: str, builder: Builder, tmp_path: Path
) -> None:
    make, processes, scalar, kernel = CASES[case]
    model = make()
    plan = plan_of(model, processes, scalar=scalar)
    assert kernel in kernels_of(plan)
    states = random_states(model, 6, seed=1)
    solver = builder.solver(plan, EXACT, name="agree", shape="kernels")
    found = solver.solve(model, states, tmp_path)
    eps = {"double": 2.0**-53, "float": 2.0**-24}[scalar]
    for q, v, tau, qdd in zip(states.q, states.v, states.tau, found, strict=True):
        other, inertia = interpret(plan, q, v, tau, once=True), joint_space_inertia(model, q)
        energy, norm = (x @ inertia @ x for x in (qdd - other, other))
        assert np.sqrt(energy) <= UNITS * eps * np.sqrt(norm)
