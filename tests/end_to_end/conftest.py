"""Built examples that are run, as fixtures."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.emitted import Builder
from tests.end_to_end.subjects import Subject, subject


@pytest.fixture
def arm(builder: Builder, tmp_path: Path) -> Subject:
    return subject("arm7_p2", builder, tmp_path)


@pytest.fixture
def human(builder: Builder, tmp_path: Path) -> Subject:
    return subject("human40_p4", builder, tmp_path)
