"""Pinocchio's dynamics with closed loops: constraintDynamics and lcaba, by every compiler.

Loops are points and welds there; a pin is a point, or two along its axis where it takes more.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from adagen.errors import EnvironmentFault
from adagen.model import Frame, Loop, Model
from adagen.reference.closed import constraints
from adagen.states import States
from adagen.studies.bench.contest import Contestant
from adagen.studies.bench.peers.pinocchio_builds import described, in_every_build

Array = NDArray[np.float64]
ALGORITHMS = {"constraintDynamics": "FACTORS", "lcaba": "LCABA"}
ARM = 0.1
"""Distance between the two points of a pin, m."""
DEPENDENT = 1e-8
"""Proximal parameter of constraintDynamics where rows follow from others; else 0."""


def closed_contestants(model: Model, states: States, folder: Path) -> Sequence[Contestant]:
    """Return both algorithms for a robot in canonical frames, one for each build.

    Raises:
        EnvironmentFault: the robot has loops that Pinocchio has not, or nothing compiles it.
    """
    file, held, given = (folder / f"pinocchio.{end}" for end in ("txt", "loops", "states"))
    lines, shift = constraint_lines(model, states.q[0])
    file.write_text(described(model), encoding="utf-8")
    held.write_text("\n".join([*lines, ""]), encoding="utf-8")
    ways = {name: (str(held), word, repr(shift)) for name, word in ALGORITHMS.items()}
    return in_every_build("pinocchio_loops", model, states, (file, given), ways)


def constraint_lines(model: Model, q: Array) -> tuple[list[str], float]:
    """Return the loops as the program reads them, and its proximal parameter.

    Args:
        model: the robot.
        q: a regular configuration in which loops are closed, shape (nq,).

    Raises:
        EnvironmentFault: Pinocchio has no such loops.
    """
    if model.couplings:
        raise EnvironmentFault("it has no couplings")
    found = constraints(model, q)
    lines, kept = [], []
    for loop in model.loops:
        own = found.rows[[name == loop.name for name in found.names]]
        if loop.kind.name not in ("weld", "spherical", "revolute"):
            raise EnvironmentFault(f'it has no loops of kind "{loop.kind.name}"')
        if loop.kind.name == "revolute" and _rank(own) == _rank(own[:3]):
            own = own[:3]
        kept.append(own)
        lines += list(_lines(loop, points=2 if len(own) == 5 else 1))
    rows = np.vstack(kept)
    pins = any(len(own) == 5 for own in kept)  # two points: six rows of rank five
    return lines, DEPENDENT if pins or _rank(rows) < len(rows) else 0.0


def _rank(rows: Array) -> int:
    sizes = np.linalg.svd(rows, compute_uv=False)
    return int((sizes > 1e-9 * sizes[0]).sum())


def _lines(loop: Loop, points: int) -> Iterator[str]:
    kind = "weld" if loop.kind.name == "weld" else "point"
    for k in range(points):
        words = [kind]
        for link, frame in loop.ends:
            place = _along(frame, ARM * k)
            numbers = (*frame.rotation.ravel().tolist(), *place.tolist())
            words += [str(link), *map(repr, map(float, numbers))]
        yield " ".join(words)


def _along(frame: Frame, distance: float) -> Array:
    place: Array = frame.translation + distance * frame.rotation[:, 2]
    return place
