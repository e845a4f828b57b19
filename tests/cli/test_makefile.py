"""Files that are generated are built by the Makefile beside them."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from adagen.build import find_toolchain
from adagen.cli import main
from tests.slow import slow

EIGEN = find_toolchain().eigen


@pytest.mark.parametrize("words", [slow(("--procs", "1")), ("--procs", "2", "--scalar", "float")])
def test_a_single_file_stands_alone(words: tuple[str, ...], arm: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert main([str(arm), *words, "--single-file", "--out", str(out)]) == 0
    assert not (out / "adagen_program.cpp").exists()
    (source,) = out.glob("*.cpp")
    assert "// links " not in source.read_text()
    assert main(["verify", str(out)]) == 0
    toolchain = find_toolchain()
    command = [
        "make",
        "-C",
        str(out),
        f"MPICXX={toolchain.mpicxx[0]}",
        "CXXFLAGS=-O1 -Wall -Wextra",
    ]
    command += [f"MPIEXEC={toolchain.mpiexec[0]}", "check"]
    environment = toolchain.variables(os.environ)
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=300)
    assert (done.returncode, done.stderr) == (0, "")
    assert ": right" in done.stdout


@pytest.mark.parametrize(("processes", "form"), [slow(1, "segment"), (2, "ada")])
def test_the_emitted_makefile_builds_and_checks(
    processes: int, form: str, arm: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    assert main([str(arm), "--procs", str(processes), "--form", form, "--out", str(out)]) == 0
    toolchain = find_toolchain()
    source = next(out.glob("*_p[0-9]*.cpp")).read_text()
    # Joints by themselves are written in 6x6 blocks; a straight line needs no Eigen.
    assert ("adagen/joins.hpp" in source) == (processes == 2)
    command = [
        "make",
        "-C",
        str(out),
        f"MPICXX={toolchain.mpicxx[0]}",
        f"MPIEXEC={toolchain.mpiexec[0]}",
        f"EIGEN={toolchain.eigen if processes == 2 else 'nowhere'}",
        "CXXFLAGS=-O1 -Wall -Wextra -Wpedantic -Werror",
        "check",
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    assert "right" in done.stdout


def said(folder: Path, *variables: str) -> list[list[str]]:
    """Return the words of each command that make says it would run."""
    command = ["make", "-n", "-C", str(folder), f"EIGEN={EIGEN}", *variables]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    lines = done.stdout.replace("\\\n", " ").splitlines()
    return [words for words in map(str.split, lines) if "-o" in words]


@pytest.fixture
def _default_options(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CXXFLAGS", raising=False)


@pytest.mark.usefixtures("_default_options")
def test_the_program_around_solvers_is_optimised_little(arm: Path, tmp_path: Path) -> None:
    assert main([str(arm), "--procs", "1", "--out", str(tmp_path)]) == 0

    def optimised(*variables: str) -> list[str]:
        commands = said(tmp_path, *variables)
        return [[word for word in words if word.startswith("-O")][-1] for words in commands]

    assert optimised() == ["-O1", "-O3"]  # the program, the solver
    assert optimised("CXXFLAGS=-O3 -g") == ["-O1", "-O3"]
    assert optimised("CXXFLAGS=-O2") == ["-O2", "-O2"]
    assert optimised("CXXFLAGS=-march=x86-64-v3") == ["-O1", "-O3"]


@pytest.mark.usefixtures("_default_options")
def test_options_of_yours_win_over_those_for_this_processor(arm: Path, tmp_path: Path) -> None:
    assert main([str(arm), "--procs", "1", "--out", str(tmp_path)]) == 0
    elsewhere = tmp_path / "other-g++"  # a compiler that does not know this processor
    elsewhere.write_text('#!/bin/sh\nfor word; do [ "$word" != -march=native ] || exit 1; done\n')
    elsewhere.chmod(0o755)

    def processors(*variables: str) -> set[tuple[str, ...]]:
        return {
            tuple(word for word in words if word.startswith(("-march", "-mcpu")))
            for words in said(tmp_path, *variables)
        }

    assert processors() == processors("CXXFLAGS=-O1") == {("-march=native",)}
    assert processors("CXXFLAGS=-march=x86-64-v3 -g") == {("-march=x86-64-v3",)}
    assert processors("CXXFLAGS=-mcpu=cortex-a72") == {("-mcpu=cortex-a72",)}
    assert processors(f"CXX={elsewhere}", "CXXFLAGS=-static") == {()}


@pytest.mark.parametrize("target", ["all", "lib"])
def test_an_mpi_compiler_that_is_not_there_is_named(target: str, arm: Path, tmp_path: Path) -> None:
    words = ["--procs", "2", "--form", "ada", "--channel", "message", "--out", str(tmp_path)]
    assert main([str(arm), *words]) == 0
    command = ["make", "-s", "-C", str(tmp_path), "MPICXX=nowhere/mpicxx", f"EIGEN={EIGEN}", target]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2
    assert "error: no compiler nowhere/mpicxx; say which one it is: make MPICXX=FILE" in done.stderr
    assert not list(tmp_path.glob("*.o"))
