"""Maps: digits that each method keeps along a family of robots, as data."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from flint import arb_mat, ctx
from numpy.typing import NDArray

from adagen.exact import exact
from adagen.model import Model
from adagen.reference.inertia import inertia_matrix
from adagen.reference.numbers import BALLS
from adagen.studies.stability.methods import METHODS, Trial, digits
from adagen.studies.stability.motion import swing
from adagen.studies.stability.robots import FAMILIES

STEPS = (1e-5, 2e-5, 5e-5, 1e-4, 1e-3, 1e-2)  # each goes into 20 ms
_STEP_METHODS = ("explicit damping", "RK4", "implicit damping")
_WORDS = {"explicit damping": "explicit", "RK4": "rk4", "implicit damping": "implicit"}
_NOT_DRAWN = ("form ada, joints not fused", "form segment, cut in four")
_COMPARED = tuple(name for name in METHODS if name not in _NOT_DRAWN)
NAMES = (*FAMILIES, "step")


@dataclass(frozen=True)
class Map:
    """Errors of methods along a family of robots.

    Attributes:
        family: its name.
        axis: what varies, with its unit.
        values: of that.
        methods: names.
        errors: a row for each method, a column for each value; infinity for a failure.
        conditions: cond(H) for each value; none where the step varies, not the robot.
    """

    family: str
    axis: str
    values: tuple[float, ...]
    methods: tuple[str, ...]
    errors: tuple[tuple[float, ...], ...]
    conditions: tuple[float, ...] = ()

    @property
    def digits(self) -> tuple[tuple[float, ...], ...]:
        """Decimal digits kept, 0 to 16, as ``errors``."""
        return tuple(tuple(digits(error) for error in row) for row in self.errors)

    def listed(self) -> dict[str, object]:
        """Return the map as data for JSON: a failure's error is None."""
        errors = [[e if math.isfinite(e) else None for e in row] for row in self.errors]
        return vars(self) | {"errors": errors, "digits": self.digits}


def make_map(family: str, progress: Callable[[str], None] = lambda _: None) -> Map:
    """Return the map of a family, one of ``NAMES``.

    Args:
        family: its name.
        progress: called with what is being worked at.
    """
    if family == "step":
        return _step_map(progress)
    axis, robot, values = FAMILIES[family]
    columns, conditions = [], []
    for k, value in enumerate(values, start=1):
        progress(f"{family}, {k} of {len(values)}")
        trial = Trial(robot(value))
        columns.append([trial.outcome(METHODS[name])[0] for name in _COMPARED])
        conditions.append(condition(trial.model, trial.state[0]))
    rows = tuple(tuple(row) for row in zip(*columns, strict=True))
    return Map(family, axis, values, _COMPARED, rows, tuple(conditions))


def _step_map(progress: Callable[[str], None]) -> Map:
    """Errors of the velocities of the damped chain after 20 ms."""
    progress("step: reference")
    truth = swing(5e-6, "rk4")
    rows = []
    for k, method in enumerate(_STEP_METHODS, start=1):
        progress(f"step, {k} of {len(_STEP_METHODS)}")
        errors = [np.abs(swing(h, _WORDS[method]) - truth).max() for h in STEPS]
        rows.append(tuple(float(e / np.abs(truth).max()) for e in errors))
    return Map(
        "step",
        "step (s); the tip's damping allows 2/lambda = 6.7e-5",
        STEPS,
        _STEP_METHODS,
        tuple(rows),
    )


_BITS = 512  # H of cond(H) = 1e25 is inverted to more digits than a double has


def condition(model: Model, q: NDArray[np.float64]) -> float:
    """Return cond(H), the largest eigenvalue of H over the least one, in mixed units.

    H and its inverse are formed in ball arithmetic: in doubles the least eigenvalue is lost where
    cond(H) comes near 1 / eps.

    Args:
        model: the robot.
        q: configuration, shape (nq,).

    Raises:
        FloatingPointError: H is singular.
    """
    before = ctx.prec
    ctx.prec = _BITS
    try:
        inertia = arb_mat(inertia_matrix(BALLS, model, exact(q)).tolist())
        inverse = inertia.inv()
    except ZeroDivisionError:
        raise FloatingPointError("the joint-space inertia is singular") from None
    finally:
        ctx.prec = before
    return _largest(inertia) * _largest(inverse)


def _largest(matrix: arb_mat) -> float:
    """Return the largest eigenvalue of a symmetric matrix."""
    rows = [[float(x.mid()) for x in row] for row in matrix.tolist()]
    return float(np.linalg.eigvalsh(np.array(rows))[-1])
