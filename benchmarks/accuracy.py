"""Forward error and residual of emitted solvers, beside composite bodies and a dense solve.

    python -m benchmarks.accuracy [URDF ...] [--procs 1,2] [--states 5]
                                  [--write docs/records/accuracy.md]

The truth is computed with certified digits from the same model; errors are in the energy norm
sqrt(e^T H e / t^T H t) and, as the residual, of inverse dynamics. Without URDFs: the robots of
generated_examples/models.
"""

from __future__ import annotations

import platform
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import make_plan
from adagen.plan.cuts import cuttable_joints
from adagen.reference import forward_dynamics
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule
from adagen.states import States
from adagen.studies.bench.report import table
from adagen.studies.truth import DOUBLE, Errors, truth_of
from adagen.urdf import read_robot
from benchmarks.page import MODELS, command, publish
from benchmarks.solvers import answers, tell

Array = NDArray[np.float64]


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


def rows_of(path: Path, processes: Sequence[int], count: int) -> Iterator[tuple[object, ...]]:
    """Yield a row for every variant on one robot."""
    model = read_robot(path).model
    truth = truth_of(model, count, digits=DOUBLE)
    states = truth.states

    def row(variant: str, p: int, errors: Errors) -> tuple[object, ...]:
        return path.stem, model.nv, variant, p, *(f"{error:.1e}" for error in errors)

    dense = np.array([forward_dynamics(model, *state) for state in states.each])
    yield row("composite bodies, solve", 1, truth.errors(dense))
    for form, scalar in (("segment", "double"), ("ada", "double"), ("segment", "float")):
        for p in processes:
            try:
                found = emitted(model, form, scalar, p, states)
                yield row(f"{form}, {scalar}", p, truth.errors(found))
            except (AdagenError, RuntimeError) as error:
                reason = str(error).removeprefix("error: ").split(";")[0]
                yield path.stem, model.nv, f"{form}, {scalar}", p, reason, ""


def main() -> None:
    """Print the table, or put it into a document."""
    parser = command(__doc__)
    parser.add_argument("models", nargs="*", type=Path)
    parser.add_argument("--procs", default="1,2")
    parser.add_argument("--states", type=int, default=5)
    options = parser.parse_args()
    processes = [int(p) for p in options.procs.split(",")]
    rows: list[tuple[object, ...]] = []
    for path in options.models or sorted(MODELS.glob("*.urdf")):
        tell(path.stem)
        rows += rows_of(path, processes, options.states)
    lines = [
        f"{options.states} random states each, {platform.machine()}, "
        "`python -m benchmarks.accuracy`",
        "",
        *table(("robot", "DOF", "variant", "P", "forward error", "residual"), rows),
    ]
    publish(options, "accuracy", "\n".join(lines))


if __name__ == "__main__":
    main()
