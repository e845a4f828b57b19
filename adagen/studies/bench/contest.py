"""Who takes part, and the rounds in which all of them are timed by turns."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np
from numpy.typing import NDArray

from adagen.errors import AdagenError, EnvironmentFault
from adagen.states import States

Array = NDArray[np.float64]


WORDS = {
    "in_place": "",
    "through_root": ", through process 0",
    "stretches": ", from stretches",
    "stretches_through_root": ", through process 0, from stretches",
}
"""What is timed, and what tables call it behind a contestant's name.

States and results are in place, or go through process 0. A time that is *from stretches* is not
the clock's: each process's computing between messages is measured by itself, and played through
with what messages cost. It stands in where there are more processes than cores.
"""


def from_stretches(what: str) -> str:
    """Return what a time is called if it is from stretches."""
    return "stretches" if what == "in_place" else f"stretches_{what}"


@dataclass(frozen=True)
class Rules:
    """How a contest is held.

    Attributes:
        rounds: how often each contestant's turn comes.
        repeat: evaluations of each state in a turn.
        states: how many states a peer's program is timed on; emitted ones have 64 of their own.
        seed: of the states.
        judged: how many of the states the answers are judged on; one of large robots.
    """

    rounds: int = 9
    repeat: int = 15
    states: int = 64
    seed: int = 1
    judged: int = 3


@dataclass(frozen=True)
class Turn:
    """Nanoseconds of an evaluation in one turn: median and minimum over its evaluations."""

    median: float
    least: float


@dataclass(frozen=True)
class Times:
    """Nanoseconds of an evaluation over all rounds.

    Attributes:
        turns: medians of each turn, in order.
        least: the fastest evaluation of all.
    """

    turns: tuple[float, ...]
    least: float

    @property
    def median(self) -> float:
        """Median of the turns' medians."""
        return float(median(self.turns))


@dataclass(frozen=True)
class Contestant:
    """A built solver of one model.

    Attributes:
        name: what tables call it.
        team: whose it is: adagen, pinocchio, casadi, mujoco.
        build: compiler and options, or code shape.
        processes: how many it runs on.
        scalar: number type.
        solve: accelerations for states, shape (S, nv).
        turn: times evaluations once; its argument is how often each state. What is timed by what
            it is called, a key of WORDS.
        predicted: nanoseconds that were predicted, if anything was.
    """

    name: str
    team: str
    build: str
    processes: int
    scalar: str
    solve: Callable[[States], Array]
    turn: Callable[[int], Mapping[str, Turn]]
    predicted: float | None = None


Progress = Callable[[str], None]


def hold(
    contestants: Sequence[Contestant], rules: Rules, on_progress: Progress
) -> tuple[dict[str, dict[str, Times]], dict[str, str]]:
    """Time contestants by turns, round after round, so that a noisy minute hits all alike.

    Returns:
        Times by contestant and by what was timed; and why some were given up, by name.

    Raises:
        EnvironmentFault: there are more turns than none, but nobody finished one.
    """
    seen: dict[str, dict[str, list[Turn]]] = {}
    gone: dict[str, str] = {}
    for number in range(rules.rounds):
        on_progress(f"round {number + 1} of {rules.rounds}")
        # Every other round backwards: nobody always follows the same neighbour.
        for contestant in contestants[:: 1 if number % 2 == 0 else -1]:
            if contestant.name in gone:
                continue
            try:
                turn = contestant.turn(rules.repeat)
            except AdagenError as error:
                gone[contestant.name] = error.reason
                seen.pop(contestant.name, None)
                continue
            kept = seen.setdefault(contestant.name, {})
            for what, times in turn.items():
                kept.setdefault(what, []).append(times)
    if contestants and not seen:
        raise EnvironmentFault(f"nothing could be timed: {next(iter(gone.values()))}")
    return {
        name: {
            what: Times(tuple(t.median for t in turns), min(t.least for t in turns))
            for what, turns in kinds.items()
        }
        for name, kinds in seen.items()
    }, gone
