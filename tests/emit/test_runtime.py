"""The runtime: headers that compile alone, and solvers of all kinds in one program."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path
from posixpath import dirname, normpath
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.build.toolchain import STANDARD, WARNINGS
from adagen.emit import emit, stem_of
from adagen.emit.runtime import (
    include_folder,
    joined,
    runtime_files,
    version_number,
)
from adagen.emit.solver_program import program_text, standalone
from adagen.states import random_states
from tests.emitted import QUICK, ROUNDING, Builder, forward_error, plan_of, truth_of
from tests.golden.examples import FOLDER
from tests.slow import spread

HEADERS = runtime_files()
ALONE = ("-march=native", "-fsyntax-only", "-Wno-unused-function", "-Wno-unused-variable")
"""A header by itself leaves functions unused."""
UNLINKED = "-Wno-unused-command-line-argument"
"""Of clang: what Open MPI's wrapper says to the linker is of no use here."""

_OWN = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def reached(header: str, found: set[str] | None = None) -> set[str]:
    """Return the headers that one includes, itself among them."""
    found = set() if found is None else found
    if header not in found:
        found.add(header)
        for name in _OWN.findall(HEADERS[header]):
            reached(normpath(f"{dirname(header)}/{name}"), found)
    return found


def takes(header: str, system: str) -> bool:
    return any(f"#include <{system}" in HEADERS[name] for name in reached(header))


def alone(header: str) -> Any:
    """A header as a parameter; those with Eigen take g++ seconds each."""
    return pytest.param(header, marks=[pytest.mark.slow] * takes(header, "Eigen"))


