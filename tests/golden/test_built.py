"""The examples compile without a warning, run, and are right."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from adagen.emit.solver_program import PROGRAM_FILE
from adagen.reference.closed import closed_forward_dynamics
from adagen.states import States, random_states
from tests.emitted import QUICK, Array, Builder, Solver, forward_error, make_variables, truth_of
from tests.golden.examples import EXAMPLES, FOLDER, Example
from tests.mechanisms import states_of
from tests.slow import spread

BY_STEM = {example.stem: example for example in EXAMPLES}
TRUTHS: dict[tuple[str, bool, bool], tuple[States, Array]] = {}
LARGEST_ERROR = {"double": 5e-12, "float": 2e-5}
"""Forward error that is let pass; measured: 4e-13 (the chain) and 2e-6 at most."""


def truth(example: Example) -> tuple[States, Array]:
    """Return random states of an example's robot and the true accelerations."""
    key = (example.robot, example.floating, example.mimic)
    if key not in TRUTHS:
        model = example.model()
        if example.closed:
            states = states_of(model, 4, seed=3)
            answers = np.array([closed_forward_dynamics(model, *row) for row in states.each])
        else:
            states = random_states(model, 4, seed=3)
            answers = truth_of(model, states)
        TRUTHS[key] = states, answers
    return TRUTHS[key]


def built(example: Example, builder: Builder) -> Solver:
    """Return the program of an example as it is in the folder."""
    source = (FOLDER / example.stem / f"{example.stem}.cpp").read_text()
    executable = builder.compile(source, example.stem, QUICK)
    return Solver(executable, example.processes, builder.toolchain)


@pytest.mark.parametrize("stem", spread(BY_STEM, 6))
def test_an_example_is_right_through_both_channels(
    stem: str, builder: Builder, tmp_path: Path
) -> None:
    example = BY_STEM[stem]
    solver = built(example, builder)
    states, expected = truth(example)
    found = []
    for channel in ("window", "message") if example.processes > 1 else ("auto",):
        words = ("--channel", channel, "--check")
        found.append(solver.solve(example.model(), states, tmp_path, *words))
        assert forward_error(found[-1], expected) < LARGEST_ERROR[example.scalar]
    assert all(np.array_equal(found[0], other) for other in found)


@pytest.mark.parametrize("stem", BY_STEM)
def test_an_example_passes_its_own_check_and_is_timed(stem: str, builder: Builder) -> None:
    done = built(BY_STEM[stem], builder).run("--check", "--time", "--repeat", "2")
    assert (done.status, done.stderr) == (0, "")
    check, sure, *time = done.stdout.splitlines()
    assert re.match(
        r"check  \d+\.\d digits of the accelerations are certain: state \d+, joint", sure
    )
    steps = BY_STEM[stem].refine or 0
    refined, time = time[:steps], time[steps:]
    assert all(line.startswith("refine error before step ") for line in refined)
    assert check.startswith("check ") and check.endswith(": right")
    assert time[0].startswith(f"time   {BY_STEM[stem].processes} process")
    # A batch tells states per second, too, on one process and on two.
    assert sum("in place  " in line for line in time) == 1 + BY_STEM[stem].batch
    rows = [line.split() for line in time]
    numbers = [row[0] for row in rows if row[1].startswith("process") and row[0].isdigit()]
    assert numbers == (["1", "2"] if BY_STEM[stem].batch else [])


@pytest.mark.parametrize("stem", [e.stem for e in EXAMPLES if not e.batch])
def test_an_example_tells_what_its_processes_compute(stem: str, builder: Builder) -> None:
    done = built(BY_STEM[stem], builder).run("--stretches", "--json", "--repeat", "2")
    assert (done.status, done.stderr) == (0, "")
    time = json.loads(done.stdout)["time"]
    assert time["source"] == "stretches" and len(time["work_ns"]) == BY_STEM[stem].processes
    assert 0 < time["in_place"]["min_ns"] <= time["in_place"]["median_ns"]


def test_the_makefile_builds_and_checks_every_example(builder: Builder) -> None:
    command = [
        "make",
        "-n",
        "-C",
        str(FOLDER),
        *make_variables(builder.toolchain),
        "OUT=out",
        "check",
    ]
    said = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout
    for example in EXAMPLES:
        text = (FOLDER / example.stem / f"{example.stem}.cpp").read_text()
        links = re.findall("^// links .*", text, re.MULTILINE)[0]
        kind = "".join(f"_{word.lower()}" for word in ("MPI", "FLOAT") if word in links)
        assert f" out/adagen_program{kind}.o -o out/{example.stem}/{example.stem}\n" in said
        line = f"-n {example.processes} --oversubscribe --bind-to none "
        assert f"{line}out/{example.stem}/{example.stem} --check\n" in said


def test_another_mpi_than_open_mpi_gets_only_what_all_know(tmp_path: Path) -> None:
    launcher = tmp_path / "mpiexec"
    launcher.write_text("#!/bin/sh\necho HYDRA build details:\n")
    launcher.chmod(0o755)
    command = ["make", "-n", "-C", str(FOLDER / "humanoid_p3"), f"MPIEXEC={launcher}", "check"]
    said = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout
    assert f"{launcher} -n 3 ./humanoid_p3 --check\n" in said


@pytest.mark.parametrize("stems", [["mobile_p1"], pytest.param([*BY_STEM], marks=pytest.mark.slow)])
def test_make_in_the_folder_of_examples_works(
    stems: list[str], builder: Builder, tmp_path: Path
) -> None:
    folder = tmp_path / "generated_examples"
    folder.mkdir()
    out = tmp_path / "build" / "generated_examples"
    for name in ("Makefile", PROGRAM_FILE):
        shutil.copy(FOLDER / name, folder)
    shutil.copytree(FOLDER / "adagen", folder / "adagen")
    for stem in stems:
        shutil.copytree(FOLDER / stem, folder / stem)
    default = {name: value for name, value in os.environ.items() if name != "CXXFLAGS"}
    for target in ("all", "check", "clean"):
        command = ["make", "-C", str(folder), *make_variables(builder.toolchain), target]
        done = subprocess.run(command, capture_output=True, text=True, timeout=1200, env=default)
        assert done.returncode == 0, done.stderr
        assert "warning" not in done.stderr
        if target == "all":
            assert all((out / stem / stem).is_file() for stem in stems)
        if target == "check":
            assert done.stdout.count(": right") == len(stems)
    assert not out.exists()
