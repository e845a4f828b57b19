"""Vectors, bodies and turns in numpy, of many states at once: arrays have the states first."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]


def cross(a: Array, b: Array) -> Array:
    """Return a x b, shape (S, 3)."""
    (a0, a1, a2), (b0, b1, b2) = a.T, b.T
    return np.stack([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0], axis=1)


def skew(c: Array) -> Array:
    """Return the matrices that cross products are, shape (S, 3, 3)."""
    found = np.zeros((len(c), 3, 3), c.dtype)
    found[:, 0, 1], found[:, 0, 2], found[:, 1, 2] = -c[:, 2], c[:, 1], -c[:, 0]
    return found - found.transpose(0, 2, 1)


def is_turn(rotation: Array) -> bool:
    """Whether a rotation turns about a coordinate axis, but for a permutation, to the bit."""
    lone = np.abs(rotation) == 1
    alone = (rotation != 0).sum(axis=0, keepdims=True) + (rotation != 0).sum(axis=1, keepdims=True)
    return bool((lone & (alone == 2)).any())


def congruent(turn: Array, block: Array) -> Array:
    """Return Q M Q^T, shape (S, 3, 3)."""
    found: Array = turn @ block @ turn.transpose(0, 2, 1)
    return found


def about_z(turn: Array, block: Array) -> Array:
    """What a turn about z makes of a block, as straight lines find it (frames.py).

    It is exact to a unit in the last place of the block, not of its entries.
    """
    found, (p, q) = congruent(turn, block), turn[:, 0, :2].T
    (a, b), (g, d) = block[:, 0, :2].T, block[:, 1, :2].T
    t = p * (a - d) + q * (b + g)
    found[:, 0, 0], found[:, 1, 1] = d + p * t, a - p * t
    found[:, 0, 1], found[:, 1, 0] = b - q * t, g - q * t
    return found


def turned_body(
    turn: Array, body: Array, force: Array, by: Callable[..., Array] = congruent
) -> tuple[Array, Array]:
    """Return a body and the force on it in axes turned, its blocks being turned as given."""
    found = np.empty_like(body)
    for i in (slice(0, 3), slice(3, 6)):
        for k in (slice(0, 3), slice(3, 6)):
            found[:, i, k] = by(turn, body[:, i, k])
    return found, np.hstack(
        [np.einsum("sik,sk->si", turn, x) for x in (force[:, :3], force[:, 3:])]
    )


def shifted_body(body: Array, force: Array, way: Array) -> tuple[Array, Array]:
    """Return a body and the force on it about a point that is so far behind."""
    found, arm = body.copy(), skew(way)
    found[:, :3, 3:] += arm @ body[:, 3:, 3:]
    found[:, :3, :3] += arm @ body[:, 3:, :3] - found[:, :3, 3:] @ arm
    found[:, 3:, :3] = found[:, :3, 3:].transpose(0, 2, 1)
    return found, np.hstack([force[:, :3] + cross(way, force[:, 3:]), force[:, 3:]])


def rotation(p: Array) -> Array:
    """Return the matrices of quaternions (x, y, z, w) of any length, shape (S, 3, 3)."""
    x, y, z, w = (p / np.sqrt((p * p).sum(axis=1, keepdims=True))).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return np.array(rows, dtype=p.dtype).transpose(2, 0, 1)


def solved(d: Array, right: Array) -> Array:
    """Return d^-1 right by Cholesky's factorization, of any number; NaN where that fails."""
    n = d.shape[1]
    lower, found = np.zeros_like(d), right.copy()
    for k in range(n):
        column = d[:, k:, k] - np.einsum("sik,sk->si", lower[:, k:, :k], lower[:, k, :k])
        lower[:, k:, k] = column / np.sqrt(column[:, :1])
    for k in range(n):
        found[:, k] -= np.einsum("si,sic->sc", lower[:, k, :k], found[:, :k])
        found[:, k] /= lower[:, k, k][:, None]
    for k in reversed(range(n)):
        found[:, k] -= np.einsum("si,sic->sc", lower[:, k + 1 :, k], found[:, k + 1 :])
        found[:, k] /= lower[:, k, k][:, None]
    return found


def pivots(d: Array) -> Array:
    """Return the pivots of symmetric matrices, shape (S, n), as L D L^T has them."""
    left, found = d.copy(), np.empty(d.shape[:2], d.dtype)
    for k in range(d.shape[1]):
        found[:, k] = left[:, k, k]
        column = left[:, :, k]
        left = left - column[:, :, None] * (column / found[:, k : k + 1])[:, None, :]
    return found
