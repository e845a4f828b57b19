"""Folders of emitted solvers, as make, CMake and pkg-config build and find what is in them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from adagen.emit.solver_program import PROGRAM_FILE
from adagen.states import random_states
from tests.emitted import ROUNDING, Builder, forward_error, truth_of
from tests.end_to_end.test_library import BY_STEM, filled
from tests.golden.examples import FOLDER

PROJECT = """\
cmake_minimum_required(VERSION 3.16)
project(controller LANGUAGES C CXX)
FINDING
add_executable(controller controller.c)
set_target_properties(controller PROPERTIES C_STANDARD 99 C_EXTENSIONS OFF)
target_link_libraries(controller PRIVATE adagen::mobile_p1)
"""


@pytest.fixture
def solvers(tmp_path: Path) -> Path:
    """A folder with a solver for one process and one for two."""
    for stem in ("mobile_p1", "arm7_p2"):
        shutil.copytree(FOLDER / stem, tmp_path / "solvers", dirs_exist_ok=True)
    shutil.copy(FOLDER / PROGRAM_FILE, tmp_path / "solvers")
    shutil.copytree(FOLDER / "adagen", tmp_path / "solvers" / "adagen")
    return tmp_path / "solvers"


def run(*command: str | Path, **variables: str) -> str:
    """Return what a command prints; it must end well."""
    words = [str(word) for word in command]
    environment = {**os.environ, **variables}
    done = subprocess.run(words, capture_output=True, text=True, timeout=300, env=environment)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "warning" not in done.stderr.lower(), done.stderr
    return done.stdout


FAST = "-DADAGEN_FLAGS=-O1;-march=native"


def settings(builder: Builder) -> list[str]:
    """Return what CMake is told: where MPI and Eigen are, and to compile fast."""
    return [
        f"-DMPI_CXX_COMPILER={builder.toolchain.mpicxx[0]}",
        f"-DEIGEN={builder.toolchain.eigen}",
        FAST,
    ]


def check(program: Path, folder: Path) -> None:
    """Have the program of controller.c solve states, and look at its answers."""
    model = BY_STEM["mobile_p1"].model()
    states = random_states(model, 2, seed=5)
    rows = [np.concatenate(row) for row in states.each]
    np.savetxt(folder / "states", rows, fmt="%.17g")
    lines = run(program, folder / "states").splitlines()
    found = np.array([line.split() for line in lines], dtype=float)
    assert forward_error(found, truth_of(model, states)) < ROUNDING["double"]


@pytest.fixture
def project(tmp_path: Path) -> Path:
    folder = tmp_path / "project"
    folder.mkdir()
    (folder / "controller.c").write_text(filled("controller.c", "mobile_p1"))
    return folder


def test_cmake_builds_all_as_part_of_a_project(
    solvers: Path, project: Path, builder: Builder, tmp_path: Path
) -> None:
    finding = f'add_compile_options(-ffast-math)\nadd_subdirectory("{solvers}" solvers)'
    text = PROJECT.replace("FINDING", finding)  # solvers take no such arithmetic
    (project / "CMakeLists.txt").write_text(text)
    build = tmp_path / "build"
    run("cmake", "-S", project, "-B", build, *settings(builder))
    run("cmake", "--build", build)
    check(build / "controller", tmp_path)
    assert (build / "solvers" / "libarm7_p2.a").is_file()


def test_cmake_finds_what_is_installed(solvers: Path, project: Path, tmp_path: Path) -> None:
    own, prefix, build = tmp_path / "own", tmp_path / "prefix", tmp_path / "build"
    for name in ("arm7_p2.cpp", "arm7_p2.h"):
        (solvers / name).unlink()
    run("cmake", "-S", solvers, "-B", own, FAST, "-DBUILD_SHARED_LIBS=ON",
        f"-DCMAKE_INSTALL_PREFIX={prefix}")  # fmt: skip
    run("cmake", "--build", own)
    run("cmake", "--install", own)
    text = PROJECT.replace("FINDING", "find_package(mobile_p1 REQUIRED)")
    (project / "CMakeLists.txt").write_text(text)
    run("cmake", "-S", project, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", build)
    check(build / "controller", tmp_path)


EMITTING = """\
cmake_minimum_required(VERSION 3.16)
project(controller LANGUAGES C CXX)
find_package(adagen REQUIRED)
adagen_add_solver(mobile MODEL mobile.urdf PROCS 1 OPTIONS --shape kernels)
add_executable(controller controller.c)
set_target_properties(controller PROPERTIES C_STANDARD 99 C_EXTENSIONS OFF)
target_link_libraries(controller PRIVATE mobile)
"""


def test_cmake_has_solvers_emitted(project: Path, tmp_path: Path) -> None:
    shutil.copy(FOLDER / "models" / "mobile.urdf", project)
    (project / "CMakeLists.txt").write_text(EMITTING)
    command = Path(sys.executable).with_name("adagen")
    folder, build = run(command, "--cmake-dir").strip(), tmp_path / "build"
    words = ("-S", project, "-B", build, f"-Dadagen_DIR={folder}", FAST)
    run("cmake", *words, f"-DADAGEN_PROGRAM={command}")
    run("cmake", "--build", build)
    check(build / "controller", tmp_path)

    source = build / "mobile" / "mobile_p1.cpp"
    written = source.stat().st_mtime_ns
    run("cmake", "-S", project, "-B", build)
    assert source.stat().st_mtime_ns == written  # it is right already
    (project / "mobile.urdf").write_text("<robot name='none'/>")
    failed = subprocess.run(["cmake", "--build", str(build)], capture_output=True, text=True)
    assert failed.returncode != 0
    assert "mobile.urdf" in failed.stderr


def test_pkg_config_finds_what_make_has_built(solvers: Path, project: Path, tmp_path: Path) -> None:
    run("make", "-C", solvers, "SOLVER=mobile_p1", "lib")
    said = run("pkg-config", "--cflags", "--libs", "mobile_p1", PKG_CONFIG_PATH=str(solvers))
    program = project / "controller"
    run("cc", "-std=c99", project / "controller.c", *said.split(), "-o", program)
    check(program, tmp_path)


def test_make_builds_all_solvers_and_asks_which_one_is_to_run(
    solvers: Path, builder: Builder
) -> None:
    toolchain = builder.toolchain
    given = [f"MPICXX={toolchain.mpicxx[0]}", f"MPIEXEC={toolchain.mpiexec[0]}"]
    given += [f"EIGEN={toolchain.eigen}", "CXXFLAGS=-O1"]
    said = run("make", "-C", solvers, *given, "check")
    assert said.count(": right") == 2
    assert "make" in run("make", "-C", solvers, *given, "all")
    assert run("make", "-s", "-C", solvers, *given, "all") == ""  # nothing is built twice
    done = subprocess.run(
        ["make", "-C", str(solvers), *given, "run"], capture_output=True, text=True, timeout=60
    )
    assert done.returncode != 0
    assert "say which solver: make run SOLVER=NAME_pP (arm7_p2 mobile_p1)" in done.stderr
