"""Solvers on 64-bit ARM: a cross compiler builds them by their Makefile, an emulator runs them."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

import adagen
from adagen.cli import main
from adagen.states import random_states, read_result, write_states
from tests.emitted import ROUNDING, Array, Builder, forward_error, make_variables, truth_of
from tests.end_to_end.test_library import run
from tests.golden.make_models import MODELS
from tests.mechanisms import states_of
from tests.slow import only

COMPILER, EMULATOR = "aarch64-linux-gnu-g++", "qemu-aarch64"
THREADS = "--channel threads --procs"
CASES = {
    "long chain": ("snake100", "--procs 1"),
    "long chain, two threads": ("snake100", f"{THREADS} 2"),
    "humanoid in lanes": ("humanoid", "--procs 1 --floating"),
    "humanoid in loops": ("humanoid", "--procs 1 --floating --shape kernels"),
    "humanoid, three threads": ("humanoid", f"{THREADS} 3 --floating --shape kernels"),
    "the paper's form": ("chain16", f"{THREADS} 4 --form ada"),
    "floats": ("arm7", "--procs 1 --scalar float --shape kernels"),
    "refined": ("arm7", "--procs 1 --refine 1 --shape kernels"),
    "balls": ("human40", "--procs 1 --shape kernels"),
    "batch": ("humanoid", "--procs 1 --batch --floating"),
    "batch of floats in loops": ("arm7", "--procs 1 --batch --scalar float --shape kernels"),
}
MAGNIFIED = 20
"""How much more than in ordinary robots rounding becomes in a chain of a hundred joints."""


@pytest.fixture(autouse=True)
def tools() -> None:
    for tool in (COMPILER, EMULATOR):
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is not installed: see docs/how_to/building.md")


def emitted(name: str, options: str, folder: Path) -> adagen.Robot:
    """Return a robot whose solver is written to a folder, by the name `own`."""
    model = MODELS / f"{name}.urdf"
    scene = model.with_suffix(".toml") if "--scene" in options else None
    options = options.replace("--scene", f"--scene={scene}")
    asked = [str(model), *options.split(), "--out", str(folder), "--name", "own"]
    assert main([*asked, "--quiet"]) == 0
    return adagen.read(model, floating="--floating" in options, scene=scene)


def built(folder: Path, builder: Builder, compiler: str, flags: str) -> Path:
    """Return the program that the folder's Makefile makes."""
    variables = (*make_variables(builder.toolchain), f"CXX={compiler}", f"CXXFLAGS={flags}")
    run("make", "-C", folder, *variables)
    (program,) = (path for path in folder.glob("own_p*") if not path.suffix)
    return program


@pytest.mark.parametrize("case", only(CASES, "humanoid in lanes"))
def test_answers_are_right(case: str, builder: Builder, tmp_path: Path) -> None:
    model = emitted(*CASES[case], tmp_path).model
    program = built(tmp_path, builder, COMPILER, "-O1 -static")
    states = random_states(model, 4, seed=6)
    write_states(states, model, tmp_path / "states.json")
    run(EMULATOR, program, "--states", tmp_path / "states.json", "--result", tmp_path / "qdd.json")
    found = read_result(tmp_path / "qdd.json", model)
    scalar = "float" if "float" in CASES[case][1] else "double"
    assert forward_error(found, truth_of(model, states)) < MAGNIFIED * ROUNDING[scalar]


@pytest.mark.slow
@pytest.mark.parametrize("options", ["", "--batch", "--scalar float", "--certify"])
@pytest.mark.parametrize(("name", "kind"), [("humanoid", "--floating"), ("ankle", "--scene")])
def test_reproducible_solvers_give_the_bits_of_x86(
    name: str, kind: str, options: str, builder: Builder, tmp_path: Path
) -> None:
    """Closed loops, too, in ordinary poses and poor ones."""
    model = emitted(name, f"--procs 1 --reproducible {options} {kind}", tmp_path).model
    drawn = states_of if model.loops else random_states
    write_states(drawn(model, 20, seed=7), model, tmp_path / "states.json")

    def answers(compiler: str, flags: str, *emulator: str) -> Array:
        program = built(tmp_path, builder, compiler, f"{flags} -static")
        given, result = tmp_path / "states.json", tmp_path / "qdd.json"
        run(*emulator, program, "--states", given, "--result", result)
        run("make", "-C", tmp_path, "clean")
        return read_result(result, model)

    here = answers(builder.toolchain.cxx[0], "-O2 -mavx2")
    assert np.array_equal(here, answers(COMPILER, "-O2", EMULATOR))
