"""Products and sums that become one operation, rounded once: a b + c."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Sequence

from adagen.graph.nodes import Node

_SUMS = ("add", "sub")


def with_fused(
    nodes: Sequence[Node], alive: Iterable[int], kept: Collection[int]
) -> dict[int, Node]:
    """Return the sums and differences that take up a product, by their indices.

    A product is taken up where it then need not be computed by itself: where all that it is used
    for are sums and differences, and none of them takes up another product. Products with few uses
    come first, then those that are known last, for which a sum would wait.

    Args:
        nodes: of a graph.
        alive: indices of those that are needed.
        kept: indices of those that are wanted by themselves.
    """
    users: dict[int, list[int]] = defaultdict(list)
    for index in alive:
        for k in nodes[index].args:
            if nodes[k].op == "mul" and k not in kept:
                users[k].append(index)
    fused: dict[int, Node] = {}
    for k in sorted(users, key=lambda k: (len(users[k]), -nodes[k].ready, k)):
        if all(_takes(nodes, index, k) and index not in fused for index in users[k]):
            fused.update((index, _taken_up(nodes, index, k)) for index in users[k])
    return fused


def _takes(nodes: Sequence[Node], index: int, product: int) -> bool:
    """Whether a value is a sum or difference that can take up a product: one of equal width."""
    node = nodes[index]
    return node.op in _SUMS and node.width == nodes[product].width


def _taken_up(nodes: Sequence[Node], index: int, product: int) -> Node:
    """A sum or difference with one of its operands, a product, taken up."""
    node = nodes[index]
    first = node.args[0] == product
    rest = node.args[1] if first else node.args[0]
    signs = (1, 1) if node.op == "add" else (1, -1) if first else (-1, 1)
    return node._replace(op="multiply_add", args=(*nodes[product].args, rest), value=signs)
