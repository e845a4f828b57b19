"""Vectors and matrices of expressions against numpy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from adagen.graph import (
    Evaluation,
    Expression,
    Graph,
    cross,
    dot,
    factorize,
    matrix_times,
    solve_by_reflections,
    total,
)
from tests.graph.evaluate import evaluate

Array = NDArray[Any]


def given_as(name: str, values: Array, graph: Graph, inputs: dict[str, float]) -> Array:
    """Return inputs that stand for the values."""
    result = np.empty(values.shape, dtype=object)
    for place, value in np.ndenumerate(values):
        inputs[f"{name}{place}"] = float(value)
        result[place] = graph.input(f"{name}{place}")
    return result


def numbers(expressions: Array, inputs: dict[str, float]) -> Array:
    found = evaluate(expressions.flat, inputs, lambda x: int(x.p) / int(x.q))
    return np.array(found).reshape(expressions.shape)


def test_products_are_those_of_numpy() -> None:
    rng = np.random.default_rng(1)
    graph, inputs = Graph(), dict[str, float]()
    u, v, m = rng.normal(size=3), rng.normal(size=3), rng.normal(size=(3, 4))
    symbols = [given_as(name, x, graph, inputs) for name, x in (("u", u), ("v", v), ("m", m))]
    a, b, matrix = symbols
    np.testing.assert_allclose(numbers(cross(a, b), inputs), np.cross(u, v), atol=1e-15)
    np.testing.assert_allclose(numbers(np.array([dot(a, b)]), inputs), u @ v, atol=1e-15)
    np.testing.assert_allclose(numbers(matrix_times(matrix.T, a), inputs), m.T @ u, atol=1e-15)
    np.testing.assert_allclose(numbers(matrix_times(matrix.T, matrix), inputs), m.T @ m, atol=1e-14)


@pytest.mark.parametrize("n", [1, 2, 3, 6])
def test_factors_solve(n: int) -> None:
    rng = np.random.default_rng(n)
    graph, inputs = Graph(), dict[str, float]()
    root = rng.normal(size=(n, n))
    m, x = root @ root.T + np.eye(n), rng.normal(size=(n, 2))
    factors = factorize(given_as("m", m, graph, inputs))
    solution = factors.solve(given_as("x", x, graph, inputs))
    np.testing.assert_allclose(numbers(solution, inputs), np.linalg.solve(m, x), atol=1e-12)
    pivots = numbers(np.array(factors.pivots, dtype=object), inputs)
    np.testing.assert_allclose(np.prod(pivots), np.linalg.det(m), rtol=1e-10)


def test_factors_of_a_diagonal_matrix_divide_only() -> None:
    graph = Graph()
    matrix = np.full((3, 3), graph.constant(0), dtype=object)
    for k in range(3):
        matrix[k, k] = graph.input(f"d{k}")
    factors = factorize(matrix)
    ops = [node.op for node in graph.nodes]
    assert ops.count("reciprocal") == 3
    assert {"add", "sub", "mul"}.isdisjoint(ops)
    assert factors.pivots == tuple(matrix.diagonal())


def test_a_sum_waits_least_for_what_comes_last() -> None:
    graph = Graph()
    early: list[Expression] = [graph.input(name) for name in "abc"]
    late = graph.input("late", ready=100)
    assert total([late, *early]).node.ready == 104
    assert ((late + early[0]) + early[1]).node.ready == 108


@given(st.integers(1, 6), st.integers(0, 2**32 - 1))
def test_reflections_solve_what_has_no_good_pivots(n: int, seed: int) -> None:
    """Of any square matrix: the first pivots of this one are zero."""
    rng = np.random.default_rng(seed)
    matrix, right = rng.normal(size=(n, n)), rng.normal(size=(n, 2))
    matrix = np.eye(n)[::-1] + 0.1 * matrix / n
    matrix[0, 0] = 0.0 if n > 1 else 1.0
    inputs: dict[str, float] = {}
    graph = Graph()
    m, x = given_as("m", matrix, graph, inputs), given_as("x", right, graph, inputs)
    expressions = solve_by_reflections(m, x)
    found = Evaluation(graph, inputs.__getitem__).of(expressions.flat)
    expected = np.linalg.solve(matrix, right)
    np.testing.assert_allclose(np.reshape(found, right.shape), expected, atol=1e-12)
