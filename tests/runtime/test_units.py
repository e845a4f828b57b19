"""Unit tests in C++ of the runtime's headers, with doctest: a program for each group of headers.

doctest.h (version 2.5.0, MIT licence) is a copy of its release, in the folder beside: neither PyPI
nor every machine has a package of it.
"""

from __future__ import annotations

import hashlib
import os
import platform
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from adagen.build.toolchain import STANDARD, WARNINGS
from adagen.emit.runtime import include_folder, runtime_files
from tests.emitted import HALVED, NARROW, QUICK, Builder
from tests.slow import slow

FOLDER = Path(__file__).parent
GROUPS = sorted(path.stem for path in FOLDER.glob("*_test.cpp"))
LANES = ("lanes_test", "rows_test")
"""Those that depend on registers."""
REGISTERS = {"x86-64-v2": 16, "x86-64-v3": 32, "x86-64-v4": 64}
"""Their bytes in kinds of processors."""
ARM = "aarch64-linux-gnu-g++"


def built(name: str, flags: tuple[str, ...], builder: Builder) -> Path:
    """Return the object of a source of this folder, compiled if anything of it has changed."""
    source = FOLDER / f"{name}.cpp"
    words = [*STANDARD, *WARNINGS, "-Werror", "-Wno-unused-function", *flags, "-pthread"]
    words += [f"-I{FOLDER}", f"-I{include_folder()}"]
    words += ["-isystem", str(FOLDER / "doctest"), "-isystem", str(builder.toolchain.eigen)]
    command = [*builder.toolchain.cxx, *words]
    texts = [*command, source.read_text(), (FOLDER / "near.hpp").read_text()]
    if name != "main":
        texts += runtime_files().values()
    made = builder.folder / f"{hashlib.sha256(chr(0).join(texts).encode()).hexdigest()}.o"
    if not made.is_file():
        builder.folder.mkdir(parents=True, exist_ok=True)
        own = made.with_suffix(f".{os.getpid()}.o")  # others may make the same
        done = subprocess.run(
            [*command, "-c", str(source), "-o", str(own)], capture_output=True, text=True
        )
        assert (done.returncode, done.stderr) == (0, "")
        own.replace(made)
    return made


@pytest.mark.parametrize(
    ("group", "flags"),
    [
        *((group, QUICK) if group != "blocks_test" else slow(group, QUICK) for group in GROUPS),
        *((group, NARROW) if group in LANES else slow(group, NARROW) for group in GROUPS),
        ("rows_test", HALVED),
    ],
    ids=[f"{group}-{registers}" for registers in ("wide", "narrow") for group in GROUPS]
    + ["rows_test-halved"],
)  # Eigen's blocks take 23 s
def test_units(group: str, flags: tuple[str, ...], builder: Builder, tmp_path: Path) -> None:
    """With the sizes of the sample; registers as wide as here, of 16 bytes, and of 32."""
    if group == "blocks_test" and flags == QUICK:
        pytest.skip("no registers in its headers; g++ 12 warns of AVX-512 in Eigen/Dense")
    objects = [str(built(name, flags, builder)) for name in ("main", group)]
    program = tmp_path / "units"
    subprocess.run([*builder.toolchain.cxx, "-pthread", *objects, "-o", str(program)], check=True)
    done = subprocess.run([program], capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stdout
    assert re.search(r"test cases: +[1-9]\d* ", done.stdout)


def said(compiler: str, text: str, *flags: str) -> str:
    """Return what a compiler says of a text that includes the runtime."""
    words = [*STANDARD, *WARNINGS, *flags, f"-I{include_folder()}", "-fsyntax-only", "-xc++", "-"]
    done = subprocess.run([compiler, *words], input=text, capture_output=True, text=True)
    return done.stderr


@pytest.mark.parametrize("processor", [*REGISTERS, "aarch64"])
def test_a_register_of_a_batch_is_one_of_the_machine(processor: str, builder: Builder) -> None:
    """Lanes of single states are those of the plan, whatever the machine."""
    compiler, flags, width = ARM, list[str](), 16
    if processor == "aarch64":
        if shutil.which(ARM) is None:
            pytest.skip(f"{ARM} is not installed: see docs/how_to/building.md")
    elif platform.machine() == "x86_64":
        compiler, flags = builder.toolchain.cxx[0], [f"-march={processor}"]
        width = REGISTERS[processor]
    else:
        pytest.skip("the compiler is for other processors")
    text = '#include "adagen/value.hpp"\nstatic_assert(sizeof(Lanes) == {});\n'
    assert said(compiler, text.format(width), "-DADAGEN_BATCH", *flags) == ""
    assert said(compiler, text.format(64), *flags) == ""
    by_state = ("-DADAGEN_BATCH", "-DADAGEN_STATE_BY_STATE")
    assert said(compiler, text.format(64), *by_state, *flags) == ""


def test_the_framework_is_beside_its_licence() -> None:
    version = re.findall(
        r"#define DOCTEST_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
        (FOLDER / "doctest" / "doctest.h").read_text(),
    )
    assert version == ["2", "5", "0"]
    assert "MIT License" in (FOLDER / "doctest" / "LICENSE.txt").read_text()
