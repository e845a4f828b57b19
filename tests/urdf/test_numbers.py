"""The grammar of numbers: what C's strtod reads in decimal, and nothing else."""

from __future__ import annotations

import math
import string

import pytest
from hypothesis import given
from hypothesis import strategies as st

from adagen.urdf.numbers import LARGEST, number, numbers


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1.0), ("-0.5", -0.5), ("+2.5e-3", 0.0025), (".5", 0.5), ("5.", 5.0),
        ("1E3", 1000.0), ("007", 7.0), ("0.1", 0.1), ("0e-999", 0.0), ("-0.0", 0.0),
    ],
)  # fmt: skip
def test_numbers_of_a_urdf(text: str, value: float) -> None:
    assert number(text) == value


@pytest.mark.parametrize(
    "text",
    [
        "", ".", "e5", "1e", "1e+", "--1", "+-1", "1.2.3", "1_0", "0x10", "1f", "1d3", "1,5", "1 2",
        "nan", "-inf", "Infinity", "1e400", "-1e400", "1e-400", "1e41", "\u0661", "\uff11",
        "1\u2009", "\u22121", "$(arg x)", "${x}", "1" * 2000,
    ],
)  # fmt: skip
def test_no_numbers(text: str) -> None:
    with pytest.raises(ValueError):
        number(text)


@given(st.text(alphabet=string.digits + "+-.eE_xnaif\u0660\uff11 ", max_size=12))
def test_whatever_is_accepted_is_spelt_in_ascii_and_is_its_value(text: str) -> None:
    try:
        value = number(text)
    except ValueError:
        return
    assert text.isascii()
    assert set(text) <= set(string.digits + "+-.eE")
    assert math.isfinite(value)
    assert value == float(text)


@given(st.floats(min_value=-LARGEST, max_value=LARGEST, allow_subnormal=False))
def test_every_double_comes_back(value: float) -> None:
    assert number(repr(value)) == value


@given(st.lists(st.floats(-1e9, 1e9), min_size=3, max_size=3), st.sampled_from(" \t\n\r"))
def test_three_numbers_between_white_space(values: list[float], space: str) -> None:
    text = space * 2 + space.join(map(repr, values)) + space
    assert numbers(text, 3) == tuple(values)


@pytest.mark.parametrize("text", ["", "1 2", "1 2 3 4", "1\u00a02\u00a03", "1,2,3"])
def test_no_three_numbers(text: str) -> None:
    with pytest.raises(ValueError):
        numbers(text, 3)


def test_an_expression_in_several_words_is_told_as_one() -> None:
    with pytest.raises(ValueError, match="unexpanded xacro expression"):
        numbers("$(optenv HUSKY_IMU_XYZ 0.19 0 0.149)", 3)
