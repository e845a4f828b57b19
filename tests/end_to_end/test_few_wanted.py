"""Processes that compute, and have none of the few accelerations that a scene wants."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import adagen
from adagen.library import Compiled
from adagen.plan.types import THREADS
from adagen.states import States, random_states
from tests.emitted import ROUNDING, Array, Builder, truth_of
from tests.golden.make_models import MODELS
from tests.slow import slow

WANTED = "joint02"


@pytest.fixture(scope="module")
def wanted(tmp_path_factory: pytest.TempPathFactory) -> tuple[Compiled, States, Array]:
    return compiled_for_two(tmp_path_factory.mktemp("wanted"))


def compiled_for_two(folder: Path, channel: str = "auto") -> tuple[Compiled, States, Array]:
    """A robot compiled for two processes, three states of it, and the acceleration in each."""
    scene = folder / "scene.toml"
    scene.write_text(f'accelerations = ["{WANTED}"]\n')
    robot = adagen.read(MODELS / "chain16.urdf", scene=scene)
    compiled = adagen.compile(robot, procs=2, channel=channel, schedule="balanced")
    states = random_states(compiled.model, 3, seed=4)
    return compiled, states, truth_of(compiled.model, states)[:, entry(compiled)]


def entry(compiled: Compiled) -> int:
    """Return which acceleration is wanted."""
    joints = compiled.model.joints
    return compiled.plan.joints[next(j for j, x in enumerate(joints) if x.name == WANTED)].v


@pytest.mark.parametrize(
    ("channel", "words"),
    [
        ("threads", ()),
        ("auto", ("--channel", "window")),
        slow("auto", ("--channel", "message")),
    ],
)
def test_all_processes_take_part(
    channel: str,
    words: tuple[str, ...],
    wanted: tuple[Compiled, States, Array],
    builder: Builder,
    tmp_path: Path,
) -> None:
    compiled, states, true = wanted
    plan, model = compiled.plan, compiled.model
    answering = [any(plan.wants(j) for j in process.owns) for process in plan.processes]
    assert all(process.owns for process in plan.processes) and answering == [True, False]

    solver = builder.solver(replace(plan, channel=THREADS) if channel == "threads" else plan)
    found = solver.solve(model, states, tmp_path, *words)
    assert np.allclose(found[:, entry(compiled)], true, rtol=100 * ROUNDING["double"], atol=0)
    for asked in (("--check",), ("--time", "--repeat", "2")):  # in place and through process 0
        done = solver.run(*asked, *words)
        assert (done.status, done.stderr) == (0, "")


@pytest.mark.filterwarnings("ignore:chain16_p2. 2 processes do not pay")
def test_in_python_all_else_is_no_number(tmp_path: Path) -> None:
    """Threads write into an array of their own, which is copied as a whole."""
    compiled, states, true = compiled_for_two(tmp_path, channel="threads")
    found = compiled.build()(states.q, states.v, states.tau)
    assert np.isnan(np.delete(found, entry(compiled), axis=1)).all()
    assert np.allclose(found[:, entry(compiled)], true, rtol=100 * ROUNDING["double"], atol=0)
