"""Values that functions of batches compute again instead of loading them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.emit.unrolled.computed_again import compute_again
from adagen.graph import Graph

OPERATIONS = {"add": np.add, "sub": np.subtract, "mul": np.multiply}


@dataclass
class Function:
    values: list[int]


def drawn(seed: int, count: int) -> tuple[Graph, list[Function], set[int]]:
    """Return a random graph, its values in functions, and which of them are results."""
    rng = np.random.default_rng(seed)
    graph = Graph()
    values = [graph.input(f"q[{k}]") for k in range(3)]
    while len(graph.nodes) < count:
        one, other = (values[int(rng.integers(len(values)))] for _ in range(2))
        made = (one + other, one - other, one * other, graph.reciprocal(one))
        values.append(made[int(rng.integers(len(made)))])
    computed = [k for k, node in enumerate(graph.nodes) if node.op not in ("input", "constant")]
    used = {arg for node in graph.nodes for arg in node.args}
    results = {k for k in computed if k not in used or rng.random() < 0.1}
    ends = sorted(rng.choice(len(computed), size=min(3, len(computed)), replace=False).tolist())
    bounds = [0, *ends, len(computed)]
    parts = [computed[a:b] for a, b in pairwise(bounds)]
    return graph, [Function(part) for part in parts if part], results


def carried_out(graph: Graph, functions: list[Function]) -> dict[int, int]:
    """Return how often each value is loaded, having looked at everything in order."""
    first: dict[int, int] = {}
    loads: dict[int, int] = {}
    for k, function in enumerate(functions):
        here: set[int] = set()
        loaded: set[int] = set()
        for v in function.values:
            assert v not in here, "computed twice by one function"
            for arg in graph.nodes[v].args:
                if graph.nodes[arg].op in ("input", "constant") or arg in here:
                    continue
                assert first[arg] < k, "used before it is computed"
                loaded.add(arg)
            here.add(v)
            first.setdefault(v, k)
        for v in loaded:
            loads[v] = loads.get(v, 0) + 1
    return loads


@settings(max_examples=200)
@given(seed=st.integers(0, 10**6), count=st.integers(4, 60))
def test_all_that_is_used_is_there_and_less_is_loaded(seed: int, count: int) -> None:
    graph, functions, results = drawn(seed, count)
    before = carried_out(graph, functions)
    home = {v: k for k, function in enumerate(functions) for v in function.values}
    compute_again(graph, functions, results)
    after = carried_out(graph, functions)
    assert sum(after.values()) <= sum(before.values())
    for k, function in enumerate(functions):
        users = {arg for v in function.values for arg in graph.nodes[v].args}
        for v in function.values:
            assert v in users or v in after or v in results, "nobody needs it"
            if v in results:
                assert home[v] == k, "results stay where they are"
    assert results <= {v for function in functions for v in function.values}


def test_rows_over_a_pivot_are_computed_from_one_reciprocal() -> None:
    graph = Graph()
    rows = [graph.input(f"q[{k}]") * graph.input("v[0]") for k in range(4)]
    pivot = graph.reciprocal(rows[0] + rows[1])
    factors = [row * pivot for row in rows]
    sums = [x + y for x, y in zip(rows, factors, strict=True)]
    total = sums[0] * sums[1] + sums[2] * sums[3]
    indices = [k for k, node in enumerate(graph.nodes) if node.op not in ("input", "constant")]
    place = indices.index(factors[-1].index) + 1
    functions = [Function(indices[:place]), Function(indices[place:])]
    compute_again(graph, functions, {total.index})
    assert set(carried_out(graph, functions)) == {pivot.index}
    assert {factor.index for factor in factors} <= set(functions[1].values)
    assert not {factor.index for factor in factors} & set(functions[0].values)


def test_long_chains_of_sums_may_be_computed_again() -> None:
    graph = Graph()
    sums = [graph.input("q[0]") + graph.input("q[1]")]
    for k in range(3000):
        sums.append(sums[-1] + graph.input(f"v[{k}]"))
    used = [x * graph.input("tau[0]") for x in sums]
    functions = [Function([x.index for x in sums]), Function([x.index for x in used[::-1]])]
    compute_again(graph, functions, {x.index for x in used})
    assert not carried_out(graph, functions)
    assert not functions[0].values
