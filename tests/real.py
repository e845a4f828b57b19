"""Real robots, of the package example-robot-data."""

from __future__ import annotations

from pathlib import Path

import pytest


def real_robot(description: str) -> Path:
    """Return the file of a robot's description; tests that need it skip without the package.

    Args:
        description: its path in the package's folder of robots.
    """
    from importlib.metadata import PackageNotFoundError, files

    try:
        listed = files("example-robot-data") or []
    except PackageNotFoundError:
        pytest.skip("example-robot-data is not installed")
    for file in listed:
        if str(file).endswith(f"/robots/{description}"):
            return Path(str(file.locate())).resolve()
    raise AssertionError(f"{description} is not in example-robot-data")
