"""Emitted solvers as libraries of other programs: in C, in C++, and on several processes."""

from __future__ import annotations

import os
import platform
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import emit, stem_of
from adagen.plan import Plan, make_plan
from adagen.plan.certificate import certified
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import random_states
from tests.emitted import QUICK, ROUNDING, Builder, Solver, forward_error, plan_of, truth_of
from tests.golden.examples import EXAMPLES, FOLDER
from tests.models import human_figure, serial_chain
from tests.slow import all_but, slow, spread

HERE = Path(__file__).parent
BY_STEM = {example.stem: example for example in EXAMPLES}
ALONE = [example.stem for example in EXAMPLES if example.processes == 1]
STRICT = ("-Wall", "-Wextra", "-pedantic", "-Werror")


def filled(name: str, stem: str, **words: str) -> str:
    """Return the text of a program with the names of a solver filled in."""
    text = (HERE / name).read_text()
    for word, value in {**words, "SOLVER": stem, "UPPER": stem.upper()}.items():
        text = re.sub(rf"\b{word}(?=\b|_)", value, text)
    return text


def run(*command: str | Path, **options: object) -> str:
    """Return what a command prints; it must end well and say nothing on stderr."""
    done = subprocess.run(
        [str(word) for word in command],
        capture_output=True,
        text=True,
        timeout=300,
        **options,  # type: ignore[call-overload]
    )
    assert (done.returncode, done.stderr) == (0, ""), done.stderr
    return str(done.stdout)


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a solver for one process, its libraries made where no MPI is to be found."""
    folder = tmp_path_factory.mktemp("library") / "mobile_p1"
    shutil.copytree(FOLDER / "mobile_p1", folder)
    shutil.copytree(FOLDER / "adagen", folder.parent / "adagen")
    nowhere = ("MPICXX=nowhere", "MPIEXEC=nowhere", "ADAGEN=nowhere", "EIGEN=/nowhere")
    known = ("-march=x86-64-v2",) if platform.machine() == "x86_64" else ()  # to valgrind
    flags = " ".join((os.environ["CXXFLAGS"], *known))
    run("make", "-C", folder, *nowhere, f"CXXFLAGS={flags}", "lib")
    return folder


def test_a_library_for_one_process_links_no_mpi(library: Path) -> None:
    said = run("readelf", "-d", library / "libmobile_p1.so")
    needed = re.findall(r"NEEDED.*\[(.*)\]", said)
    assert needed
    assert {re.sub(r"[.-].*", "", name) for name in needed} <= {
        *("libstdc++", "libm", "libgcc_s", "libc", "ld", "libstdc")
    }


@pytest.mark.parametrize("stem", spread(ALONE, 4))
def test_a_solver_for_one_process_throws_nothing_and_knows_no_mpi(
    stem: str, builder: Builder
) -> None:
    source = (FOLDER / stem / f"{stem}.cpp").read_text()
    assert "mpi.h" not in source
    flags = ("-DADAGEN_NO_MAIN", "-DADAGEN_NO_MPI", "-fno-exceptions", "-fsyntax-only")
    builder.check(source, stem, flags)


def test_who_wants_no_mpi_is_told_that_a_solver_needs_it(builder: Builder, tmp_path: Path) -> None:
    path = tmp_path / "solver.c"
    path.write_text('#include "arm7_p2.h"\n')
    words = ("-x", "c", "-fsyntax-only", "-DADAGEN_NO_MPI", f"-I{FOLDER / 'arm7_p2'}", path)
    done = subprocess.run([*builder.toolchain.cxx, *words], capture_output=True, text=True)
    assert done.returncode == 1
    assert "#error" in done.stderr and "generate one with --procs 1" in done.stderr


def controller(kind: str, library: Path, folder: Path) -> Path:
    """Return a C99 program that is linked with the library, built into a folder."""
    (folder / "controller.c").write_text(filled("controller.c", "mobile_p1"))
    libraries = [str(library / f"libmobile_p1.{kind}"), "-lm"]
    libraries.append(f"-Wl,-rpath,{library}" if kind == "so" else "-lstdc++")
    run("cc", "-std=c99", "-g", *STRICT, f"-I{library}", folder / "controller.c", *libraries,
        "-o", folder / "controller")  # fmt: skip
    return folder / "controller"


@pytest.mark.skipif(shutil.which("valgrind") is None, reason="valgrind is not installed")
@pytest.mark.parametrize("kind", ["so", "a"])
def test_valgrind_finds_nothing(kind: str, library: Path, tmp_path: Path) -> None:
    states = random_states(BY_STEM["mobile_p1"].model(), 3, seed=1)
    rows = [np.concatenate(each) for each in states.each]
    np.savetxt(tmp_path / "states", [*rows, np.full_like(rows[0], np.nan)], fmt="%.17g")
    program = controller(kind, library, tmp_path)
    words = ("--quiet", "--leak-check=full", "--show-leak-kinds=all", "--error-exitcode=9")
    assert len(run("valgrind", *words, program, tmp_path / "states").splitlines()) == 4


@pytest.mark.parametrize("kind", ["so", "a"])
def test_a_program_in_c99_links_it(kind: str, library: Path, tmp_path: Path) -> None:
    model = BY_STEM["mobile_p1"].model()
    states = random_states(model, 3, seed=8)
    rows = [np.concatenate(row) for row in states.each]
    spoilt = rows[0].copy()
    spoilt[-1] = np.nan
    np.savetxt(tmp_path / "states", [*rows, spoilt], fmt="%.17g")
    program = controller(kind, library, tmp_path)
    lines = run(program, tmp_path / "states", env={}).splitlines()
    found = np.array([line.split() for line in lines[:-1]], dtype=float)
    assert forward_error(found, truth_of(model, states)) < ROUNDING["double"]
    last = model.joints[-1].name
    told = f'1 {len(model.joints) - 1} joint "{last}": its q, v or tau is not a finite number'
    assert lines[-1] == told


@pytest.mark.parametrize("stem", BY_STEM)
def test_headers_are_c99_and_cpp17_and_included_by_the_source(
    stem: str, builder: Builder, tmp_path: Path
) -> None:
    source = (FOLDER / stem / f"{stem}.cpp").read_text()
    assert f'#include "{stem}.h"\n' in source
    include = f'#include "{stem}.h"\n#include "{stem}.h"\n'
    mpicxx = Path(builder.toolchain.mpicxx[0])
    for ending, standard, wrapper in (("c", "c99", "mpicc"), ("cpp", "c++17", mpicxx.name)):
        (tmp_path / f"use.{ending}").write_text(
            f"{include}int main(void) {{ return {stem}_reason(0) + {stem.upper()}_NQ; }}\n"
        )
        plain = "cc" if ending == "c" else "c++"
        compiler = plain if stem in ALONE else mpicxx.with_name(wrapper)
        flags = (f"-std={standard}", *STRICT, "-fsyntax-only", f"-I{FOLDER / stem}")
        run(compiler, *flags, tmp_path / f"use.{ending}")


def _chain_in_parts(scalar: str) -> Plan:
    chain = serial_chain(300)
    swept = best_schedule(chain, 1, load_profile("default"), in_parts=True)
    assert swept.parts == 8
    return make_plan(chain, swept, scalar=scalar)


ARM = BY_STEM["arm7_p1"].model
PLANS: dict[str, tuple[Callable[[], Plan], dict[str, object]]] = {
    "ada": (lambda: plan_of(ARM(), 1, form="ada"), {"shape": "joints"}),
    "kernels": (lambda: plan_of(human_figure(), 1), {"shape": "kernels"}),
    "unrolled": (lambda: plan_of(ARM(), 1), {"shape": "unrolled"}),
    "in lanes": (lambda: plan_of(human_figure(), 1), {"shape": "unrolled"}),
    "float": (lambda: plan_of(ARM(), 1, scalar="float"), {}),
    "refined": (lambda: plan_of(human_figure(), 1), {"refine": 2}),
    "slaved": (lambda: plan_of(BY_STEM["arm7_slaved_p2"].model(), 1), {}),
    "batch": (lambda: plan_of(ARM(), 1), {"batch": 1}),
    "certified batch": (
        lambda: certified(plan_of(BY_STEM["human40_p1"].model(), 1)),
        {"batch": 1, "shape": "unrolled"},
    ),
    "chain in parts": (lambda: _chain_in_parts("double"), {}),
    "the same in float": (lambda: _chain_in_parts("float"), {}),  # takes most of the stack
}
STACK = 64 << 10  # bytes that a call takes at most, as docs/how_to/library.md says


@pytest.mark.parametrize(
    "name",
    all_but(
        PLANS, "ada", "refined", "float", "certified batch", "chain in parts", "the same in float"
    ),
)
def test_calls_take_nothing_from_the_heap_and_little_of_the_stack(
    name: str, builder: Builder
) -> None:
    make, options = PLANS[name]
    plan = make()
    files = emit(plan, name="heap", **options)  # type: ignore[arg-type]
    stem = stem_of(plan, "heap", 1)
    batch = "#define BATCH\n" if "batch" in options else ""
    counting = filled("memory.cpp", stem, OPEN="SOLVER_open()")
    text = f"#define ADAGEN_NO_MAIN\n{batch}{files[f'{stem}.cpp']}{counting}"
    flags = ("-O1", "-march=native", "-fno-builtin-malloc", "-pthread")
    heap, stack = run(builder.compile(text, "heap", flags)).splitlines()
    assert heap == "opened 1, failed 1, said 1, later 0"
    assert 0 < int(stack.removeprefix("stack ")) < STACK


@pytest.mark.slow
def test_what_failed_has_no_correction(builder: Builder) -> None:
    """Zero would say that there was nothing to correct."""
    plan = PLANS["kernels"][0]()
    files = emit(plan, name="refined", refine=1, shape="kernels")
    probe = """
