"""Certificates of emitted solvers: bounds beside true errors, and what they take in time.

    python -m benchmarks.certificates errors [--robots 24] [--states 400] [--seed 1] [--write FILE]
    python -m benchmarks.certificates times [ROBOT.urdf ...] [--write FILE]

Errors are those of hard states of random robots of twelve families (adagen/studies/stability), in
the energy norm against certified accelerations. Times are minima of runs with and without
certificates by turns.
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
from collections.abc import Iterable
from pathlib import Path

import numpy as np

import adagen
from adagen.build import Toolchain, build_executable, find_toolchain
from adagen.errors import AdagenError
from adagen.run import launch
from adagen.studies.stability.adversary import FAMILIES, hard_states, robots
from adagen.studies.stability.bounds import FACTOR, Bounded, Certified, bounded
from benchmarks.page import write_between_marks

WAYS = [
    Certified("unrolled"),
    Certified("kernels"),
    Certified("unrolled", batch=True),
    Certified("kernels", batch=True),
    Certified("unrolled", scalar="float"),
    Certified("kernels", scalar="float"),
]
MODELS = Path(__file__).resolve().parents[1] / "generated_examples" / "models"
ROBOTS = [MODELS / f"{name}.urdf" for name in ("arm7", "chain16", "humanoid", "human40")]
SHAPES = [(shape, batch) for batch in (False, True) for shape in ("unrolled", "kernels")]
ROUNDS = 5


def errors_table(found: dict[tuple[str, str], list[Bounded]]) -> list[str]:
    """Return the table of bounds and errors, by way and family."""
    lines = [
        "| emitted | robots | evaluations | refused | largest error | largest bound "
        "| bound / error, median | error / bound, largest | above 3 |",
        "|---|---|--:|--:|--:|--:|--:|--:|--:|",
    ]
    for (way, family), parts in found.items():
        errors = np.concatenate([one.errors for one in parts])
        bounds = np.concatenate([one.bounds for one in parts])
        refused = sum(one.refused for one in parts)
        if not errors.size:
            continue
        ratios = np.concatenate([one.ratios for one in parts])
        pessimism = np.median(bounds / np.maximum(errors, 1e-300))
        cells = (
            *(way, family, errors.size, refused, f"{errors.max():.0e}", f"{bounds.max():.0e}"),
            *(f"{pessimism:.2g}", f"{ratios.max():.2f}", int((ratios > FACTOR).sum())),
        )
        lines.append(f"| {' | '.join(map(str, cells))} |")
    evaluations = sum(one.errors.size for parts in found.values() for one in parts)
    exceeded = sum(int((one.ratios > FACTOR).sum()) for parts in found.values() for one in parts)
    return [*lines, "", f"{evaluations} evaluations, {exceeded} bounds exceeded by more than 3."]


def measured_errors(count: int, states: int, seed: int, toolchain: Toolchain) -> list[str]:
    """Return the table of random robots."""
    found: dict[tuple[str, str], list[Bounded]] = {
        (str(way), family.__name__.replace("_", " ")): [] for way in WAYS for family in FAMILIES
    }
    for k, model in enumerate(robots(count, seed)):
        family = FAMILIES[k % len(FAMILIES)].__name__.replace("_", " ")
        for way, one in bounded(model, hard_states(model, states, seed), WAYS, toolchain).items():
            found[str(way), family].append(one)
        print(f"{k + 1} of {count} robots", end="\r", file=sys.stderr)
    return errors_table({key: parts for key, parts in found.items() if parts})


def fastest(programs: list[Path], toolchain: Toolchain) -> list[float]:
    """Least nanoseconds of an evaluation of each program, run by turns."""
    least = [np.inf] * len(programs)
    for _ in range(ROUNDS):
        for k, program in enumerate(programs):
            ran = launch(program, 1, ["--time", "--json"], toolchain, timeout=120)
            told = json.loads(ran.stdout)["time"]["in_place"]["min_ns"]
            least[k] = min(least[k], told)
    return least


def measured_times(paths: Iterable[Path], toolchain: Toolchain) -> list[str]:
    """Return the table of times."""
    lines = [
        "| robot | shape | plain, ns | certified, ns | ratio |",
        "|---|---|--:|--:|--:|",
    ]
    for path in paths:
        robot = adagen.read(path)
        for shape, batch in SHAPES:
            programs = []
            try:
                for certify in (False, True):
                    made = adagen.compile(robot, shape=shape, batch=batch, certify=certify)
                    source = made.files[f"{made.stem}.cpp"]
                    programs.append(build_executable(source, made.stem, toolchain))
            except AdagenError as error:
                print(f"{path.stem}, {shape}: {error}", file=sys.stderr)
                continue
            plain, certified = fastest(programs, toolchain)
            name = f"{shape}{', batch' * batch}"
            cells = (
                path.stem,
                name,
                f"{plain:.0f}",
                f"{certified:.0f}",
                f"{certified / plain:.2f}",
            )
            lines.append(f"| {' | '.join(cells)} |")
    return lines


def main() -> int:
    """Print a table, or put it into a document."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("what", choices=("errors", "times"))
    parser.add_argument("urdf", nargs="*", type=Path, default=ROBOTS)
    parser.add_argument("--robots", type=int, default=24)
    parser.add_argument("--states", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    toolchain = find_toolchain()
    if options.what == "errors":
        asked = f"--robots {options.robots} --states {options.states} --seed {options.seed}"
        lines = measured_errors(options.robots, options.states, options.seed, toolchain)
    else:
        asked = " ".join(path.name for path in options.urdf)
        lines = measured_times(options.urdf, toolchain)
    command = f"`python -m benchmarks.certificates {options.what} {asked}`"
    text = "\n".join([f"{platform.machine()}, {command}", "", *lines])
    if options.write is None:
        print(text)
    else:
        write_between_marks(options.write, f"certificates.{options.what}", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
