"""What studies of hard states share: families of robots, fastest runs, and their words."""

from __future__ import annotations

import json
import platform
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from adagen.build import Toolchain, find_toolchain
from adagen.model import Model
from adagen.run import launch
from adagen.states import States
from adagen.studies.stability.adversary import FAMILIES, Family, hard_states, robots
from adagen.studies.stability.mechanisms import mechanisms, worst_states
from benchmarks.page import Record, command, publish


def name_of(family: Family) -> str:
    """Return the name of a family of robots, as tables have it."""
    return family.__name__.replace("_", " ")


ROUNDS = 5


@dataclass(frozen=True)
class Asked:
    """Which robots and states a study takes.

    Attributes:
        robots: how many.
        states: of each.
        seed: what they are drawn from.
    """

    robots: int
    states: int
    seed: int

    def key(self, robot: int) -> dict[str, int]:
        """Return what tells a robot, by its number, from others in a record."""
        return {"seed": self.seed, "states": self.states, "robot": robot}

    def __str__(self) -> str:
        return f"--robots {self.robots} --states {self.states} --seed {self.seed}"


Errors = Callable[[Asked, Record, Toolchain], list[str]]
"""A table of errors of hard states of random robots."""
Times = Callable[[Sequence[Path], Toolchain], list[str]]
"""The table of times of robots."""


def hard_robots(
    asked: Asked, families: Sequence[Family] = FAMILIES
) -> Iterator[tuple[str, Model, States]]:
    """Yield random robots with their family and hard states; how far it is goes to stderr."""
    for k, model in enumerate(robots(asked.robots, asked.seed, families)):
        name = name_of(families[k % len(families)])
        yield name, model, hard_states(model, asked.states, asked.seed)
        print(f"{k + 1} of {asked.robots} robots", end="\r", file=sys.stderr)


def hard_mechanisms(asked: Asked) -> Iterator[tuple[str, Model, States]]:
    """Yield the same of random mechanisms with closed loops, velocities and torques up to 100."""
    for k, (family, model) in enumerate(mechanisms(asked.robots, asked.seed)):
        states = worst_states(model, asked.states, asked.seed + k)
        rng = np.random.default_rng((asked.seed, k))
        fast, strong = 10.0 ** rng.uniform(-2, 2, size=(2, states.count, 1))
        yield family, model, States(states.q, states.v * fast, states.tau * strong)
        print(f"{k + 1} of {asked.robots} mechanisms", end="\r", file=sys.stderr)


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
    name: str,
    about: str | None,
    usual: Asked,
    timed: Sequence[Path],
    errors: Mapping[str, Errors],
    times: Times,
) -> None:
    """Print a table, or put it into a document; what the command line of a study does.

    Args:
        name: of the study, as in ``python -m benchmarks.NAME``.
        about: what ``--help`` says.
        usual: how many robots and states, and seed, by default.
        timed: robots to time, likewise.
        errors: makes a table of errors, by the word that asks for it.
        times: makes the table of times.
    """
    parser = command(about)
    parser.add_argument("what", choices=(*errors, "times"))
    parser.add_argument("urdf", nargs="*", type=Path)
    for option, value in asdict(usual).items():
        parser.add_argument(f"--{option}", type=int, default=value)
    parser.add_argument("--record", type=Path, help="what is there already; it is gone on with")
    options = parser.parse_args()
    toolchain = find_toolchain()
    if options.what in errors:
        wanted = Asked(options.robots, options.states, options.seed)
        lines = errors[options.what](wanted, Record(options.record), toolchain)
        asked = str(wanted)
    else:
        paths = options.urdf or timed
        asked = " ".join(path.name for path in paths)
        lines = times(paths, toolchain)
    head = f"{platform.machine()}, `python -m benchmarks.{name} {options.what} {asked}`"
    publish(options, f"{name}.{options.what}", "\n".join([head, "", *lines]))
