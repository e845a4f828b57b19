"""Closed planar loops: more constraint rows than rank, with which plain Cholesky fails.

What is shown here, on trees cut open at pins, is how to treat the rows of a pin: in
space they are five, in a plane only two of them are independent. The compiler chooses rows when it
emits code (docs/explanation/loops.md).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from adagen.model import Model
from adagen.reference import bias, joint_space_inertia
from adagen.studies.stability import robots
from adagen.studies.stability.motion import Row

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Pinned:
    """Rods in a plane, tips of some of them pinned to the ground.

    Attributes:
        lengths: of the rods, m.
        pins: (rod, where its tip is pinned: x and z, m).
        guess: a configuration near one that closes the loops.
    """

    lengths: tuple[float, ...]
    pins: tuple[tuple[int, tuple[float, float]], ...]
    guess: tuple[float, ...]

    def model(self) -> Model:
        """Return the tree."""
        inertias = [robots.rod(length, length) for length in self.lengths]
        return robots.chain("pinned", inertias, axes="y", lengths=self.lengths)

    def closure(self, q: Array, v: Array) -> tuple[Array, Array, Array]:
        """Return the gaps at the pins, their rates' Jacobian, and their accelerations at rest.

        Shapes (2 P,), (2 P, n), (2 P,).
        """
        angle, rate = np.cumsum(q), np.cumsum(v)
        gaps, rows, free = [], [], []
        for rod, place in self.pins:
            along = np.array(self.lengths) * (np.arange(len(q)) <= rod)
            x, z = along * np.sin(angle), along * np.cos(angle)
            gaps += [x.sum() - place[0], z.sum() - place[1]]
            rows += [np.cumsum(z[::-1])[::-1], -np.cumsum(x[::-1])[::-1]]
            free += [-(x * rate**2).sum(), -(z * rate**2).sum()]
        return np.array(gaps), np.array(rows), np.array(free)

    def closed_state(self) -> tuple[Array, Array]:
        """Return a configuration and a velocity that the pins allow, (n,) each, by Newton."""
        q = np.array(self.guess)
        for _ in range(30):
            gap, rows, _ = self.closure(q, q)
            q = q - np.linalg.lstsq(rows, gap, rcond=None)[0]
        _, rows, _ = self.closure(q, q)
        v = np.cos(2.3 * np.arange(1, len(q) + 1))
        return q, v - np.linalg.lstsq(rows, rows @ v, rcond=None)[0]


FOUR_BAR = Pinned((1.0, 2.5, 2.0), ((2, (3.0, 0.0)),), (0.5, 0.8, 1.5))
COUPLED = Pinned(
    (1.0, 2.5, 2.0, 1.5, 1.5), ((2, (3.0, 0.0)), (4, (4.0, -1.0))), (0.5, 0.8, 1.5, -1.0, 1.0)
)


def four_bar() -> tuple[Row, ...]:
    """Return what methods make of a planar four-bar linkage."""
    return _solved("four-bar", FOUR_BAR)


def coupled_loops() -> tuple[Row, ...]:
    """Return what methods make of two loops with links in common."""
    return _solved("two loops", COUPLED)


def _solved(name: str, pinned: Pinned) -> tuple[Row, ...]:
    model = pinned.model()
    q, v = pinned.closed_state()
    tau = np.sin(3.1 * np.arange(1, model.nv + 1))
    inertia, right = joint_space_inertia(model, q), tau - bias(model, q, v)
    _, plane, free = pinned.closure(q, v)
    rows, wanted = _in_space(plane), _in_space(-free[:, None])[:, 0]
    truth = _kkt(inertia, right, plane, -free)
    a = rows @ np.linalg.solve(inertia, rows.T)
    missing = wanted - rows @ np.linalg.solve(inertia, right)

    def error(multipliers: Array) -> float:
        found = np.linalg.solve(inertia, right + rows.T @ multipliers)
        return float(np.linalg.norm(found - truth) / np.linalg.norm(truth))

    try:
        np.linalg.cholesky(a)
        plain = 0.0
    except np.linalg.LinAlgError:
        plain = float("inf")
    least = error(np.linalg.pinv(a, rcond=1e-12) @ missing)
    proximal = error(_proximal(a, missing))
    return (
        (f"{name}: Cholesky of all rows", True, plain, "fails", plain == float("inf")),
        (f"{name}: rows of full rank", False, least, "< 1e-12", least < 1e-12),
        (f"{name}: proximal iteration", False, proximal, "< 1e-12", proximal < 1e-12),
    )


def _in_space(plane: Array) -> Array:
    """Tell the two rows of each planar pin as the five of one in space: x, y, z, about x, z."""
    result = np.zeros((5 * len(plane) // 2, plane.shape[1]))
    for pin in range(len(plane) // 2):
        result[5 * pin], result[5 * pin + 2] = plane[2 * pin], plane[2 * pin + 1]
    return result


def _kkt(inertia: Array, right: Array, rows: Array, wanted: Array) -> Array:
    """Return the accelerations from the dense KKT system of independent rows."""
    m = len(rows)
    matrix = np.block([[inertia, rows.T], [rows, np.zeros((m, m))]])
    result: Array = np.linalg.solve(matrix, np.concatenate([right, wanted]))[: len(right)]
    return result


def _proximal(a: Array, wanted: Array) -> Array:
    """Solve a semi-definite system by lambda += (A + mu)^-1 (wanted - A lambda)."""
    shifted = a + 1e-6 * np.trace(a) * np.eye(len(a))
    multipliers = np.zeros(len(a))
    for _ in range(20):
        multipliers = multipliers + np.linalg.solve(shifted, wanted - a @ multipliers)
    return multipliers
