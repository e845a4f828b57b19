"""Which processes of a program are alive."""

from __future__ import annotations

import os
from pathlib import Path


def running(executable: Path) -> list[int]:
    """Return the processes whose program is ``executable``, ascending."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if os.path.realpath(folder / "exe") == str(executable.resolve()):
                found.append(int(folder.name))
        except OSError:
            continue
    return sorted(found)