int main() {
  std::vector<Number> q(kNq, Number(0.3)), v(kNv, Number(0.2)), tau(kNtau), qdd(kNv);
  auto* const solver = refined_p1_open();
  const auto told = [&] {
    const int status = refined_p1_solve(solver, q.data(), v.data(), tau.data(), qdd.data());
    const double size = refined_p1_correction(solver, 0);
    std::printf("%d %d\\n", status == 0, size > 0 ? 1 : size == size ? 0 : -1);
  };
  told();
  v[0] = std::numeric_limits<Number>::infinity();
  told();
  refined_p1_close(solver);
}
"""
    head = "#define ADAGEN_NO_MAIN\n#include <cstdio>\n#include <limits>\n#include <vector>\n"
    program = builder.compile(f"{head}{files['refined_p1.cpp']}{probe}", "refined", QUICK)
    assert run(program) == "1 1\n0 -1\n"


class TestWorkers:
    """Programs on several processes: all but the first serve, until that ends it."""

    def lines(self, builder: Builder, stem: str, source: str, header: str, channel: str,
              folder: Path, processes: int, batch: bool = False) -> list[str]:  # fmt: skip
        (folder / f"{stem}.h").write_text(header)
        part = builder.object_file(source, stem)
        words = {"SOLVER_SOLVE": f"{stem}_solve_{'batch_' * batch}at_root"}
        words["COUNT"] = "1," if batch else ""
        text = filled("workers.cpp", stem, **words)
        program = builder.compile(text, "workers", (*QUICK, f"-I{folder}", str(part)))
        done = Solver(program, processes, builder.toolchain).run(channel, timeout=60)
        assert (done.status, done.stderr) == (0, "")
        return sorted(done.stdout.splitlines())

    @pytest.mark.parametrize(
        ("stem", "channel"),
        [
            ("arm7_p2", "window"),
            ("arm7_batch_p2", "message"),
            slow("arm7_p2", "message"),
            slow("arm7_batch_p2", "window"),
        ],
    )
    def test_a_worker_serves_until_it_is_ended(
        self, stem: str, channel: str, builder: Builder, tmp_path: Path
    ) -> None:
        batch = BY_STEM[stem].batch
        if batch and channel == "window":
            channel = "auto"  # states are distributed in messages
        source, header = ((FOLDER / stem / f"{stem}.{end}").read_text() for end in ("cpp", "h"))
        lines = self.lines(builder, stem, source, header, channel, tmp_path, 2, batch)
        answers = [line.split()[4:] for line in lines if line.startswith("process 0 asked 1")]
        assert len(answers) == 4
        assert all(answer == answers[0] for answer in answers)
        model = BY_STEM[stem].model()
        states = random_states(model, 1, seed=1)
        for part, value in ((states.q, 0.3), (states.v, 0.2), (states.tau, 0.1)):
            part[:] = value
        found = np.array([answers[0]], dtype=float)
        assert forward_error(found, truth_of(model, states)) < ROUNDING["double"]
        assert len([line for line in lines if line.startswith("process 0 asked 0")]) == 2
        assert lines[-2:] == ["process 1 served 0"] * 2
        assert lines.count("process 0 ended 0") == 2

    def test_a_worker_that_owns_nothing_is_ended_too(
        self, builder: Builder, tmp_path: Path
    ) -> None:
        model = BY_STEM["arm7_p1"].model()
        plan = make_plan(model, best_schedule(model, 2, load_profile("default")))
        assert not plan.processes[1].owns
        files = emit(plan, name="idle")
        lines = self.lines(
            builder, "idle_p2", files["idle_p2.cpp"], files["idle_p2.h"], "auto", tmp_path, 2
        )
        assert lines[-2:] == ["process 1 served 0"] * 2
        assert lines.count("process 0 ended 0") == 2
