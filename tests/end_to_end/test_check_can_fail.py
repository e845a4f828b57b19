"""The self-check of an emitted program finds what is wrong with its solver."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from adagen.emit.runtime import joined
from tests.emitted import Builder, Solver
from tests.slow import all_but

EXAMPLES = Path(__file__).resolve().parents[2] / "generated_examples"

SPOILT = {
    "a slaved joint follows with another multiplier": (
        "arm7_slaved_p2",
        r"(coupling_row\(rows\[0\], [^;]*, )(-?[\d.e+-]+)\);",
        r"\g<1>0.75);",
    ),
    "a torque is taken for its opposite": (
        "arm7_p1",
        r"const Value& tau = w\.tau\[",
        "const Value tau = -w.tau[",
    ),
    "a velocity product is left out": (
        "arm7_p1",
        r"at\.alpha \+= turn_with\(axis",
        "turn_with(axis",
    ),
    "a link is a thousandth too heavy for the sweep": (
        "arm7_p1",
        r"bias_force\(J, c, wide\(constants\.mass\)",
        "bias_force(J, c, Real(1.001) * wide(constants.mass)",
    ),
}


@pytest.mark.parametrize("wrong", all_but(SPOILT, "a slaved joint follows with another multiplier"))
def test_a_spoilt_solver_is_found_out(wrong: str, builder: Builder) -> None:
    stem, pattern, replacement = SPOILT[wrong]
    text = joined((EXAMPLES / stem / f"{stem}.cpp").read_text())
    spoilt, count = re.subn(pattern, replacement, text, count=1)
    assert count == 1
    processes = int(stem[-1])
    program = builder.compile(spoilt, stem)
    done = Solver(program, processes, builder.toolchain).run("--check")
    assert done.status == 1
    assert "WRONG" in done.stdout
