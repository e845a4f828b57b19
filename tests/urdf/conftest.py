"""Fixtures of the URDF stage."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from adagen.errors import InputError
from adagen.urdf import Reading, read_robot


@pytest.fixture
def read(tmp_path: Path) -> Callable[..., Reading]:
    """Write a text to a file and read it as a robot."""

    def reader(text: str | bytes, **options: Any) -> Reading:
        path = tmp_path / "robot.urdf"
        path.write_bytes(text.encode() if isinstance(text, str) else text)
        return read_robot(path, **options)

    return reader


@pytest.fixture
def refusal(tmp_path: Path, read: Callable[..., Reading]) -> Callable[..., str]:
    """Return the line with which a text is refused, the folder cut from its start."""

    def refused(text: str | bytes, **options: Any) -> str:
        with pytest.raises(InputError) as caught:
            read(text, **options)
        line = str(caught.value)
        assert "\n" not in line
        assert caught.value.status == 1
        return line.removeprefix(f"{tmp_path}/")

    return refused
