"""Expressions as C++ text, a value that is used once written inline; steps as comments."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from adagen.emit.expressions import Printer
from adagen.emit.symbols import Symbols
from adagen.emit.unrolled.arrangement import is_given
from adagen.graph import Graph, Node
from adagen.plan.steps import Step

_MOST = 6  # operands of one statement
_LARGEST = {"double": 1.7976931348623157e308, "float": 3.4028234663852886e38}
_LEAST = {"double": 5e-324, "float": 1.401298464324817e-45}
FUNCTIONS = {"sqrt": "sqrt_of", "sign": "sign_of", "max": "max_of"}
"""Operations that are functions of the runtime, and their names there."""
MULTIPLY_ADD = {(1, 1): "fused", (1, -1): "fused_less", (-1, 1): "fused_from"}
"""Functions of the runtime for products and sums that are rounded once, by their signs."""
TYPES = {1: "Real", 2: "Two", 4: "Four", 8: "Eight"}
"""Names of the types of single states' values, by width."""

_MOVES = ("pack", "lane", "across")  # what they work on has a name
_SUM, _PRODUCT, _SIGN, _ATOM = range(4)  # how tightly a text binds


@dataclass(frozen=True)
class _Piece:
    text: str
    binding: int
    operands: int


class Text:
    """Prints the values of one graph.

    Args:
        graph: the graph.
        scalar: "double" or "float".
        only_user: by index, the one value that uses a value, where there is just one use.
    """

    def __init__(self, graph: Graph, scalar: str, only_user: Mapping[int, int]) -> None:
        self.graph = graph
        self.scalar = scalar
        self.only_user = only_user
        self.printer = Printer(scalar)

    def literal(self, value: object) -> str:
        """Return a rational number, or one for each lane, as a literal, rounded once."""
        if isinstance(value, tuple):
            return f"{TYPES[len(value)]}{{{', '.join(self.literal(x) for x in value)}}}"
        p, q = int(getattr(value, "p", 0)), int(getattr(value, "q", 1))
        try:
            number = p / q
        except OverflowError:
            number = float("inf") if p > 0 else float("-inf")
        if abs(number) > _LARGEST[self.scalar]:
            return "kInfinity" if number > 0 else "-kInfinity"
        return self.printer.number(0.0 if abs(number) < _LEAST[self.scalar] else number)

    def name(self, index: int) -> str:
        """Return the name of a value, or a constant's number."""
        node = self.graph.nodes[index]
        if node.op == "constant":
            return self.literal(node.value)
        if not is_given(node):
            return f"x{index}"
        if node.width == 1:
            return str(node.value)
        array, place = str(node.value).removesuffix("]").split("[")
        return f"load<{TYPES[node.width]}>({array} + {place})"

    def statements(self, chunk: Sequence[int]) -> dict[int, str]:
        """Return the right-hand sides of those values of a chunk that get a name, in order.

        Args:
            chunk: indices of the values to compute; what they use from elsewhere is named.
        """
        here = set(chunk)
        named: dict[int, str] = {}
        waiting: dict[int, _Piece] = {}
        for index in chunk:
            node = self.graph.nodes[index]
            if node.op == "input":
                named[index] = str(node.value)
                continue
            pieces = [self._operand(k, waiting) for k in node.args]
            while node.op not in _MOVES and sum(piece.operands for piece in pieces) > _MOST:
                k = max(range(len(pieces)), key=lambda k: pieces[k].operands)
                named[node.args[k]] = waiting.pop(node.args[k]).text
                pieces[k] = self._operand(node.args[k], waiting)
            for k in node.args:
                waiting.pop(k, None)
            piece = _moved(node, pieces) if node.op in _MOVES else _combined(node, pieces)
            if self.only_user.get(index) in here:
                waiting[index] = piece
            else:
                named[index] = piece.text
        return named

    def inlined(self, index: int) -> str:
        """Return a value with all its operands inline, down to inputs."""
        node = self.graph.nodes[index]
        if node.op in ("input", "constant"):
            return self._operand(index, {}).text
        pieces = []
        for k in node.args:
            binding = _ATOM if self.graph.nodes[k].op in ("input", "constant") else _SUM
            pieces.append(_Piece(self.inlined(k), binding, 1))
        return _combined(node, pieces).text

    def _operand(self, index: int, waiting: Mapping[int, _Piece]) -> _Piece:
        if index in waiting:
            return waiting[index]
        text = self.name(index)
        return _Piece(text, _SIGN if text.startswith("-") else _ATOM, 1)


def _moved(node: Node, pieces: Sequence[_Piece]) -> _Piece:
    """Moves of numbers into lanes or out of them."""
    numbers = ", ".join(piece.text for piece in pieces)
    match node.op:
        case "pack":
            text = f"{TYPES[node.width]}{{{numbers}}}"
        case "lane":
            text = f"{numbers}[{node.value}]"
        case _:
            text = f"across<{node.value}>({numbers})"
    return _Piece(text, _ATOM, 1)


def _combined(node: Node, pieces: Sequence[_Piece]) -> _Piece:
    """An operation on pieces, parenthesised so that it is done in the order of the graph."""
    op, count = node.op, sum(piece.operands for piece in pieces)
    if op == "multiply_add":
        name = MULTIPLY_ADD[node.value]
        return _Piece(f"{name}({', '.join(p.text for p in pieces)})", _ATOM, count)
    if op == "neg":
        return _Piece(f"-{_within(pieces[0], _PRODUCT)}", _SIGN, count)
    if op == "reciprocal":
        return _Piece(f"1 / {_within(pieces[0], _ATOM)}", _PRODUCT, count)
    if op in FUNCTIONS:
        return _Piece(f"{FUNCTIONS[op]}({', '.join(p.text for p in pieces)})", _ATOM, count)
    a, b = pieces
    if op == "mul":
        return _Piece(f"{_within(a, _PRODUCT)} * {_within(b, _SIGN)}", _PRODUCT, count)
    if op == "add" and b.binding == _SUM and a.binding != _SUM:
        a, b = b, a
    sign = "+" if op == "add" else "-"
    return _Piece(f"{_within(a, _SUM)} {sign} {_within(b, _PRODUCT)}", _SUM, count)


def _within(piece: _Piece, least: int) -> str:
    return piece.text if piece.binding >= least else f"({piece.text})"


def describe_step(symbols: Symbols, step: Step, row: Callable[[int], Sequence[int]]) -> str:
    """Return a step with its joints or links, in one line of ASCII.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        step: the step.
        row: the joints that are treated as one with a joint.
    """
    link, joint = getattr(step, "link", None), getattr(step, "joint", None)
    if link is not None:
        links = [j + 1 for j in row(link - 1)]
        names = ", ".join(f"{k} {symbols.quoted_link(k)}" for k in links)
        return f"link{'s' * (len(links) > 1)} {names}: {step.about}"
    if joint is None:
        return step.about
    joints = row(joint)
    names = ", ".join(f"{j} {symbols.quoted_joint(j)}" for j in joints)
    if len(joints) == 1:
        return f"joint {names}: {step.about}"
    return f"joints {names}: {getattr(step, 'about_row', step.about)}"
