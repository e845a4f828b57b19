"""Number types: the same formulas for doubles and for balls of any precision.

Arrays are numpy arrays, of float64 or of python-flint ``arb`` objects; formulas use ``+ - * /`` and
``dot`` only, and what differs between the two kinds of numbers is collected here.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.exact import exact, rotation_taking_z_to, rounded

Numeric = NDArray[Any]  # of float64 or, dtype object, of arb


@dataclass(frozen=True)
class Numbers:
    """A kind of number.

    Attributes:
        array: turns floats of any shape into an array of these numbers, without rounding.
        sincos: sine and cosine of one number (rad).
        sqrt: square root of one number.
        tanh: hyperbolic tangent of one number.
        turn: rotation, shape (3, 3), whose third column is a given axis.
    """

    array: Callable[[Any], Numeric]
    sincos: Callable[[Any], tuple[Any, Any]]
    sqrt: Callable[[Any], Any]
    tanh: Callable[[Any], Any]
    turn: Callable[[Any], Numeric]

    def zeros(self, *shape: int) -> Numeric:
        """Return an array of zeros."""
        return self.array(np.zeros(shape))


DOUBLE = Numbers(
    array=lambda values: np.asarray(values, dtype=np.float64),
    sincos=lambda x: (math.sin(x), math.cos(x)),
    sqrt=math.sqrt,
    tanh=math.tanh,
    turn=lambda axis: rounded(rotation_taking_z_to(axis)),
)
BALLS = Numbers(
    array=exact,
    sincos=lambda x: x.sin_cos(),
    sqrt=lambda x: x.sqrt(),
    tanh=lambda x: x.tanh(),
    turn=rotation_taking_z_to,
)


def cross(a: Numeric, b: Numeric) -> Numeric:
    """Return the cross product of two vectors, shape (3,)."""
    return np.array(
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    )


def cross_matrix(a: Numeric) -> Numeric:
    """Return the matrix K, shape (3, 3), with K b = a x b."""
    zero = a[0] - a[0]
    return np.array([[zero, -a[2], a[1]], [a[2], zero, -a[0]], [-a[1], a[0], zero]])
