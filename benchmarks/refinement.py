"""Refinement in loops: what one step makes good in hard states, and what it takes in time.

    python -m benchmarks.refinement errors [--robots 24] [--states 100] [--seed 2]
                                           [--record FILE] [--write FILE]
    python -m benchmarks.refinement times [ROBOT.urdf ...] [--write FILE]

Errors are those of hard states of random robots of twelve families (adagen/studies/stability), in
the energy norm against certified accelerations: of loops as they are, and refined once by residuals
in their own numbers. Times are minima of runs by turns, those of wider residuals among them.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import adagen
from adagen.build import Toolchain
from adagen.emit import emit
from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import Plan
from adagen.reference import energy_norm_error, joint_space_inertia
from adagen.states import States
from adagen.studies.bench.report import table
from adagen.studies.stability.audit import Way, planned, solved, truths
from benchmarks.certificates import ROBOTS
from benchmarks.hard import Asked, fastest, hard_robots, name_of, study
from benchmarks.page import MODELS, Record
from benchmarks.stability.adversary import FAMILIES

RESIDUALS = ("", "own", "wide")
"""How answers are refined: not at all, or by residuals in these numbers."""


def _options(residual: str) -> dict[str, Any]:
    return {"refine": 1, "residual": residual} if residual else {}


def _errors(model: Model, plan: Plan, states: States, toolchain: Toolchain) -> list[list[float]]:
    """The errors of the answers to all states, in each way; those that are not refused in any."""
    rows = []
    for residual in RESIDUALS[:2]:
        try:
            text = emit(plan, name="audited", shape="kernels", **_options(residual))
        except AdagenError:
            return []
        rows.append(list(solved(text["audited_p1.cpp"], plan, states, toolchain)))
    found = []
    for k, truth in enumerate(truths(model, states)):
        answers = [row[k] for row in rows]
        given = [answer for answer in answers if answer is not None]
        if truth is None or len(given) < len(answers):
            continue
        inertia = joint_space_inertia(model, states.q[k])
        found.append([energy_norm_error(inertia, one - truth, truth) for one in given])
    return found


def errors_table(asked: Asked, record: Record, toolchain: Toolchain) -> list[str]:
    """Return the table of random robots."""
    found: dict[str, list[list[float]]] = {name_of(family): [] for family in FAMILIES}
    for k, (family, model, hard) in enumerate(hard_robots(asked)):
        plan = planned(model, Way("kernels"))
        assert plan is not None  # one process has all
        find = partial(_errors, model, plan, hard, toolchain)
        found[family] += record.of(asked.key(k), find)
    lines = []
    for name, rows in found.items():
        if not rows:
            continue
        every = np.array(rows)
        cells = [f"{x:.0e}" for one in every.T for x in (one.max(), np.median(one))]
        lines.append((name, len(rows), *cells))
    head = ("robots", "states", "plain, largest", "median", "refined, largest", "median")
    return list(table(head, lines))


def times_table(files: Sequence[str]) -> list[str]:
    """Return the table of times in loops."""
    rows = []
    for path in map(Path, files):
        robot = adagen.read(path)
        solvers = {}
        for residual in RESIDUALS:
            made = adagen.compile(robot, shape="kernels", **_options(residual))
            solvers[residual] = made.plan, made.source
        plain, own, wide = fastest(robot.model, solvers)
        cells = [f"{plain:.0f}"]
        cells += [cell for x in (own, wide) for cell in (f"{x:.0f}", f"{x / plain:.2f}")]
        rows.append((path.stem, *cells))
    return list(table(("robot", "plain, ns", "own, ns", "ratio", "wide, ns", "ratio"), rows))


def main() -> None:
    """Print a table, or put it into a document."""
    timed = [*ROBOTS, str(MODELS / "mobile.urdf")]
    errors = {"errors": errors_table}
    times = {"times": (times_table, timed)}
    study("refinement", __doc__, Asked(24, 100, 2), errors, times)


if __name__ == "__main__":
    main()
