"""Expression graphs: symbolic evaluation, without duplicate or unused values."""

from __future__ import annotations

from adagen.graph.block_triangular import Regular, solved_by_blocks
from adagen.graph.count import Operations, count_operations, live_nodes, uses_of
from adagen.graph.evaluate import BALLS, DOUBLE, FLOAT, Algebra, Evaluation
from adagen.graph.expressions import Expression, Graph
from adagen.graph.fused import with_fused
from adagen.graph.linear import (
    Factors,
    cross,
    dot,
    factorize,
    matrix_times,
    reflect,
    solve_by_reflections,
    solve_lower,
    solved_by_reflections,
    total,
)
from adagen.graph.nodes import Node
from adagen.graph.numbers import Number, Numbers
from adagen.graph.rounded_once import RoundedGraph

__all__ = [
    "BALLS",
    "DOUBLE",
    "FLOAT",
    "Algebra",
    "Evaluation",
    "Expression",
    "Factors",
    "Graph",
    "Node",
    "Number",
    "Numbers",
    "Operations",
    "Regular",
    "RoundedGraph",
    "count_operations",
    "cross",
    "dot",
    "factorize",
    "live_nodes",
    "matrix_times",
    "reflect",
    "solve_by_reflections",
    "solve_lower",
    "solved_by_blocks",
    "solved_by_reflections",
    "total",
    "uses_of",
    "with_fused",
]
