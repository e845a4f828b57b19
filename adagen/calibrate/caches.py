"""Sizes of a core's caches, as Linux tells them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

CACHES = Path("/sys/devices/system/cpu/cpu0/cache")
_BYTES = {"": 1, "K": 1 << 10, "M": 1 << 20}


def instruction_cache(caches: Path = CACHES) -> int | None:
    """Return the bytes of a core's first instruction cache; None where that is not told.

    Args:
        caches: folder with a folder for each cache, as sysfs has it.
    """
    return _first(caches, "1", ("Instruction", "Unified"))


def second_cache(caches: Path = CACHES) -> int | None:
    """Return the bytes of a core's second-level cache; None where that is not told.

    Args:
        caches: folder with a folder for each cache, as sysfs has it.
    """
    return _first(caches, "2", ("Data", "Unified"))


def _first(caches: Path, level: str, kinds: tuple[str, ...]) -> int | None:
    """Bytes of the first cache of a level and of some kinds."""
    told = _told(caches)
    return next((size for at, kind, size in told if at == level and kind in kinds), None)


def _told(caches: Path) -> Iterator[tuple[str, str, int]]:
    """The level, kind and bytes of each cache whose size is told."""
    for cache in sorted(caches.glob("index*")):
        try:
            level, kind, size = (
                (cache / name).read_text(encoding="ascii").strip()
                for name in ("level", "type", "size")
            )
        except (OSError, UnicodeDecodeError):
            continue
        found = re.fullmatch(r"(\d+)([KM]?)", size)
        if found and int(found[1]):
            yield level, kind, int(found[1]) * _BYTES[found[2]]
