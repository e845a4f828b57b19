"""Sizes of a core's caches, as Linux tells them, and registers, as the compiler does."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

from adagen.build import Toolchain
from adagen.build.cache import run_compiler

CACHES = Path("/sys/devices/system/cpu/cpu0/cache")
_REGISTERS = {"__AVX512F__": 64, "__AVX__": 32}  # as registers.hpp has it, else 16
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


def widest_register(toolchain: Toolchain) -> int:
    """Return the bytes of the widest registers that a compiler takes for numbers.

    Its options decide on that: programs may be built for narrower ones than this machine's.

    Args:
        toolchain: the compiler and its options.

    Raises:
        EnvironmentFault: the compiler cannot be run.
    """
    command = [*toolchain.cxx, *toolchain.flags, "-dM", "-E", "-x", "c++", os.devnull]
    done = run_compiler(command, toolchain)
    macros = {words[1] for line in done.stdout.splitlines() if len(words := line.split()) > 1}
    return next((width for name, width in _REGISTERS.items() if name in macros), 16)


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
