"""Solvers that several tests call."""

from __future__ import annotations

import pytest

import adagen
from tests.library.solvers import ARM, MOBILE, build


@pytest.fixture(scope="module")
def arm() -> adagen.Solver:
    return build(ARM)


@pytest.fixture(scope="module")
def mobile() -> adagen.Solver:
    return build(MOBILE)
