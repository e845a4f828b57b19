"""Motions that emitted programs simulate."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.model import Model
from adagen.states import States, random_states, write_states
from tests.emitted import Builder, Solver, plan_of

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Motion:
    """A simulated trajectory and what the program reported."""

    time: Array
    q: Array
    v: Array
    told: dict[str, Any]


@dataclass(frozen=True)
class Stage:
    """A robot, its program and a folder to work in."""

    model: Model
    solver: Solver
    folder: Path

    def play(self, state: States, seconds: float, step: float, *words: str) -> Motion:
        """Simulate; return the trajectory."""
        write_states(state, self.model, self.folder / "s.json")
        path = self.folder / "t.npz"
        asked = ["--simulate", repr(seconds), "--step", repr(step), "--trajectory", str(path)]
        done = self.solver.run("--states", self.folder / "s.json", *asked, "--json", *words)
        assert (done.status, done.stderr) == (0, "")
        with np.load(path) as found:
            names = [name.decode() for name in found["joints"]]
            assert names == [joint.name for joint in self.model.joints]
            told = json.loads(done.stdout)["simulation"]
            return Motion(found["time"], found["q"], found["v"], told)


def stage(model: Model, builder: Builder, folder: Path, processes: int = 1) -> Stage:
    return Stage(model, builder.solver(plan_of(model, processes)), folder)


def still_torques(model: Model, seed: int = 2) -> States:
    state = random_states(model, 1, seed)
    return States(state.q, state.v, np.zeros_like(state.tau))


def fitted_order(steps: Sequence[float], errors: Sequence[float]) -> float:
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
