"""Constants that are set at run time: from Python, C, on processes and threads, in all shapes."""

from __future__ import annotations

import copy
import pickle
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import adagen
from adagen.emit import emit, stem_of
from adagen.errors import UsageError
from adagen.model import Inertia, Model
from adagen.plan import plan_from_json, plan_to_json
from adagen.run import launch
from adagen.states import States, random_states, write_states
from tests.emitted import QUICK, ROUNDING, Builder, forward_error, plan_of, truth_of
from tests.end_to_end.test_library import BY_STEM, filled
from tests.golden.make_models import MODELS
from tests.slow import all_but, slow, spread

ARM, MOBILE, HUMANOID = (MODELS / f"{name}.urdf" for name in ("arm7", "mobile", "humanoid"))
MOON = np.array([0.1, -0.2, -1.62])


def build(path: Path, floating: bool = False, **asked: Any) -> adagen.Solver:
    return adagen.compile(adagen.read(path, floating=floating), **asked).build()


CASES: dict[str, tuple[Path, bool, dict[str, Any]]] = {
    "straight line": (ARM, False, {"shape": "unrolled"}),
    "loops": (ARM, False, {"shape": "kernels"}),
    "joints": (ARM, False, {"form": "ada", "shape": "joints"}),
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
    "loops refined wide": (ARM, False, {"refine": 1, "shape": "kernels", "residual": "wide"}),
    "refined joints": (ARM, False, {"form": "ada", "refine": 1, "shape": "joints"}),
    "threads": (HUMANOID, True, {"procs": 2, "channel": "threads", "schedule": "balanced"}),
}  # fmt: skip


SLOW = (
    *("joints", "refined joints", "loops refined wide", "the paper's form"),
    *("floating line", "batch of loops", "float", "refined loops"),
)
"""Each is like another one but for the shape, a base that floats, the scalar, or corrections."""


@pytest.mark.filterwarnings("ignore:humanoid_p2. 2 processes do not pay")
@pytest.mark.parametrize("case", all_but(CASES, *SLOW))
def test_gravity_is_set_at_run_time(case: str) -> None:
    path, floating, asked = CASES[case]
    solver = build(path, floating, runtime="gravity", **asked)
    assert all(process.owns for process in solver.compiled.plan.processes)
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
    with pytest.raises(ValueError, match="a value is not finite, a mass not positive"):
        solver.gravity = [0, np.nan, 0]
    with pytest.raises(ValueError, match=r"gravity has shape \(3,\), not \(2,\)"):
        solver.gravity = [0, 0]
    assert solver.gravity.tolist() == [0, 0, -9.81]
    fixed = build(ARM, shape="kernels")
    assert fixed.gravity.tolist() == [0, 0, -9.81]
    with pytest.raises(UsageError, match='compile with runtime="gravity"'):
        fixed.gravity = MOON
    with pytest.raises(UsageError, match="gravity is given twice"):
        adagen.compile(adagen.read(ARM), runtime="gravity,gravity")
    with pytest.raises(UsageError, match="not friction"):
        adagen.compile(adagen.read(ARM), runtime="gravity,friction")


def test_the_command_in_the_head_says_so(tmp_path: Path) -> None:
    compiled = adagen.compile(adagen.read(ARM), runtime="gravity")
    assert "--runtime=gravity" in compiled.in_folder(tmp_path)["arm7_p1.cpp"]
    assert "// run time  gravity can be set\n" in compiled.source
    assert "_LINK_" not in compiled.header
    payload = adagen.compile(adagen.read(ARM), runtime="mass:hand")
    assert '// run time  mass of "hand" can be set\n' in payload.source
    assert "ARM7_P1_LINK_hand = 0" in payload.header
    assert "arm7_p1_set_mass(" in payload.header
    assert "arm7_p1_set_center(" not in payload.header
    assert "arm7_p1_set_gravity(" not in payload.header
    assert plan_from_json(plan_to_json(compiled.plan)) == compiled.plan


def loaded(model: Model, link: str, mass: float, center: Any) -> Model:
    """Return a robot of which a link has another mass and centre of mass."""
    (k,) = (k for k, each in enumerate(model.links) if each.name == link)
    inertia = Inertia(mass, np.array(center), model.links[k].inertia.tensor)
    links = list(model.links)
    links[k] = replace(links[k], inertia=inertia)
    return replace(model, links=tuple(links))


MASSES: dict[str, tuple[Path, bool, dict[str, Any]]] = {
    name: CASES[name]
    for name in ("straight line", "loops", "in lanes", "floating loops", "planar joint",
                 "batch of lines", "batch of loops", "float", "threads")
}  # fmt: skip


