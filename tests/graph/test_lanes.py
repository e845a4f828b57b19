"""Wide expressions: each lane is what it would be by itself."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from adagen.graph import Expression, Graph, count_operations
from tests.graph.evaluate import evaluate

WIDTH = 4
NAMES = ("a", "b")
NUMBERS = st.sampled_from([0.0, 1.0, -1.0, 2.0, -0.5])
LANES = st.tuples(*[NUMBERS] * WIDTH)
Formula = tuple[Any, ...]
FORMULAS: st.SearchStrategy[Formula] = st.recursive(
    st.one_of(
        st.tuples(st.just("single"), st.sampled_from(NAMES)),
        st.tuples(st.just("wide"), st.sampled_from(NAMES)),
        st.tuples(st.just("packed"), st.tuples(*[st.sampled_from(NAMES)] * WIDTH)),
        st.tuples(st.just("numbers"), LANES),
    ),
    lambda inner: st.one_of(
        st.tuples(st.sampled_from(["+", "-", "*"]), inner, inner),
        st.tuples(st.just("neg"), inner),
        st.tuples(st.just("1/"), st.tuples(st.just("numbers"), LANES)),
        st.tuples(st.just("turned"), inner),
        st.tuples(st.just("across"), st.integers(1, WIDTH), inner),
    ),
    max_leaves=12,
)
INPUTS = {
    **{name: Fraction(3 + k, 7) for k, name in enumerate(NAMES)},
    **{
        f"{name}[{k}]": Fraction(2 * k - 3, 5 + j) for j, name in enumerate(NAMES) for k in range(4)
    },
}


def built(formula: Formula, graph: Graph) -> Expression:
    """Return a formula as an expression."""
    match formula:
        case ("single", name):
            return graph.input(name)
        case ("wide", name):
            return graph.input(f"{name}[0]", width=WIDTH)
        case ("packed", names):
            return graph.pack([graph.input(name) for name in names])
        case ("numbers", values):
            return graph.constant(values)
        case ("neg", x):
            return -built(x, graph)
        case ("1/", x):
            return graph.reciprocal(built(x, graph))
        case ("turned", x):  # lanes in another order
            inner = built(x, graph)
            return graph.pack([graph.lane(inner, (k + 1) % WIDTH) for k in range(WIDTH)])
        case ("across", count, x):
            return graph.across(built(x, graph), count)
    op, x, y = formula
    left, right = built(x, graph), built(y, graph)
    return {"+": left + right, "-": left - right, "*": left * right}[op]


def valued(formula: Formula) -> tuple[Fraction, ...]:
    """Return a formula's lanes as they stand."""
    match formula:
        case ("single", name):
            return (INPUTS[name],) * WIDTH
        case ("wide", name):
            return tuple(INPUTS[f"{name}[{k}]"] for k in range(WIDTH))
        case ("packed", names):
            return tuple(INPUTS[name] for name in names)
        case ("numbers", values):
            return tuple(map(Fraction, values))
        case ("neg", x):
            return tuple(-value for value in valued(x))
        case ("1/", x):
            return tuple(1 / value for value in valued(x))
        case ("turned", x):
            inner = valued(x)
            return (*inner[1:], inner[0])
        case ("across", count, x):
            return (sum(valued(x)[:count], start=Fraction(0)),) * WIDTH
    op, x, y = formula
    pairs = zip(valued(x), valued(y), strict=True)
    return tuple({"+": a + b, "-": a - b, "*": a * b}[op] for a, b in pairs)


def exactly(value: Any) -> Fraction:
    return Fraction(int(value.p), int(value.q))


@given(FORMULAS)
def test_folding_changes_no_lane(formula: Formula) -> None:
    try:
        expected = valued(formula)
    except ZeroDivisionError:
        return
    (found,) = evaluate([built(formula, Graph())], INPUTS, exactly)
    assert (found if isinstance(found, tuple) else (found,) * WIDTH) == expected


def test_what_all_lanes_have_in_common_is_a_single_number() -> None:
    graph = Graph()
    x = graph.input("x[0]", width=WIDTH)
    assert graph.constant((2.0, 2.0)) == graph.constant(2.0)
    signs = graph.constant((1.0, -1.0, 1.0, -1.0))
    assert (signs * signs).constant == 1
    assert x + graph.constant((0.0, 0.0, 0.0, 0.0)) == x
    assert (x * signs).node.op == "mul"
    assert x * -signs == -(x * signs)


def test_numbers_put_into_lanes_come_out_again() -> None:
    graph = Graph()
    numbers = [graph.input(name) for name in "abcd"]
    wide = graph.pack(numbers)
    assert [graph.lane(wide, k) for k in range(4)] == numbers
    assert graph.pack([graph.lane(wide * wide, k) for k in range(4)]) == wide * wide
    assert graph.pack([-x for x in numbers]) == -wide
    assert graph.pack([numbers[0]] * 4) == numbers[0]


def test_inputs_of_one_name_and_two_widths_are_two() -> None:
    graph = Graph()
    assert graph.input("q[0]", width=2) != graph.input("q[0]")


def test_a_wide_operation_counts_once() -> None:
    graph = Graph()
    x = graph.pack([graph.input(name) for name in "abcd"])
    count = count_operations(graph, [graph.across(x * x + graph.constant(1), 3)])
    assert (count.multiply, count.add, count.wide, count.moves) == (1, 1, 2, 4 + 3)
    assert graph.constant((0.5, fmpq(1, 3))).node.width == 2
