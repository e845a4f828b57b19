"""Expression graphs: what is folded, shared and left alone; values never change."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from adagen.graph import Expression, Graph, count_operations
from tests.graph.evaluate import evaluate

NAMES = ("a", "b", "c")
# Numbers that meet, cancel and are one; and one that is tiny, but not nothing.
NUMBERS = st.sampled_from([0.0, 1.0, -1.0, 2.0, -0.5, 0.1, 4.9e-12, 3.0])
Formula = tuple[Any, ...]
FORMULAS: st.SearchStrategy[Formula] = st.recursive(
    st.one_of(
        st.tuples(st.just("input"), st.sampled_from(NAMES)),
        st.tuples(st.just("number"), NUMBERS),
    ),
    lambda inner: st.one_of(
        st.tuples(st.sampled_from(["+", "-", "*"]), inner, inner),
        st.tuples(st.sampled_from(["neg", "1/"]), inner),
    ),
    max_leaves=25,
)


def built(formula: Formula, graph: Graph) -> Expression:
    """Return a formula as an expression."""
    match formula:
        case ("input", name):
            return graph.input(name)
        case ("number", value):
            return graph.constant(value)
        case ("neg", x):
            return -built(x, graph)
        case ("1/", x):
            return graph.reciprocal(built(x, graph))
    op, x, y = formula
    left, right = built(x, graph), built(y, graph)
    return {"+": left + right, "-": left - right, "*": left * right}[op]


def valued(formula: Formula, inputs: dict[str, Any], number: Any) -> Any:
    """Return a formula's value as it stands, in the arithmetic of the inputs."""
    match formula:
        case ("input", name):
            return inputs[name]
        case ("number", value):
            return number(value)
        case ("neg", x):
            return -valued(x, inputs, number)
        case ("1/", x):
            return 1 / valued(x, inputs, number)
    op, x, y = formula
    left, right = valued(x, inputs, number), valued(y, inputs, number)
    return {"+": lambda: left + right, "-": lambda: left - right, "*": lambda: left * right}[op]()


def fraction(value: Any) -> Fraction:
    return Fraction(int(value.p), int(value.q))


@given(FORMULAS, st.lists(st.fractions(-3, 3, max_denominator=50), min_size=3, max_size=3))
def test_folding_keeps_the_value_exactly(formula: Formula, given_values: list[Fraction]) -> None:
    inputs = dict(zip(NAMES, given_values, strict=True))
    try:
        expected = valued(formula, inputs, Fraction)
    except ZeroDivisionError:
        return
    assert evaluate([built(formula, Graph())], inputs, fraction) == [expected]


@given(FORMULAS, st.lists(st.floats(-3, 3), min_size=3, max_size=3))
def test_without_constants_to_fold_not_a_bit_changes(
    formula: Formula, given_values: list[float]
) -> None:
    inputs = dict(zip(NAMES, given_values, strict=True))
    plain = without_numbers(formula)
    try:
        expected = valued(plain, inputs, float)
        (found,) = evaluate([built(plain, Graph())], inputs, lambda x: float(fraction(x)))
    except ZeroDivisionError:
        return
    # a - a is nothing for finite numbers only: what overflows on the way is left out.
    assert found == expected or not abs(expected) <= 1e300


def without_numbers(formula: Formula) -> Formula:
    """Return a formula with an input for each number."""
    if formula[0] == "number":
        return ("input", NAMES[0])
    return tuple(without_numbers(x) if isinstance(x, tuple) else x for x in formula)


@given(FORMULAS)
def test_building_twice_adds_nothing(formula: Formula) -> None:
    graph = Graph()
    first = built(formula, graph)
    count = len(graph.nodes)
    assert built(formula, graph) == first
    assert len(graph.nodes) == count


@given(FORMULAS)
def test_operands_come_before_what_uses_them(formula: Formula) -> None:
    graph = Graph()
    built(formula, graph)
    for index, node in enumerate(graph.nodes):
        assert all(k < index for k in node.args)
        assert all(graph.nodes[k].ready < node.ready or node.op == "neg" for k in node.args)


class TestIdentities:
    @pytest.fixture
    def graph(self) -> Graph:
        return Graph()

    def test_nothing_is_left_of_what_is_structurally_zero(self, graph: Graph) -> None:
        a, b = graph.input("a"), graph.input("b")
        zero = graph.constant(0.0)
        for nothing in (a * zero, a - a, zero * (a + b), -zero, (a + b) - (b + a)):
            assert nothing.constant == 0
        for same in (a + 0, a - 0, 1 * a, graph.neg(-a), (-1.0) * (-a), a - zero * b):
            assert same == a

    def test_what_is_merely_tiny_stays(self, graph: Graph) -> None:
        a = graph.input("a")
        assert (a * 4.9e-12).constant is None
        assert (a + 5e-324) != a
        assert graph.constant(0.1) + graph.constant(0.2) - graph.constant(0.3) != graph.constant(0)

    def test_constants_are_rounded_once(self, graph: Graph) -> None:
        third = graph.reciprocal(graph.constant(3))
        assert (third * 3).constant == 1
        assert (graph.constant(0.1) * graph.constant(10)).constant == fmpq(
            *(0.1).as_integer_ratio()
        ) * 10

    def test_constants_do_not_grow_without_end(self, graph: Graph) -> None:
        x = graph.constant(0.1)
        for _ in range(12):
            x = x * x
        assert int(x.constant.q).bit_length() < 60_000
        exact = Fraction(0.1) ** 4096
        assert abs(fraction(x.constant) / exact - 1) < Fraction(1, 2**230)

    def test_one_by_zero_is_left_to_whoever_evaluates(self, graph: Graph) -> None:
        assert graph.reciprocal(graph.constant(0)).constant is None

    def test_signs_leave_products_and_meet_sums(self, graph: Graph) -> None:
        a, b, c = (graph.input(name) for name in NAMES)
        count = count_operations(graph, [c + (-a) * b, c - a * (-b), (-2.0 * a) * b - c])
        assert count.negate <= 1
        assert (-a) * b == -(a * b)
        assert a - b == -(b - a)


def test_operations_are_counted() -> None:
    graph = Graph()
    a, b, c = (graph.input(name) for name in NAMES)
    product = a * b
    unused = a + c
    count = count_operations(graph, [product + c, graph.reciprocal(product - c), c * c + a])
    assert (count.multiply, count.add, count.divide, count.negate) == (2, 3, 1, 0)
    assert count.fused == 1  # c c is used once, a b twice
    assert count.ready == 4 + 4 + 14
    assert unused.index not in [root.index for root in (a, b, c)]


def test_a_difference_the_other_way_round_is_the_negative_of_what_is_known() -> None:
    graph = Graph()
    a, b = graph.input("a"), graph.input("b")
    difference = a - b
    assert (b - a).negated == difference
