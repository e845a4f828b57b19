"""Errors of what is emitted on the robots of the stability suite that are hardest for it.

    python -m benchmarks.emitted_digits [--states 10] [--write docs/stability.md]

The suite's state and random ones; each robot on one and two processes, scheduled as by default, in
each shape that takes its plan, beside the interpreter of the same plan. The truth is certified; the
errors are the largest in the energy norm sqrt(e^T H e / t^T H t).
"""

from __future__ import annotations

import argparse
import platform
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from adagen.emit.shapes import SHAPES, chosen_shape
from adagen.executor import interpret
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.reference import energy_norm_error, exact_forward_dynamics, joint_space_inertia
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States, random_states
from adagen.studies.stability import robots
from benchmarks.page import write_between_marks
from benchmarks.solvers import answers

Array = NDArray[np.float64]
ROBOTS = {
    "60 spherical joints": lambda: robots.spherical_rods(60),
    "30 links, masses graded 1 to 1e8": lambda: robots.graded(30, 1e8),
    "30 links, a tip of 1e8 kg": lambda: robots.with_mass(30, 30, 1e8),
    "a coil of 100 links": lambda: robots.coil(100),
}


def states_of(model: Model, count: int) -> States:
    """Return the suite's state and so many random ones."""
    first, more = robots.state(model), random_states(model, count, seed=1)
    return States(
        *(np.vstack([a, b]) for a, b in zip(first, (more.q, more.v, more.tau), strict=True))
    )


def row(name: str, model: Model, plan: Plan, states: States) -> str:
    """Return a row of the table: the errors of a plan in each shape and of its interpreter."""
    each = list(zip(states.q, states.v, states.tau, strict=True))
    truth = [exact_forward_dynamics(model, *state).value for state in each]
    inertia = [joint_space_inertia(model, q) for q in states.q]

    def largest(found: list[Array] | Array) -> str:
        rows = zip(inertia, found, truth, strict=True)
        return f"{max(energy_norm_error(h, x - t, t) for h, x, t in rows):.1e}"

    processes, cells = len(plan.processes), []
    for shape in ("kernels", "unrolled", "joints"):
        reason = SHAPES[shape].why_not(plan)
        mark = "**" if chosen_shape(plan) == shape else ""
        found = None if reason else largest(answers(plan, model, states, shape=shape).qdd)
        cells.append("" if found is None else f"{mark}{found}{mark}")
    cells.append(largest([interpret(plan, *state) for state in each]))
    return f"| {name} | {processes} | {' | '.join(cells)} |"


def main() -> int:
    """Print the table, or put it into a document."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--states", type=int, default=10)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    lines = [
        f"The suite's state and {options.states} random ones, {platform.machine()}, "
        "`python -m benchmarks.emitted_digits`; bold: the default shape",
        "",
        "| robot | P | kernels | unrolled | joints | interpreter |",
        "|---|---|---|---|---|---|",
    ]
    for name, make in ROBOTS.items():
        model = make()
        states = states_of(model, options.states)
        for processes in (1, 2):
            print(f"{name}, P = {processes}", file=sys.stderr)
            schedule = best_schedule(model, processes, load_profile("default"))
            plan = make_plan(model, schedule, form="segment")
            lines.append(row(name, model, plan, states))
    table = "\n".join(lines)
    if options.write is None:
        print(table)
    else:
        write_between_marks(options.write, "emitted_digits", table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
