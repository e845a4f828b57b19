"""Costs of statements, fitted to measured times of straight lines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import log

import numpy as np
from numpy.typing import NDArray

from adagen.calibrate.fit import SHORT, Sample, huber
from adagen.calibrate.nnls import nnls
from adagen.calibrate.samples import ORDERS
from adagen.cost.straight import straight_stretches
from adagen.emit.unrolled.arrangement import values_of
from adagen.executor import simulate
from adagen.executor.stretches import SINES, WAITS, at_once
from adagen.program import Program
from adagen.schedule.costs import LIMIT

Array = NDArray[np.float64]

HELD = range(1000, 6001, 500)
"""Statements whose decoded instructions may be held."""
FITS = range(2000, 9001, 500)
"""Statements that a first instruction cache may fit: 32 kB are some 2700."""

_WORK = ("unrolled.operation", "unrolled.move", "unrolled.fetched", "unrolled.evicted")
_NAMES = (*_WORK, WAITS, SINES, "unrolled.evaluation")
_TURNS = 60
_BEYOND = 2  # lines at least that are longer than what caches are taken to hold


@dataclass(frozen=True)
class Timed:
    """A stretch of statements that was timed.

    Attributes:
        features: how often each coefficient counts, no statement being held.
        statements: of all stretches of its process.
        time: microseconds.
    """

    features: dict[str, float]
    statements: float
    time: float

    def row(self, held: float, fits: float) -> list[float]:
        """Return how often each of ``_NAMES`` counts where so many statements are held, and fit."""
        beyond = max(0.0, 1 - held / max(1.0, self.statements))
        own = self.features["unrolled.fetched"]
        evicted = own * (self.statements > fits)
        found = {
            **self.features,
            "unrolled.fetched": beyond * own,
            "unrolled.evicted": evicted,
        }
        return [found.get(name, 0.0) for name in _NAMES]


def faster_orders(samples: Sequence[Sample]) -> tuple[float, list[Sample]]:
    """Return up to how many values lines are faster in the first of ``ORDERS``.

    Args:
        samples: the same programs in each order, one order after the other.

    Returns:
        That number, and the sample of each program in the order that it has by this number.
    """
    count = len(samples) // len(ORDERS)
    pairs = list(zip(samples[:count], samples[count:], strict=True))
    sizes = [longest_line(first.program) for first, _ in pairs]
    steps = sorted(set(sizes))
    between = [(one + next_one) / 2 for one, next_one in pairwise(steps)]

    def taken(urgent: float) -> list[Sample]:
        return [pair[size > urgent] for pair, size in zip(pairs, sizes, strict=True)]

    def spent(urgent: float) -> float:
        return sum(log(each.measured.time) for each in taken(urgent))

    urgent = min((ORDERS[0], ORDERS[1], *between), key=spent)
    return urgent, taken(urgent)


def longest_line(program: Program) -> int:
    """Return the values of the process that has the most."""
    return max(len(values_of(one)) for one in simulate(program.plan, program.slots.limbs))


def timed_stretches(samples: Sequence[Sample]) -> list[Timed]:
    """Return the stretches of straight lines, with what was measured of them.

    Whole evaluations of one process, and what several do before and after messages.
    """
    return [timed for sample in samples for timed in _timed(sample)]


def _timed(sample: Sample) -> Iterator[Timed]:
    alone = len(sample.program.processes) == 1
    for p, own in enumerate(straight_stretches(sample.program, 0.0)):
        times = [0.0] * len(own)
        place = 0
        for stage in sample.measured.of(p):
            place += stage.message is not None
            times[place] += stage.length * (stage.message is None)
        statements = sum(part.features["unrolled.fetched"] for part in own)
        for part, time in zip(own, times, strict=True):
            if alone:
                features = {**part.features, "unrolled.evaluation": 1.0}
                yield Timed(features, statements, sample.measured.time)
            elif time >= SHORT:  # what a clock can tell
                yield Timed(part.features, statements, time)


def fit_straight(timed: Sequence[Timed]) -> dict[str, float]:
    """Return the coefficients of straight lines of statements, but for the cache; microseconds.

    How many statements caches hold is what explains the times best, of numbers that two lines or
    more are longer than: one by itself would be explained by anything. Where no such number of what
    fits explains them better than that all of them do, none is said.
    """
    lengths = sorted(each.statements for each in timed)
    most = lengths[-min(_BEYOND, len(lengths))]
    tried = [held for held in HELD if held < most] or HELD[:1]
    all_fit = min((_fit(timed, held, LIMIT) for held in tried), key=lambda found: found[0])
    not_all = [_fit(timed, held, fits) for held in tried for fits in FITS if held <= fits < most]
    return min((all_fit, *not_all), key=lambda found: found[0])[1]


def _fit(timed: Sequence[Timed], held: float, fits: float) -> tuple[float, dict[str, float]]:
    """Return how far off the times are, and the coefficients by which they are.

    A time is linear in its operations and its waits but for ``at_once``; that is a sum of both with
    weights that depend on them, from turn to turn. A line whose instructions happen to lie badly in
    the caches takes longer in all its runs: it counts for less (Huber).
    """
    weight = 1 / np.array([each.time for each in timed])
    A = np.array([each.row(held, fits) for each in timed]) * weight[:, None]
    work, waits = range(len(_WORK)), _NAMES.index(WAITS)
    weights, trust = np.full((len(timed), 2), 0.5), np.ones(len(timed))
    for _ in range(_TURNS):
        B = A.copy()
        B[:, work] *= weights[:, :1]
        B[:, waits] *= weights[:, 1]
        x = nnls(B * trust[:, None], trust)
        parts = np.column_stack([A[:, work] @ x[work], A[:, waits] * x[waits]])
        both = np.array([at_once(*each) for each in parts])
        # By Euler's theorem the sum with these weights is what both take together.
        weights = np.maximum((parts / np.maximum(both, 1e-12)[:, None]) ** 3, 1e-9)
        off = np.abs(both + A[:, waits + 1 :] @ x[waits + 1 :] - 1)
        trust = huber(off)
    return float(off.sum()), {
        **dict(zip(_NAMES, map(float, x), strict=True)),
        "unrolled.held": float(held),
        "unrolled.fits": float(fits),
    }
