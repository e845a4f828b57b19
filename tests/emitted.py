"""Building and running what adagen emits, each source once however many tests and workers ask."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import re
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.atomic_files import write_whole
from adagen.build import Toolchain, build_executable
from adagen.build.cache import uses_mpi
from adagen.build.toolchain import STANDARD, WARNINGS, with_compiler
from adagen.emit import emit, stem_of
from adagen.emit.runtime import joined
from adagen.emit.solver_program import options_in
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.reference import energy_norm_error, exact_forward_dynamics, joint_space_inertia
from adagen.run import Completed, launch
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule, named_schedule
from adagen.states import States, read_result, write_states

Array = NDArray[np.float64]
MARCH = os.environ.get("MARCH", "native")
"""What solvers of tests are built for: with MARCH=x86-64-v3 as on a processor with AVX2 alone."""
QUICK = ("-O1", f"-march={MARCH}", "-DNDEBUG", "-fno-math-errno")
EXACT = (*QUICK, "-ffp-contract=off")  # each operation of the text is one of the processor
OPTIMISED = ("-O3", *QUICK[1:])
NARROW = ("-O1", "-march=x86-64-v2", *QUICK[2:])  # registers of two doubles
HALVED = ("-O1", "-march=x86-64-v3", *QUICK[2:])  # of four
CHECKED = ("-fsanitize=undefined", "-fno-sanitize-recover=all", *QUICK)  # as it runs
HURRIED = ("--param=ggc-min-heapsize=1500000", "-Wno-unused-command-line-argument")
"""g++ collects no memory below 1.5 GB, and takes a twelfth less time; others ignore it."""
PARSED = (QUICK, EXACT)
"""Flags of so many solvers that what they include is parsed once for all."""
SOLVERS_INCLUDE = (
    *("algorithm", "array", "chrono", "cmath", "cstddef", "cstdint", "cstring"),
    *("initializer_list", "limits", "new", "type_traits", "utility", "vector"),
)
PROCESSES_INCLUDE = ("atomic", "exception", "memory", "mpi.h", "string", "thread")
TIMEOUT = 120.0
WRITTEN = 9
"""What is written for a solver: source, header, plan, drawing, program, what builds it, runtime."""
ROUNDING = {
    scalar: 450 * float(np.finfo(number).eps)
    for scalar, number in (("double", np.float64), ("float", np.float32))
}
"""Forward errors that rounding explains in robots of ordinary conditioning.

