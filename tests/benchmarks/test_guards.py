"""A solver without its guards is the same but for what it notices."""

from __future__ import annotations

import pytest

from adagen.emit import stem_of
from adagen.emit.runtime import joined
from adagen.emit.shapes import SHAPES
from benchmarks.guards import unguarded
from tests.emitted import Builder, Solver, plan_of, text_of
from tests.models import serial_chain


@pytest.mark.parametrize("shape", SHAPES)
def test_one_line_is_what_guards_end_in(shape: str) -> None:
    plan = plan_of(serial_chain(3), 1, form="ada" if shape == "joints" else "segment")
    text = joined(text_of(plan, shape=shape))
    pairs = zip(text.splitlines(), unguarded(text).splitlines(), strict=True)
    (changed,) = ((old, new) for old, new in pairs if old != new)
    assert "fail" in changed[0] and "fail" not in changed[1]


def test_without_guards_the_answers_are_the_same(builder: Builder) -> None:
    plan = plan_of(serial_chain(3), 1)
    program = builder.compile(unguarded(text_of(plan)), stem_of(plan))
    done = Solver(program, 1, builder.toolchain).run("--check")
    assert (done.status, done.stderr) == (0, "")


def test_a_source_that_notes_failures_elsewhere_is_refused() -> None:
    with pytest.raises(ValueError, match="another way"):
        unguarded("int main() {}\n")
