"""Choice of independent and dependent accelerations, and of redundant rows, of a closure.

Pivots of J are found by complete pivoting at each sample. Of the choices that these give, the one
with the least arithmetic wins, including the poses in which it is poor and everything is computed
again with another choice.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Numbers = tuple[int, ...]

NO_PIVOT = 1e-9
"""A pivot below this, relative to the largest entry, is none: the row follows from others."""
SAME = 9
"""Digits of pivots, relative to the largest one, that are compared."""
VANISHING = 1e-6
"""A singular value of rows that are brought to a size of one which counts as none."""
NEAR = 0.3
"""A pivot may be so much smaller than the largest one where it is better placed."""
FAR = 0.02
"""It may be even so much smaller in further choices that are compared with these."""
MOST_OFFERS = 24
"""Choices that are compared: those that suit most samples best."""
_OF_BASIS = 4
"""Products of an orthogonal basis beside rows^2 (freedoms left + 1)."""
MOST_SETS = 2
APART = 1e-2
"""Rows that are so far from following from each other, brought to a size of one, are good."""
LARGE = 200.0
"""Size of G up to which a choice loses hardly any digits, and nothing else is tried."""
AS_GOOD = 0.25
"""Digits, on the average, that choices may differ by and be as good."""
COVERED = 1e3
"""How much larger than its pivots the inertia of what is left free may be, where that can be had:
so much of a light link's inertia is rounded away beside that of a heavy one."""


def chosen(
    samples: Array, depths: Sequence[int], inertias: Sequence[Array] = (), *, whole: bool
) -> tuple[tuple[Numbers, Numbers], list[Numbers]]:
    """Return choices of dependent columns with their rows, and rows for other poses.

    Chosen is what takes least arithmetic, that in poses in which it is poor included. Rows for
    those are the ones that are farthest from following from each other; where loops can be put
    together in several ways, there may be several sets, of several ranks.
    """
    pattern = np.abs(samples).max(axis=0) > 0.0
    offers = offers_of(samples, depths, whole=whole)
    losses = [largest(offer, samples) for offer in offers]
    fine = uncovered(offers, samples, inertias)
    best = min(fine, key=lambda k: expected(offers[k], pattern, losses[k]))
    kept = list(dict.fromkeys(rows for _, rows in offers))
    apart = np.array([[_apart(rows, each) for each in samples] for rows in kept])
    taken: list[Numbers] = []
    so_far = np.zeros(len(samples))
    while len(taken) < MOST_SETS and (so_far < APART).any():
        reached = np.minimum(np.maximum(apart, so_far), APART).sum(axis=1)
        k = int(np.argmax(reached))
        if taken and float(reached[k]) < float(np.minimum(so_far, APART).sum()) + APART / 2:
            break
        taken.append(kept[k])
        so_far = np.maximum(so_far, apart[k])
    return offers[best], taken


def uncovered(
    offers: Sequence[tuple[Numbers, Numbers]], samples: Array, inertias: Sequence[Array]
) -> list[int]:
    """Return the choices in which no heavy link depends on light ones, or hardly more than least.

    Args:
        offers: columns that follow with rows that they follow by.
        samples: J at states, shape (S, rows, columns).
        inertias: of the columns at the first of these, shape (columns, columns) each.
    """
    covers = [
        max((covered(offer, *of) for of in zip(samples, inertias, strict=False)), default=1.0)
        for offer in offers
    ]
    most = max(COVERED, 10 * min(covers, default=1.0))
    return [k for k, cover in enumerate(covers) if cover <= most]


def offers_of(
    samples: Array, depths: Sequence[int], *, whole: bool
) -> list[tuple[Numbers, Numbers]]:
    """Return possible dependent columns with their rows, those of most samples first.

    Args:
        samples: J of the closure, shape (S, rows, columns).
        depths: of columns: how far from the ground their joints are.
        whole: whether all joints are held back, so that it matters what else rows act on.
    """
    if whole:  # what few rows feel, and of that what is farthest from the top, moves alone
        counts = (np.abs(samples).max(axis=0) > 0.0).sum(axis=0).tolist()
        most = max(depths, default=0) + 1
        weights = [count * most - depth for count, depth in zip(counts, depths, strict=True)]
    else:
        weights = list(depths)
    sizes = np.abs(samples).max(axis=(0, 1), initial=0.0)
    alike_columns = samples / np.where(sizes > 0.0, sizes, 1.0)  # metres beside radians
    offers = [
        offer
        for each, scaled in zip(samples, alike_columns, strict=True)
        for offer in (
            _pivots(scaled, weights, FAR),
            _pivots(scaled, weights),
            _pivots(each, weights),
            _pivots(each, ()),
        )
    ]
    return [offer for offer, _ in Counter(offers).most_common(MOST_OFFERS)]


def _apart(rows: Numbers, matrix: Array) -> float:
    """How independent kept rows are; 0 where other rows do not follow from them."""
    _, sizes, right = np.linalg.svd(matrix[list(rows)], full_matrices=False)
    if not len(sizes) or sizes[-1] < VANISHING:
        return 0.0 if len(rows) else float(not np.abs(matrix).max(initial=0.0) > VANISHING)
    rest = matrix - (matrix @ right.T) @ right
    return 0.0 if float(np.abs(rest).max(initial=0.0)) > 1e-6 else float(sizes[-1])


