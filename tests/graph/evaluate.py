"""Evaluates expressions in any arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from adagen.graph import Evaluation, Expression
from adagen.graph.evaluate import Floating


class Arithmetic(Floating):
    """Sums, products and quotients of any numbers."""

    def __init__(self, number: Callable[[Any], Any]) -> None:
        super().__init__()
        self._number = number

    def number(self, value: Any) -> Any:
        return self._number(value)


def evaluate(
    roots: Iterable[Expression], inputs: Mapping[str, Any], number: Callable[[Any], Any]
) -> list[Any]:
    """Return the values of expressions of one graph, of wide ones tuples.

    Args:
        roots: what is wanted.
        inputs: values of the inputs by name; a wide one's lanes follow each other in an array.
        number: makes a number of the arithmetic from a rational one.
    """
    roots = list(roots)
    return Evaluation(roots[0].graph, inputs.__getitem__, Arithmetic(number)).of(roots)
