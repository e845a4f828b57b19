"""What an answer leaves over of the equations, which a correction feels instead of forces."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

from numpy.typing import NDArray

from adagen.executor.front import End
from adagen.graph import Expression
from adagen.plan.arms import WideUnknown

Array = NDArray[Any]


class LeftOver(Protocol):
    """Residuals of an answer (residuals.py)."""

    def by_loops(self, link: int) -> Array:
        """Return the wrench on a link from loops that end at it, with opposite sign, shape (6,)."""

    def of_link(self, link: int) -> Array:
        """Return the residual wrench of a link for the answer's acceleration, shape (6,)."""

    def of_joint(self, j: int, torques: Array) -> Array:
        """Return the residual torques of a joint, less rotor and couplings, shape (n,)."""

    def handed(self, j: int, force: Array) -> Array:
        """Return what a joint hands on: nothing where a loop sweeps its residual."""

    def of_row(
        self, bias: Expression, ends: Sequence[End], wide_unknown: WideUnknown
    ) -> Expression:
        """Return the residual of a loop's row; ``bias``: its value for zero deviations."""

    def of_coupling(self, joints: Sequence[int], factors: Array) -> Expression:
        """Return the residual of a coupling's row."""
