"""Refinement in loops: what one step makes good in hard states, and what it takes in time.

    python -m benchmarks.refinement errors [--robots 24] [--states 100] [--seed 2] [--write FILE]
    python -m benchmarks.refinement times [ROBOT.urdf ...] [--write FILE]

Errors are those of hard states of random robots of twelve families (adagen/studies/stability), in
the energy norm against certified accelerations: of loops as they are, and refined once by residuals
in their own numbers. Times are minima of runs by turns, those of wider residuals among them.
"""

from __future__ import annotations

import argparse
import platform
import sys
from collections.abc import Iterable
from pathlib import Path

import numpy as np

import adagen
from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.emit import emit
from adagen.errors import AdagenError
from adagen.model import Model
from adagen.plan import Plan
from adagen.reference import energy_norm_error, joint_space_inertia
from adagen.states import States
from adagen.studies.stability.adversary import FAMILIES, hard_states, robots
from adagen.studies.stability.audit import Way, planned, solved, truths
from benchmarks.certificates import ROBOTS, fastest
from benchmarks.page import write_between_marks

RESIDUALS = ("", "own", "wide")
"""How answers are refined: not at all, or by residuals in these numbers."""


def _options(residual: str) -> dict[str, object]:
    return {"refine": 1, "residual": residual} if residual else {}


def _errors(model: Model, plan: Plan, states: States, toolchain: Toolchain) -> list[list[float]]:
    """The errors of the answers to all states, in each way; those that are not refused in any."""
    rows = []
    for residual in RESIDUALS[:2]:
        try:
            text = emit(plan, name="audited", shape="kernels", **_options(residual))  # type: ignore[arg-type]
        except AdagenError:
            return []
        rows.append(list(solved(text["audited_p1.cpp"], plan, states, toolchain)))
    found = []
    for k, truth in enumerate(truths(model, states)):
        answers = [row[k] for row in rows]
        if truth is None or any(answer is None for answer in answers):
            continue
        inertia = joint_space_inertia(model, states.q[k])
        found.append([energy_norm_error(inertia, one - truth, truth) for one in answers])
    return found


def errors_table(count: int, states: int, seed: int, toolchain: Toolchain) -> list[str]:
    """Return the table of random robots."""
    found: dict[str, list[list[float]]] = {each.__name__: [] for each in FAMILIES}
    for k, model in enumerate(robots(count, seed)):
        plan = planned(model, Way("kernels"))
        assert plan is not None  # one process has all
        own = _errors(model, plan, hard_states(model, states, seed), toolchain)
        found[FAMILIES[k % len(FAMILIES)].__name__] += own
        print(f"{k + 1} of {count} robots", end="\r", file=sys.stderr)
    lines = [
        "| robots | states | plain, largest | median | refined, largest | median |",
        "|---|--:|--:|--:|--:|--:|",
    ]
    for name, rows in found.items():
        if not rows:
            continue
        every = np.array(rows)
        cells = [f"{x:.0e}" for one in every.T for x in (one.max(), np.median(one))]
        lines.append(f"| {' | '.join([name.replace('_', ' '), str(len(rows)), *cells])} |")
    return lines


def times_table(paths: Iterable[Path], toolchain: Toolchain) -> list[str]:
    """Return the table of times in loops."""
    lines = [
        "| robot | plain, ns | own, ns | ratio | wide, ns | ratio |",
        "|---|--:|--:|--:|--:|--:|",
    ]
    for path in paths:
        robot = adagen.read(path)
        programs = []
        for residual in RESIDUALS:
            made = adagen.compile(robot, shape="kernels", **_options(residual))
            source = made.files[f"{made.stem}.cpp"]
            programs.append(build_executable(source, made.stem, toolchain))
        plain, own, wide = fastest(programs, toolchain)
        cells = [f"{plain:.0f}"]
        cells += [cell for x in (own, wide) for cell in (f"{x:.0f}", f"{x / plain:.2f}")]
        lines.append(f"| {' | '.join([path.stem, *cells])} |")
    return lines


def main() -> int:
    """Print a table, or put it into a document."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("what", choices=("errors", "times"))
    parser.add_argument("urdf", nargs="*", type=Path)
    parser.add_argument("--robots", type=int, default=24)
    parser.add_argument("--states", type=int, default=100)
    parser.add_argument("--seed", type=int, default=2)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    toolchain = find_toolchain()
    if options.what == "errors":
        asked = f"--robots {options.robots} --states {options.states} --seed {options.seed}"
        lines = errors_table(options.robots, options.states, options.seed, toolchain)
    else:
        paths = options.urdf or [*ROBOTS, ROBOTS[0].with_name("mobile.urdf")]
        asked = " ".join(path.name for path in paths)
        lines = times_table(paths, toolchain)
    command = f"`python -m benchmarks.refinement {options.what} {asked}`"
    text = "\n".join([f"{platform.machine()}, {command}", "", *lines])
    if options.write is None:
        print(text)
    else:
        write_between_marks(options.write, f"refinement.{options.what}", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
