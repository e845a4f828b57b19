"""Other people's forward dynamics; each is skipped by name where it is not installed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

from adagen.errors import AdagenError, EnvironmentFault
from adagen.model import Model, canonical
from adagen.states import States
from adagen.studies.bench.contest import Contestant, Progress
from adagen.studies.bench.machine import package

PEERS = {"pinocchio": "pin", "casadi": "casadi", "mujoco": "mujoco"}
"""By name: the package that each comes in.

Its module here has ``contestants``, which is given the robot in canonical frames, the states to be
timed on, and a folder for its files; it raises AdagenError where the peer cannot treat the robot.
"""

LOOPED = ("pinocchio",)
"""Peers whose dynamics with closed loops is rigid; MuJoCo's equality constraints are springs."""


def contestants(name: str, model: Model, states: States, folder: Path) -> Sequence[Contestant]:
    """Return a peer's contestants for a robot.

    Args:
        name: a key of ``PEERS``.
        model: the robot.
        states: what is timed.
        folder: for the peer's files.

    Raises:
        AdagenError: the peer cannot treat the robot.
    """
    if model.closed and name not in LOOPED:
        raise EnvironmentFault("it has no rigid closed loops")
    found: list[Contestant] = import_module(f"{__name__}.{name}").contestants(
        canonical(model), states, folder
    )
    return found


def entered(
    names: Iterable[str],
    model: Model,
    states: States,
    folder: Path,
    absent: dict[str, str],
    on_progress: Progress,
) -> list[Contestant]:
    """Return the contestants of peers, built; why others are missing goes into ``absent``.

    Args:
        names: keys of ``PEERS``.
        model: the robot.
        states: what is timed.
        folder: for the peers' files.
        absent: why a peer does not take part, by name.
        on_progress: told what is being done.
    """
    found: list[Contestant] = []
    for name in names:
        reason = missing(name)
        if reason is None:
            on_progress(f"compiling {name}")
            try:
                found += contestants(name, model, states, folder)
                continue
            except AdagenError as error:
                reason = error.reason
        absent[name] = reason
    return found


def missing(name: str) -> str | None:
    """Return why a peer cannot take part; None where it can."""
    wheel = PEERS[name]
    if package(wheel) is None or (name != "pinocchio" and find_spec(name) is None):
        return f"the package {wheel} is not installed: pip install 'adagen[bench]'"
    return None
