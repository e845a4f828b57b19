"""Expression graphs: formulas run symbolically, without anything that is there twice or unused."""

from __future__ import annotations

from adagen.graph.count import Operations, count_operations, live_nodes
from adagen.graph.evaluate import BALLS, DOUBLE, FLOAT, Algebra, Evaluation
from adagen.graph.linear import Factors, cross, dot, factorize, matrix_times, total
from adagen.graph.nodes import Expression, Graph, Node

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
    "Operations",
    "count_operations",
    "cross",
    "dot",
    "factorize",
    "live_nodes",
    "matrix_times",
    "total",
]
