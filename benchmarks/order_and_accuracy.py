"""Does the schedule change the accuracy? Orders in form ada, cuts in form segment.

    python -m benchmarks.order_and_accuracy [--random 10]
        [--write docs/records/schedule_and_accuracy.md]

The paper leaves it open whether the order of assembly matters to the accuracy. Here every order of
a robot is carried out in double and compared with the truth; then two processes meet at every
joint of a chain in turn. Errors are in the energy norm, the largest of three states.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import get_args

import numpy as np

from adagen.executor import interpret
from adagen.executor.join_digits import predicted_growth
from adagen.model import Model
from adagen.plan import Plan, make_plan
from adagen.plan.cuts import LARGEST_GROWTH
from adagen.schedule import Node, Schedule, Topology, load_profile
from adagen.schedule.tree import Named
from adagen.search import named_schedule
from adagen.studies.bench.report import table
from adagen.studies.stability import robots
from adagen.studies.truth import DOUBLE, truth_of
from adagen.urdf import read_robot
from benchmarks.page import MODELS, command, publish
from benchmarks.solvers import tell
from tests.schedules import random_schedule, wrapped

STATES = 3
NONE = float("inf")


class Truth:
    """A robot, its states and the true accelerations."""

    def __init__(self, name: str, model: Model) -> None:
        self.name, self.model = name, model
        self._true = truth_of(model, STATES, digits=DOUBLE)

    def error(self, plan: Plan) -> float:
        """Return the largest error of a plan; infinity where a factorization fails."""
        states = self._true.states
        try:
            found = np.array([interpret(plan, *state) for state in states.each])
        except FloatingPointError:
            return NONE
        return self._true.errors(found).forward


def subjects() -> Iterator[Truth]:
    """Yield the robots whose orders are compared."""
    yield Truth("30 rods", robots.rods(30))
    yield Truth("coil of 30", robots.coil(30))
    yield Truth("dill of 16", robots.dill(4))
    for mass in (1e-4, 1e-8):
        yield Truth(f"30 rods, one of {mass:g} kg", robots.with_mass(30, 15, mass))
    yield Truth("30 slender rods", robots.rods(30, radius=5e-4))
    yield Truth("30 rods, tip of 1e8 kg", robots.with_mass(30, 30, 1e8))
    for name in ("human40", "humanoid"):
        yield Truth(name, read_robot(MODELS / f"{name}.urdf").model)


def orders(model: Model, count: int) -> Iterator[Schedule]:
    """Yield the schedules by name for one process, then random ones."""
    for name in get_args(Named):
        yield named_schedule(name, Topology.of(model), 1, profile=load_profile("paper"))
    for seed in range(count):
        yield random_schedule(model, 1, np.random.default_rng(seed))


def order_row(truth: Truth, count: int) -> tuple[object, ...]:
    """Return a table row: how errors of form ada spread over schedules."""
    plans = [make_plan(truth.model, s, form="ada") for s in orders(truth.model, count)]
    errors = np.array([truth.error(plan) for plan in plans])
    predicted = np.median([predicted_growth(plan).error for plan in plans])
    alone = truth.error(make_plan(truth.model, next(orders(truth.model, 0)), form="segment"))
    spread = np.log10(errors.max() / errors.min())
    found = (f"{x:.0e}" for x in (errors.min(), np.median(errors), errors.max()))
    return truth.name, len(plans), *found, f"{spread:.1f}", f"{predicted:.0e}", f"{alone:.0e}"


def cut_at(model: Model, joint: int) -> Schedule:
    """Return the schedule in which two processes meet at one joint of a chain."""

    def sequence(joints: range, process: int) -> Node | None:
        node = None
        for j in reversed(joints):
            boundary = (j > 0) + (process == 0)  # the joint above it, and the cut below
            node = Node(j, (process, process + 1), None, node, 0.0, boundary)
        return node

    sides = sequence(range(joint), 0), sequence(range(joint + 1, len(model.joints)), 1)
    return wrapped(Node(joint, (0, 2), *sides, 0.0, 0), model, 2)


def cut_rows(truth: Truth) -> Iterator[tuple[str, ...]]:
    """Yield table rows: the error of form segment and g, for a cut at each joint of a chain."""
    for joint in range(1, len(truth.model.joints) - 1):
        plan = make_plan(truth.model, cut_at(truth.model, joint), form="segment")
        error, growth = truth.error(plan), predicted_growth(plan)
        refused = "no" if growth.largest > LARGEST_GROWTH["double"] else "yes"
        figures = (f"{x:.0e}" for x in (growth.largest, growth.error, error))
        yield truth.name, truth.model.joints[joint].name, *figures, refused


def tables(count: int) -> list[str]:
    """Return both tables as Markdown."""
    orders, cuts = [], list[tuple[str, ...]]()
    for truth in subjects():
        tell(truth.name)
        orders.append(order_row(truth, count))
    for mass in (1.0, 1e-4, 1e-8):
        cuts += cut_rows(Truth(f"12 rods, link 6 of {mass:g} kg", robots.with_mass(12, 6, mass)))
    head = ("robot", "orders", "best error", "median", "worst", "decades between", "predicted")
    return [
        *("Orders in form `ada`:", "", *table((*head, "form segment"), orders), ""),
        *("Cuts in form `segment`, two processes:", ""),
        *table(("robot", "cut at", "g", "predicted", "error", "g below the limit"), cuts),
    ]


def main() -> None:
    """Print the tables, or put them into a document."""
    parser = command(__doc__)
    parser.add_argument("--random", type=int, default=10)
    options = parser.parse_args()
    publish(options, "order_and_accuracy", "\n".join(tables(options.random)))


if __name__ == "__main__":
    main()
