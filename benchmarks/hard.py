"""What studies of hard states have in common: families of robots, fastest runs, and their words."""

from __future__ import annotations

import argparse
import json
import platform
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import numpy as np

from adagen.build import Toolchain, find_toolchain
from adagen.model import Model
from adagen.run import launch
from adagen.states import States
from adagen.studies.stability.adversary import FAMILIES, hard_states, robots
from benchmarks.page import write_between_marks

MODELS = Path(__file__).resolve().parents[1] / "generated_examples" / "models"
NAMES = tuple(family.__name__.replace("_", " ") for family in FAMILIES)
"""The families of robots, as tables have them."""
ROUNDS = 5

Errors = Callable[[int, int, int, Toolchain], list[str]]
"""The table of errors of so many robots, in so many states each, from a seed."""
Times = Callable[[Sequence[Path], Toolchain], list[str]]
"""The table of times of robots."""


def hard_robots(count: int, states: int, seed: int) -> Iterator[tuple[str, Model, States]]:
    """Yield random robots with their family and hard states; how far it is goes to stderr."""
    for k, model in enumerate(robots(count, seed)):
        yield NAMES[k % len(NAMES)], model, hard_states(model, states, seed)
        print(f"{k + 1} of {count} robots", end="\r", file=sys.stderr)


def fastest(programs: Sequence[Path], toolchain: Toolchain) -> list[float]:
    """Least nanoseconds of an evaluation of each program, run by turns."""
    least = [np.inf] * len(programs)
    for _ in range(ROUNDS):
        for k, program in enumerate(programs):
            ran = launch(program, 1, ["--time", "--json"], toolchain, timeout=120)
            time = json.loads(ran.stdout)["time"]["in_place"]["min_ns"]
            least[k] = min(least[k], time)
    return least


def study(
    name: str, about: str | None, usual: argparse.Namespace, errors: Errors, times: Times
) -> int:
    """Print a table, or put it into a document; what the command line of a study does.

    Args:
        name: of the study, as in ``python -m benchmarks.NAME``.
        about: what ``--help`` says.
        usual: how many robots and states, seed, and robots to time, where nothing is said.
        errors: makes the table of errors.
        times: makes the table of times.
    """
    parser = argparse.ArgumentParser(
        description=about, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("what", choices=("errors", "times"))
    parser.add_argument("urdf", nargs="*", type=Path)
    for option in ("robots", "states", "seed"):
        parser.add_argument(f"--{option}", type=int, default=getattr(usual, option))
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    toolchain = find_toolchain()
    if options.what == "errors":
        asked = f"--robots {options.robots} --states {options.states} --seed {options.seed}"
        lines = errors(options.robots, options.states, options.seed, toolchain)
    else:
        paths = options.urdf or usual.urdf
        asked = " ".join(path.name for path in paths)
        lines = times(paths, toolchain)
    command = f"`python -m benchmarks.{name} {options.what} {asked}`"
    text = "\n".join([f"{platform.machine()}, {command}", "", *lines])
    if options.write is None:
        print(text)
    else:
        write_between_marks(options.write, f"{name}.{options.what}", text)
    return 0
