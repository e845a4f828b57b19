"""Is the error estimate of refined solvers within a factor 3 of the true error?

    python -m benchmarks.estimates measure RECORD ROBOT.json ... [--procs 1,2] [--forms ...]
    python -m benchmarks.estimates report RECORD [--write docs/records/refinement.md]

ROBOT.json holds true answers beside ROBOT.urdf: {"modes": {"fixed": MODE, "floating": MODE}}, where
MODE is {"status": "ok", "joints": {NAME: {"q": [...], "v": [...], "tau": [...], "qdd": [...]}}}.
Each is solved for by a solver that refines once; the size of its correction is laid beside the
error of the answer that it had before, in the energy norm. The record, a line of JSON for each
robot and variant, is added to as it goes: what it has is not measured again. CXXFLAGS=-O1 has
solvers built in half the time.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.reference import energy_norm_error, exact_forward_dynamics, joint_space_inertia
from adagen.schedule import load_profile
from adagen.search.objective import schedule_for
from adagen.states import States, read_result, read_states
from adagen.urdf import read_robot
from benchmarks.estimates_report import report, within
from benchmarks.page import Record, publish
from benchmarks.solvers import answers, tell

Array = NDArray[np.float64]
FIELDS = ("q", "v", "tau")


@dataclass(frozen=True, eq=False)
class Subject:
    """A robot on a base, with true answers.

    Attributes:
        name: of robot and base.
        model: the robot.
        states: what is solved for.
        truth: accelerations as the file tells them, shape (S, nv).
    """

    name: str
    model: Model
    states: States
    truth: Array

    def error(self, s: int, found: Array) -> float:
        """Return the error of a state's answer against the file's truth, in the energy norm."""
        inertia = joint_space_inertia(self.model, self.states.q[s])
        return energy_norm_error(inertia, found - self.truth[s], self.truth[s])

    def own_error(self, s: int, found: Array) -> float:
        """Return the same against the exact answer of the robot as it was read.

        Constants of oblique frames are rounded where the file is read. The difference is formed
        before anything else is rounded.
        """
        q, v, tau = self.states.q[s], self.states.v[s], self.states.tau[s]
        exact = exact_forward_dynamics(self.model, q, v, tau, digits=25).raw
        wrong = [float(arb(x) - t) for x, t in zip(found, exact, strict=True)]
        return energy_norm_error(
            joint_space_inertia(self.model, q), wrong, [float(t) for t in exact]
        )


def subjects(path: Path) -> Iterator[Subject]:
    """Yield a robot on each base for which its file has true answers."""
    modes = json.loads(path.read_text(encoding="utf-8"))["modes"]
    for base, mode in modes.items():
        if mode["status"] != "ok":
            continue
        model = read_robot(path.with_suffix(".urdf"), floating=base == "floating").model
        with tempfile.TemporaryDirectory() as folder:
            given, true = Path(folder, "states.json"), Path(folder, "truth.json")
            given.write_text(_document(mode["joints"], FIELDS))
            true.write_text(_document(mode["joints"], ("qdd",)))
            yield Subject(
                f"{path.stem} {base}", model, read_states(given, model), read_result(true, model)
            )


def _document(joints: dict[str, Any], fields: Sequence[str]) -> str:
    rows = {name: {field: joint[field] for field in fields} for name, joint in joints.items()}
    return json.dumps({"joints": rows})


def planned(model: Model, form: str, scalar: str, processes: int) -> Plan:
    """Return the plan that ``adagen --refine`` makes."""
    schedule = schedule_for(
        "both", model, processes, load_profile("default"), form, scalar, gather=False
    )
    return make_plan(model, schedule, form=form, scalar=scalar)


def measured(subject: Subject, form: str, scalar: str, processes: int) -> dict[str, Any]:
    """Return what one variant reported of its errors, and what they are, state by state."""
    model, states = subject.model, subject.states
    try:
        plan = planned(model, form, scalar, processes)
        bounds = answers(plan, model, states, refine=1).corrections[:, 0]
        found = answers(plan, model, states, refine=1, raw=True).qdd
    except (AdagenError, RuntimeError) as error:
        return {"refused": str(error).splitlines()[0]}
    true = [subject.error(s, found[s]) for s in range(states.count)]
    own = [
        None if within(bounds[s], true[s]) else subject.own_error(s, found[s])
        for s in range(states.count)
    ]
    busy = sum(bool(process.owns) for process in plan.processes)
    return {"said": bounds.tolist(), "true": true, "own": own, "busy": busy}


def measure(options: argparse.Namespace) -> None:
    """Measure what the record lacks."""
    record = Record(options.record)
    chosen = list(product(options.procs, options.scalars, options.forms))
    for path in options.robots:
        for subject in subjects(path):
            for processes, scalar, form in chosen:
                key = [subject.name, form, scalar, processes]
                find = partial(measured, subject, form, scalar, processes)
                row = record.of({"key": key, "dof": subject.model.nv}, find)
                tell(f"{' '.join(map(str, key))} {row.get('refused', '')}")


def told(options: argparse.Namespace) -> None:
    """Print the tables, or put them into a document."""
    rows = [{"key": row["key"], **row["found"]} for row in Record(options.record).rows]
    publish(options, "estimates", report(rows))


def main(argv: Sequence[str] | None = None) -> int:
    """Measure, or print the tables or put them into a document."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    verbs = parser.add_subparsers(required=True)
    one = verbs.add_parser("measure")
    one.add_argument("record", type=Path)
    one.add_argument("robots", nargs="+", type=Path)
    one.add_argument("--procs", type=lambda text: [int(p) for p in text.split(",")], default=[1, 2])
    one.add_argument("--scalars", type=lambda text: text.split(","), default=["double"])
    one.add_argument("--forms", type=lambda text: text.split(","), default=["segment", "ada"])
    one.set_defaults(run=measure)
    other = verbs.add_parser("report")
    other.add_argument("record", type=Path)
    other.add_argument("--write", type=Path)
    other.set_defaults(run=told)
    options = parser.parse_args(argv)
    options.run(options)
    return 0


if __name__ == "__main__":
    main()
