"""Reproducible solvers answer the same to the last bit, whatever they are compiled with."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
from dataclasses import replace
from math import inf, isnan, nan
from pathlib import Path

import numpy as np
import pytest
from flint import arb, ctx

from adagen.atomic_files import write_files
from adagen.build import build_executable
from adagen.build.toolchain import STANDARD
from adagen.emit import emit, stem_of
from adagen.emit.runtime import joined
from adagen.emit.shapes import MOST_FREEDOMS_IN_BATCHES
from adagen.errors import UsageError
from adagen.executor import groupings
from adagen.graph import DOUBLE
from adagen.model import REVOLUTE, Model
from adagen.plan import Plan
from adagen.plan.constants import joints_of
from adagen.plan.types import THREADS
from adagen.states import States, random_states, write_states
from adagen.urdf import read_robot
from tests.emitted import Builder, plan_of, text_of
from tests.executor.test_lane_bits import affected, limbs
from tests.gathered import distributed, reproducible_plan
from tests.models import human_figure, serial_chain
from tests.slow import slow

FLAGS = (
    ("-O2", "-march=x86-64"),
    ("-O3", "-march=x86-64-v3"),
    ("-O3", "-march=x86-64-v3", "-ffp-contract=fast"),
    ("-O3", "-march=x86-64-v4"),
    ("-O1", "-march=native", "-fno-signed-zeros", "-fno-trapping-math"),
)
"""What reproducible solvers are compiled with; the last two only where the processor can."""
CLANG_FLAGS = (*FLAGS[:2], FLAGS[3], ("-O1", "-march=native"))
"""For clang++, which fuses and reorders by option whatever the source says; that is refused."""
ROBOTS = {
    "quadruped": ("erd_go1", True, "double"),
    "humanoid": ("erd_icub", True, "double"),
    "arm on a quadruped": ("erd_b1_z1", True, "float"),
    "hand": ("unitree_Left_Hand", False, "float"),
}


def runs(flags: tuple[str, ...]) -> bool:
    """Return whether this processor runs what is compiled so."""
    if "-march=x86-64-v4" not in flags:
        return True
    return "avx512f" in Path("/proc/cpuinfo").read_text(encoding="utf-8")


def spread(model: Model) -> States:
    """Return states, one with angles that are large and one that are very large."""
    states = random_states(model, 6, seed=2)
    for joint in joints_of(model):
        if joint.kind == "revolute":
            states.q[4, joint.q] *= 3.1e6
            states.q[5, joint.q] *= 2.7e21
    return states


def answer(
    builder: Builder, plan: Plan, flags: tuple[str, ...], model: Model, folder: Path, **how: object
) -> str:
    """Return the text of a result file: numbers in it are exact to the last bit."""
    solver = builder.solver(plan, flags, **how)  # type: ignore[arg-type]
    given, result = folder / "states.json", folder / "result.json"
    write_states(spread(model), model, given)
    done = solver.run("--states", given, "--result", result)
    assert (done.status, done.stderr) == (0, "")
    return result.read_text(encoding="utf-8")


@pytest.mark.slow
@pytest.mark.parametrize("robot", ROBOTS)
def test_real_robots(robot: str, builder: Builder, shared: Path, tmp_path: Path) -> None:
    """By two compilers for four processors, on 1, 2 and 4 processes, in lanes and not, batched."""
    name, floating, scalar = ROBOTS[robot]
    model = read_robot(str(shared / "real" / f"{name}.urdf"), floating=floating).model
    plan = reproducible_plan(model, scalar=scalar)
    expected = answer(builder, plan, FLAGS[0], model, tmp_path, limbs=groupings(plan)[0])
    for flags in filter(runs, FLAGS[1:]):
        assert answer(builder, plan, flags, model, tmp_path) == expected, flags
    assert answer(builder, plan, FLAGS[1], model, tmp_path, batch=1) == expected
    for processes in (2, 4):
        gathered = distributed(model, processes, np.random.default_rng(processes))
        shares = replace(reproducible_plan(model, gathered, scalar=scalar), channel=THREADS)
        for grouping, flags in zip(groupings(shares), FLAGS[1:], strict=False):
            found = answer(builder, shares, flags, model, tmp_path, limbs=grouping)
            assert found == expected, (processes, flags)
    if shutil.which("clang++"):
        other = builder.with_compiler("clang++")
        for flags in filter(runs, CLANG_FLAGS):
            assert answer(other, plan, flags, model, tmp_path) == expected, flags


@pytest.mark.parametrize("every", [False, slow(True)])
def test_lanes_processes_and_processors(every: bool, builder: Builder, tmp_path: Path) -> None:
    model = affected(limbs(4, REVOLUTE, REVOLUTE, trunk=1, beside=0))
    plan = reproducible_plan(model)
    expected = answer(builder, plan, ("-O1", "-march=x86-64"), model, tmp_path, limbs=((),))
    wide = ("-O1", "-march=native", "-ffp-contract=fast")
    shares = reproducible_plan(model, distributed(model, 2, np.random.default_rng(2), core=0.0))
    assert any(len(own) for own in groupings(shares)[-1])
    assert answer(builder, shares, wide, model, tmp_path) == expected
    if not every:
        return
    assert answer(builder, plan, wide, model, tmp_path) == expected
    assert answer(builder, plan, wide, model, tmp_path, batch=1) == expected
    if shutil.which("clang++"):
        other = builder.with_compiler("clang++")
        assert answer(other, shares, CLANG_FLAGS[-1], model, tmp_path) == expected


@pytest.mark.slow
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_a_processor_without_fused_operations(
    scalar: str, builder: Builder, tmp_path: Path
) -> None:
    """Baseline programs ask for them when they are loaded, and call the C library if need be."""
    emulator = shutil.which("qemu-x86_64")
    if emulator is None:
        pytest.skip("qemu-x86_64 is not installed: see docs/how_to/building.md")
    model = affected(limbs(4, REVOLUTE, REVOLUTE, trunk=1, beside=0))
    plan, flags = reproducible_plan(model, scalar=scalar), ("-O2", "-march=x86-64")
    old = (*STANDARD, *flags)
    toolchain = replace(builder.toolchain, flags=old, program_flags=old)
    given, result = tmp_path / "states.json", tmp_path / "old.json"
    for batch in (0, 1):
        expected = answer(builder, plan, flags, model, tmp_path, batch=batch)
        text = text_of(plan, batch=batch)
        program = build_executable(text, stem_of(plan, batch=batch), toolchain, builder.folder)
        command = [emulator, "-cpu", "Nehalem", str(program)]
        subprocess.run([*command, "--states", str(given), "--result", str(result)], check=True)
        assert result.read_text(encoding="utf-8") == expected


_FUSED = re.compile(r"\bvfn?m(?:add|sub)\w*")
_CALLED = re.compile(r"\bfused(?:_less|_from)?\(")


def assembly(builder: Builder, text: str, folder: Path, *flags: str) -> str:
    """Return what a compiler makes of a solver's text, without the program around it."""
    source, made = folder / "solver.cpp", folder / "solver.s"
    source.write_text(text)
    command = builder.toolchain.compile_command(source, made, False)
    subprocess.run([*command, "-S", *flags, "-DADAGEN_NO_MAIN"], check=True)
    return made.read_text()


