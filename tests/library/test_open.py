"""Solvers of robots with loops say by how much a loop is open."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import adagen
from adagen.library.open_by import open_by
from adagen.model import LoopEnd, NamedCoupling, NamedLoop
from adagen.reference.closed import closed_states, constraints
from tests.golden.make_models import MODELS
from tests.mechanisms import with_loops
from tests.models import serial_chain


@pytest.fixture(scope="module")
def solver() -> adagen.Solver:
    scene = MODELS / "fourbar.toml"
    return adagen.compile(adagen.read(MODELS / "fourbar.urdf", scene=scene)).build()


def closed(solver: adagen.Solver, count: int) -> tuple[Any, Any, Any]:
    model = solver.compiled.model
    q, v = closed_states(model, count, seed=1)
    return q, v, np.zeros((count, model.ntau))


def test_of_one_state(solver: adagen.Solver) -> None:
    q, v, tau = (each[0] for each in closed(solver, 1))
    model, moved = solver.compiled.model, q + np.array([0.01, 0.0, 0.0])
    with pytest.raises(adagen.SolveError) as failed:
        solver(moved, v, tau)
    by = np.linalg.norm(constraints(model, moved).gaps[:3])
    assert failed.value.text.endswith(f", by more than its tolerance: it is open by {by:.3g} m")
    faster = v + np.array([1.0, 0.0, 0.0])
    with pytest.raises(adagen.SolveError) as failed:
        solver(q, faster, tau)
    rates = constraints(model, q).rows @ faster
    by, turns = np.linalg.norm(rates[:3]), np.linalg.norm(rates[3:])
    assert f": it opens by {by:.3g} m/s" in failed.value.text
    assert turns < 1e-12


def test_of_many_states_the_first_that_fails_is_looked_at(solver: adagen.Solver) -> None:
    q, v, tau = closed(solver, 5)
    q[2, 0] += 0.02
    q[4, 0] += 0.5
    with pytest.raises(adagen.SolveError) as failed:
        solver(q, v, tau)
    by = np.linalg.norm(constraints(solver.compiled.model, q[2]).gaps[:3])
    assert (failed.value.state, failed.value.count) == (2, 2)
    assert f": it is open by {by:.3g} m" in failed.value.text
    assert np.isfinite(failed.value.out[[0, 1, 3]]).all()


def test_words_of_places_turns_and_couplings() -> None:
    model = with_loops(serial_chain(3), ())
    names = [link.name for link in model.links]
    ends = LoopEnd(names[1]), LoopEnd(names[3])
    loop = NamedLoop("weld", "weld", *ends)
    tie = NamedCoupling("tie", ((model.joints[0].name, 2.0), (model.joints[1].name, 1.0)), 0.5)
    model = with_loops(model, (loop,), (tie,))
    q, v = np.array([0.1, 0.2, 0.3]), np.array([1.0, -0.5, 0.0])
    found = constraints(model, q)
    sizes = [np.linalg.norm(part) for part in (found.gaps[:3], found.gaps[3:6])]
    words = f": it is open by {sizes[0]:.3g} m and {sizes[1]:.3g} rad"
    assert open_by(model, 0, q, v, opens=False) == words
    assert open_by(model, 1, q, v, opens=False) == ": it is open by 0.1 rad"
    assert open_by(model, 1, q, v, opens=True) == ": it opens by 1.5 rad/s"
    still = np.zeros(3)
    assert open_by(model, 0, q, still, opens=True) == ""
