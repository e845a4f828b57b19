"""Run-time checks of an evaluation: pivots, poses, loops."""

from __future__ import annotations

from dataclasses import dataclass

from adagen.graph import Expression

SINGULAR = "kSingularPose"
"""The failure after which the recovery of a plan is carried out."""


@dataclass(frozen=True)
class Check:
    """A run-time check: a value has to be finite and larger than another.

    Attributes:
        pivot: the value.
        least: what it must exceed.
        joint: what fails otherwise.
        failure: how.
        near: below this it is no failure yet, but digits are lost; 0: nothing is reported.
    """

    pivot: Expression
    least: Expression
    joint: int
    failure: str = "kFactorization"
    near: float = 0.0


def exceeds(value: Expression, least: Expression) -> bool:
    """Whether a constant is known to be more than another value, in all lanes."""
    graph = value.graph
    lanes = range(max(value.node.width, least.node.width))
    pairs = [(graph.lane(value, k).constant, graph.lane(least, k).constant) for k in lanes]
    return all(x > (y or 0) for x, y in pairs)
