"""Fresh copies of a program for timing, so that its memory pages lie elsewhere each time."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def fresh_copy(executable: Path) -> Iterator[Path]:
    """Lend a copy of a program.

    Where in memory a file's pages lie decides how its code shares caches, for as long as the file
    is kept in memory: small solvers differ by a third. Copies lie elsewhere each time.
    """
    with tempfile.TemporaryDirectory(prefix="adagen-") as folder:
        copy = Path(folder, executable.name)
        shutil.copy2(executable, copy)
        yield copy
