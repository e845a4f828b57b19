"""Processes that compute, and have none of the few accelerations that a scene wants."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import adagen
from adagen.plan.types import THREADS
from adagen.states import random_states
from tests.emitted import ROUNDING, Builder, truth_of
from tests.golden.make_models import MODELS
from tests.slow import slow

WANTED = "joint002"


@pytest.mark.parametrize(
    ("channel", "words"),
    [
        ("threads", ()),
        ("auto", ("--channel", "window")),
        slow("auto", ("--channel", "message")),
    ],
)
def test_all_processes_take_part(
    channel: str, words: tuple[str, ...], builder: Builder, tmp_path: Path
) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(f'accelerations = ["{WANTED}"]\n')
    robot = adagen.read(MODELS / "snake100.urdf", scene=scene)
    compiled = adagen.compile(robot, procs=2)
    plan, model = compiled.plan, compiled.model
    answering = [any(plan.wants(j) for j in process.owns) for process in plan.processes]
    assert all(process.owns for process in plan.processes) and answering == [True, False]

    solver = builder.solver(replace(plan, channel=THREADS) if channel == "threads" else plan)
    states = random_states(model, 3, seed=4)
    found = solver.solve(model, states, tmp_path, *words)
    place = next(j for j, joint in enumerate(model.joints) if joint.name == WANTED)
    entry = plan.joints[place].v
    true = truth_of(model, states)[:, entry]
    assert np.allclose(found[:, entry], true, rtol=100 * ROUNDING["double"], atol=0)
    for asked in (("--check",), ("--time", "--repeat", "2")):  # in place and through process 0
        done = solver.run(*asked, *words)
        assert (done.status, done.stderr) == (0, "")
