"""Expressions as a graph: each value exists once, and constants are folded.

Constants are rational numbers, folded without rounding and rounded once, when they are printed.
Only identities that hold for every finite number to the last bit are used: x + 0, 1 x, 0 x, -(-x),
x - x, and signs moved out of products. A product that is structurally zero is zero; a product that
is merely tiny is kept.

A value has a width: one number, or as many as there are SIMD lanes. Operations on wide values work
lane by lane, and a single number beside them stands for all lanes. A constant that is the same in
all lanes is a single number, so that the identities are used where they hold in all lanes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import isqrt
from typing import Any

from flint import fmpq

from adagen.graph.constants import KEPT, is_negative, lanewise, rational, shortened
from adagen.graph.nodes import CYCLES, Node, Op

_tuple: Callable[..., Any] = tuple.__new__
"""Makes a node of a tuple, without the call that names its fields."""


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
        self._numbers: dict[float, int] = {}  # nodes of plain numbers
        self._opposite: dict[int, int] = {}  # nodes of constants, by those of their negatives
        self._minus: set[int] = set()  # nodes of constants that are the negatives of others
        # Of each node: its value if it is a constant, and what it is the negative of, or -1.
        self._constants: list[Any] = []
        self._negated: list[int] = []
        self._zero = self._one = -1

    def input(self, name: str, ready: int = 0, width: int = 1) -> Expression:
        """Return the input with the given name."""
        return self._node("input", (), name, ready, width)

    def constant(self, value: Any) -> Expression:
        """Return a number: a float or int (kept as it is, nothing is rounded) or a fmpq.

        A tuple holds a number for each lane.
        """
        if isinstance(value, fmpq):
            return self._constant((value,))
        if isinstance(value, tuple):
            return self._constant(tuple([rational(x) for x in value]))
        index = self._numbers.get(value)
        if index is not None:
            return Expression(self, index)
        found = self._constant((rational(value),))
        self._numbers[value] = found.index
        return found

    def _constant(self, lanes: tuple[Any, ...]) -> Expression:
        """A constant: a rational number for each lane, or a single one for all."""
        # Hashes of rational numbers are slow, those of their parts are not.
        parts = tuple([(int(x.p), int(x.q)) for x in lanes])
        if len(lanes) > 1 and parts.count(parts[0]) == len(parts):
            return self._constant(lanes[:1])
        index = self._known.get(parts)
        if index is None:
            value = tuple(shortened(x, *part) for x, part in zip(lanes, parts, strict=True))
            if value != lanes:
                return self._constant(value)
            single = len(value) == 1
            index = self._known[parts] = len(self.nodes)
            self._add("constant", (), value[0] if single else value, 0, len(value))
            if is_negative(value):
                self._minus.add(index)
            if single:
                self._zero = index if value[0] == 0 else self._zero
                self._one = index if value[0] == 1 else self._one
        return Expression(self, index)

    def pack(self, numbers: Sequence[Expression], count: int | None = None) -> Expression:
        """Return a value with a number in each lane; the number itself where all are the same.

        Args:
            numbers: for each lane.
            count: lanes that count, all if not given; what is in others does not matter.
        """
        first, own = numbers[0], numbers[:count]
        if all(x == first for x in numbers):
            return first
        known = tuple(x.constant for x in numbers)
        if None not in known:
            return self.constant(known)
        opposite = [x.negated for x in numbers]
        if all(x is not None for x in opposite):
            return -self.pack([x for x in opposite if x is not None], count)
        if all(x.node.op == "lane" and x.node.value == k for k, x in enumerate(own)):
            (source, *others) = {x.node.args[0] for x in own}
            if not others and self.nodes[source].width == len(numbers):
                return Expression(self, source)
        return self._node("pack", tuple(x.index for x in numbers), width=len(numbers))

    def lane(self, a: Expression, k: int) -> Expression:
        """Return the number in lane k of a value; a single number is in all lanes."""
        if a.node.width == 1:
            return a
        if a.constant is not None:
            return self.constant(a.constant[k])
        if a.negated is not None:
            return -self.lane(a.negated, k)
        if a.node.op == "pack":
            return Expression(self, a.node.args[k])
        return self._node("lane", (a.index,), k, width=1)

    def across(self, a: Expression, count: int) -> Expression:
        """Return the sum of a value's first numbers."""
        if a.node.width == 1:
            return self.constant(count) * a
        if a.constant is not None:
            return self.constant(sum(a.constant[:count], start=fmpq(0)))
        if a.negated is not None:
            return -self.across(a.negated, count)
        return self._node("across", (a.index,), count, width=1)

    def add(self, a: Expression, b: Expression) -> Expression:
        """Return a + b."""
        i, k = a.index, b.index
        if i == self._zero:
            return b
        if k == self._zero:
            return a
        x, y = self._constants[i], self._constants[k]
        if x is not None and y is not None:
            return self.constant(lanewise(lambda a, b: a + b, x, y))
        if self._negated[i] >= 0:
            return self.sub(b, Expression(self, self._negated[i]))
        if self._negated[k] >= 0:
            return self.sub(a, Expression(self, self._negated[k]))
        if i == k:
            return self.mul(self.constant(2), a)
        return self._pair("add", (i, k) if i < k else (k, i))

    def sub(self, a: Expression, b: Expression) -> Expression:
        """Return a - b."""
        i, k = a.index, b.index
        if k == self._zero:
            return a
        if i == self._zero:
            return self.neg(b)
        x, y = self._constants[i], self._constants[k]
        if x is not None and y is not None:
            return self.constant(lanewise(lambda a, b: a - b, x, y))
        if i == k:
            return self.constant(0)
        if self._negated[k] >= 0:
            return self.add(a, Expression(self, self._negated[k]))
        if self._negated[i] >= 0:
            return self.neg(self.add(Expression(self, self._negated[i]), b))
        opposite = self._known.get(("sub", (k, i), None))
        if opposite is not None:
            return self.neg(Expression(self, opposite))
        return self._pair("sub", (i, k))

    def mul(self, a: Expression, b: Expression) -> Expression:
        """Return a b."""
        i, k = a.index, b.index
        if i == self._zero or k == self._one:
            return a
        if k == self._zero or i == self._one:
            return b
        x, y = self._constants[i], self._constants[k]
        if x is not None or y is not None:
            if x is not None and y is not None:
                return self.constant(lanewise(lambda a, b: a * b, x, y))
            if (k if x is None else i) in self._minus:
                return self.neg(self.mul(self.neg(a), b) if y is None else self.mul(a, self.neg(b)))
        if self._negated[i] >= 0:
            return self.neg(self.mul(Expression(self, self._negated[i]), b))
        if self._negated[k] >= 0:
            return self.neg(self.mul(a, Expression(self, self._negated[k])))
        return self._pair("mul", (i, k) if i < k else (k, i))

    def multiply_add(self, a: Expression, b: Expression, c: Expression) -> Expression:
        """Return a b + c, rounded once; a product or a sum where that is one of its operations."""
        x, y, z = (self._constants[k.index] for k in (a, b, c))
        if x is not None and y is not None and z is not None:
            known = lanewise(lambda a, b: a * b, x, y)
            return self.constant(lanewise(lambda a, b: a + b, known, z))
        (a, minus), (b, also) = self._with_sign(a), self._with_sign(b)
        if self._zero in (a.index, b.index):
            return c
        if c.index == self._zero or self._one in (a.index, b.index):
            product = self.mul(a, b)
            return self.add(product, c) if minus == also else self.sub(c, product)
        i, k = (a.index, b.index) if a.index < b.index else (b.index, a.index)
        rest = self._negated[c.index]
        if minus == also:
            args, signs = ((i, k, c.index), (1, 1)) if rest < 0 else ((i, k, rest), (1, -1))
            return self._node("multiply_add", args, signs)
        if rest < 0:
            return self._node("multiply_add", (i, k, c.index), (-1, 1))
        return self.neg(self._node("multiply_add", (i, k, rest), (1, 1)))

    def _with_sign(self, a: Expression) -> tuple[Expression, bool]:
        """A value without its sign where that is written, and whether it is."""
        if a.index in self._minus or self._negated[a.index] >= 0:
            return self.neg(a), True
        return a, False

    def neg(self, a: Expression) -> Expression:
        """Return -a."""
        x = self._constants[a.index]
        if x is not None:
            index = self._opposite.get(a.index)
            if index is None:
                found = self.constant(tuple(-one for one in x) if isinstance(x, tuple) else -x)
                index = self._opposite[a.index] = found.index
            return Expression(self, index)
        if self._negated[a.index] >= 0:
            return Expression(self, self._negated[a.index])
        return self._node("neg", (a.index,))

    def reciprocal(self, a: Expression) -> Expression:
        """Return 1 / a; of zero it is left to whoever evaluates it."""
        x = a.constant
        if x is not None and x != 0 and not (isinstance(x, tuple) and 0 in x):
            return self.constant(lanewise(lambda x, y: x / y, fmpq(1), x))
        if a.negated is not None:
            return self.neg(self.reciprocal(a.negated))
        return self._node("reciprocal", (a.index,))

    def sqrt(self, a: Expression) -> Expression:
        """Return the square root of a; of a number to 256 bits behind the point."""
        if a.node.width > 1:
            return self._by_lanes(self.sqrt, a)
        x = a.constant
        if x is None or x < 0:
            return self._node("sqrt", (a.index,))
        root = isqrt((int(x.p) << 2 * KEPT) // int(x.q))
        return self.constant(fmpq(root) / fmpq(2) ** KEPT)

    def sign(self, a: Expression) -> Expression:
        """Return 1 where a is not negative, else -1."""
        if a.node.width > 1:
            return self._by_lanes(self.sign, a)
        if a.constant is not None:
            return self.constant(1 if a.constant >= 0 else -1)
        return self._node("sign", (a.index,))

    def larger(self, a: Expression, b: Expression) -> Expression:
        """Return the larger of a and b."""
        x, y = a.constant, b.constant
        if x is not None and y is not None:
            return self.constant(lanewise(max, x, y))
        if a.index == b.index:
            return a
        return self._node("max", (min(a.index, b.index), max(a.index, b.index)))

    def _by_lanes(self, function: Callable[..., Expression], *args: Expression) -> Expression:
        """A function of the runtime on single numbers, for each lane."""
        width = max(a.node.width for a in args)
        return self.pack([function(*(self.lane(a, k) for a in args)) for k in range(width)])

    def _node(
        self, op: Op, args: tuple[int, ...], value: Any = None, ready: int = 0, width: int = 0
    ) -> Expression:
        """Return a value, an existing one if it is equal; by default as wide as its args."""
        key = (op, args, (value, width) if op == "input" else value)
        index = self._known.get(key)
        if index is None:
            index = self._known[key] = len(self.nodes)
            self._add(op, args, value, ready, width)
        return Expression(self, index)

    def _pair(self, op: Op, args: tuple[int, int]) -> Expression:
        """Return a sum, difference or product: what ``_node`` does, in half its time.

        Graphs are little else, and most of what they hold is made here.
        """
        key = (op, args, None)
        index = self._known.get(key)
        if index is None:
            nodes = self.nodes
            index = self._known[key] = len(nodes)
            _, _, _, ready, _, width = nodes[args[0]]
            _, _, _, other, _, breadth = nodes[args[1]]
            if other > ready:
                ready = other
            if breadth > width:
                width = breadth
            nodes.append(_tuple(Node, (op, args, None, ready + 4, self.mark, width)))
            self._constants.append(None)
            self._negated.append(-1)
        return Expression(self, index)

    def _add(self, op: Op, args: tuple[int, ...], value: Any, ready: int, width: int) -> None:
        """Append a node; without a width it is as wide as its operands."""
        nodes, latest, widest = self.nodes, 0, 1
        for k in args:  # comparisons instead of max: this loop runs for every value
            _, _, _, earlier, _, wide = nodes[k]
            if earlier > latest:
                latest = earlier
            if wide > widest:
                widest = wide
        ready += latest + CYCLES.get(op, 4)
        nodes.append(Node(op, args, value, ready, self.mark, width or widest))
        self._constants.append(value if op == "constant" else None)
        self._negated.append(args[0] if op == "neg" else -1)


class Expression:
    """A value of a graph with operators: +, -, * with other expressions and plain numbers."""

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
        """Its value if it is a constant (fmpq; a tuple where it is wide), else None."""
        return self.graph._constants[self.index]

    @property
    def negated(self) -> Expression | None:
        """Its operand, if it is a negation."""
        index = self.graph._negated[self.index]
        return Expression(self.graph, index) if index >= 0 else None

    def __add__(self, other: Any) -> Expression:
        graph = self.graph
        if type(other) is not Expression:
            other = graph.constant(other)
        return graph.add(self, other)

    def __radd__(self, other: Any) -> Expression:
        graph = self.graph
        if type(other) is not Expression:
            other = graph.constant(other)
        return graph.add(other, self)

    def __sub__(self, other: Any) -> Expression:
        graph = self.graph
        if type(other) is not Expression:
            other = graph.constant(other)
        return graph.sub(self, other)

    def __rsub__(self, other: Any) -> Expression:
        graph = self.graph
        if type(other) is not Expression:
            other = graph.constant(other)
        return graph.sub(other, self)

    def __mul__(self, other: Any) -> Expression:
        graph = self.graph
        if type(other) is not Expression:
            other = graph.constant(other)
        return graph.mul(self, other)

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
