"""Which processor this is, as Linux tells it."""

from __future__ import annotations

import platform
import re
from pathlib import Path

TOLD = Path("/proc/cpuinfo")


def told(key: str, file: Path = TOLD) -> list[str]:
    """Return what is told of each core under a key; nothing where nothing is told.

    Args:
        key: such as "model name".
        file: where Linux tells it.
    """
    try:
        text = file.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return []
    return re.findall(rf"^{re.escape(key)}\s*: *(.*)$", text, re.MULTILINE)


def processor_name() -> str:
    """Return the processor's name."""
    return next(iter(told("model name")), "") or platform.processor() or platform.machine()


def processor_family(file: Path = TOLD) -> tuple[str, int] | None:
    """Return the maker's name and the family of an x86 processor; None if that is not told.

    Args:
        file: where Linux tells it.
    """
    makers, families = told("vendor_id", file), told("cpu family", file)
    return (makers[0], int(families[0])) if makers and families else None
