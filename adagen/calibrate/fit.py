"""From measured times to the coefficients of a cost profile.

Every stage of work of every measured process is an equation: the sum of what its steps are made of,
times the coefficients, is its time. They are solved by least squares of relative errors; no
coefficient may be negative, so that costs never fall with the number of handles.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np
from numpy.typing import NDArray

from adagen.calibrate.measure import Measurement
from adagen.calibrate.nnls import nnls
from adagen.model.kinds import KINDS
from adagen.plan import Plan
from adagen.plan.stages import Stage, stages
from adagen.predict.features import Features, features
from adagen.predict.simulate import message_numbers
from adagen.schedule.costs import NAMES, PER_KIND, ChannelCosts, StepCosts

Array = NDArray[np.float64]
_STEADY = 1e-2
"""Weight of the wish that coefficients of one group resemble each other, for what no equation tells
apart (a link's start and its joint's articulation, say)."""
_SHORT = 0.05
"""Microseconds that a short stage may be off by before its relative error counts in full."""


_WAITED = 0.1
"""Microseconds that a receiver must have begun to wait before a message is sent, to tell its way
from other delays."""


@dataclass(frozen=True)
class Equation:
    """A stage of work that was measured.

    Attributes:
        what: sort of work.
        features: what its steps are made of.
        time: microseconds.
    """

    what: str
    features: Features
    time: float

    def predicted(self, costs: StepCosts) -> float:
        """Return the time that a profile gives it, microseconds."""
        return sum(costs[name] * count for name, count in self.features.items())


@dataclass(frozen=True)
class Sample:
    """A plan without slaved joints, and what was measured of its program."""

    plan: Plan
    measured: Measurement

    def equations(self) -> list[Equation]:
        """Return one equation for each stage of work."""
        found = []
        for p in range(len(self.plan.processes)):
            for stage, time in self._timed(p):
                if stage.message is None and stage.what != "slaved":
                    steps = self.plan.processes[p].steps[stage.first : stage.last]
                    total: Features = {}
                    for step in steps:
                        for name, count in features(step, self.plan.joints).items():
                            total[name] = total.get(name, 0) + count
                    found.append(Equation(stage.what, total, time))
        return found

    def _timed(self, process: int) -> Iterable[tuple[Stage, float]]:
        times = self.measured.of(process)
        found = stages(self.plan.processes[process])
        return ((stage, time.length) for stage, time in zip(found, times, strict=True))

    def evaluation(self) -> float:
        """Return what one process takes apart from its stages, microseconds."""
        return self.measured.time - sum(stage.length for stage in self.measured.stages)

    def messages(self) -> list[tuple[int, float, float | None]]:
        """Return for each message its numbers, the time to send it, and how long it travelled.

        The last is None where the receiver was not waiting for it; microseconds.
        """
        sent: dict[int, float] = {}
        used: dict[int, tuple[float, float]] = {}
        times: dict[int, float] = {}
        for p in range(len(self.plan.processes)):
            row = self.measured.of(p)
            for stage, after in zip(row, (*row[1:], None), strict=True):
                if stage.message is None:
                    continue
                end = stage.start + stage.length if after is None else after.start
                if stage.what == "send":
                    sent[stage.message], times[stage.message] = end, stage.length
                else:
                    used[stage.message] = (stage.start, end)
        found = []
        for number, message in enumerate(self.plan.messages):
            begin, end = used[number]
            travelled = end - sent[number] if begin < sent[number] - _WAITED else None
            found.append((message_numbers(self.plan, message), times[number], travelled))
        return found


def fit_steps(samples: Sequence[Sample]) -> dict[str, float]:
    """Return a coefficient for each of ``NAMES``, microseconds.

    Those that no sample tells anything about are those of their group on average.
    """
    equations = [equation for sample in samples for equation in sample.equations()]
    column = {name: k for k, name in enumerate(NAMES)}
    A = np.zeros((len(equations), len(NAMES)))
    b = np.array([equation.time for equation in equations])
    for row, equation in zip(A, equations, strict=True):
        for name, count in equation.features.items():
            row[column[name]] = count
    scale = 1 / (b + _SHORT)
    alike = _alike()
    weight = np.ones(len(b))
    for _ in range(4):
        rows = A * (scale * weight)[:, None]
        size = np.sqrt((rows**2).sum(axis=0).mean())
        stacked = np.vstack([rows, _STEADY * size * alike])
        x = nnls(stacked, np.concatenate([b * scale * weight, np.zeros(len(alike))]))
        off = np.abs((A @ x - b) * scale)
        typical = max(1e-3, float(np.median(off)))
        weight = np.sqrt(np.minimum(1.0, 2 * typical / np.maximum(off, 1e-12)))  # Huber
    table = {name: float(x[k]) for k, name in enumerate(NAMES)}
    for group in ("propagate", "deliver"):
        if not A[:, column[f"{group}.reversed"]].any():  # turning a joint round costs the same
            table[f"{group}.reversed"] = table["accelerate.reversed"]
    return table


def _alike() -> Array:
    """Return rows that are zero where the coefficients of the joint kinds of a group are equal."""
    rows = []
    for group in PER_KIND:
        members = [NAMES.index(f"{group}.{kind}") for kind in KINDS]
        for k in members:
            row = np.zeros(len(NAMES))
            row[members] = -1 / len(members)
            row[k] += 1
            rows.append(row)
    for k in range(len(NAMES)):
        row = np.zeros(len(NAMES))
        row[k] = 0.1  # and nothing is dearer than it need be
        rows.append(row)
    return np.array(rows)


def fit_channel(samples: Sequence[Sample]) -> ChannelCosts:
    """Return what the messages of samples over one channel cost.

    Time per number is told by how much longer large messages take than small ones.
    """
    rows = [row for sample in samples for row in sample.messages()]
    waited = [(numbers, time) for numbers, _, time in rows if time is not None]
    if len(waited) < 2:
        raise ValueError("too few messages were waited for")
    times = np.array([max(0.0, time) for _, time in waited])
    A = np.array([[1.0, numbers / 2] for numbers, _ in waited])
    scale = 1 / (times + _SHORT)
    latency, number = (float(x) for x in nnls(A * scale[:, None], times * scale))
    send = median(max(0.0, time - numbers * number / 2) for numbers, time, _ in rows)
    return ChannelCosts(send, latency, number)


def evaluation_cost(samples: Sequence[Sample]) -> float:
    """Return what an evaluation takes apart from its stages, microseconds."""
    alone = [s.evaluation() for s in samples if len(s.plan.processes) == 1]
    return max(0.0, sorted(alone)[len(alone) // 3])  # a disturbed time is a longer one


def relative_errors(samples: Sequence[Sample], costs: StepCosts) -> dict[str, list[float]]:
    """Return (predicted - measured) / measured of every stage of work, by sort of work."""
    found: dict[str, list[float]] = {}
    for sample in samples:
        for equation in sample.equations():
            error = (equation.predicted(costs) - equation.time) / max(equation.time, _SHORT)
            found.setdefault(equation.what, []).append(error)
    return found
