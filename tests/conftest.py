"""Fixtures that every test may use."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="session")
def shared() -> Path:
    """The folder of shared robots with true answers; tests that need it skip where it is absent."""
    folder = ROOT.parent / "shared" / "robots"
    if not folder.is_dir():
        pytest.skip("the shared robots are not beside this checkout")
    return folder
