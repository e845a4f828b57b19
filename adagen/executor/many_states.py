"""Vectors, bodies and rotations in numpy for many states: arrays have the states first."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
_NEXT, _LAST = np.array([1, 2, 0]), np.array([2, 0, 1])


def cross(a: Array, b: Array) -> Array:
    """Return a x b, shape (..., 3)."""
    found: Array = a.take(_NEXT, -1) * b.take(_LAST, -1)
    found -= a.take(_LAST, -1) * b.take(_NEXT, -1)
    return found


def skew(c: Array) -> Array:
    """Return the matrices of cross products, shape (..., 3, 3)."""
    found = np.zeros((*c.shape, 3), c.dtype)
    found[..., 0, 1], found[..., 0, 2], found[..., 1, 2] = -c[..., 2], c[..., 1], -c[..., 0]
    return found - found.swapaxes(-1, -2)


def is_turn(rotation: Array) -> bool:
    """Whether a rotation is about a coordinate axis, up to a permutation, to the bit."""
    lone = np.abs(rotation) == 1
    alone = (rotation != 0).sum(axis=0, keepdims=True) + (rotation != 0).sum(axis=1, keepdims=True)
    return bool((lone & (alone == 2)).any())


def congruent(turn: Array, block: Array) -> Array:
    """Return Q M Q^T, shape (..., 3, 3)."""
    found: Array = turn @ block @ turn.swapaxes(-1, -2)
    return found


def about_z(turn: Array, block: Array) -> Array:
    """A block rotated about z, with the operations of straight lines (frames.py).

    It is exact to a unit in the last place of the block, not of its entries.
    """
    found, p, q = congruent(turn, block), turn[..., 0, 0], turn[..., 0, 1]
    a, b, g, d = (block[..., i, k] for i in range(2) for k in range(2))
    t = p * (a - d) + q * (b + g)
    found[..., 0, 0], found[..., 1, 1] = d + p * t, a - p * t
    found[..., 0, 1], found[..., 1, 0] = b - q * t, g - q * t
    return found


def turned_body(
    turn: Array, body: Array, force: Array, by: Callable[..., Array] = congruent
) -> tuple[Array, Array]:
    """Return a body and the force on it in rotated axes, its blocks rotated by a given function."""
    blocks = body.reshape(-1, 2, 3, 2, 3).swapaxes(2, 3)
    found = by(turn[:, None, None], blocks).swapaxes(2, 3).reshape(body.shape)
    halves = [np.einsum("sik,sk->si", turn, x) for x in (force[:, :3], force[:, 3:])]
    return found, np.concatenate(halves, axis=1)


def shifted_body(body: Array, force: Array, way: Array, arm: Array) -> tuple[Array, Array]:
    """Return a body and the force on it about another point.

    Args:
        body: shape (S, 6, 6).
        force: shape (S, 6).
        way: shape (S, 3).
        arm: the matrix that a cross product with it is, shape (S, 3, 3).
    """
    found, moved = body.copy(), force.copy()
    found[:, :3, 3:] += arm @ body[:, 3:, 3:]
    found[:, :3, :3] += arm @ body[:, 3:, :3] - found[:, :3, 3:] @ arm
    found[:, 3:, :3] = found[:, :3, 3:].transpose(0, 2, 1)
    moved[:, :3] += cross(way, force[:, 3:])
    return found, moved


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
    """Return d^-1 right by Cholesky's factorization; NaN where that fails."""
    n = d.shape[1]
    if n == 1:
        lower = d / np.sqrt(d)
        return right / lower / lower
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
