"""Forward error and residual of emitted solvers, beside composite bodies and a dense solve.

    python -m benchmarks.accuracy [URDF ...] [--procs 1,2] [--states 5]
                                  [--write docs/records/accuracy.md]

The truth is computed with 60 certified digits from the same model; errors are in the energy norm
sqrt(e^T H e / t^T H t) and, as the residual, of inverse dynamics. Without URDFs: the robots of
generated_examples/models.
"""

from __future__ import annotations

import argparse
import platform
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import make_plan
from adagen.plan.cuts import cuttable_joints
from adagen.reference import (
    energy_norm_error,
    exact_forward_dynamics,
    forward_dynamics,
    joint_space_inertia,
    residual,
)
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule
from adagen.states import States, random_states
from adagen.urdf import read_robot
from benchmarks.page import write_between_marks
from benchmarks.solvers import answers

Array = NDArray[np.float64]
ROOT = Path(__file__).resolve().parents[1]


def emitted(model: Model, form: str, scalar: str, processes: int, states: States) -> Array:
    """Return the accelerations that an emitted solver gives, shape (S, nv)."""
    schedule = find_schedule(
        Topology.of(model),
        processes,
        profile=load_profile("default"),
        cuttable=cuttable_joints(model, scalar) if form == "segment" else None,
    )
    plan = make_plan(model, schedule, form=form, scalar=scalar)
    return answers(plan, model, states).qdd


def errors(model: Model, states: States, truth: Array, found: Array) -> tuple[float, float]:
    """Return the largest forward error in the energy norm, and the largest residual."""
    forward = back = 0.0
    for s in range(states.count):
        inertia = joint_space_inertia(model, states.q[s])
        forward = max(forward, energy_norm_error(inertia, found[s] - truth[s], truth[s]))
        back = max(back, residual(model, states.q[s], states.v[s], states.tau[s], found[s]))
    return forward, back


def rows_of(path: Path, processes: Sequence[int], count: int) -> list[str]:
    """Return a table row for every variant on one robot."""
    model = read_robot(path).model
    states = random_states(model, count, seed=1)
    each = list(zip(states.q, states.v, states.tau, strict=True))
    truth = np.array([exact_forward_dynamics(model, *state).value for state in each])
    dense = np.array([forward_dynamics(model, *state) for state in each])
    start = f"| {path.stem} | {model.nv} |"
    forward, back = errors(model, states, truth, dense)
    rows = [f"{start} composite bodies, solve | 1 | {forward:.1e} | {back:.1e} |"]
    for form, scalar in (("segment", "double"), ("ada", "double"), ("segment", "float")):
        for p in processes:
            try:
                found = emitted(model, form, scalar, p, states)
            except (AdagenError, RuntimeError) as error:
                reason = str(error).removeprefix("error: ").split(";")[0]
                rows.append(f"{start} {form}, {scalar} | {p} | {reason} | |")
                continue
            forward, back = errors(model, states, truth, found)
            rows.append(f"{start} {form}, {scalar} | {p} | {forward:.1e} | {back:.1e} |")
    return rows


def main() -> int:
    """Print the table, or put it into a document."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("models", nargs="*", type=Path)
    parser.add_argument("--procs", default="1,2")
    parser.add_argument("--states", type=int, default=5)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    models = options.models or sorted((ROOT / "generated_examples" / "models").glob("*.urdf"))
    processes = [int(p) for p in options.procs.split(",")]
    lines = [
        f"{options.states} random states each, {platform.machine()}, "
        "`python -m benchmarks.accuracy`",
        "",
        "| robot | DOF | variant | P | forward error | residual |",
        "|---|---|---|---|---|---|",
    ]
    for path in models:
        print(path.stem, file=sys.stderr)
        lines += rows_of(path, processes, options.states)
    table = "\n".join(lines)
    if options.write is None:
        print(table)
        return 0
    write_between_marks(options.write, "accuracy", table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