def test_no_other_product_is_fused(builder: Builder, tmp_path: Path) -> None:
    """g++ 12 makes vfmaddsub of neighbours, whatever -ffp-contract says; sines fuse by default."""
    model, rng = human_figure(), np.random.default_rng(4)
    plan = replace(reproducible_plan(model, distributed(model, 4, rng)), channel=THREADS)
    flags, fused = ("-O3", "-march=x86-64-v3"), []
    text = joined(text_of(plan))
    apart = text.replace("__builtin_fma(a, b, c)", "(a * b + c)")  # rounded twice
    apart = re.sub(r"#if defined\((__FMA__|__x86_64__)\)", "#if 0  // \\1", apart)
    apart = apart.replace("#elif defined(__FMA__)", "#elif 0")
    for each in (apart, joined(text_of(replace(plan, reproducible=False), shape="unrolled"))):
        fused.append(len(_FUSED.findall(assembly(builder, each, tmp_path, *flags))))
    assert fused[0] == 0 < fused[1]


@pytest.mark.parametrize("march", ["x86-64-v3", slow("x86-64-v4")])
def test_lanes_are_fused_at_once(march: str, builder: Builder, tmp_path: Path) -> None:
    """One instruction for all of them, and nothing is called."""
    model = affected(limbs(4, REVOLUTE, REVOLUTE, trunk=1, beside=0))
    text = text_of(reproducible_plan(model), batch=1)
    calls = len(_CALLED.findall(text))
    made = assembly(builder, joined(text), tmp_path, "-O2", f"-march={march}")
    packed = [word for word in _FUSED.findall(made) if word.endswith("pd")]
    assert calls > 100
    assert calls * 0.98 <= len(packed) <= calls
    assert not re.search(r"(?:call|jmp)\s+fmaf?\b", made)


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("-ffast-math",), "without -ffast-math"),
        (("-Ofast",), "without -ffast-math"),
        (("-mfpmath=387",), "for SSE2"),
    ],
)
def test_other_arithmetic_is_not_compiled(
    flags: tuple[str, ...], said: str, builder: Builder, tmp_path: Path
) -> None:
    source = tmp_path / "solver.cpp"
    source.write_text(joined(text_of(reproducible_plan(serial_chain(2)))))
    command = builder.toolchain.compile_command(source, tmp_path / "x.o", False)
    command += ["-c", "-Wfatal-errors", *flags]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert said in done.stderr


