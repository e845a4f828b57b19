"""Evaluates expressions in any arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from adagen.graph import Expression, Node, live_nodes


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
    graph = roots[0].graph
    values: dict[int, Any] = {}
    for index in live_nodes(graph, roots):
        node = graph.nodes[index]
        args = [values[k] for k in node.args]
        match node.op:
            case "constant" if node.width > 1:
                values[index] = tuple(map(number, node.value))
            case "constant":
                values[index] = number(node.value)
            case "input" if node.width > 1:
                values[index] = tuple(inputs[name] for name in _lanes_of(node))
            case "input":
                values[index] = inputs[node.value]
            case "pack":
                values[index] = tuple(args)
            case "lane":
                values[index] = args[0][node.value]
            case "across":
                values[index] = sum(args[0][1 : node.value], start=args[0][0])
            case _:
                values[index] = _lane_by_lane(_OPERATIONS[node.op], args)
    return [values[root.index] for root in roots]


_OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "neg": lambda x: -x,
    "reciprocal": lambda x: 1 / x,
}


def _lane_by_lane(operation: Callable[..., Any], args: Sequence[Any]) -> Any:
    width = max(len(x) if isinstance(x, tuple) else 1 for x in args)
    if width == 1:
        return operation(*args)
    lanes = zip(*(x if isinstance(x, tuple) else (x,) * width for x in args), strict=True)
    return tuple(operation(*each) for each in lanes)


def _lanes_of(node: Node) -> list[str]:
    array, first = str(node.value).removesuffix("]").split("[")
    return [f"{array}[{int(first) + k}]" for k in range(node.width)]
