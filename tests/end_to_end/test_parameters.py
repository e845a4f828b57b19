"""Constants that are set at run time: from Python, C, on processes and threads, in all shapes."""

from __future__ import annotations

import copy
import pickle
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.emit import emit, stem_of
from adagen.errors import UsageError
from adagen.model import Model
from adagen.plan import plan_from_json, plan_to_json
from adagen.run import launch
from adagen.states import States, random_states
from tests.emitted import QUICK, ROUNDING, Builder, forward_error, plan_of, truth_of
from tests.end_to_end.test_library import BY_STEM, filled
from tests.golden.make_models import MODELS

ARM, MOBILE, HUMANOID = (MODELS / f"{name}.urdf" for name in ("arm7", "mobile", "humanoid"))
MOON = np.array([0.1, -0.2, -1.62])


@pytest.fixture(autouse=True, scope="module")
def _cache(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """A cache of builds, for this module alone; compiled fast."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        patch.setenv("CXXFLAGS", "-O1")
        yield


def build(path: Path, floating: bool = False, **asked: Any) -> adagen.Solver:
    return adagen.compile(adagen.read(path, floating=floating), **asked).build()


CASES: dict[str, tuple[Path, bool, dict[str, Any]]] = {
    "straight line": (ARM, False, {"shape": "unrolled"}),
    "loops": (ARM, False, {"shape": "kernels"}),
    "joints": (ARM, False, {"shape": "joints"}),
    "the paper's form": (ARM, False, {"form": "ada", "shape": "joints", "procs": 2,
                                      "channel": "threads"}),
    "in lanes": (HUMANOID, False, {"shape": "unrolled"}),
    "planar joint": (MOBILE, False, {"shape": "kernels"}),
    "floating loops": (HUMANOID, True, {"shape": "kernels"}),
    "floating line": (ARM, True, {"shape": "unrolled"}),
    "batch of lines": (ARM, False, {"batch": True, "shape": "unrolled"}),
    "batch of loops": (ARM, False, {"batch": True, "shape": "kernels"}),
    "float": (ARM, False, {"scalar": "float"}),
    "refined loops": (ARM, False, {"refine": 1, "shape": "kernels"}),
    "refined joints": (ARM, False, {"refine": 1, "shape": "joints"}),
    "mixed": (ARM, False, {"scalar": "mixed"}),
    "threads": (HUMANOID, True, {"procs": 2, "channel": "threads"}),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_gravity_is_set_at_run_time(case: str) -> None:
    path, floating, asked = CASES[case]
    solver = build(path, floating, runtime="gravity", **asked)
    model = solver.compiled.model
    states = random_states(model, 3, seed=4)
    enough = 4 * ROUNDING["float" if asked.get("scalar") == "float" else "double"]
    for gravity in (model.gravity, MOON, -model.gravity[::-1]):
        if gravity is not model.gravity:
            solver.gravity = gravity
        assert np.array_equal(solver.gravity, gravity)
        truth = truth_of(model.with_gravity(gravity), states)
        assert forward_error(solver(states.q, states.v, states.tau), truth) < enough


def test_gravity_goes_with_copies_and_pickles() -> None:
    solver = build(ARM, runtime="gravity", shape="kernels")
    solver.gravity = MOON
    states = random_states(solver.compiled.model, 2, seed=4)
    found = solver(states.q, states.v, states.tau)
    for other in (copy.copy(solver), copy.deepcopy(solver), pickle.loads(pickle.dumps(solver))):
        assert np.array_equal(other(states.q, states.v, states.tau), found)
        other.gravity = [0, 0, 0]
        assert np.array_equal(solver(states.q, states.v, states.tau), found)


def test_what_cannot_be_set_is_told() -> None:
    solver = build(ARM, runtime="gravity", shape="kernels")
    with pytest.raises(ValueError, match="what is to be set at run time is not a finite number"):
        solver.gravity = [0, np.nan, 0]
    with pytest.raises(ValueError, match=r"gravity has shape \(3,\), not \(2,\)"):
        solver.gravity = [0, 0]
    assert solver.gravity.tolist() == [0, 0, -9.81]
    fixed = build(ARM, shape="kernels")
    assert fixed.gravity.tolist() == [0, 0, -9.81]
    with pytest.raises(UsageError, match='compile with runtime="gravity"'):
        fixed.gravity = MOON
    with pytest.raises(UsageError, match="gravity is to be set at run time twice"):
        adagen.compile(adagen.read(ARM), runtime="gravity,gravity")
    with pytest.raises(UsageError, match="not friction"):
        adagen.compile(adagen.read(ARM), runtime="gravity,friction")


def test_the_command_in_the_head_says_so(tmp_path: Path) -> None:
    compiled = adagen.compile(adagen.read(ARM), runtime="gravity")
    assert "--runtime=gravity" in compiled.in_folder(tmp_path)["arm7_p1.cpp"]
    assert plan_from_json(plan_to_json(compiled.plan)) == compiled.plan


def on_processes(model: Model, batch: bool, builder: Builder, tmp_path: Path) -> list[str]:
    """Return what a program of two processes prints that sets gravity."""
    plan = plan_of(model, 1 if batch else 2, runtime="gravity")
    options = {"batch": 2 * batch, "shape": "auto"}
    files = emit(plan, name="falling", **options)  # type: ignore[arg-type]
    stem = stem_of(plan, "falling", 2 * batch)
    (tmp_path / f"{stem}.h").write_text(files[f"{stem}.h"])
    solve, count = ("solve_batch", "1,") if batch else ("solve", "")
    words = {"SOLVER_SOLVE": f"{stem}_{solve}", "COUNT": count}
    text = filled("gravity.cpp", stem, **words)
    source = f"#define ADAGEN_NO_MAIN\n{files[f'{stem}.cpp']}"
    both = source + re.sub(r'#include "falling_p2.h"', "", text)
    program = builder.compile(both, stem, QUICK)
    done = launch(program, 2, ["auto"], builder.toolchain, 60)
    assert (done.status, done.stderr) == (0, "")
    return done.stdout.splitlines()


@pytest.mark.parametrize("batch", [False, True])
def test_processes_agree_on_gravity(batch: bool, builder: Builder, tmp_path: Path) -> None:
    model = BY_STEM["arm7_p1"].model()
    earth, wrong, *others = on_processes(model, batch, builder, tmp_path)
    assert wrong == "1 what is to be set at run time is not a finite number"
    sizes = (model.nq, model.nv, model.ntau)
    state = States(*(np.full((1, n), x) for n, x in zip(sizes, (0.3, 0.2, 0.1), strict=True)))
    sideways = [9.81, 0, 0]
    shares = 2 if batch else 1  # each process has solved the state of the batch
    expected = [(earth, model.gravity, 1), *((line, MOON, 1) for line in others[:2])]
    for line, gravity, share in [*expected, (others[2], sideways, shares)]:
        truth = truth_of(model.with_gravity(np.array(gravity)), state)
        found = np.array([line.split()], dtype=float) / share
        assert forward_error(found, truth) < ROUNDING["double"]