Measured: 1 to 40 units of the last place; the rest is for other compilers and machines. Where a
robot magnifies rounding more, its test says how much more.
"""


_WATCHED = re.compile("-fsanitize=.*(address|thread)")
"""What a program is to be built with as a whole; undefined behaviour is that of each source."""


@dataclass(frozen=True)
class Solver:
    """An emitted program and how to run it."""

    executable: Path
    processes: int
    toolchain: Toolchain

    def run(self, *words: str | Path, timeout: float = TIMEOUT) -> Completed:
        """Run it on its number of processes."""
        arguments = [str(word) for word in words]
        return launch(self.executable, self.processes, arguments, self.toolchain, timeout)

    def solve(self, model: Model, states: States, folder: Path, *words: str) -> Array:
        """Return the accelerations for states of a model, shape (S, nv)."""
        given, result = folder / "states.json", folder / "result.json"
        write_states(states, model, given)
        done = self.run("--states", given, "--result", result, *words)
        assert (done.status, done.stderr) == (0, "")
        return read_result(result, model)

    def error(self, model: Model, states: States, folder: Path, *words: str) -> float:
        """Return the forward error of these, the largest of all states."""
        found = self.solve(model, states, folder, *words)
        return forward_error(found, truth_of(model, states))


def included_by(source: str) -> list[str]:
    """Return what all solvers include, with Eigen and MPI if this one does."""
    names = [*SOLVERS_INCLUDE, *(PROCESSES_INCLUDE if "#include <mpi.h>" in source else ())]
    return [*names, *["Eigen/Core"] * ("#include <Eigen/Core>" in source)]


@dataclass(frozen=True)
class Builder:
    """Compiles emitted sources into a folder that all tests share."""

    folder: Path
    toolchain: Toolchain

    @property
    def quick(self) -> Toolchain:
        """A toolchain for what builds by itself: it optimises little, and has the same program.

        What solvers include is parsed once for all that are loaded.
        """
        flags: tuple[str, ...] = (*STANDARD, *HURRIED, *QUICK)
        if self._gnu:
            header = self._parsed(SOLVERS_INCLUDE, (*flags, "-shared", "-fPIC", "-pthread"))
            flags = (*flags, "-include", str(header))
        return replace(self.toolchain, flags=flags, program_flags=self.toolchain.flags)

    @property
    def _gnu(self) -> bool:
        """Whether the compiler takes what is parsed: clang++ does not, for an #include."""
        return "clang" not in self.toolchain.cxx[0]

    def with_compiler(self, name: str) -> Builder:
        """Return a builder with another compiler behind the wrapper."""
        return replace(self, toolchain=with_compiler(self.toolchain, name))

    def compile(
        self, source: str, stem: str, flags: Sequence[str] = QUICK, libraries: Sequence[str] = ()
    ) -> Path:
        """Return the executable of a source; a warning is an error."""
        source = joined(source)
        shared = self._gnu and flags in PARSED and options_in(source) is not None
        common = (*STANDARD, *WARNINGS, "-Werror", *HURRIED)
        all_flags = (*common, *flags, *libraries)
        if shared:
            header = self._parsed(included_by(source), all_flags)
            source = f'#include "{header}"\n#line 1\n{source}'
        # The program around a solver is the same whatever the solver is optimised for.
        watched = any(map(_WATCHED.match, flags))
        around = (*common, *flags) if watched else self.toolchain.flags
        toolchain = replace(self.toolchain, flags=all_flags, program_flags=around)
        with self._locked(source, all_flags):
            return build_executable(source, stem, toolchain, self.folder)

    def object_file(self, source: str, stem: str, flags: Sequence[str] = QUICK) -> Path:
        """Return the object of a source, without its program; a warning is an error."""
        more = ("-Werror", *HURRIED, *flags, "-c")
        alone = f"#define ADAGEN_NO_MAIN\n{source}"
        return self._kept(alone, f"{stem}.o", (*STANDARD, *WARNINGS, *more))

    def library(self, source: str, flags: Sequence[str]) -> Path:
        """Return a shared library of a source, without its program, with the tool's own flags."""
        more = ("-shared", "-fPIC", "-Wl,-Bsymbolic", *flags)
        alone = f"#define ADAGEN_NO_MAIN\n{joined(source)}"
        return self._kept(alone, "solver.so", (*self.toolchain.flags, *more))

    def _parsed(self, names: Sequence[str], flags: Sequence[str]) -> Path:
        """Return a header that includes others, parsed beside it for solvers with these flags.

        Where the compiler can, it takes them parsed: 0.12 s of the 0.7 s of most solvers, with
        Eigen's 0.7 s of 3.3 s. What the program around them includes beside would cost each of them
        half of that.
        """
        includes = "".join(f"#include <{name}>\n" for name in names)
        kept = self._kept(includes, "parsed.hpp.gch", (*flags, "-c", "-x", "c++-header"))
        header = kept.with_suffix("")
        write_whole(header, includes)
        return header

    def _kept(self, source: str, name: str, flags: Sequence[str]) -> Path:
        """Return what is made of a source, found again like an executable although it is none."""
        toolchain = replace(self.toolchain, flags=tuple(flags))
        with self._locked(source, flags):
            file = build_executable(source, name, toolchain, self.folder)
            file.chmod(0o755)
        return file

    @contextmanager
    def _locked(self, source: str, flags: Sequence[str]) -> Iterator[None]:
        """Let one test worker at a time compile the same thing."""
        digest = hashlib.sha256("\0".join((source, *flags)).encode()).hexdigest()
        self.folder.mkdir(parents=True, exist_ok=True)
        with (self.folder / f"{digest}.lock").open("w") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            yield

    def check(self, source: str, stem: str, flags: Sequence[str]) -> None:
        """Have a source compiled into an object for its warnings alone."""
        toolchain = replace(self.toolchain, flags=(*STANDARD, *WARNINGS, "-Werror", "-c", *flags))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, f"{stem}.cpp")
            path.write_text(joined(source))
            mpi = "-DADAGEN_MPI" in flags or uses_mpi(source)
            command = toolchain.compile_command(path, path.with_suffix(".o"), mpi)
            done = subprocess.run(
                command, capture_output=True, text=True, env=toolchain.variables(os.environ)
            )
        assert (done.returncode, done.stderr) == (0, "")

    def solver(
        self,
        plan: Plan,
        flags: Sequence[str] = QUICK,
        name: str | None = None,
        batch: int = 0,
        **options: Any,
    ) -> Solver:
        """Return the built program of a plan, emitted with the options."""
        text = text_of(plan, name, batch, **options)
        executable = self.compile(text, stem_of(plan, name, batch), flags)
        return Solver(executable, batch or plan.launched, self.toolchain)


