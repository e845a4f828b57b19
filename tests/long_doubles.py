"""Straight lines in more digits than solvers have, where balls would take long."""

from __future__ import annotations

from typing import Any

import numpy as np

from adagen.graph.evaluate import Floating


class LongDoubles(Floating):
    """Long doubles; constants are rounded as emitted ones are."""

    def __init__(self) -> None:
        super().__init__(np.longdouble)

    def _sine_and_cosine(self, angle: Any) -> tuple[Any, Any]:
        """Sine and cosine of the C library."""
        return np.sin(angle), np.cos(angle)
