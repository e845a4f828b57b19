"""A small robot, and what the command line said, as fixtures."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.robots import Said, write_arm


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    return write_arm(tmp_path / "arm.urdf")


@pytest.fixture
def said(capsys: pytest.CaptureFixture[str]) -> Said:
    """What was said to stdout and stderr since the last call."""

    def read() -> tuple[str, str]:
        out, err = capsys.readouterr()
        return out, err

    return read
