"""Which SIMD registers the compiler at hand makes use of."""

from __future__ import annotations

import os
import platform
from pathlib import Path

import pytest

from adagen.build.registers import Registers, find_registers

PLAIN = {"PATH": os.environ["PATH"]}


def compiler(folder: Path, *lines: str, status: int = 0) -> dict[str, str]:
    """Return variables that choose a compiler that says ``lines``."""
    file = folder / "cc"
    said = "".join(f"echo '{line}'\n" for line in lines)
    file.write_text(f"#!/bin/sh\n{said}exit {status}\n")
    file.chmod(0o755)
    return {**PLAIN, "CXX": str(file)}


@pytest.mark.parametrize(
    ("macros", "bits"),
    [
        (["__x86_64__", "__AVX__", "__AVX512F__"], 512),
        (["__AVX__", "__AVX2__", "__x86_64__"], 256),
        (["__x86_64__", "__SSE2__"], 128),
        (["__aarch64__"], None),
    ],
)
def test_the_widest_counts(macros: list[str], bits: int | None, tmp_path: Path) -> None:
    found = find_registers(compiler(tmp_path, *(f"#define {macro} 1" for macro in macros)))
    assert found == (None if bits is None else Registers(bits, halved=False))
    assert found is None or found.hold_parts == (bits == 512)


def test_clang_holds_wide_vectors_in_several(tmp_path: Path) -> None:
    macros = ("__x86_64__", "__AVX__", "__clang__")
    found = find_registers(compiler(tmp_path, *(f"#define {macro} 1" for macro in macros)))
    assert found == Registers(256, halved=True)
    assert found.hold_parts


def test_it_is_unknown_without_a_compiler_that_tells(tmp_path: Path) -> None:
    failing = compiler(tmp_path, "#define __AVX__ 1", "#define __x86_64__ 1", status=1)
    assert find_registers(failing) is None
    assert find_registers({**PLAIN, "CXX": str(tmp_path / "none")}) is None
    assert find_registers({**PLAIN, "CXXFLAGS": "'"}) is None


@pytest.mark.skipif(platform.machine() != "x86_64", reason="options of x86-64")
def test_options_of_the_user_decide() -> None:
    for option, bits in (("haswell", 256), ("skylake-avx512", 512), ("x86-64", 128)):
        found = find_registers({**PLAIN, "CXXFLAGS": f"-march={option}"})
        assert found is not None
        assert found.bits == bits
