"""Which processor this is."""

from __future__ import annotations

import re
from pathlib import Path

TOLD = Path("/proc/cpuinfo")


def processor(told: Path = TOLD) -> tuple[str, int] | None:
    """Return the maker's name and the family of this machine's processor.

    Args:
        told: where Linux tells it.

    Returns:
        None if it is no x86 processor, or the system does not tell.
    """
    try:
        text = told.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return None
    maker = re.search(r"^vendor_id\s*: (\S+)$", text, re.MULTILINE)
    family = re.search(r"^cpu family\s*: (\d+)$", text, re.MULTILINE)
    return (maker[1], int(family[1])) if maker and family else None