@pytest.mark.parametrize("case", spread(MASSES, 3))
def test_masses_and_their_centres_are_set_at_run_time(case: str) -> None:
    path, floating, asked = MASSES[case]
    model = adagen.read(path, floating=floating).model
    names = [link.name for k, link in enumerate(model.links) if k and link.inertia.mass > 0]
    first, last = names[len(names) // 2], names[-1]
    words = f"mass:{first},gravity,center:{last},mass:{last}"
    solver = build(path, floating, runtime=words, **asked)
    states = random_states(model, 3, seed=4)
    enough = 4 * ROUNDING["float" if asked.get("scalar") == "float" else "double"]

    def error(expected: Model) -> float:
        found = solver(states.q, states.v, states.tau)
        return forward_error(found, truth_of(expected, states))

    assert error(model) < enough
    (mass, center), (other, at) = (
        (link.inertia.mass, link.inertia.com)
        for name in (first, last)
        for link in model.links
        if link.name == name
    )
    solver.set_mass(first, 1.5 * mass)
    model = loaded(model, first, 1.5 * mass, center)
    assert error(model) < enough
    moved = at + np.array([0.02, 0.01, -0.03])
    solver.set_center(last, moved)
    model = loaded(model, last, other, moved)
    assert error(model) < enough
    solver.set_mass(last, 0.7 * other)
    solver.gravity = MOON
    model = loaded(model, last, 0.7 * other, moved).with_gravity(MOON)
    assert error(model) < enough
    assert np.array_equal(
        copy.copy(solver)(states.q, states.v, states.tau), solver(states.q, states.v, states.tau)
    )


@pytest.mark.parametrize(
    ("runtime", "asked", "said"),
    [
        ("mass:forarm", {}, "mass:forarm: no moving link of this name; did you mean 'forearm'"),
        ("mass:camera", {}, "camera is fixed to hand: say mass:hand"),
        ("mass:pedestal", {}, "no moving link of this name"),
        (
            "mass:hand",
            {"refine": 1, "residual": "wide"},
            "masses cannot be set where answers are refined",
        ),
        ("mass:hand", {"form": "ada"}, "use --form segment or --procs 1"),
        ("center:", {}, "no moving link"),
    ],
)
def test_masses_that_cannot_be_set_are_told(runtime: str, asked: dict[str, Any], said: str) -> None:
    with pytest.raises(UsageError, match=said):
        adagen.compile(adagen.read(ARM), runtime=runtime, **asked)


def on_processes(model: Model, batch: bool, builder: Builder) -> list[str]:
    """Return what a program of two processes prints that sets gravity, a mass and its centre."""
    runtime = "gravity,center:hand,mass:hand"
    plan = plan_of(model, 1 if batch else 2, meeting="gather", runtime=runtime)
    files = emit(plan, name="falling", batch=2 * batch)
    stem = stem_of(plan, "falling", 2 * batch)
    solve, count = ("solve_batch", "1,") if batch else ("solve", "")
    text = filled("parameters.cpp", stem, SOLVER_SOLVE=f"{stem}_{solve}", COUNT=count)
    text = text.replace(f'#include "{stem}.h"\n', "")  # it stands in front
    source = f"#define ADAGEN_NO_MAIN\n{files[f'{stem}.h']}{files[f'{stem}.cpp']}{text}"
    done = launch(builder.compile(source, stem, QUICK), 2, [], builder.toolchain, 60)
    assert (done.status, done.stderr) == (0, "")
    return done.stdout.splitlines()


@pytest.mark.parametrize("batch", [slow(False), True])
def test_processes_go_by_what_process_0_has_set(batch: bool, builder: Builder) -> None:
    model = BY_STEM["arm7_p1"].model()
    earth, wrong, moon, told, heavy, each = on_processes(model, batch, builder)
    assert wrong == "1 a value is not finite, a mass not positive, or the constant cannot be set"
    assert told == "0 0 16 16 16"
    sizes = (model.nq, model.nv, model.ntau)
    state = States(*(np.full((1, n), x) for n, x in zip(sizes, (0.3, 0.2, 0.1), strict=True)))
    light, hand = model.with_gravity(MOON), (2.5, [0.1, -0.02, 0.03])
    sideways = model.with_gravity(np.array([9.81, 0, 0]))
    expected = [(earth, model), (moon, light), (heavy, loaded(light, "hand", *hand))]
    for line, robot in expected:
        found = np.array([line.split()], dtype=float)
        assert forward_error(found, truth_of(robot, state)) < ROUNDING["double"]
    # Each process has set gravity, but process 0 alone the hand, and process 1 has its from there.
    found = np.array([each.split()], dtype=float) / (2 if batch else 1)
    truth = truth_of(loaded(sideways, "hand", *hand), state)
    assert forward_error(found, truth) < ROUNDING["double"]


@pytest.mark.parametrize(
    ("runtime", "processes"),
    [
        slow("gravity", 2),
        ("", 1),
        *(pytest.param(*c, marks=pytest.mark.slow) for c in [("gravity", 1), ("", 2)]),
    ],
)
def test_a_program_goes_by_the_gravity_of_its_states(
    processes: int, runtime: str, builder: Builder, tmp_path: Path
) -> None:
    model = BY_STEM["arm7_p1"].model()
    light = model.with_gravity(MOON)
    plan = plan_of(model, processes, runtime=runtime)
    solver = builder.solver(plan, QUICK, name="program", shape="kernels")
    states = random_states(model, 3, seed=4)
    if runtime:
        found = solver.solve(light, states, tmp_path, "--check")
        assert forward_error(found, truth_of(light, states)) < ROUNDING["double"]
        return
    write_states(states, light, tmp_path / "states.json")
    done = solver.run("--states", tmp_path / "states.json")
    assert done.status == 1
    assert "another gravity is compiled into this solver" in done.stderr