def expected(
    offer: tuple[Numbers, Numbers], pattern: Array, sizes: Array
) -> tuple[float, int, Numbers]:
    """Return the average cost of a choice in products, about; then the digits that it costs.

    Where G is large, it is computed in vain, and an orthogonal basis after it. Of choices that are
    as good, the last columns follow: legs that are alike choose alike, and can share lanes.
    """
    count = len(offer[0])
    again = float((sizes > LARGE).mean()) * _OF_BASIS * count**2 * (pattern.shape[1] - count + 1)
    digits = np.log10(np.clip(sizes, 1.0, 1e12)).mean()
    columns = tuple(-column for column in reversed(offer[0]))
    return _work(offer, pattern) + again, int(digits / AS_GOOD), columns


def _work(offer: tuple[Numbers, Numbers], pattern: Array) -> int:
    """Products to solve by a choice, from the sizes of its blocks."""
    columns, rows = map(list, offer)
    parts: list[tuple[set[int], int]] = []
    for row in pattern[np.ix_(rows, columns)]:
        touched, count = set(np.flatnonzero(row).tolist()), 1
        for part in [part for part in parts if part[0] & touched]:
            parts.remove(part)
            touched, count = touched | part[0], count + part[1]
        parts.append((touched, count))
    free = pattern.shape[1] - len(columns) + 1
    return sum(count**3 + count**2 * free for _, count in parts)


def largest(
    offer: tuple[Numbers, Numbers], samples: Array, counted: Sequence[int] | None = None
) -> Array:
    """Return the largest entries of G by a choice; infinity where kept rows do not give all rows.

    Args:
        offer: columns and rows.
        samples: J of S states, shape (S, rows, columns).
        counted: columns of G that count; all if not given.

    Returns:
        One for each state, shape (S,).
    """
    columns, rows = map(list, offer)
    others = [c for c in range(samples.shape[2]) if c not in columns]
    left = [r for r in range(samples.shape[1]) if r not in rows]
    found = np.full(len(samples), np.inf)
    square = samples[:, rows][:, :, columns]
    fine = np.arange(len(samples))
    if rows:
        fine = np.flatnonzero(np.linalg.svd(square, compute_uv=False)[:, -1] >= VANISHING)
    matrix = samples[fine]
    follows = np.linalg.solve(square[fine], matrix[:, rows][:, :, others])
    rest = matrix[:, left][:, :, others] - matrix[:, left][:, :, columns] @ follows
    held = np.abs(rest).max(axis=(1, 2), initial=0.0) <= 1e-6
    if counted is not None:
        follows = follows[:, :, [k for k, c in enumerate(others) if c in counted]]
    found[fine[held]] = np.abs(follows[held]).max(axis=(1, 2), initial=0.0)
    return found


def covered(offer: tuple[Numbers, Numbers], matrix: Array, inertia: Array) -> float:
    """Return the ratio of inertia to pivots of a choice's independent accelerations.

    Args:
        offer: columns and rows.
        matrix: J of one state, shape (rows, columns).
        inertia: of the columns, shape (columns, columns).
    """
    columns, rows = map(list, offer)
    others = [c for c in range(matrix.shape[1]) if c not in columns]
    square = matrix[np.ix_(rows, columns)]
    if len(square) and np.linalg.svd(square, compute_uv=False)[-1] < VANISHING:
        return 1.0  # that is another matter
    basis = np.zeros((matrix.shape[1], len(others)))
    basis[others, range(len(others))] = 1.0
    basis[columns] = -np.linalg.solve(square, matrix[np.ix_(rows, others)])
    left = basis.T @ inertia @ basis
    sizes, worst = np.diag(left).copy(), 1.0
    for k, size in enumerate(sizes):
        if size > 0.0:
            worst = max(worst, size / max(left[k, k], 1e-30 * size))
        if left[k, k] > 0.0:
            left = left - np.outer(left[:, k], left[k]) / left[k, k]
    return float(worst)


def _pivots(matrix: Array, weights: Sequence[int], near: float = NEAR) -> tuple[Numbers, Numbers]:
    """Columns and rows of the pivots of a matrix, the largest ones first.

    Args:
        matrix: J of one state.
        weights: of columns: among pivots about as large, that of least weight is chosen; none.
        near: a pivot may be so much smaller than the largest one.
    """
    left = matrix.copy()
    columns: list[int] = []
    rows: list[int] = []
    first = float(np.abs(left).max(initial=0.0))
    while True:
        sizes = np.abs(left)
        largest = float(sizes.max(initial=0.0))
        if largest <= NO_PIVOT * first or largest == 0.0:
            return tuple(sorted(columns)), tuple(sorted(rows))
        # Alike arms have entries that differ by rounding alone, and that depends on the processor.
        seen = np.round(sizes / largest, SAME)
        seen[seen < (near if weights else 1.0)] = 0.0
        if weights:
            heavy = np.where(seen.any(axis=0), weights, np.inf)
            seen[:, heavy > heavy.min()] = 0.0
        r, c = map(int, np.unravel_index(int(seen.argmax()), seen.shape))
        columns.append(c)
        rows.append(r)
        left = left - np.outer(left[:, c], left[r]) / left[r, c]
        left[r], left[:, c] = 0.0, 0.0
