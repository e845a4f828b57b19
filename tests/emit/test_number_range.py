"""Robots and motions so small that squares of what is computed leave the range of a float."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.build import Toolchain
from adagen.model import REVOLUTE, Model
from adagen.states import States, random_states
from benchmarks.stability.bounds import Certified, bounded
from tests.emitted import ROUNDING, Builder, energy_errors, plan_of
from tests.models import random_tree, serial_chain, shrunk, star
from tests.slow import all_but, spread

LINE, LOOPS = Certified("unrolled", scalar="float"), Certified("kernels", scalar="float")
LINES, BATCH = (replace(way, batch=True) for way in (LINE, LOOPS))
WAYS = all_but((LINE, LOOPS, LINES, BATCH), LINES, BATCH)


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


def _hinges() -> Model:
    return random_tree(np.random.default_rng(3), 8, kinds=(REVOLUTE,))


@pytest.mark.parametrize("way", WAYS, ids=str)
@pytest.mark.parametrize("robot", all_but(("tree", "chain"), "chain"))
def test_robots_of_tiny_inertias_keep_their_digits(
    robot: str, way: Certified, quick: Toolchain
) -> None:
    """Inertias of 1e-25 kg m^2, whose squares no float holds: answers of loops were half wrong."""
    model, mass, length = _hinges() if robot == "tree" else serial_chain(12), 1e-15, 1e-5
    given = random_states(model, 15, seed=3)
    states = States(given.q, given.v, given.tau * mass * length**2)
    found = bounded(shrunk(model, mass, length), states, [way], quick)[way]
    assert found.refused == 0
    assert found.errors.max() < ROUNDING["float"]
    assert (found.ratios <= 1).all() and np.isfinite(found.bounds).all()


@pytest.mark.parametrize("way", WAYS, ids=str)
def test_bounds_are_sure_of_nothing_where_hardly_anything_moves(
    way: Certified, quick: Toolchain
) -> None:
    """Without gravity, at rates of ever smaller powers of ten: bounds were 0 below 1e-8 rad/s."""
    model = replace(_hinges(), gravity=np.zeros(3))
    states = random_states(model, 12, seed=3)
    rates = 10.0 ** -np.arange(12)[:, None]
    slow = States(states.q, states.v * rates, np.zeros_like(states.tau))
    found = bounded(model, slow, [way], quick)[way]
    assert found.refused == 0 and found.errors.max() < ROUNDING["float"]
    assert (found.ratios <= 1).all()
    assert np.isfinite(found.bounds[:4]).all() and np.isinf(found.bounds[-3:]).all()


@pytest.mark.parametrize(
    ("residual", "processes"), spread([("own", 1), ("wide", 1), ("wide", 2)], 2)
)
def test_corrections_are_told_where_hardly_anything_moves(
    residual: str, processes: int, builder: Builder, tmp_path: Path
) -> None:
    """Without gravity, at rates of ever smaller powers of ten: they were 0 at 1e-8 rad/s."""
    model = replace(star(4, 5), gravity=np.zeros(3))
    states = random_states(model, 1, seed=3)
    rates = 100.0 ** -np.arange(8)[:, None]
    slow = States(np.repeat(states.q, 8, 0), states.v * rates, 0 * rates * states.tau)
    slow = slow.read_in("float")
    plan = plan_of(model, processes, scalar="float")
    plain = builder.solver(plan, shape="kernels").solve(model, slow, tmp_path)
    solver = builder.solver(plan, shape="kernels", refine=1, residual=residual)
    refined = solver.solve(model, slow, tmp_path)
    assert energy_errors(model, slow, refined).max() < ROUNDING["float"]
    told = json.loads((tmp_path / "result.json").read_text())["corrections"]
    said = np.array(told, dtype=float)[:, 0]  # null, which stands for infinity, becomes NaN
    errors = energy_errors(model, slow, plain)
    if residual == "own":
        assert (said[:3] > 0).all() and np.isnan(said[-4:]).all()
    else:
        assert ((said < 3 * errors) & (errors < 3 * said)).all()