@pytest.mark.parametrize("header", spread(map(alone, HEADERS), len(HEADERS) // 3))
@pytest.mark.parametrize("compiler", [pytest.param("g++", marks=pytest.mark.slow), "clang++"])
def test_a_header_compiles_alone(header: str, compiler: str, builder: Builder) -> None:
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    toolchain = builder.with_compiler(compiler).toolchain
    mpi = any("\n#include <mpi.h>\n\n" in HEADERS[name] for name in reached(header))
    command = [*toolchain.compiler(mpi), *STANDARD, *WARNINGS, "-Werror", *ALONE]
    command += [UNLINKED] if compiler == "clang++" else []
    command += [f"-I{include_folder()}", "-isystem", str(toolchain.eigen), "-x", "c++", "-"]
    variables = toolchain.variables(os.environ)
    done = subprocess.run(
        command, input=f'#include "{header}"\n', capture_output=True, text=True, env=variables
    )
    assert (done.returncode, done.stderr) == (0, "")


def test_headers_define_nothing_that_others_could_see() -> None:
    """Unnamed namespaces, but for what the solver's and the program's side of both share."""
    shared = {"adagen/description.hpp", "adagen/start.hpp"}
    named = {"adagen/c_interface.hpp", "adagen/entry.hpp"}  # the interface itself, and main
    for name, text in HEADERS.items():
        assert text.startswith("// adagen's runtime, the same for all robots.\n"), name
        assert text.count("#pragma once\n") == 1, name
        code = text.partition("#pragma once\n")[2]
        code = re.sub(r"//.*|^ *#(?:.*\\\n)*.*$", "", code, flags=re.MULTILINE)
        if name not in shared | named and code.strip():
            assert re.match(r"\s*(namespace adagen \{\s*)?namespace \{", code), name


def test_the_version_is_that_of_the_package() -> None:
    assert (
        f"#define ADAGEN_VERSION {version_number(adagen.__version__)}\n"
        in HEADERS["adagen/version.hpp"]
    )
    assert version_number("1.12.3") == 11203


def test_joined_sources_hold_each_header_once_and_no_sample() -> None:
    source = (FOLDER / "humanoid_p2" / "humanoid_p2.cpp").read_text()
    header = (FOLDER / "humanoid_p2" / "humanoid_p2.h").read_text()
    whole = standalone(source, header=header)
    assert header in whole and '#include "' not in whole
    assert "// The program around this solver, the same for all robots." in whole
    for text in (joined(source), whole, joined(program_text())):
        assert '#include "' not in text
        assert "ADAGEN_SAMPLE" not in text and "#pragma once" not in text
        assert text.count("enum Failure : int {") == 1
    assert joined('#include "mine.hpp"\n') == '#include "mine.hpp"\n'


def test_heads_say_where_eigen_is_needed() -> None:
    said = {}
    for path in FOLDER.glob("*/*_p[0-9]*.cpp"):
        source = path.read_text()
        said[path.stem] = "\n// needs     Eigen's headers\n" in source
        assert said[path.stem] == ("#include <Eigen/" in joined(source)), path.stem
    assert {True, False} == set(said.values())


def source_of(stem: str) -> list[str]:
    return (FOLDER / stem / f"{stem}.cpp").read_text().splitlines()


@pytest.mark.parametrize(
    ("stem", "most"),
    [
        ("arm7_p1", 1000),
        ("arm7_p2", 1000),
        ("arm7_unrolled_p1", 1100),  # seven joints and a gripper of two
        ("human40_p1", 1600),
        ("humanoid_p1", 1600),
        ("humanoid_p2", 1600),
    ],
)
def test_a_source_is_not_long(stem: str, most: int) -> None:
    assert len(source_of(stem)) < most


@pytest.mark.parametrize(
    ("stem", "other"),
    [
        ("arm7_p1", "human40_p1"),
        ("human40_p1", "arm7_slaved_p2"),
        ("arm7_unrolled_p1", "human40_p1"),
        ("humanoid_p1", "arm7_p2"),
        ("mobile_p1", "humanoid_p1"),
    ],
)
def test_of_a_source_most_is_the_robot(stem: str, other: str) -> None:
    """At least four of five lines are not in a source of another robot.

    Not so for loops on two processes of an arm: most of their few lines are alike.
    """
    lines, elsewhere = (
        [line for line in map(str.strip, source_of(name)) if line] for name in (stem, other)
    )
    assert sum(line not in elsewhere for line in lines) >= 0.8 * len(lines)


def test_headers_that_are_right_are_not_written_again(tmp_path: Path) -> None:
    made = adagen.compile(adagen.read(FOLDER / "models" / "arm7.urdf"))
    made.write(tmp_path)
    header, other = tmp_path / "adagen" / "status.hpp", tmp_path / "adagen" / "version.hpp"
    os.utime(header, (1, 1))
    other.write_text(f"{HEADERS['adagen/version.hpp']}// spoilt\n")
    made.write(tmp_path)
    assert header.stat().st_mtime == 1
    assert other.read_text() == HEADERS["adagen/version.hpp"]


def test_headers_of_another_version_are_refused(builder: Builder) -> None:
    source = (FOLDER / "mobile_p1" / "mobile_p1.cpp").read_text()
    files = {**HEADERS, "adagen/version.hpp": "#pragma once\n#define ADAGEN_VERSION 99999\n"}
    with pytest.raises(adagen.EnvironmentFault, match="of another version than the adagen"):
        builder.compile(joined(source, files), "other", (*QUICK, "-DADAGEN_NO_MAIN"))


def test_a_program_of_another_version_is_not_linked(tmp_path: Path) -> None:
    adagen.compile(adagen.read(FOLDER / "models" / "arm7.urdf"), name="arm").write(tmp_path)
    version = tmp_path / "adagen" / "version.hpp"
    ours = version.read_text()

    def make(goal: str) -> subprocess.CompletedProcess[str]:
        command = ["make", "-C", str(tmp_path), goal]
        return subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)

    version.write_text("#pragma once\n#define ADAGEN_VERSION 99999\n")
    assert make("adagen_program.o").returncode == 0
    version.write_text(ours)
    os.utime(version, (1, 1))  # as where a folder was copied: make sees nothing that is newer
    done = make("arm_p1")
    assert done.returncode != 0
    assert re.search(rf"undefined reference to .*program<{version_number()},", done.stderr)


KINDS: dict[str, tuple[int, dict[str, Any], dict[str, Any]]] = {
    "joints": (1, {"form": "ada"}, {"shape": "joints"}),
    "loops": (1, {"scalar": "float"}, {"shape": "kernels"}),
    "lines": (1, {}, {"shape": "unrolled", "target": "embedded"}),
    "threads": (2, {"channel": "threads"}, {"shape": "kernels"}),
    "mpi": (2, {}, {"shape": "unrolled"}),
}
"""Processes, options of the plan and of the emission, of solvers that one program links."""

CALLS = """
template <class Number, class Solver, class Solve>
void answer(const char* kind, Solver* solver, Solve solve) {
  Number q[9], v[9], tau[9], qdd[9];
  for (int k = 0; k < 9; ++k) q[k] = Number(Q[k]), v[k] = Number(V[k]), tau[k] = Number(TAU[k]);
  std::printf("%s %d", kind, solve(solver, q, v, tau, qdd));
  for (const Number x : qdd) std::printf(" %.17g", double(x));
  std::printf("\\n");
}
alignas(64) unsigned char memory[LINES_P1_BYTES];

int main() {
  answer<double>("joints", joints_p1_open(), joints_p1_solve);
  answer<float>("loops", loops_p1_open(), loops_p1_solve);
  answer<double>("lines", lines_p1_open(memory, sizeof memory), lines_p1_solve);
  answer<double>("threads", threads_p2_open_threads(nullptr, 20), threads_p2_solve);
  const bool opened = mpi_p2_open(MPI_COMM_WORLD, "auto", 20) != nullptr;
  std::printf("mpi %d %s\\n", opened, mpi_p2_failure(nullptr));
}
"""


def test_solvers_of_all_kinds_link_into_one_program(builder: Builder) -> None:
    """Each has its own sizes and its own scalar, channel and shape, whatever the others have."""
    model = adagen.read(FOLDER / "models" / "arm7.urdf").model
    state = random_states(model, 1, seed=5)
    objects, text = [], "#include <cstdio>\n"
    for name, (processes, planned, emitted) in KINDS.items():
        plan = plan_of(model, processes, **planned)
        files, stem = emit(plan, name=name, **emitted), stem_of(plan, name)
        objects.append(str(builder.object_file(files[f"{stem}.cpp"], stem)))
        text += files[f"{stem}.h"]
    for name, row in (("Q", state.q[0]), ("V", state.v[0]), ("TAU", state.tau[0])):
        text += f"constexpr double {name}[]{{{', '.join(map(repr, row.tolist()))}}};\n"
    program = builder.compile(text + CALLS, "together", (*QUICK, *objects, "-pthread"))
    environment = builder.toolchain.variables(os.environ)
    done = subprocess.run([program], capture_output=True, text=True, env=environment, timeout=100)
    assert (done.returncode, done.stderr) == (0, "")
    *answers, refused = [line.split() for line in done.stdout.splitlines()]
    assert " ".join(refused) == "mpi 0 MPI is not initialised: call MPI_Init first"
    assert [words[0] for words in answers] == [*KINDS][:-1]
    for kind, status, *qdd in answers:
        assert status == "0"
        found = np.array([[float(x) for x in qdd]])
        scalar = KINDS[kind][1].get("scalar", "double")
        assert forward_error(found, truth_of(model, state)) < ROUNDING[scalar], kind
