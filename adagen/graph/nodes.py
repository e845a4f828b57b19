"""Expressions as a graph: each value is there once, and what is known beforehand is folded.

Constants are rational numbers, folded without rounding and rounded once, when they are printed.
Only identities that hold for every finite number to the last bit are used: x + 0, 1 x, 0 x, -(-x),
x - x, and signs drawn out of products. A product that is structurally zero is zero; a product that
is merely tiny is not touched.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isqrt
from typing import Any, Literal

from flint import fmpq

Op = Literal[
    "constant", "input", "add", "sub", "mul", "neg", "reciprocal", "sqrt", "sign", "tanh", "max"
]

_LONGEST = 2048  # bits of a numerator or denominator before it is cut to
_KEPT = 256

_CYCLES: dict[Op, int] = {
    "constant": -1,
    "input": 0,
    "neg": 0,
    "reciprocal": 14,
    "sqrt": 18,
    "sign": 2,
    "tanh": 60,
}


@dataclass(frozen=True)
class Node:
    """One value of a graph.

    Attributes:
        op: what is done.
        args: indices of the operands; all are less than the node's own index.
        value: the rational number of a constant, the name of an input, else None.
        ready: about how many cycles after the inputs the value is there (add and multiply: 4).
        mark: what ``Graph.mark`` was when it was made: the step it belongs to.
    """

    op: Op
    args: tuple[int, ...]
    value: Any
    ready: int
    mark: int


class Graph:
    """A growing set of expressions; equal ones are one.

    Attributes:
        nodes: in the order in which they were made, operands before what uses them.
        mark: a number that new nodes carry, for whoever prints them.
    """

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.mark = 0
        self._known: dict[tuple[Any, ...], int] = {}

    def input(self, name: str, ready: int = 0) -> Expression:
        """Return the value that is called ``name`` where the graph is evaluated."""
        return self._node("input", (), name, ready)

    def constant(self, value: Any) -> Expression:
        """Return a number: a float or int (taken as it is, nothing is rounded) or a fmpq."""
        if not isinstance(value, fmpq):
            value = fmpq(*value.as_integer_ratio()) if isinstance(value, float) else fmpq(value)
        return self._node("constant", (), _shortened(value))

    def add(self, a: Expression, b: Expression) -> Expression:
        """Return a + b."""
        x, y = a.constant, b.constant
        if x is not None and y is not None:
            return self.constant(x + y)
        if x == 0:
            return b
        if y == 0:
            return a
        if a.negated is not None:
            return self.sub(b, a.negated)
        if b.negated is not None:
            return self.sub(a, b.negated)
        if a.index == b.index:
            return self.mul(self.constant(2), a)
        return self._node("add", (min(a.index, b.index), max(a.index, b.index)))

    def sub(self, a: Expression, b: Expression) -> Expression:
        """Return a - b."""
        x, y = a.constant, b.constant
        if x is not None and y is not None:
            return self.constant(x - y)
        if x == 0:
            return self.neg(b)
        if y == 0:
            return a
        if a.index == b.index:
            return self.constant(0)
        if b.negated is not None:
            return self.add(a, b.negated)
        if a.negated is not None:
            return self.neg(self.add(a.negated, b))
        if ("sub", (b.index, a.index), None) in self._known:
            return self.neg(self._node("sub", (b.index, a.index)))
        return self._node("sub", (a.index, b.index))

    def mul(self, a: Expression, b: Expression) -> Expression:
        """Return a b."""
        x, y = a.constant, b.constant
        if x is not None and y is not None:
            return self.constant(x * y)
        if y is not None:
            a, b, x = b, a, y
        if x is not None:
            if x == 0:
                return a
            if x == 1:
                return b
            if x < 0:
                return self.neg(self.mul(self.constant(-x), b))
        if a.negated is not None:
            return self.neg(self.mul(a.negated, b))
        if b.negated is not None:
            return self.neg(self.mul(a, b.negated))
        return self._node("mul", (min(a.index, b.index), max(a.index, b.index)))

    def neg(self, a: Expression) -> Expression:
        """Return -a."""
        if a.constant is not None:
            return self.constant(-a.constant)
        if a.negated is not None:
            return a.negated
        return self._node("neg", (a.index,))

    def reciprocal(self, a: Expression) -> Expression:
        """Return 1 / a; of zero it is left to whoever evaluates it."""
        if a.constant is not None and a.constant != 0:
            return self.constant(1 / a.constant)
        if a.negated is not None:
            return self.neg(self.reciprocal(a.negated))
        return self._node("reciprocal", (a.index,))

    def sqrt(self, a: Expression) -> Expression:
        """Return the square root of a; of a number to 256 bits behind the point."""
        x = a.constant
        if x is None or x < 0:
            return self._node("sqrt", (a.index,))
        root = isqrt((int(x.p) << 2 * _KEPT) // int(x.q))
        return self.constant(fmpq(root) / fmpq(2) ** _KEPT)

    def sign(self, a: Expression) -> Expression:
        """Return 1 where a is not negative, else -1."""
        if a.constant is not None:
            return self.constant(1 if a.constant >= 0 else -1)
        return self._node("sign", (a.index,))

    def tanh(self, a: Expression) -> Expression:
        """Return the hyperbolic tangent of a; an odd function."""
        if a.negated is not None:
            return self.neg(self.tanh(a.negated))
        return a if a.constant == 0 else self._node("tanh", (a.index,))

    def larger(self, a: Expression, b: Expression) -> Expression:
        """Return the larger of a and b."""
        x, y = a.constant, b.constant
        if x is not None and y is not None:
            return a if x >= y else b
        if a.index == b.index:
            return a
        return self._node("max", (min(a.index, b.index), max(a.index, b.index)))

    def _node(self, op: Op, args: tuple[int, ...], value: Any = None, ready: int = 0) -> Expression:
        key = (op, args, value)
        index = self._known.get(key)
        if index is None:
            ready += max((self.nodes[k].ready for k in args), default=0)
            ready += _CYCLES.get(op, 4)
            index = self._known[key] = len(self.nodes)
            self.nodes.append(Node(op, args, value, ready, self.mark))
        return Expression(self, index)


class Expression:
    """A value of a graph, to calculate with: +, -, * with other expressions and plain numbers."""

    __slots__ = ("graph", "index")

    def __init__(self, graph: Graph, index: int) -> None:
        self.graph = graph
        self.index = index

    @property
    def node(self) -> Node:
        """The node."""
        return self.graph.nodes[self.index]

    @property
    def constant(self) -> Any:
        """Its value if that is known beforehand (fmpq), else None."""
        node = self.graph.nodes[self.index]
        return node.value if node.op == "constant" else None

    @property
    def negated(self) -> Expression | None:
        """What it is the negative of, if it is a negation."""
        node = self.graph.nodes[self.index]
        return Expression(self.graph, node.args[0]) if node.op == "neg" else None

    def _lift(self, other: Any) -> Expression:
        return other if isinstance(other, Expression) else self.graph.constant(other)

    def __add__(self, other: Any) -> Expression:
        return self.graph.add(self, self._lift(other))

    def __radd__(self, other: Any) -> Expression:
        return self.graph.add(self._lift(other), self)

    def __sub__(self, other: Any) -> Expression:
        return self.graph.sub(self, self._lift(other))

    def __rsub__(self, other: Any) -> Expression:
        return self.graph.sub(self._lift(other), self)

    def __mul__(self, other: Any) -> Expression:
        return self.graph.mul(self, self._lift(other))

    __rmul__ = __mul__

    def __neg__(self) -> Expression:
        return self.graph.neg(self)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Expression)
            and other.graph is self.graph
            and other.index == self.index
        )

    def __hash__(self) -> int:
        return hash((id(self.graph), self.index))

    def __repr__(self) -> str:
        return f"Expression({self.index}: {self.node})"


def _shortened(value: Any) -> Any:
    """A rational number that has grown out of hand, to 256 bits: far more than any scalar keeps."""
    p, q = int(value.p), int(value.q)
    longest = max(p.bit_length(), q.bit_length())
    if longest <= _LONGEST:
        return value
    shift = _KEPT - p.bit_length() + q.bit_length()
    scaled = (p << shift) // q if shift >= 0 else p // (q << -shift)
    return fmpq(scaled) / fmpq(2) ** shift
