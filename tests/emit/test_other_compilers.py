"""What versions of g++ and clang++ beside the usual ones say of emitted code: nothing.

Those of the kind g++-11 and clang++-16 that are installed are asked, and clang++ with the standard
library of LLVM.
"""

from __future__ import annotations

import os
import platform
import re
import subprocess
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path

import pytest

from adagen.emit import emit, stem_of
from adagen.emit.solver_program import program_text
from adagen.plan import Plan
from benchmarks.stability.bounds import certified_plan
from tests.emit.test_compilers import BY_STEM, text
from tests.emitted import Builder
from tests.models import serial_chain, star
from tests.slow import slow

WIDE = ("-march=x86-64-v4",) if platform.machine() == "x86_64" else ()
FLAGS = ("-fsyntax-only", "-O2", *WIDE)  # warnings come from the front end
QUIET = "-Wno-unused-command-line-argument"  # what the linker is told is not used here
NAMED = re.compile(r"(g|clang)\+\+-\d+")
LLVM = "-stdlib=libc++"


def _in_loops(plan: Plan) -> str:
    return emit(plan, shape="kernels")[f"{stem_of(plan)}.cpp"]


SOURCES: dict[str, Callable[[], str]] = {
    "certified on two processes": lambda: _in_loops(certified_plan(star(4, 3), processes=2)),
    "certified in parts": lambda: _in_loops(certified_plan(serial_chain(30), parts=True)),
    "in strips": lambda: _in_loops(certified_plan(serial_chain(30))),
    "refined": lambda: text(BY_STEM["arm7_refined_p2"]),
    "joint by joint": lambda: text(BY_STEM["chain16_p3"]),
    "lanes": lambda: text(BY_STEM["humanoid_lanes_p1"]),
    "line": lambda: text(BY_STEM["fourbar_p1"]),
    "program": program_text,
}


@cache
def installed() -> tuple[str, ...]:
    """Return the compilers with a version in their names."""
    folders = map(Path, os.environ["PATH"].split(os.pathsep))
    return tuple(sorted({e.name for f in folders for e in entries(f) if NAMED.fullmatch(e.name)}))


def entries(folder: Path) -> Iterator[Path]:
    """Yield what lies in a folder that may not be there."""
    if folder.is_dir():
        yield from folder.iterdir()


@pytest.mark.parametrize(
    "what", [what if what.startswith("certified") else slow(what) for what in SOURCES]
)
def test_the_usual_one(what: str, builder: Builder) -> None:
    builder.check(SOURCES[what](), "other", FLAGS)


@pytest.mark.slow
@pytest.mark.parametrize("what", SOURCES)
def test_every_version(what: str, builder: Builder) -> None:
    if not installed():
        pytest.skip("no g++-N or clang++-N is installed")
    for name in installed():
        other = builder.with_compiler(name)
        quiet = (QUIET,) if name.startswith("clang") else ()
        other.check(SOURCES[what](), "other", (*FLAGS, *quiet))
        if name.startswith("clang") and _has_library_of_llvm(name):
            other.check(SOURCES[what](), "other", (*FLAGS, QUIET, LLVM))


@cache
def _has_library_of_llvm(name: str) -> bool:
    words = [name, LLVM, "-x", "c++", "-std=c++17", "-fsyntax-only", "-"]
    source = "#include <vector>"
    done = subprocess.run(words, input=source, text=True, capture_output=True, timeout=60)
    return done.returncode == 0 and not done.stderr  # some say that they are too old for it
