"""Sizes of a core's caches and registers, as Linux tells them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

CACHES = Path("/sys/devices/system/cpu/cpu0/cache")
PROCESSORS = Path("/proc/cpuinfo")
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


def processor_flags(processors: Path = PROCESSORS) -> frozenset[str]:
    """Return what an x86 processor can, as Linux names it; nothing of others.

    Args:
        processors: a text like that of procfs.
    """
    try:
        text = processors.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return frozenset()
    lines = (line.split() for line in text.splitlines() if line.startswith("flags"))
    return frozenset(next(lines, []))


def widest_register(processors: Path = PROCESSORS) -> int:
    """Return the bytes of the widest registers that compilers take for numbers.

    Args:
        processors: a text like that of procfs.
    """
    flags = processor_flags(processors)
    return 64 if "avx512f" in flags else 32 if "avx" in flags else 16


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
