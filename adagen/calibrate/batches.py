"""Costs of batches, fitted to measured times."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from adagen.calibrate.fit import Sample, huber
from adagen.calibrate.nnls import nnls
from adagen.cost.batches import batch_features, states_at_once
from adagen.schedule.costs import BATCH, GROUPS

_NAMES = tuple(f"{BATCH}.{key}" for key in GROUPS[BATCH])
_TURNS = 6


def fit_batches(samples: Sequence[Sample], register: int) -> dict[str, float]:
    """Return the coefficients of batches, microseconds for a register full of states.

    Args:
        samples: programs of batches; their times are of one state.
        register: bytes of a register.
    """
    A = np.zeros((len(samples), len(_NAMES)))
    for row, sample in zip(A, samples, strict=True):
        at_once = states_at_once(sample.program, register)
        for name, count in batch_features(sample.program).items():
            row[_NAMES.index(name)] = count / (at_once * sample.measured.time)
    trust = np.ones(len(samples))
    for _ in range(_TURNS):
        x = nnls(A * trust[:, None], trust)
        trust = huber(np.abs(A @ x - 1))
    return dict(zip(_NAMES, map(float, x), strict=True))
