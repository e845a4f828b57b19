"""Solvers cannot be compiled with arithmetic that makes their answers wrong."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

import adagen
from adagen.atomic_files import write_files
from tests.emitted import Builder
from tests.golden.make_models import MODELS
from tests.slow import spread

SOURCES: dict[str, dict[str, Any]] = {
    "straight line": {"shape": "unrolled"},
    "loops": {"shape": "kernels"},
    "joint by joint": {"form": "ada", "shape": "joints"},
    "batch": {"batch": True},
    "embedded": {"target": "embedded"},
}
FIRST_ONLY = "-Wfatal-errors"  # the rest of the text is not read
FLAGS = ("-ffast-math", "-Ofast", "-ffinite-math-only", "-funsafe-math-optimizations")


def refusals(source: Path, compiler: str, flag: str, builder: Builder) -> str:
    """Return what a compiler says of a source, which it must refuse."""
    command = [compiler, "-std=c++17", "-isystem", str(builder.toolchain.eigen), "-c", FIRST_ONLY]
    done = subprocess.run(
        [*command, flag, source.name, "-o", "solver.o"],
        capture_output=True, text=True, check=False, cwd=source.parent,
    )  # fmt: skip
    assert done.returncode != 0
    return done.stderr


@pytest.mark.parametrize(
    ("name", "flag"), spread([(name, flag) for name in SOURCES for flag in FLAGS], 5)
)
def test_unsafe_arithmetic_is_not_compiled(
    name: str, flag: str, builder: Builder, tmp_path: Path
) -> None:
    compiled = adagen.compile(adagen.read(MODELS / "arm7.urdf"), procs=1, **SOURCES[name])
    write_files(tmp_path, compiled.files)
    source = tmp_path / f"{compiled.stem}.cpp"
    compiler = builder.toolchain.cxx[0]
    assert "compile solvers without -ffast-math" in refusals(source, compiler, flag, builder)


@pytest.mark.parametrize("flag", ["-ffast-math", "-Ofast", "-ffinite-math-only"])
def test_nor_is_it_by_clang_and_around_a_solver(
    flag: str, builder: Builder, tmp_path: Path
) -> None:
    compiled = adagen.compile(adagen.read(MODELS / "arm7.urdf"), procs=1)
    write_files(tmp_path, compiled.files)
    compilers = [builder.toolchain.cxx[0], *(["clang++"] if shutil.which("clang++") else [])]
    for compiler in compilers:
        for source in (f"{compiled.stem}.cpp", "adagen_program.cpp"):
            said = refusals(tmp_path / source, compiler, flag, builder)
            assert "compile solvers without -ffast-math" in said
