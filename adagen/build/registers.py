"""Which SIMD registers the compiler at hand makes use of, by the macros that it defines."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass

from adagen.build.toolchain import find_compiler, find_flags
from adagen.errors import EnvironmentFault

_PATIENCE = 5.0  # seconds; it takes some 10 ms
_WIDEST_FIRST = (("__AVX512F__", 512), ("__AVX__", 256), ("__x86_64__", 128))


@dataclass(frozen=True)
class Registers:
    """The registers that solvers use that are built here.

    Attributes:
        bits: the width of the widest ones.
        halved: whether the compiler puts wider vectors into several of them, as clang++ does; g++
            keeps such vectors in memory.
    """

    bits: int
    halved: bool

    @property
    def hold_parts(self) -> bool:
        """Whether they hold a number of each of eight parts of a chain."""
        return self.bits >= 512 or self.halved


def find_registers(environ: Mapping[str, str] | None = None) -> Registers | None:
    """Return what registers solvers use that are built here.

    Args:
        environ: environment variables, those of this process by default; see ``find_toolchain``.

    Returns:
        None where it is not known: without a compiler, or on other processors than x86-64.
    """
    environ = os.environ if environ is None else environ
    try:
        command = [*find_compiler(environ), *find_flags(environ), "-dM", "-E", "-x", "c++", "-"]
        told = subprocess.run(
            command,
            input="",
            capture_output=True,
            text=True,
            check=True,
            timeout=_PATIENCE,
            env=dict(environ),
        ).stdout
    except (EnvironmentFault, OSError, subprocess.SubprocessError):
        return None
    macros = {words[1] for words in map(str.split, told.splitlines()) if len(words) > 1}
    bits = next((bits for macro, bits in _WIDEST_FIRST if macro in macros), None)
    return None if bits is None else Registers(bits, "__clang__" in macros)
