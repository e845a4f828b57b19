"""Evaluates expressions in any arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from adagen.graph import Expression, live_nodes


def evaluate(
    roots: Iterable[Expression], inputs: Mapping[str, Any], number: Callable[[Any], Any]
) -> list[Any]:
    """Return the values of expressions of one graph.

    Args:
        roots: what is wanted.
        inputs: values of the inputs by name.
        number: makes a number of the arithmetic from a rational one.
    """
    roots = list(roots)
    graph = roots[0].graph
    values: dict[int, Any] = {}
    for index in live_nodes(graph, roots):
        node = graph.nodes[index]
        args = [values[k] for k in node.args]
        match node.op:
            case "constant":
                values[index] = number(node.value)
            case "input":
                values[index] = inputs[node.value]
            case "add":
                values[index] = args[0] + args[1]
            case "sub":
                values[index] = args[0] - args[1]
            case "mul":
                values[index] = args[0] * args[1]
            case "neg":
                values[index] = -args[0]
            case "reciprocal":
                values[index] = 1 / args[0]
    return [values[root.index] for root in roots]
