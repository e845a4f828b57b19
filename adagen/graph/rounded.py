"""Expressions whose constants are rounded operation by operation, as a processor rounds them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from flint import fmpq

from adagen.graph.expressions import Expression, Graph
from adagen.graph.rounded_once import Scalar, nearest


class RoundedGraph(Graph):
    """A graph with the same values to the last bit, whichever of them are constants.

    Each constant is a number of the scalar, so that what is folded is rounded operation by
    operation, as it is where the same operation is done at run time.

    Args:
        scalar: "double" or "float".
    """

    def __init__(self, scalar: str) -> None:
        super().__init__()
        self.number: Scalar = np.float32 if scalar == "float" else np.float64

    def _constant(self, lanes: tuple[Any, ...]) -> Expression:
        return super()._constant(tuple(self._rounded(x) for x in lanes))

    def _rounded(self, value: Any) -> Any:
        """A rational number as one of the scalar; as it is where that has no such number."""
        try:
            rounded = nearest(int(value.p), int(value.q), self.number)
        except OverflowError:
            return value
        return fmpq(*rounded.as_integer_ratio()) if math.isfinite(rounded) else value
