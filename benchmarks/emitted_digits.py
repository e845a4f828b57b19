"""Errors of what is emitted on the robots of the stability suite that are hardest for it.

    python -m benchmarks.emitted_digits [--states 5] [--write docs/records/stability.md]

The suite's state and random ones; each robot scheduled as by default, as loops (shape kernels),
beside the executor of the same plan in double, which straight lines equal to the last bit where
products are not added in one. The truth is certified; the errors are the largest in the energy norm
sqrt(e^T H e / t^T H t).
"""

from __future__ import annotations

import platform
from collections.abc import Callable

import numpy as np

from adagen.executor import interpret
from adagen.model import Inertia, Model
from adagen.plan import Plan, make_plan
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import random_states
from adagen.studies.bench.report import table
from adagen.studies.stability import robots
from adagen.studies.truth import DOUBLE, truth_of
from benchmarks.page import command, publish
from benchmarks.solvers import answers, tell


def slender_tool(radius: float) -> Model:
    """Return three axes x, y, z through rods of 1 m, the last rod of another radius, m."""
    links = [robots.rod(), robots.rod(), robots.rod(radius=radius)]
    return robots.chain("slender tool", links, axes="xyz")


def light_wrists() -> Model:
    """Return 40 rods on three axes each, through links of 1e-4 kg and 2 cm."""
    light = Inertia(1e-4, np.zeros(3), np.eye(3) * 4e-8)
    return robots.three_axis(40, light)


Case = tuple[Callable[[], Model], int, str]
ROBOTS: dict[str, Case] = {
    "3 joints, a tool of 2 um radius": (lambda: slender_tool(2e-6), 1, "double"),
    "3 joints, a tool of 5 mm radius": (lambda: slender_tool(5e-3), 1, "float"),
    "30 links, masses graded 1 to 1e8": (lambda: robots.graded(30, 1e8), 1, "double"),
    "30 links, a tip of 1e8 kg": (lambda: robots.with_mass(30, 30, 1e8), 1, "double"),
    "three axes through massless links x 40": (lambda: robots.three_axis(40), 1, "double"),
    "three axes through links of 0.1 g x 40": (light_wrists, 1, "double"),
    "a coil of 100 links": (lambda: robots.coil(100), 1, "double"),
    "a coil of 100 links, two processes": (lambda: robots.coil(100), 2, "double"),
    "60 spherical joints": (lambda: robots.spherical_rods(60), 1, "double"),
    "60 spherical joints, two processes": (lambda: robots.spherical_rods(60), 2, "double"),
}


def row(name: str, model: Model, plan: Plan, count: int) -> tuple[object, ...]:
    """Return a row of the table: the errors of a plan as loops and of its executor."""
    states = robots.states_with(model, random_states(model, count, seed=1))
    truth = truth_of(model, states, digits=DOUBLE)
    found = (
        answers(plan, model, states, shape="kernels").qdd,
        np.array([interpret(plan, *state) for state in states.each]),
    )
    errors = (f"{truth.errors(qdd).forward:.1e}" for qdd in found)
    return name, len(plan.processes), plan.scalar, *errors


def main() -> None:
    """Print the table, or put it into a document."""
    parser = command(__doc__)
    parser.add_argument("--states", type=int, default=5)
    options = parser.parse_args()
    rows = []
    for name, (make, processes, scalar) in ROBOTS.items():
        tell(name)
        model = make()
        schedule = best_schedule(model, processes, load_profile("default"))
        plan = make_plan(model, schedule, form="segment", scalar=scalar)
        rows.append(row(name, model, plan, options.states))
    lines = [
        f"The suite's state and {options.states} random ones, {platform.machine()}, "
        f"`python -m benchmarks.emitted_digits --states {options.states}`",
        "",
        *table(("robot", "P", "scalar", "loops", "executor, double"), rows),
    ]
    publish(options, "emitted_digits", "\n".join(lines))


if __name__ == "__main__":
    main()
