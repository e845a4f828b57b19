"""Numbers as C++ text."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from adagen.emit.expressions import Printer


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_double_reads_back_as_it_was(value: float) -> None:
    assert float(Printer("double").number(value)) == value


@given(st.floats(width=32, allow_nan=False, allow_infinity=False))
def test_a_float_reads_back_as_it_was(value: float) -> None:
    assert np.float32(Printer("float").number(value).removesuffix("f")) == np.float32(value)


@pytest.mark.parametrize("value", [-5.5e-53, 2.0**-150, -0.0])
def test_what_no_float_holds_is_written_as_zero(value: float) -> None:
    """Compilers warn of a literal that becomes zero."""
    assert Printer("float").number(value) == "0.0f"
