"""Size of the first instruction cache, as Linux tells it."""

from __future__ import annotations

import re
from pathlib import Path

CACHES = Path("/sys/devices/system/cpu/cpu0/cache")
_BYTES = {"": 1, "K": 1 << 10, "M": 1 << 20}


def instruction_cache(caches: Path = CACHES) -> int | None:
    """Return the bytes of a core's first instruction cache; None where that is not told.

    Args:
        caches: folder with a folder for each cache, as sysfs has it.
    """
    for cache in sorted(caches.glob("index*")):
        try:
            level, kind, size = (
                (cache / name).read_text(encoding="ascii").strip()
                for name in ("level", "type", "size")
            )
        except (OSError, UnicodeDecodeError):
            continue
        found = re.fullmatch(r"(\d+)([KM]?)", size)
        if level == "1" and kind in ("Instruction", "Unified") and found:
            return int(found[1]) * _BYTES[found[2]] or None
    return None
