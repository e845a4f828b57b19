"""Products and sums that are rounded once: what is folded, which are taken up, their last bits."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest
from flint import fmpq

from adagen.graph import (
    DOUBLE,
    FLOAT,
    Evaluation,
    Expression,
    Graph,
    RoundedGraph,
    count_operations,
    live_nodes,
    with_fused,
)
from adagen.graph.rounded_once import Scalar, _exact, multiply_add, nearest

SCALARS: list[Scalar] = [np.float64, np.float32]
ALGEBRAS = {np.float64: DOUBLE, np.float32: FLOAT}


def next_to_middles(scalar: Scalar) -> list[tuple[float, float, float]]:
    """Return operands whose exact result is next to the middle of two numbers."""
    step = float(np.finfo(scalar).eps)
    return [
        (sign * (1 + step) * step / 2, 1 + nudge * step, other * (1 + odd * step))
        for sign, nudge, other, odd in product((1, -1), (-1, 0, 1), (1, -1), (0, 1))
    ]


def operands(scalar: Scalar) -> list[tuple[float, float, float]]:
    """Return operands, half of which nearly cancel, of any size."""
    rng = np.random.default_rng(5)
    a, b, c = rng.standard_normal((3, 400)) * np.exp(rng.uniform(-30, 30, (3, 400)))
    c[::2] = -(a * b)[::2]
    own = np.array([a, b, c], dtype=scalar).astype(float).T
    return [*map(tuple, own), *next_to_middles(scalar)]


@pytest.mark.parametrize("scalar", SCALARS)
def test_it_is_rounded_once(scalar: Scalar) -> None:
    exact = _exact(scalar)
    given = np.array(operands(scalar), dtype=scalar).T
    expected = np.array([exact(*each) for each in given.T], dtype=scalar)
    found = multiply_add(scalar)(*given)
    assert found.dtype == scalar
    np.testing.assert_array_equal(found, expected)
    twice = given[0] * given[1] + given[2]
    assert not np.array_equal(twice, expected)


@pytest.mark.parametrize("scalar", SCALARS)
def test_without_a_library_it_is_the_same(scalar: Scalar) -> None:
    """Where numbers end, too."""
    largest, least = (float(getattr(np.finfo(scalar), n)) for n in ("max", "smallest_subnormal"))
    ends = [0.0, -0.0, 1.0, -1.0, largest, -largest, least, -least, np.inf, np.nan]
    exact, library = _exact(scalar), multiply_add(scalar)
    with np.errstate(all="ignore"):
        for a, b, c in product(ends, repeat=3):
            one, other = scalar(exact(a, b, c)), library(scalar(a), scalar(b), scalar(c))
            np.testing.assert_equal(one, other)
            assert np.isnan(one) or np.signbit(one) == np.signbit(other), (a, b, c)


def test_the_nearest_float_is_not_that_of_the_nearest_double() -> None:
    beside = Fraction(1) + Fraction(3, 2**24) - Fraction(1, 2**70)
    assert np.float32(float(beside)) == 1 + 2.0**-22
    assert nearest(beside.numerator, beside.denominator, np.float32) == 1 + 2.0**-23


NUMBERS = [0.0, 1.0, -1.0, 2.0, -0.5, 0.1]


def any_operand(graph: Graph) -> list[tuple[Expression, Fraction]]:
    """Return inputs and numbers, the negatives of some, and their values."""
    x, y = graph.input("x"), graph.input("y")
    inputs = [
        (x, Fraction(3, 7)),
        (-x, Fraction(-3, 7)),
        (y, Fraction(-5, 3)),
        (-y, Fraction(5, 3)),
    ]
    return [*inputs, *((graph.constant(n), Fraction(n)) for n in NUMBERS)]


def exactly(x: Expression) -> Fraction:
    """Return the value of an expression in rational numbers."""
    inputs = {"x": Fraction(3, 7), "y": Fraction(-5, 3)}
    nodes, args = x.graph.nodes, [Expression(x.graph, k) for k in x.node.args]
    values = [exactly(each) for each in args]
    match nodes[x.index].op:
        case "input":
            return inputs[str(x.node.value)]
        case "constant":
            return Fraction(int(x.node.value.p), int(x.node.value.q))
        case "multiply_add":
            one, other = x.node.value
            return Fraction(one) * values[0] * values[1] + Fraction(other) * values[2]
        case "neg":
            return -values[0]
        case op:
            a, b = values
            return Fraction({"add": a + b, "sub": a - b, "mul": a * b}[op])


def test_folding_keeps_the_value() -> None:
    graph = Graph()
    known = any_operand(graph)
    for (a, p), (b, q), (c, r) in product(known, repeat=3):
        found = graph.multiply_add(a, b, c)
        assert exactly(found) == p * q + r
        if found.node.op == "multiply_add":
            assert found.node.value in ((1, 1), (1, -1), (-1, 1))
            assert all(Expression(graph, k).constant not in (0, 1, -1) for k in found.node.args[:2])


def test_what_needs_no_second_rounding_is_a_product_or_a_sum() -> None:
    graph = Graph()
    x, y = graph.input("x"), graph.input("y")
    zero, one = graph.constant(0), graph.constant(1)
    assert graph.multiply_add(x, y, zero) == x * y
    assert graph.multiply_add(x, one, y) == x + y
    assert graph.multiply_add(-one, x, y) == y - x
    assert graph.multiply_add(zero, x, y) == y
    assert graph.multiply_add(x, y, x) == graph.multiply_add(-y, -x, x)
    assert graph.multiply_add(-x, y, -x) == -graph.multiply_add(x, y, x)
    wide = graph.multiply_add(graph.constant((0.0, 1.0)), x, y)
    assert (wide.node.op, wide.node.width) == ("multiply_add", 2)


@pytest.mark.parametrize("scalar", SCALARS)
def test_numbers_known_beforehand_are_rounded_as_they_are_at_run_time(scalar: Scalar) -> None:
    name = "float" if scalar is np.float32 else "double"
    for given in operands(scalar):
        graph = RoundedGraph(name)
        names = dict(zip("abc", (scalar(x) for x in given), strict=True))
        lookup: Callable[[str], Any] = names.__getitem__
        unknown = graph.multiply_add(*(graph.input(key) for key in names))
        known = graph.multiply_add(*(graph.constant(float(x)) for x in names.values()))
        assert unknown.node.op == "multiply_add" and known.constant is not None
        found = Evaluation(graph, lookup, ALGEBRAS[scalar]).of([unknown, known])
        assert found[0] == found[1]


def taken_up(graph: Graph, roots: list[Expression]) -> dict[int, tuple[int, ...]]:
    """Return the operands of what takes up a product, by its index."""
    kept = {x.index for x in roots}
    fused = with_fused(graph.nodes, live_nodes(graph, roots), kept)
    return {k: (*node.args, *node.value) for k, node in fused.items()}


def test_sums_take_up_products_that_nothing_else_needs() -> None:
    graph = Graph()
    a, b, c, d = (graph.input(name) for name in "abcd")
    one, two, three = a * b + c, c - a * d, c * d - b
    assert taken_up(graph, [one, two, three]) == {
        one.index: (a.index, b.index, c.index, 1, 1),
        two.index: (a.index, d.index, c.index, -1, 1),
        three.index: (c.index, d.index, b.index, 1, -1),
    }


def test_products_that_something_else_needs_are_left_alone() -> None:
    graph = Graph()
    a, b, c = (graph.input(name) for name in "abc")
    assert taken_up(graph, [a * b + c, a * b]) == {}
    assert taken_up(graph, [a * b + c, a * b * c]) == {}
    both = [a * b + c, c - a * b]
    assert taken_up(graph, both).keys() == {x.index for x in both}
    wide = graph.input("w[0]", width=4)
    assert taken_up(graph, [a * b + wide]) == {}


def test_of_two_products_a_sum_takes_up_the_one_that_it_waits_for() -> None:
    graph = Graph()
    a, b, late = graph.input("a"), graph.input("b"), graph.input("late", ready=100)
    x = a * b + late * b
    (args,) = taken_up(graph, [x]).values()
    assert args[:2] == tuple(sorted((late.index, b.index)))


def test_a_product_and_a_sum_are_one_instruction() -> None:
    graph = Graph()
    x = graph.multiply_add(graph.input("a"), graph.input("b"), graph.constant(fmpq(1, 3)))
    count = count_operations(graph, [x])
    assert (count.multiply, count.add, count.fused, count.instructions) == (1, 1, 1, 1)
    assert x.node.ready == 4
