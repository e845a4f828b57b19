"""What is looked at during an evaluation."""

from __future__ import annotations

from dataclasses import dataclass

from adagen.graph import Expression


@dataclass(frozen=True)
class Check:
    """A value that has to be finite and more than another.

    Attributes:
        pivot: the value.
        least: what it must exceed.
        joint: what fails otherwise.
        failure: how.
    """

    pivot: Expression
    least: Expression
    joint: int
    failure: str = "kFactorization"
