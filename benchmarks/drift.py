"""What 100 simulated seconds of linkages lose: how far loops open, and the energy's drift.

    python -m benchmarks.drift [--seconds 100] [--steps 1e-3,2.5e-4] [--only NAME ...]
        [--mechanisms FOLDER] [--write docs/records/loops.md]

Solvers are emitted and simulate by RK4 from a closed state without torques; loops are projected
after each step (`--simulate`). A second, finer step is the reference. FOLDER holds further
linkages (NAME.urdf, NAME.scene.toml).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

from adagen.build import build_executable, find_toolchain
from adagen.emit import stem_of
from adagen.errors import AdagenError
from adagen.library import read
from adagen.model import Model
from adagen.reference.closed import constraints
from adagen.states import States
from adagen.studies.bench.report import table
from adagen.studies.chart.motion import Played, Player, drifts, state_error
from adagen.studies.chart.variants import REFERENCE
from adagen.studies.random_states import drawn_states
from benchmarks.closed_robots import MECHANISMS, on_springs
from benchmarks.page import command, publish
from benchmarks.solvers import tell

SPRINGS = "g1 on both feet, on springs"
DRIFTS = ("energy's drift", "from the finest step")


def _player(model: Model) -> Player:
    _, plan = REFERENCE.plan(model)
    toolchain, stem = find_toolchain(), stem_of(plan)
    program = build_executable(REFERENCE.files(plan)[f"{stem}.cpp"], stem, toolchain)
    return Player(model, program, len(plan.processes), toolchain)


def _read(urdf: Path, scene: Path) -> Model:
    return read(urdf, scene=scene).model


def _open(model: Model, motion: Played) -> float:
    """Return how far loops open along a motion, m or rad."""
    return max(float(np.abs(constraints(model, q).gaps).max()) for q in motion.q)


def _start(name: str, model: Model) -> States:
    """A random closed state without torques; on springs the pose in which these are at rest."""
    if name == SPRINGS:
        _, pose = on_springs()
        return States(pose[None, :], np.zeros((1, model.nv)), np.zeros((1, model.ntau)))
    state = drawn_states(model, 1, seed=1)
    return States(state.q, state.v, np.zeros_like(state.tau))


def rows_of(
    name: str, model: Model, seconds: float, steps: tuple[float, ...]
) -> list[tuple[str, ...]]:
    """Return a linkage's rows of the table, one for each step."""
    player, start = _player(model), _start(name, model)
    found = {step: player.play(start, seconds, step, "rk4") for step in steps}
    finest = found[min(steps)]
    rows: list[tuple[str, ...]] = []
    for step, motion in found.items():
        energy, _ = drifts(model, motion)
        apart = "-" if motion is finest else f"{state_error(model, motion, finest):.0e}"
        kept = "-" if energy is None else f"{energy:.0e}"
        rows.append((name, f"{step:g}", f"{_open(model, motion):.0e}", kept, apart))
    return rows


def main() -> None:
    """Print the table, or put it into a document."""
    parser = command(__doc__)
    parser.add_argument("--seconds", type=float, default=100.0)
    parser.add_argument("--steps", default="1e-3,2.5e-4")
    parser.add_argument("--only", nargs="+", metavar="NAME")
    parser.add_argument("--mechanisms", type=Path)
    options = parser.parse_args()
    known: dict[str, Callable[[], Model]] = {**MECHANISMS, SPRINGS: lambda: on_springs()[0]}
    for scene in sorted(options.mechanisms.glob("*.scene.toml")) if options.mechanisms else ():
        name = scene.name.removesuffix(".scene.toml")
        urdf = scene.with_name(f"{name}.urdf")
        known[name] = partial(_read, urdf, scene)
    steps = tuple(float(step) for step in options.steps.split(","))
    rows: list[tuple[str, ...]] = []
    for name in options.only or known:
        try:
            rows += rows_of(name, known[name](), options.seconds, steps)
        except AdagenError as error:
            rows.append((name, "", str(error).removeprefix("error: "), "", ""))
        tell(", ".join(rows[-1]))
    lines = [
        f"RK4, {options.seconds:g} s from a random closed state, no torques; on springs from rest.",
        "",
        *table(("linkage", "step, s", "loops open by, m or rad", *DRIFTS), rows),
    ]
    publish(options, "drift", "\n".join(lines))


if __name__ == "__main__":
    main()
