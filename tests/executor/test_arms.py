"""Alike arms of one closure share straight lines, one in each SIMD lane."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from adagen.executor import Grouping, chosen_grouping, interpret, simulate
from adagen.executor.grouping import groupings_of
from adagen.graph import DOUBLE, FLOAT
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL, LoopEnd, Model, NamedLoop
from adagen.plan import Plan
from adagen.plan.arms import arms_among
from adagen.plan.closure_steps import closures_in
from tests.emitted import EXACT, Builder
from tests.executor.plans import in_lanes_off
from tests.executor.test_closures import plan_of, worst
from tests.mechanisms import states_of, with_loops
from tests.models import Part, assemble, rod, vector
from tests.slow import slow


def plate(count: int, *, balls: bool, kind: str = "point") -> Model:
    """Return a plate on a ball, held by arms around it: cranks with rods, or telescopic legs.

    Args:
        count: how many arms.
        balls: whether each is a crank and a rod on a ball; else two hinges and a slide.
        kind: of the loops that close them.
    """
    body = rod(3.0, vector(0.2, 0.1, 0.05))
    parts = [
        Part("stand", None, REVOLUTE, rod(2.0, vector(0.0, 0.1, 0.5))),
        Part("plate", "stand", SPHERICAL, body, vector(0.0, 0.0, 0.6)),
    ]
    loops = []
    for n in range(count):
        angle = 2.0 * np.pi * n / count + 0.1
        out = vector(np.cos(angle), np.sin(angle), 0.0)
        across, up = vector(-out[1], out[0], 0.0), vector(0.0, 0.0, 1.0)
        foot, length = 0.5 * out, 0.55 + 0.02 * n
        parts.append(
            Part(f"one{n}", "stand", REVOLUTE, rod(0.4 + 0.1 * n, 0.1 * out), foot, axis=across)
        )
        if balls:
            stick = rod(0.3, length * up)
            parts.append(Part(f"two{n}", f"one{n}", SPHERICAL, stick, 0.1 * out))
            end = length * up
        else:
            tube, piston = rod(0.5, 0.3 * up), rod(0.2, -0.2 * up)
            parts.append(Part(f"two{n}", f"one{n}", REVOLUTE, tube, axis=out))
            parts.append(Part(f"slide{n}", f"two{n}", PRISMATIC, piston, 0.5 * up, axis=up))
            end = vector(0.0, 0.0, 0.0)
        last = f"two{n}_link" if balls else f"slide{n}_link"
        pin = LoopEnd(last, tuple(end)), LoopEnd("plate_link", tuple(0.4 * out))
        loops.append(NamedLoop(f"pin{n}", kind, *pin))
    return with_loops(assemble("plate", parts), tuple(loops))


def arms_of(plan: Plan, grouping: Grouping) -> list[int]:
    """Return how many arms go together, each time that some do."""
    return [
        each.limbs.count
        for process, limbs in zip(plan.processes, grouping, strict=True)
        for arms in arms_among(plan, closures_in(process.steps).values(), limbs).values()
        for each in arms
    ]


CASES: dict[str, tuple[Callable[[], Model], list[int]]] = {
    "two rods": (lambda: plate(2, balls=True), [2]),
    "three rods, one lane idle": (lambda: plate(3, balls=True), [3]),
    "three legs": (lambda: plate(3, balls=False), [3]),
    "five legs, one by itself": (lambda: plate(5, balls=False), [4]),
}


@pytest.mark.parametrize("name", CASES)
def test_alike_arms_share_lanes(name: str) -> None:
    """They do, it is less work, and what is computed is the same but for rounding."""
    make, expected = CASES[name]
    model = make()
    plan, states = plan_of(model), states_of(model, 2)
    grouping = groupings_of(plan)[0]
    assert arms_of(plan, grouping) == expected
    (apart,), (together,) = simulate(plan), simulate(plan, grouping)
    assert together.operations.arithmetic < 0.8 * apart.operations.arithmetic
    assert worst(model, plan, states) < 1e-11
    assert in_lanes_off(plan, states, grouping) < 1e-11


def test_an_open_loop_of_an_arm_is_refused_by_its_name() -> None:
    model = plate(3, balls=False)
    plan, states = plan_of(model), states_of(model, 1)
    grouping = groupings_of(plan)[0]
    q, v, tau = states.q[0], states.v[0], states.tau[0]
    names = [joint.name for joint in model.joints]
    for n in range(3):
        slide = names.index(f"slide{n}")
        moved = q + 0.01 * (np.arange(model.nq) == model.q_start[slide])
        with pytest.raises(FloatingPointError, match=f'loop "pin{n}": it is open'):
            interpret(plan, moved, v, tau, lanes=grouping)
        torn = v + 0.01 * (np.arange(model.nv) == model.v_start[slide])
        with pytest.raises(FloatingPointError, match=f'loop "pin{n}": the velocity'):
            interpret(plan, q, torn, tau, lanes=grouping)


@pytest.mark.parametrize(
    ("name", "scalar"), [("three rods, one lane idle", "double"), slow("three legs", "float")]
)
def test_emitted_arms_compute_what_the_executor_does(
    name: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    """In poses in which the first choice is poor arms go side by side, too."""
    make, _ = CASES[name]
    model = make()
    plan, states = plan_of(model, scalar=scalar), states_of(model, 12, seed=3)
    assert arms_of(plan, chosen_grouping(plan))
    solver = builder.solver(plan, EXACT, name="arms", shape="unrolled")
    found = solver.solve(model, states, tmp_path)
    algebra = FLOAT if scalar == "float" else DOUBLE
    expected = np.array([interpret(plan, *row, algebra, lanes=True) for row in states.each])
    np.testing.assert_array_equal(found.astype(expected.dtype), expected)


CORES = ("Prescott", "Haswell")
"""Kinds of processors that numpy's algebra can be told to compute as; all here are younger."""
CHOICES = """
from adagen.plan.steps import Eliminate
from tests.executor.test_arms import plate
from tests.executor.test_closures import plan_of
for balls in (True, False):
    plan = plan_of(plate(3, balls=balls))
    print([s for p in plan.processes for s in p.steps if isinstance(s, Eliminate)])
"""


def test_what_follows_from_what_is_the_same_on_all_processors() -> None:
    """Rods spin about themselves: what rounding makes of that is no motion that rows feel."""
    seen = {
        subprocess.run(
            [sys.executable, "-c", CHOICES],
            env={**os.environ, "OPENBLAS_CORETYPE": core},
            cwd=Path(__file__).resolve().parents[2],
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for core in CORES
    }
    assert len(seen) == 1
    assert "Eliminate" in seen.pop()
