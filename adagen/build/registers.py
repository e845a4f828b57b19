"""How wide the registers are that a compiler takes for numbers."""

from __future__ import annotations

import os

from adagen.build.cache import run_compiler
from adagen.build.toolchain import Toolchain
from adagen.errors import EnvironmentFault, printable

_REGISTERS = {"__AVX512F__": 64, "__AVX__": 32}
"""Bytes by macro, as registers.hpp has it; else 16."""


def widest_register(toolchain: Toolchain) -> int:
    """Return the bytes of the widest registers that a compiler takes for numbers.

    Its options decide on that: programs may be built for narrower ones than this machine's.

    Args:
        toolchain: the compiler and its options.

    Raises:
        EnvironmentFault: the compiler cannot be run, or refuses its options.
    """
    command = [*toolchain.cxx, *toolchain.flags, "-dM", "-E", "-x", "c++", os.devnull]
    done = run_compiler(command, toolchain)
    if done.returncode != 0:
        said = printable(" ".join(done.stderr.split()))[:300]
        raise EnvironmentFault(f"{toolchain.cxx[0]} refuses its options: {said or 'no message'}")
    macros = {words[1] for line in done.stdout.splitlines() if len(words := line.split()) > 1}
    return next((width for name, width in _REGISTERS.items() if name in macros), 16)
