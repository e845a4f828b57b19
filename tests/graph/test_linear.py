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
    solved_by_blocks,
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


@pytest.mark.parametrize("seed", range(6))
def test_independent_parts_are_solved_by_themselves(seed: int) -> None:
    """Parts of one to four unknowns, rows and columns in any order, of any size."""
    rng = np.random.default_rng(seed)
    sizes, n = (1, 2, 3, 4), 10
    matrix, first = np.zeros((n, n)), 0
    for size in sizes:
        part = slice(first, first + size)
        matrix[part, part] = rng.uniform(-1.0, 1.0, (size, size))
        first += size
    rows, columns = rng.permutation(n), rng.permutation(n)
    scales = 2.0 ** rng.integers(-9, 9, n)
    matrix = (matrix / scales[:, None])[np.ix_(rows, columns)]
    scales, right = scales[rows], rng.uniform(-1.0, 1.0, (n, 3))
    graph, inputs = Graph(), dict[str, float]()
    given = given_as("m", matrix, graph, inputs)
    for place in zip(*np.nonzero(matrix == 0.0), strict=True):
        given[place] = graph.constant(0)
    own = np.array([graph.constant(float(x)) for x in scales], dtype=object)
    solved, regular = solved_by_blocks(given, given_as("x", right, graph, inputs), own)
    expected = np.linalg.solve(matrix, right)
    np.testing.assert_allclose(numbers(solved, inputs), expected, rtol=1e-9)
    squares = numbers(np.array([each.square for each in regular], dtype=object), inputs)
    assert (squares > 0.0).all()
    assert len(regular) == sum(sizes) + 2  # rows or pivots, and two determinants


@pytest.mark.parametrize("seed", range(6))
def test_parts_that_need_others_follow_them(seed: int) -> None:
    """Two of three unknowns below each other, in any order, take no square root."""
    rng = np.random.default_rng(seed)
    matrix = rng.uniform(-1.0, 1.0, (6, 6))
    matrix[:3, 3:] = 0.0
    rows, columns = rng.permutation(6), rng.permutation(6)
    matrix, right = matrix[np.ix_(rows, columns)], rng.uniform(-1.0, 1.0, (6, 2))
    graph, inputs = Graph(), dict[str, float]()
    given = given_as("m", matrix, graph, inputs)
    for place in zip(*np.nonzero(matrix == 0.0), strict=True):
        given[place] = graph.constant(0)
    own = np.array([graph.constant(1)] * 6, dtype=object)
    solved, regular = solved_by_blocks(given, given_as("x", right, graph, inputs), own)
    expected = np.linalg.solve(matrix, right)
    np.testing.assert_allclose(numbers(solved, inputs), expected, rtol=1e-9)
    assert len(regular) == 6 + 2  # rows, and two determinants
    assert not any(node.op == "sqrt" for node in graph.nodes)


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_a_part_that_is_next_to_singular_is_told(n: int) -> None:
    rng = np.random.default_rng(n)
    near = rng.uniform(0.5, 1.0, (n, n))
    near[-1] = near[:-1].sum(axis=0) + 1e-9 * rng.uniform(-1.0, 1.0, n)
    least = []
    for matrix in (near, np.eye(n) + 0.1 * near):
        graph, inputs = Graph(), dict[str, float]()
        given, right = (given_as(name, matrix, graph, inputs) for name in "mx")
        own = np.array([graph.constant(1)] * n, dtype=object)
        ratios = []
        for each in solved_by_blocks(given, right, own)[1]:
            told = [each.square, each.beside + graph.constant(0)]
            square, beside = numbers(np.array(told, dtype=object), inputs)
            ratios.append(square / beside)
        least.append(min(ratios))
    assert least[0] < 1e-14 < 1e-4 < least[1]