def test_other_arithmetic_is_refused_where_a_solver_is_opened(
    builder: Builder, tmp_path: Path
) -> None:
    """Compilers may do otherwise in spite of the text, and programs tell processors to."""
    plan = reproducible_plan(serial_chain(2))
    text = re.sub("#pragma (GCC optimize|STDC).*\n", "", joined(text_of(plan)))
    fusing = ("-O2", "-march=x86-64-v3", "-ffp-contract=fast")
    refused = [builder.compile(text, "chain", fusing)]
    if shutil.which("clang++"):
        as_it_is = joined(text_of(plan))
        refused.append(builder.with_compiler("clang++").compile(as_it_is, "chain", fusing))
    for fused in refused:
        done = subprocess.run([fused], capture_output=True, text=True, check=False)
        assert done.returncode != 0
        assert "compiled to fuse products and sums" in done.stderr
    twice = joined(text_of(plan)).replace("__builtin_fma(a, b, c)", "(a * b + c)")
    program = builder.compile(twice, "chain", ("-O2", "-march=x86-64-v3"))
    done = subprocess.run([program], capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert "the C library's fma rounds twice" in done.stderr
    library = tmp_path / "solver.so"
    source = tmp_path / "solver.cpp"
    source.write_text(joined(text_of(plan)))
    stem = stem_of(plan)
    flags = ["-shared", "-fPIC", "-DADAGEN_NO_MAIN"]
    command = [*builder.toolchain.compile_command(source, library, False), *flags]
    subprocess.run(command, check=True)
    loaded, maths = ctypes.CDLL(str(library)), ctypes.CDLL("libm.so.6")
    opened, why = loaded[f"{stem}_open"], loaded[f"{stem}_failure"]
    opened.restype, why.restype = ctypes.c_void_p, ctypes.c_char_p
    assert opened()
    downwards, nearest = 0x400, 0
    assert maths.fesetround(downwards) == 0
    try:
        assert not opened()
    finally:
        maths.fesetround(nearest)
        assert b"does not round to the nearest" in why(None)


_CALLER = """
#include <stdio.h>
#include "{stem}.h"
int main(void) {{
  {stem}_solver* solver = {stem}_open();
  puts(solver ? "opened" : {stem}_failure(0));
  return 0;
}}
"""


@pytest.mark.parametrize(
    ("flags", "said"), [((), "opened"), (("-ffast-math",), "flushes subnormal numbers to zero")]
)
def test_a_program_that_flushes_small_numbers_is_refused(
    flags: tuple[str, ...], said: str, builder: Builder, tmp_path: Path
) -> None:
    plan = reproducible_plan(serial_chain(2))
    stem = stem_of(plan)
    write_files(tmp_path, emit(plan))
    caller = tmp_path / "caller.cpp"
    caller.write_text(_CALLER.format(stem=stem))
    compiled, program = tmp_path / "solver.o", tmp_path / "caller"
    source = tmp_path / f"{stem}.cpp"
    command = builder.toolchain.compile_command(source, compiled, False)
    subprocess.run([*command, "-c", "-DADAGEN_NO_MAIN"], check=True)
    command = builder.toolchain.compile_command(caller, program, False)
    subprocess.run([*command, str(compiled), *flags], check=True)
    done = subprocess.run([program], capture_output=True, text=True, check=True)
    assert said in done.stdout


def test_what_is_not_reproducible_is_not_emitted() -> None:
    plan = reproducible_plan(serial_chain(3))
    for shape in ("kernels", "joints"):
        with pytest.raises(UsageError, match="only straight lines are reproducible"):
            emit(plan, shape=shape)
    with pytest.raises(UsageError, match="degrees of freedom: only straight lines"):
        emit(reproducible_plan(serial_chain(MOST_FREEDOMS_IN_BATCHES + 1)))


def test_others_hold_nothing_of_it() -> None:
    text = joined(text_of(plan_of(human_figure(), 1), shape="unrolled"))
    marks = (", reproducible, ", "#define ADAGEN_REPRODUCIBLE", "#pragma GCC optimize(")
    assert not any(mark in text for mark in marks)
    own = joined(text_of(reproducible_plan(human_figure())))
    assert all(mark in own for mark in marks)


_FUNCTIONS = r"""
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#define ADAGEN_SOLVER
#include "adagen/settings.hpp"
struct Settings : PlainSettings {
  static constexpr int kJointCount = 1, kNq = 1, kNv = 1;
};
#define ADAGEN_BATCH
#include "adagen/far_angles_reduced.hpp"
#include "adagen/kernels/lanes.hpp"
#include "adagen/tangents.hpp"
extern "C" void circular(double x, double* found) { far_sine_and_cosine(x, found[0], found[1]); }
extern "C" double tangent(double x) { return hyperbolic_tangent(x); }
extern "C" double tangent_in_lanes(double x, int k) {
  Lanes all{};
  all[k % kLanes] = x;
  return hyperbolic_tangent(all)[k % kLanes];
}
"""


def test_functions_of_its_own(builder: Builder, tmp_path: Path) -> None:
    """Sines of large angles, and tangents, are right to about a unit in the last place."""
    source, library = tmp_path / "functions.cpp", tmp_path / "functions.so"
    source.write_text(joined(_FUNCTIONS))
    command = builder.toolchain.compile_command(source, library, False)
    subprocess.run([*command, "-shared", "-fPIC", "-ffp-contract=off"], check=True)
    loaded, found = ctypes.CDLL(str(library)), (ctypes.c_double * 2)()
    loaded.circular.argtypes = [ctypes.c_double, ctypes.POINTER(ctypes.c_double)]
    loaded.tangent.argtypes, loaded.tangent.restype = [ctypes.c_double], ctypes.c_double
    loaded.tangent_in_lanes.argtypes = [ctypes.c_double, ctypes.c_int]
    loaded.tangent_in_lanes.restype = ctypes.c_double
    rng = np.random.default_rng(3)
    # The first one is of all doubles the nearest to a multiple of pi/2.
    angles = [6381956970095103.0 * 2.0**797, 1.7e308, *np.exp(rng.uniform(9.1, 709.0, 2000))]
    with ctx.workprec(1300):
        for angle in [*angles, *(-x for x in angles)]:
            loaded.circular(angle, found)
            for value, exact in zip(found, (arb(angle).sin(), arb(angle).cos()), strict=True):
                assert abs(float((arb(value) - exact) / exact)) < 5e-16
        for x in [1e-300, 0.6249, 0.625, 19.99, *rng.uniform(-20, 20, 2000)]:
            exact = arb(x).tanh()
            assert abs(float((arb(loaded.tangent(x)) - exact) / exact)) < 3e-16
            own = loaded.tangent(x)
            assert [loaded.tangent_in_lanes(y, 3) for y in (x, -x)] == [own, -own]
            assert [float(y) for y in DOUBLE.tanh(np.array([x, -x]))] == [own, -own]
    limits = ((0.0, 0.0), (20.0, 1.0), (-1e300, -1.0), (5e-324, 5e-324), (-inf, -1.0))
    for x, expected in limits:
        assert loaded.tangent(x) == loaded.tangent_in_lanes(x, 5) == expected
        assert float(DOUBLE.tanh(x)) == expected
    assert isnan(loaded.tangent_in_lanes(nan, 1))
    assert isnan(DOUBLE.tanh(nan))
