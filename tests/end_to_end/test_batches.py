"""Batches of any size, with bad states among them, shared by processes of one host or several."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import adagen
from adagen.states import random_states, write_states
from tests.emitted import (
    QUICK,
    ROUNDING,
    Builder,
    Solver,
    forward_error,
    plan_of,
    states_text,
    truth_of,
)
from tests.end_to_end.hosts import APART
from tests.end_to_end.test_library import filled
from tests.golden.examples import EXAMPLES, FOLDER
from tests.slow import slow, spread

STEM = "arm7_batch_p2"
ARM = next(example for example in EXAMPLES if example.stem == STEM)
SIZES = (0, 1, 7, 8, 9, 16, 17, 63, 64, 65, 1000, 5003)
SPOILT = ((1, 0), (9, 8), (64, 0, 7, 8, 63), (1003, 5, 500, 1002), (16, *range(16)))


def _program(
    builder: Builder, stem: str, folder: Path, processes: int, *more: str, name: str = "batches"
) -> Solver:
    """The program around a solver whose source and header are in a folder."""
    object_file = builder.object_file((folder / f"{stem}.cpp").read_text(), stem)
    text = filled(f"{name}.cpp", stem)
    flags = (*QUICK, *more, f"-I{folder}", str(object_file))
    return Solver(builder.compile(text, name, flags), processes, builder.toolchain)


def _said(program: Solver, folder: Path) -> list[str]:
    """What the program printed, sorted."""
    states = random_states(ARM.model(), 37, seed=4)
    np.savetxt(folder / "states", [np.concatenate(row) for row in states.each], fmt="%.17g")
    cases = [str(n) for n in SIZES] + [" ".join(map(str, case)) for case in SPOILT]
    done = program.run("message", folder / "states", *cases)
    assert (done.status, done.stderr) == (0, "")
    return sorted(done.stdout.splitlines())


@pytest.fixture(scope="module")
def program(builder: Builder) -> Solver:
    return _program(builder, STEM, FOLDER / STEM, 2)


@pytest.fixture(scope="module", params=["one host", *APART])
def said(
    request: pytest.FixtureRequest, program: Solver, tmp_path_factory: pytest.TempPathFactory
) -> list[str]:
    variables = APART.get(request.param, ())
    apart = replace(program.toolchain, environment=(*program.toolchain.environment, *variables))
    return _said(replace(program, toolchain=apart), tmp_path_factory.mktemp("batches"))


@pytest.mark.parametrize("who", ["alone", "shared"])
def test_a_batch_of_any_size_is_solved_as_its_states_are_one_by_one(
    who: str, said: list[str]
) -> None:
    for size in SIZES:
        assert f"{who} {size}: fine;; same" in said


@pytest.mark.parametrize("who", ["alone", "shared"])
def test_bad_states_are_named_and_all_others_solved(who: str, said: list[str]) -> None:
    joint = ARM.model().joints[3].name
    for size, *bad in SPOILT:
        assert _named(who, joint, size, bad) in said


def _named(who: str, joint: str, size: int, bad: list[int]) -> str:
    """What is said where some states of a batch are bad."""
    why = f'state {bad[0] + 1}: joint "{joint}": its q, v or tau is not a finite number'
    why += f" (and {len(bad) - 1} more states)" * (len(bad) > 1)
    numbers = " ".join(map(str, bad))
    return f"{who} {size} {numbers}: failed; {why}; {numbers}; same"


@pytest.mark.parametrize(
    ("processes", "shape"), [(2, "kernels"), slow(2, "unrolled"), (3, "unrolled")]
)
def test_every_state_has_the_bound_that_it_has_alone_whoever_solves_it(
    processes: int, shape: str, builder: Builder, tmp_path: Path
) -> None:
    """Of batches with bounds and without by turns; bad states have none."""
    made = adagen.compile(
        adagen.read(ARM.urdf), procs=processes, batch=True, certify=True, shape=shape
    )
    for name in (f"{made.stem}.cpp", f"{made.stem}.h"):
        (tmp_path / name).write_text(made.files[name])
    program = _program(builder, made.stem, tmp_path, processes, "-DCERTIFIED")
    said, joint = _said(program, tmp_path), ARM.model().joints[3].name
    for who in ("alone", "shared"):
        for size in SIZES:
            assert f"{who} {size}: fine;; same" in said
        for size, *bad in SPOILT:
            assert _named(who, joint, size, bad) in said


def test_what_a_late_process_owes_is_no_number(builder: Builder) -> None:
    """Nothing is left of what was there before the call; in later calls nothing is answered."""
    done = _program(builder, STEM, FOLDER / STEM, 2, name="late_batch").run(timeout=60)
    assert (done.status, done.stderr) == (0, "")
    told = "process 1 did not answer within the time limit"
    assert done.stdout.splitlines() == [f"1 0 1 1 -1: {told}"] * 2


def test_the_other_processes_do_not_hear_of_bad_states(said: list[str]) -> None:
    assert len(said) == 2 * (len(SIZES) + len(SPOILT))


@pytest.mark.parametrize("shape", spread(["kernels", "unrolled"], 1))
@pytest.mark.parametrize("scalar", spread(["double", "float"], 1))
def test_a_program_names_states_with_bad_quaternions_and_answers_the_others(
    scalar: str, shape: str, builder: Builder, tmp_path: Path
) -> None:
    model = next(e for e in EXAMPLES if e.stem == "humanoid_p1").model()
    plan = plan_of(model, 1, scalar=scalar)
    solver = builder.solver(plan, name="humanoid", batch=2, shape=shape)
    states = random_states(model, 23, seed=6)
    data = states_text(model, states, tmp_path)
    for bad in (4, 20):
        data["joints"]["__base__"]["q"][bad][3:] = [0, 0, 0, 0]
    given, result = tmp_path / "given.json", tmp_path / "result.json"
    given.write_text(json.dumps(data))
    done = solver.run("--states", given, "--result", result, "--check")
    assert done.status == 1
    why = 'joint "__base__": its quaternion cannot be normalised'
    assert done.stderr.splitlines() == [
        f"{given}: error: state 5: {why}",
        f"{given}: error: state 21: {why}",
    ]
    answers = json.loads(result.read_text())["joints"]
    qdd = np.array(
        [
            np.reshape(np.array(answers[j.name]["qdd"], dtype=float), (23, -1))
            for j in model.joints[1:]
        ]
    )[..., 0].T
    assert np.array_equal(np.flatnonzero(np.isnan(qdd).any(axis=1)), [4, 20])
    good = [0, 3, 5, 19, 21, 22]
    few = replace(states, q=states.q[good], v=states.v[good], tau=states.tau[good])
    truth = truth_of(model, few)
    assert forward_error(qdd[good], truth[:, 6:]) < ROUNDING[scalar]
    write_states(few, model, given)
    assert solver.run("--states", given, "--result", result, "--check").status == 0


def test_slaved_joints_are_in_step_in_batches_too(builder: Builder, tmp_path: Path) -> None:
    model = next(example for example in EXAMPLES if example.mimic).model()
    solver = builder.solver(plan_of(model, 1), name="slaved", batch=1)
    states = random_states(model, 11, seed=7)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]
