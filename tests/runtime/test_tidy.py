"""clang-tidy and clangd have nothing to say of the runtime: .clang-tidy says what is asked."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from adagen.emit.runtime import include_folder
from tests.emitted import Builder
from tests.golden.examples import FOLDER as EXAMPLES
from tests.runtime.test_units import FOLDER, GROUPS
from tests.slow import only

ROOT = FOLDER.parents[1]
EMITTED = ("arm7_unrolled_p1", "humanoid_p2", "arm7_refined_p2", "arm7_batch_p2", "fourbar_p1")
"""Sources that include most of the headers that the unit tests do not."""


def tool(name: str) -> str:
    """Return the path of a tool that pip has installed, or that of the system."""
    found = shutil.which(name, path=str(Path(sys.executable).parent)) or shutil.which(name)
    if found is None:
        pytest.skip(f"{name} is not installed: pip install {name}")
    return found


def words(builder: Builder) -> list[str]:
    """Return the options that a source of this folder is compiled with."""
    folders = [f"-I{FOLDER}", f"-I{include_folder()}"]
    outside = [FOLDER / "doctest", builder.toolchain.eigen, Path(sys.prefix, "include")]
    return [
        *("-std=c++17", "-march=x86-64-v3", "-pthread", *folders),
        *(word for path in outside for word in ("-isystem", str(path))),
    ]


SAMPLE = FOLDER / "lanes_test.cpp"
SOURCES = [path for group in GROUPS if (path := FOLDER / f"{group}.cpp") != SAMPLE]
MORE = [EXAMPLES / stem / f"{stem}.cpp" for stem in EMITTED] + [EXAMPLES / "adagen_program.cpp"]


@pytest.mark.parametrize(
    "source",
    [SAMPLE, *(pytest.param(path, marks=pytest.mark.slow) for path in [*SOURCES, *MORE])],
    ids=lambda path: path.stem,
)
def test_clang_tidy_has_nothing_to_say(source: Path, builder: Builder) -> None:
    command = [tool("clang-tidy"), "--quiet", f"--config-file={ROOT / '.clang-tidy'}", str(source)]
    done = subprocess.run(
        [*command, "--", *words(builder)], capture_output=True, text=True, timeout=600
    )
    said = re.findall(r"^.*(?:error|warning): .*$", done.stdout, re.MULTILINE)
    assert (done.returncode, said) == (0, []), done.stderr


QUICKLY = ("adagen/articulated.hpp", "adagen/kernels/strips.hpp")
HEADERS = [str(h.relative_to(include_folder())) for h in sorted(include_folder().rglob("*.hpp"))]


@pytest.mark.parametrize("header", only(HEADERS, *QUICKLY))
def test_clangd_finds_no_errors(header: str, builder: Builder, tmp_path: Path) -> None:
    """As an editor shows it: by itself, with the sizes of the sample.

    The whole file is checked; what clangd offers at a place (tweaks) is tried in the first line.
    """
    flags = "\n".join(["-xc++", *words(builder)])
    (tmp_path / "compile_flags.txt").write_text(flags)
    command = [tool("clangd"), f"--check={include_folder() / header}", "--check-lines=1-1"]
    done = subprocess.run(
        [*command, f"--compile-commands-dir={tmp_path}", "--log=error"],
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr
