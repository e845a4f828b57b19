"""Independent answers to any precision, with a bound on their error (ball arithmetic)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, log2
from typing import Any

import numpy as np
from flint import arb, arb_mat, ctx
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.exact import exact, rounded
from adagen.model import Model
from adagen.reference.coupling import checked, coupled, coupling, free_rows, prescribed
from adagen.reference.inertia import inertia_matrix
from adagen.reference.loop_rows import loop_rows, more_than_rounding
from adagen.reference.newton_euler import joint_torques
from adagen.reference.numbers import BALLS, DOUBLE, Numeric

Array = NDArray[np.float64]
MOST_BITS = 1 << 12  # of a chain of 200 joints some 100 bits are lost, of 5000 some 2500


@dataclass(frozen=True, eq=False)
class Certified:
    """An answer and what is proven about it.

    Attributes:
        value: rounded to double, shape (nv,).
        raw: object array of arb, shape (nv,): balls that hold the true answer.
        error: bound on the error of ``raw``'s midpoints, relative to the largest entry.
        bits: working precision that it took.
    """

    value: Array
    raw: NDArray[Any]
    error: float
    bits: int


def exact_inverse_dynamics(model: Model, q: Any, v: Any, a: Any, digits: int = 60) -> Certified:
    """Return `inverse_dynamics` to the given number of decimal digits.

    The doubles of the model and the state count as exact; a joint's rotation is the
    orthonormal matrix at its rounded columns.

    Args:
        model: the robot.
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        a: accelerations, shape (nv,).
        digits: decimal digits relative to the largest entry.

    Raises:
        InputError: as `inverse_dynamics`.
    """
    state = (
        checked(model, "q", q, model.nq),
        checked(model, "v", v, model.nv),
        checked(model, "a", a, model.nv),
    )

    def attempt() -> Numeric:
        at, speed, rate = coupled(BALLS, model, *(exact(x) for x in state))
        result = BALLS.zeros(model.nv)
        tau = joint_torques(BALLS, model, at, speed, rate)
        result[free_rows(model)] = coupling(BALLS, model).T.dot(tau)
        return result

    return _to_digits(attempt, digits)


def exact_forward_dynamics(model: Model, q: Any, v: Any, tau: Any, digits: int = 60) -> Certified:
    """Return `forward_dynamics` to the given number of decimal digits.

    With closed loops it is the solution of [H J^T; J 0] [qdd; -f] = [tau - bias; -Jdot v] with
    independent rows of J (Featherstone, Rigid Body Dynamics Algorithms, 8.2). A state in doubles
    closes its loops up to rounding only, so rows that are left out hold up to rounding, too.

    Args:
        model: the robot, its doubles counted as exact (as in `exact_inverse_dynamics`).
        q: configuration, shape (nq,).
        v: velocity, shape (nv,).
        tau: torques and outer forces, shape (ntau,).
        digits: decimal digits relative to the largest entry.

    Raises:
        InputError: as `forward_dynamics`; singular means that no precision up to 4096 bits (or
            four times what the digits take) proves the joint-space inertia regular.
    """
    state = (
        checked(model, "q", q, model.nq),
        checked(model, "v", v, model.nv),
        checked(model, "tau", tau, model.ntau),
    )

    kept = independent_rows(model, state[0])

    def attempt() -> Numeric:
        at, speed = coupled(BALLS, model, exact(state[0]), exact(state[1]))
        given = exact(state[2])
        shares, known = coupling(BALLS, model), prescribed(BALLS, model, given)
        held = joint_torques(BALLS, model, at, speed, known, given)
        needed = shares.T.dot(given[: model.nv] - held)
        moved = inertia_matrix(BALLS, model, at)
        rows, drift = BALLS.zeros(0, model.nv), BALLS.zeros(0)
        if kept:
            rows, drift = (part[kept] for part in loop_rows(BALLS, model, at, speed))
        result: Numeric = shares.dot(_solve(moved, shares, needed, rows, -drift - rows.dot(known)))
        return result + known

    return _to_digits(attempt, digits)


def independent_rows(model: Model, q: Any, rank: float = 1e-9) -> list[int]:
    """Return rows of J that are independent at q, as many as its rank, the best ones first.

    Args:
        model: the robot.
        q: configuration, shape (nq,).
        rank: rows whose distance from those before is less, relative to the longest, follow.
    """
    if not model.closed:
        return []
    (at,) = coupled(DOUBLE, model, checked(model, "q", q, model.nq), np.zeros(model.nv))[:1]
    rows = loop_rows(DOUBLE, model, at, np.zeros(model.nv))[0]
    rows = np.where(more_than_rounding(model, rows)[:, None], rows, 0.0)
    rows = rows.dot(coupling(DOUBLE, model))
    least = rank * float(np.linalg.norm(rows, axis=1).max(initial=0.0))
    kept: list[int] = []
    while len(kept) < len(rows):
        left = np.linalg.norm(rows, axis=1)
        k = int(left.argmax())
        if left[k] <= least:
            break
        kept.append(k)
        along = rows[k] / left[k]
        for _ in range(2):  # twice is enough
            rows = rows - np.outer(rows @ along, along)
    return kept


def _solve(
    inertia: Numeric, shares: Numeric, right: Numeric, rows: Numeric, wanted: Numeric
) -> Numeric:
    """Solve (G^T H G) x - (J G)^T f = right and J G x = wanted in C.

    x is NaN where the matrix is not proven regular.
    """
    g, both = _matrix(shares), np.concatenate([right, wanted])
    reduced = _array(g.transpose() * _matrix(inertia) * g)
    held, count = rows.dot(shares), len(rows)
    whole = np.block([[reduced, held.T], [held, BALLS.zeros(count, count)]])
    result = np.empty(len(both), dtype=object)
    column = arb_mat(len(both), 1, both.tolist())
    result[:] = _matrix(whole).solve(column, nonstop=True).entries()
    return result[: len(right)]


def _array(matrix: arb_mat) -> Numeric:
    result = np.empty(matrix.nrows() * matrix.ncols(), dtype=object)
    result[:] = matrix.entries()
    return result.reshape(matrix.nrows(), matrix.ncols())


def _matrix(values: Numeric) -> arb_mat:
    rows, columns = values.shape
    return arb_mat(rows, columns, values.reshape(-1).tolist())


def _to_digits(attempt: Callable[[], Numeric], digits: int) -> Certified:
    """Evaluate at rising precision until the balls are small enough."""
    bits = ceil(digits * log2(10)) + 128
    before, most = ctx.prec, max(MOST_BITS, 4 * bits)
    try:
        while bits <= most:
            ctx.prec = bits
            raw = attempt()
            error = _relative_radius(raw)
            if error * arb(10) ** digits < 1:
                return Certified(rounded(raw), raw, float(error), bits)
            bits *= 2
    finally:
        ctx.prec = before
    raise InputError(
        "the joint-space inertia is singular (no precision proves it regular): some motion of the "
        "joints moves no mass; give every link that moves alone an inertia"
    )


def _relative_radius(raw: Numeric) -> arb:
    """Return the largest radius over the largest entry; infinity where a ball is not finite."""
    if not all(x.is_finite() for x in raw):
        return arb("inf")
    radius = max((x.rad() for x in raw), default=arb(0))
    largest = max((x.abs_lower() for x in raw), default=arb(0))
    return arb(0) if radius == 0 else (radius / largest).upper()
