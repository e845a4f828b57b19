"""Textbook algorithms that emitted code is compared with: right where they are said to be."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from adagen.emit.shapes import BASELINES, SHAPES, chosen_shape
from adagen.errors import UsageError
from adagen.model import SPHERICAL, Model
from adagen.states import States, random_states
from tests.emitted import Builder, energy_errors, plan_of
from tests.models import random_tree, serial_chain
from tests.slow import spread


def error_of(model: Model, states: States, shape: str, builder: Builder, folder: Path) -> float:
    plan = plan_of(model, 1)
    found = builder.solver(plan, shape=shape).solve(model, states, folder)
    return float(energy_errors(model, states, found).max())


@pytest.mark.parametrize("shape", spread(BASELINES, 1))
def test_a_baseline_solves_every_kind_of_joint(
    shape: str, builder: Builder, tmp_path: Path
) -> None:
    model = random_tree(np.random.default_rng(5), 12, floating=True)
    assert len({joint.kind for joint in model.joints}) >= 4
    assert error_of(model, random_states(model, 3), shape, builder, tmp_path) < 1e-11


@pytest.mark.slow
def test_the_textbook_loses_digits_on_spherical_joints_that_exact_projection_keeps(
    builder: Builder, tmp_path: Path
) -> None:
    """The state is that of the suite of cases where methods fail."""
    model = serial_chain(60, kind=SPHERICAL, mass=1.0, length=1.0, radius=0.05)
    i, k = np.arange(1, 61), np.arange(1, model.nv + 1)
    q = np.stack([np.sin(1.1 * i), np.cos(1.3 * i), np.sin(1.7 * i), np.cos(1.9 * i)], axis=1)
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    states = States(q.reshape(1, -1), np.cos(2.3 * k)[None], np.sin(3.1 * k)[None])
    exact = error_of(model, states, "aba_exact", builder, tmp_path)
    assert exact < 1e-12
    assert error_of(model, states, "aba", builder, tmp_path) > 10 * exact


def test_baselines_are_for_one_process_without_slaved_joints_and_never_chosen() -> None:
    chain = serial_chain(4)
    with pytest.raises(UsageError, match="one process"):
        chosen_shape(plan_of(chain, 2), "crba")
    slaved = random_tree(np.random.default_rng(1), 6, mimics=2)
    assert any(joint.mimic for joint in slaved.joints)
    with pytest.raises(UsageError, match="slaved"):
        chosen_shape(plan_of(slaved, 1), "aba")
    assert chosen_shape(plan_of(chain, 1)) in SHAPES
