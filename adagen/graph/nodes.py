"""Nodes of an expression graph: one operation each, with its operands by their indices."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

Op = Literal[
    "constant",
    "input",
    "add",
    "sub",
    "mul",
    "multiply_add",
    "neg",
    "reciprocal",
    "sqrt",
    "sign",
    "max",
    "pack",
    "lane",
    "across",
]

CYCLES: dict[Op, int] = {
    "constant": -1,
    "input": 0,
    "neg": 0,
    "reciprocal": 14,
    "sqrt": 18,
    "sign": 2,
    "pack": 3,
    "lane": 3,
    "across": 12,
}
"""Cycles that operations take, about; others take 4."""


class Node(NamedTuple):
    """One value of a graph.

    Attributes:
        op: what is done; "pack" makes one wide value of numbers, "lane" takes one of its numbers,
            "across" adds up its first numbers, "multiply_add" is a b + c, rounded once.
        args: indices of the operands; all are less than the node's own index.
        value: the rational number of a constant (a tuple where it is wide), the name of an input,
            which number "lane" takes, how many "across" adds up, the signs of a b and of c in
            "multiply_add" (not both -1), else None.
        ready: about how many cycles after the inputs the value is there (add and multiply: 4).
        mark: what ``Graph.mark`` was when it was made: the step it belongs to.
        width: how many numbers it holds, one for each lane.
    """

    op: Op
    args: tuple[int, ...]
    value: Any
    ready: int
    mark: int
    width: int = 1
