"""Unit tests in C++ of the runtime's headers, with doctest: a program for each group of headers.

doctest.h (version 2.5.0, MIT licence) is a copy of its release, in the folder beside: neither PyPI
nor every machine has a package of it.
"""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
from pathlib import Path

import pytest

from adagen.build.toolchain import STANDARD, WARNINGS
from adagen.emit.runtime import include_folder, runtime_files
from tests.emitted import NARROW, QUICK, Builder
from tests.slow import slow

FOLDER = Path(__file__).parent
GROUPS = sorted(path.stem for path in FOLDER.glob("*_test.cpp"))


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
        *((group, NARROW) if group == "lanes_test" else slow(group, NARROW) for group in GROUPS),
    ],
    ids=[f"{group}-{registers}" for registers in ("wide", "narrow") for group in GROUPS],
)  # Eigen's blocks take 23 s; lanes alone depend on registers
def test_units(group: str, flags: tuple[str, ...], builder: Builder, tmp_path: Path) -> None:
    """With the sizes of the sample; registers as wide as here, and of 16 bytes."""
    if group == "blocks_test" and flags == QUICK:
        pytest.skip("no registers in its headers; g++ 12 warns of AVX-512 in Eigen/Dense")
    objects = [str(built(name, flags, builder)) for name in ("main", group)]
    program = tmp_path / "units"
    subprocess.run([*builder.toolchain.cxx, "-pthread", *objects, "-o", str(program)], check=True)
    done = subprocess.run([program], capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stdout
    assert re.search(r"test cases: +[1-9]\d* ", done.stdout)


def test_the_framework_is_beside_its_licence() -> None:
    version = re.findall(
        r"#define DOCTEST_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
        (FOLDER / "doctest" / "doctest.h").read_text(),
    )
    assert version == ["2", "5", "0"]
    assert "MIT License" in (FOLDER / "doctest" / "LICENSE.txt").read_text()
