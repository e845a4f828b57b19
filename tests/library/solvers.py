"""Robots of the library's tests, built, and their states with true answers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import adagen
from adagen.states import random_states
from tests.emitted import truth_of
from tests.golden.make_models import MODELS

ARM, MOBILE = MODELS / "arm7.urdf", MODELS / "mobile.urdf"


def build(path: Path, **asked: Any) -> adagen.Solver:
    return adagen.compile(adagen.read(path), **asked).build()


def states(solver: adagen.Solver, count: int) -> tuple[Any, Any, Any, Any]:
    """Return q, v, tau and the true accelerations of random states."""
    model = solver.compiled.model
    some = random_states(model, count, seed=2)
    return some.q, some.v, some.tau, truth_of(model, some)
