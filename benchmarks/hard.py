"""What studies of hard states share: families of robots, fastest runs, and their words."""

from __future__ import annotations

import platform
import shlex
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np

from adagen.build import Toolchain, find_toolchain
from adagen.model import Model
from adagen.plan import Plan
from adagen.states import States
from adagen.studies.bench.contest import Times
from adagen.studies.random_states import hard_states
from benchmarks.page import Record, command, publish
from benchmarks.solvers import by_turns, contestant
from benchmarks.stability.adversary import FAMILIES, Family, robots
from benchmarks.stability.mechanisms import mechanisms, worst_states


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
Timed = Callable[[Sequence[str]], list[str]]
"""A table of times of robots by their names, or by the files of their descriptions."""


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


def fastest(model: Model, solvers: Mapping[str, tuple[Plan, str]]) -> list[float]:
    """Least nanoseconds of an evaluation by each of a robot's solvers, timed by turns.

    Args:
        model: the robot.
        solvers: plans and sources by name.
    """
    return [times.least for times in raced(model, solvers, ROUNDS)]


def raced(model: Model, solvers: Mapping[str, tuple[Plan, str]], rounds: int) -> list[Times]:
    """Times of evaluations by each of a robot's solvers, by turns.

    Args:
        model: the robot.
        solvers: plans and sources by name.
        rounds: in each of which all of them have a turn, one after the other.
    """
    times = by_turns([contestant(name, model, *one) for name, one in solvers.items()], rounds)
    return [times[name]["in_place"] for name in solvers]


def study(
    name: str,
    about: str | None,
    usual: Asked,
    errors: Mapping[str, Errors],
    times: Mapping[str, tuple[Timed, Sequence[str]]],
) -> None:
    """Print a table, or put it into a document; what the command line of a study does.

    Args:
        name: of the study, as in ``python -m benchmarks.NAME``.
        about: what ``--help`` says.
        usual: how many robots and states, and seed, by default.
        errors: makes a table of errors, by the word that asks for it.
        times: likewise a table of times, with the robots that are timed by default.
    """
    parser = command(about)
    parser.add_argument("what", choices=(*errors, *times))
    parser.add_argument("robot", nargs="*", help="of those to time")
    for option in asdict(usual):
        parser.add_argument(f"--{option}", type=int)
    parser.add_argument("--record", type=Path, help="what is there already; it is gone on with")
    options = parser.parse_args()
    given = {key: found for key in asdict(usual) if (found := getattr(options, key)) is not None}
    if options.what in errors:
        if options.robot:
            parser.error(f"{options.what} draws its robots: {options.robot[0]} is not one of them")
        wanted = replace(usual, **given)
        lines = errors[options.what](wanted, Record(options.record), find_toolchain())
        asked = str(wanted)
    else:
        if given or options.record:
            parser.error(f"{options.what} takes robots, and nothing is drawn or recorded")
        table, usually = times[options.what]
        names = options.robot or usually
        asked = shlex.join(Path(name).name for name in options.robot)
        lines = table(names)
    words = " ".join(filter(None, [options.what, asked]))
    head = f"{platform.machine()}, `python -m benchmarks.{name} {words}`"
    publish(options, f"{name}.{options.what}", "\n".join([head, "", *lines]))
