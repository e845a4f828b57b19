"""What corrections and certificates of an answer know of the process that has computed it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence

from adagen.executor.allowance import Allowance
from adagen.executor.closures import Closures
from adagen.executor.kinematics import Motion
from adagen.executor.state import State
from adagen.plan.steps import Step


class Repeatable(State, ABC):
    """A process whose steps can be repeated for the residuals of its answer.

    Attributes:
        motion: its kinematics.
        closures: its closures.
        bounds: allowances for rounding, where answers are certified.
    """

    motion: Motion
    closures: Closures
    bounds: Allowance

    @abstractmethod
    def step(self, step: Step) -> bool:
        """Execute one step; return False if it has to wait for a message."""

    @abstractmethod
    def again(self, steps: Sequence[Step]) -> Repeatable:
        """Return a process that repeats steps in the same graph and lanes."""
