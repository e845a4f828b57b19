"""From measured times to the coefficients of a cost profile.

Every stage of every measured process is an equation: the sum of its features times the coefficients
is its time. They are solved by least squares of relative errors; no coefficient may be negative, so
that costs never fall with the number of handles.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from statistics import median

import numpy as np
from numpy.typing import NDArray

from adagen.calibrate.measure import Measurement
from adagen.calibrate.nnls import nnls
from adagen.cost.features import Features, added, joins_of, operation_features
from adagen.model.kinds import KINDS
from adagen.plan import Plan
from adagen.plan.passive import tangents
from adagen.plan.stages import Stage, stages
from adagen.program import Program
from adagen.schedule.costs import LIKE, NAMES, PER_KIND, PRESCRIBED, StepCosts

Array = NDArray[np.float64]
_STEADY = 1e-2
"""Weight of the wish that coefficients of one group resemble each other, for what no equation tells
apart (a link's start and its joint's articulation, say)."""
SHORT = 0.05
"""Microseconds that a short stage may be off by before its relative error counts in full."""


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
        return costs.total(self.features)


@dataclass(frozen=True)
class Sample:
    """A program without slaved joints, and what was measured of it."""

    program: Program
    measured: Measurement

    @property
    def plan(self) -> Plan:
        """What each process computes."""
        return self.program.plan

    def equations(self) -> list[Equation]:
        """Return one equation for each stage of work."""
        found, joins = [], joins_of(self.plan)
        for p, process in enumerate(self.program.processes):
            for number, (stage, time) in enumerate(self._timed(p)):
                if stage.message is None and stage.what != "slaved":
                    own = (each for each in process.operations if each.stage == number)
                    total = added(operation_features(each, self.plan.joints, joins) for each in own)
                    found.append(Equation(stage.what, total, time))
        return found

    def _timed(self, process: int) -> Iterable[tuple[Stage, float]]:
        times = self.measured.of(process)
        found = stages(self.plan.processes[process])
        return ((stage, time.length) for stage, time in zip(found, times, strict=True))

    def evaluation(self) -> float:
        """Return what one process takes apart from its stages, microseconds."""
        return self.measured.time - sum(stage.length for stage in self.measured.stages)


def fit_steps(samples: Sequence[Sample]) -> dict[str, float]:
    """Return a coefficient for each of ``NAMES``, microseconds.

    Those that no sample tells anything about are those of their group on average, or 0 where they
    are not of steps.
    """
    equations = [equation for sample in samples for equation in sample.equations()]
    column = {name: k for k, name in enumerate(NAMES)}
    A = np.zeros((len(equations), len(NAMES)))
    b = np.array([equation.time for equation in equations])
    for row, equation in zip(A, equations, strict=True):
        for name, count in equation.features.items():
            row[column[name]] = count
    scale = 1 / (b + SHORT)
    alike = _alike()
    weight = np.ones(len(b))
    for _ in range(4):
        rows = A * (scale * weight)[:, None]
        size = np.sqrt((rows**2).sum(axis=0).mean())
        stacked = np.vstack([rows, _STEADY * size * alike])
        x = nnls(stacked, np.concatenate([b * scale * weight, np.zeros(len(alike))]))
        weight = huber(np.abs((A @ x - b) * scale))
    table = {name: float(x[k]) for k, name in enumerate(NAMES)}
    for group in ("propagate", "deliver"):
        if not A[:, column[f"{group}.reversed"]].any():  # turning a joint round costs the same
            table[f"{group}.reversed"] = table["accelerate.reversed"]
    return table


def huber(off: Array) -> Array:
    """Return the weights of equations by their residuals: large residuals weigh less."""
    typical = max(1e-3, float(np.median(off)))
    return np.sqrt(np.minimum(1.0, 2 * typical / np.maximum(off, 1e-12)))


def _alike() -> Array:
    """Return rows that are zero where coefficients that resemble each other are equal.

    Those of the joint kinds of a group do, and that of a row of joints side by side, or of a joint
    of a run that is passed together, resembles that of one such joint. To pass a strip resembles
    its kinematics. Wrenches that are carried through runs take a fraction of what a mobility does.
    """
    rows = []
    for group in PER_KIND:
        alone = "kinematics" if group == "passing_strips" else group.split("_")[0]
        alone = group if alone == "propagate" else alone
        priced = (*KINDS, *({PRESCRIBED} & set(PER_KIND[group])))
        for kind in priced:
            others = priced if alone == group else (kind,)
            row = np.zeros(len(NAMES))
            row[[NAMES.index(f"{alone}.{other}") for other in others]] = -1 / len(others)
            row[NAMES.index(f"{group}.{kind}")] += 1
            rows.append(row)
    row = np.zeros(len(NAMES))  # a run's ends are about as dear as one more joint
    row[NAMES.index("articulate.run")], row[NAMES.index("articulate.revolute")] = 1, -1
    rows.append(row)
    row = np.zeros(len(NAMES))  # by columns or not
    row[NAMES.index("articulate_columns.run")], row[NAMES.index("articulate.run")] = 1, -1
    rows.append(row)
    for group, like in LIKE.items():
        for key in sorted({*PER_KIND[group]} - {PRESCRIBED}):
            row = np.zeros(len(NAMES))
            row[NAMES.index(f"{group}.{key}")], row[NAMES.index(f"{like}.{key}")] = 1, -1
            rows.append(row)
    for k in range(len(NAMES)):
        row = np.zeros(len(NAMES))
        row[k] = 0.1  # and nothing is dearer than it need be
        rows.append(row)
    return np.array(rows)


def evaluation_cost(samples: Sequence[Sample]) -> float:
    """Return the time of an evaluation beside its stages, microseconds."""
    alone = [s.evaluation() for s in samples if len(s.plan.processes) == 1]
    return max(0.0, sorted(alone)[len(alone) // 3])  # a disturbed time is a longer one


def rubs(plan: Plan) -> bool:
    """Return whether a process of a plan takes hyperbolic tangents, for friction."""
    return any(tangents(plan, process) for process in plan.processes)


def with_tangents(costs: StepCosts, samples: Sequence[Sample]) -> StepCosts:
    """Return the costs with that of a tangent, from the times of robots with and without friction.

    Args:
        costs: the others.
        samples: of both.
    """
    alone = [sample for sample in samples if len(sample.plan.processes) == 1]
    without = {
        (s.plan.name, s.program.processes): s.measured.time for s in alone if not rubs(s.plan)
    }
    each = [
        (sample.measured.time - without[sample.plan.name, sample.program.processes])
        / tangents(sample.plan, sample.plan.processes[0])
        for sample in alone
        if rubs(sample.plan)
    ]
    table = {**costs.table, "process.tangent": max(0.0, median(each))}
    return replace(costs, table=table)


def relative_errors(samples: Sequence[Sample], costs: StepCosts) -> dict[str, list[float]]:
    """Return (predicted - measured) / measured of every stage of work, by sort of work."""
    found: dict[str, list[float]] = {}
    for sample in samples:
        for equation in sample.equations():
            error = (equation.predicted(costs) - equation.time) / max(equation.time, SHORT)
            found.setdefault(equation.what, []).append(error)
    return found
