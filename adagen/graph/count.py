"""Live values of a graph, and the operations of its evaluation."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from adagen.graph.expressions import Expression, Graph
from adagen.graph.nodes import Node


@dataclass(frozen=True)
class Operations:
    """Operations of an evaluation.

    Attributes:
        multiply: products.
        add: sums and differences.
        divide: reciprocals.
        negate: changes of sign that no sum takes up.
        fused: sums and differences that can take up a product of no other use.
        ready: cycles until the last value is there, were there no limit to what is done at once.
        wide: how many of the products, sums, quotients and negations are done in several lanes.
        moves: numbers put into lanes or read from there.
    """

    multiply: int
    add: int
    divide: int
    negate: int
    fused: int
    ready: int
    wide: int = 0
    moves: int = 0

    @property
    def arithmetic(self) -> int:
        """Products, sums and differences."""
        return self.multiply + self.add

    @property
    def instructions(self) -> int:
        """Approximate number of instructions: a multiply-add is one."""
        return self.arithmetic - self.fused + self.divide + self.negate + self.moves


def uses_of(graph: Graph, roots: Iterable[Expression]) -> list[int]:
    """Return for each node how often it is used by what the roots depend on, and as a root."""
    nodes = graph.nodes
    uses = [0] * len(nodes)
    for root in roots:
        uses[root.index] += 1
    for index in range(len(nodes) - 1, -1, -1):
        if uses[index]:
            for k in nodes[index].args:
                uses[k] += 1
    return uses


def live_nodes(graph: Graph, roots: Iterable[Expression]) -> list[int]:
    """Return the indices, ascending, of all nodes that the roots depend on."""
    return [index for index, used in enumerate(uses_of(graph, roots)) if used]


def count_operations(
    graph: Graph,
    roots: Iterable[Expression],
    uses: Sequence[int] | None = None,
    alive: Sequence[int] | None = None,
) -> Operations:
    """Return the operations of an evaluation of the roots.

    Args:
        graph: it.
        roots: what is wanted.
        uses: what ``uses_of`` returns, if it is known.
        alive: nodes that are used, ascending, likewise.
    """
    roots, nodes = list(roots), graph.nodes
    uses = uses_of(graph, roots) if uses is None else uses
    alive = [index for index, used in enumerate(uses) if used] if alive is None else alive
    kinds: Counter[str] = Counter()
    fused = wide = moves = 0
    for index in alive:
        op, args, _, _, _, width = nodes[index]
        kinds[op] += 1
        if op in _DONE:
            wide += width > 1
            if op in _SUMS:  # written without a loop: it runs for every other statement
                i, k = args
                if (uses[i] == 1 and nodes[i].op == "mul") or (
                    uses[k] == 1 and nodes[k].op == "mul"
                ):
                    fused += 1
            fused += op == "multiply_add"
        elif op in _MOVED:
            moves += _moves(nodes[index])
    ready = max((nodes[root.index].ready for root in roots), default=0)
    return Operations(
        kinds["mul"] + kinds["multiply_add"],
        kinds["add"] + kinds["sub"] + kinds["multiply_add"],
        kinds["reciprocal"],
        kinds["neg"],
        fused,
        ready,
        wide,
        moves,
    )


_DONE = ("mul", "multiply_add", "add", "sub", "reciprocal", "neg")
_SUMS = ("add", "sub")
_MOVED = ("pack", "lane", "across")


def _moves(node: Node) -> int:
    """Return the number of moves into lanes or out of them for a value."""
    match node.op:
        case "pack":
            return node.width
        case "lane":
            return 1
        case "across":
            return int(node.value)
        case _:
            return 0
