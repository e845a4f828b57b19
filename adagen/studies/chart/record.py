"""What a chart holds, as data: JSON, CSV, and the points that no other beats."""

from __future__ import annotations

import dataclasses
import hashlib
import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from adagen.model import Model
from adagen.studies.records import record_in


@dataclass(frozen=True)
class Point:
    """One way to compute, and how fast and how right it is.

    Attributes:
        label: its name.
        team: whose it is: adagen, baseline, or a peer's name.
        algorithm: one of ``adagen.studies.chart.variants.ALGORITHMS``, or what a peer calls it.
        schedule: of adagen's forms.
        scalar: "double" or "float".
        processes: P.
        refine: steps of iterative refinement.
        shape: shape of the code.
        time_ns: median time of an evaluation, state and result in place; None where not timed.
        source: of the time: "clock", or "stretches" of computing, played through, where there are
            more processes than cores; None where not timed.
        ratio: median over the rounds of its time over the reference's.
        error: largest forward error in the energy norm; None where it failed.
        residual: largest torque residual.
        predicted: eps times the sum of g, what joins are predicted to lose; None where none are.
        why: the reason where it failed or was not timed.
        front: whether nothing that adagen emits is both faster and more accurate.
        batch: whether it solves many states at once; its time is that of one of them.
        reproducible: whether its last digits are the same on every machine.
        lanes: whether limbs that are alike may share code.
        objective: what its schedule and shape are searched for.
        certify: whether a bound of its error comes with each answer.
        method: a key of ``adagen.studies.chart.variants.METHODS``, or a peer's name: the line that
            it is drawn on.
    """

    label: str
    team: str
    algorithm: str
    schedule: str
    scalar: str
    processes: int
    refine: int
    shape: str
    time_ns: float | None = None
    source: str | None = None
    ratio: float | None = None
    error: float | None = None
    residual: float | None = None
    predicted: float | None = None
    why: str | None = None
    front: bool = False
    batch: bool = False
    reproducible: bool = False
    lanes: bool = True
    objective: str = "both"
    certify: bool = False
    method: str = ""

    @property
    def failed(self) -> bool:
        """Whether it gives no answer."""
        return self.error is None

    @property
    def clocked(self) -> bool:
        """Whether its time is one by the clock of the machine."""
        return self.time_ns is not None and self.source != "stretches"


@dataclass(frozen=True)
class Chart:
    """A robot's work-precision diagram as data.

    Attributes:
        model: the robot's name.
        dof: its degrees of freedom.
        states: how many the errors are the largest of.
        digits: certified digits of the truth.
        rounds: in which all variants were timed by turns.
        machine: where.
        points: the variants.
        mechanism: ``mechanism_of`` the robot; "" in records of releases that did not write it.
    """

    model: str
    dof: int
    states: int
    digits: int
    rounds: int
    machine: str
    points: tuple[Point, ...]
    mechanism: str = ""


def mechanism_of(model: Model) -> str:
    """Return a digest of what moves: joints, bodies, loops and forces.

    Gravity is no part of it, nor which results are asked for: errors and times hardly change.
    """
    same = dataclasses.replace(
        model, name="", gravity=np.zeros(3), wanted=(), outputs=(), at_rest=False
    )
    with np.printoptions(threshold=sys.maxsize, precision=9, floatmode="maxprec"):
        return hashlib.sha256(repr(same).encode()).hexdigest()[:16]


def front(points: Sequence[Point]) -> set[int]:
    """Return which points are on the Pareto front: none is as fast and as right, and better in one.

    Args:
        points: any; those that adagen does not emit, batches, and those without a time by the
            clock or a finite error, are not on it.
    """
    known = sorted(
        (p.time_ns, p.error, k)
        for k, p in enumerate(points)
        if p.team == "adagen"
        and not p.batch
        and p.time_ns is not None
        and p.clocked
        and p.error is not None
        and math.isfinite(p.error)
    )
    best, last, found = math.inf, (math.nan, math.nan), set()
    for time, error, k in known:
        if error < best or (time, error) == last:  # a double of one on the front is on it too
            found.add(k)
            best, last = error, (time, error)
    return found


def marked(points: Sequence[Point]) -> tuple[Point, ...]:
    """Return the points, those on the front marked."""
    on = front(points)
    return tuple(dataclasses.replace(p, front=k in on) for k, p in enumerate(points))


def read_chart(path: Path) -> Chart:
    """Read a chart.

    Raises:
        InputError: it cannot be read, or is none.
    """
    return record_in(path, "a chart as adagen chart writes it", _chart)


def _chart(data: dict[str, Any]) -> Chart:
    return Chart(points=tuple(Point(**point) for point in data.pop("points")), **data)
