"""Emitted straight lines compute what the executor does, to the last bit.

Compiled without contraction, each operation of the text is one operation of the graph, whatever the
family of the plan, the scalar and the number of processes.
"""

from __future__ import annotations

import secrets
from pathlib import Path

import numpy as np
import pytest

from adagen.executor import interpret, simulate
from adagen.graph import DOUBLE, FLOAT
from adagen.model import REVOLUTE, SPHERICAL, Model
from adagen.plan import Plan
from adagen.plan.steps import FusedJoin
from adagen.states import States, random_states
from tests.emitted import EXACT, ROUNDING, Builder, forward_error, truth_of
from tests.executor.plans import ADA, CASES, Case, anything, kinds_of
from tests.executor.test_lane_bits import limbs
from tests.gathered import reproducible_plan
from tests.models import three_axis_chain
from tests.slow import spread

ALGEBRAS = {"double": DOUBLE, "float": FLOAT}


def require_same_bits(plan: Plan, states: States, model: Model, builder: Builder, to: Path) -> None:
    """Build, run and carry out a plan, each limb by itself: both give the same numbers."""
    none = tuple(() for _ in plan.processes)
    solver = builder.solver(plan, EXACT, name="bits", shape="unrolled", limbs=none)
    found = solver.solve(model, states, to, "--check")
    expected = np.array([interpret(plan, *row, ALGEBRAS[plan.scalar]) for row in states.each])
    np.testing.assert_array_equal(found.astype(expected.dtype), expected)


@pytest.mark.parametrize(
    ("name", "scalar"),
    [
        pytest.param(
            name,
            scalar,
            marks=pytest.mark.slow if case.slow or scalar == "float" else (),
        )
        for name, case in CASES.items()
        for scalar in ("double", "float")
    ],
)
def test_a_straight_line_is_the_executor(
    name: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    case = CASES[name]
    plan = case.plan(scalar)
    assert case.has in kinds_of(plan)
    states = random_states(case.model, 3, seed=4)
    require_same_bits(plan, states, case.model, builder, tmp_path)


@pytest.mark.parametrize("scalar", spread(["double", "float"], 1))
def test_a_reproducible_line_is_the_executor(scalar: str, builder: Builder, tmp_path: Path) -> None:
    """Products and sums that are rounded once among its operations."""
    model = limbs(4, REVOLUTE, SPHERICAL, trunk=1, beside=0)
    plan = reproducible_plan(model, scalar=scalar)
    (line,) = simulate(plan)
    operations = {line.machine.graph.nodes[k].op for k in line.alive}
    assert {"multiply_add", "mul", "add"} <= operations
    require_same_bits(plan, random_states(model, 5, seed=4), model, builder, tmp_path)


@pytest.mark.parametrize("name", CASES)
def test_what_is_computed_is_true(name: str) -> None:
    case = CASES[name]
    plan, states = case.plan("double"), random_states(case.model, 3, seed=4)
    found = np.array([interpret(plan, *row) for row in states.each])
    error = forward_error(found, truth_of(case.model, states))
    assert error < case.magnified * ROUNDING["double"]


@pytest.mark.parametrize("k", spread(range(20), 2))
def test_straight_lines_of_random_robots_are_the_executor(
    k: int, builder: Builder, tmp_path: Path
) -> None:
    """Others at each run: the seed is printed where one fails."""
    seed = secrets.randbits(32)
    print(f"seed {seed}")
    model, plan = anything(seed, ("ada", "join", "gather", "fused")[k % 4])
    states = random_states(model, 2, seed=seed % 1000)
    require_same_bits(plan, states, model, builder, tmp_path)


@pytest.mark.parametrize(
    "name", ["alone with effects", pytest.param("ada by one, fused", marks=pytest.mark.slow)]
)
def test_batches_take_them_too(name: str, builder: Builder, tmp_path: Path) -> None:
    """In lanes sines are others; what is computed is true."""
    fused = Case(three_axis_chain(2), 1, ADA, FusedJoin)
    case = {**CASES, "ada by one, fused": fused}[name]
    solver = builder.solver(case.plan("double"), name="many", batch=2, shape="unrolled")
    states = random_states(case.model, 21, seed=3)
    assert solver.error(case.model, states, tmp_path, "--check") < ROUNDING["double"]