def make_variables(toolchain: Toolchain) -> list[str]:
    """Return the words by which make builds with a toolchain."""
    words = " ".join(f"'{name}={value}'" for name, value in toolchain.environment)
    return [
        f"MPICXX={toolchain.mpicxx[0]}",
        f"MPIEXEC={toolchain.mpiexec[0]}",
        f"EIGEN={toolchain.eigen}",
        f"VARIABLES={words}",
    ]


def plan_of(model: Model, processes: int, **options: Any) -> Plan:
    """Return a plan that gives every process its part, whether that pays or not."""
    profile, topology = load_profile("default"), Topology.of(model)
    if processes == 1:
        schedule = find_schedule(topology, 1, profile=profile)
    else:
        schedule = named_schedule("balanced", topology, processes, profile=profile)
    return make_plan(model, schedule, **options)


def text_of(plan: Plan, name: str | None = None, batch: int = 0, **options: Any) -> str:
    """Return the source that is emitted for a plan with the options."""
    return emit(plan, name=name, batch=batch, **options)[f"{stem_of(plan, name, batch)}.cpp"]


def kernels_of(plan: Plan, batch: int = 0) -> str:
    """Return the same in shape kernels, whether that pays or not."""
    return text_of(plan, batch=batch, shape="kernels")


def truth_of(model: Model, states: States) -> Array:
    """Return the true accelerations, shape (S, nv)."""
    return np.array([exact_forward_dynamics(model, *row, digits=20).value for row in states.each])


def forward_error(found: Array, truth: Array) -> float:
    """Return the largest error of an acceleration, relative to the largest of its state."""
    size = np.maximum(1.0, np.abs(truth).max(axis=1, keepdims=True))
    return float((np.abs(found - truth) / size).max())


def energy_errors(model: Model, states: States, found: Array) -> Array:
    """Return the errors of the states' accelerations in the energy norm, shape (S,)."""
    rows = zip(states.q, found, truth_of(model, states), strict=True)
    return np.array(
        [energy_norm_error(joint_space_inertia(model, q), x - t, t) for q, x, t in rows]
    )


def states_text(model: Model, states: States, folder: Path) -> dict[str, Any]:
    """Return a states file as data, to be spoilt."""
    write_states(states, model, folder / "good.json")
    data = json.loads((folder / "good.json").read_text())
    assert isinstance(data, dict)
    return data


def cores() -> int:
    """Return how many cores this process may use."""
    return len(os.sched_getaffinity(0))
