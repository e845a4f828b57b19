"""Pinocchio's articulated-body algorithm: both conventions, every compiler, the best counts."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from adagen.model import Model
from adagen.states import States
from adagen.studies.bench.contest import Contestant
from adagen.studies.bench.peers.pinocchio_builds import described, in_every_build
from adagen.studies.bench.peers.pinocchio_loops import closed_contestants

CONVENTIONS = ("LOCAL", "WORLD")


def contestants(model: Model, states: States, folder: Path) -> Sequence[Contestant]:
    """Return pinocchio's contestants for a robot, one for each build and convention.

    Raises:
        EnvironmentFault: its headers are not where its wheel should have put them, or nothing
            compiles them.
    """
    if model.closed:
        return closed_contestants(model, states, folder)
    file, given = folder / "pinocchio.txt", folder / "pinocchio.states"
    file.write_text(described(model), encoding="utf-8")
    ways = {convention: (convention,) for convention in CONVENTIONS}
    return in_every_build("pinocchio", model, states, (file, given), ways)
