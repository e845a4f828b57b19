"""Bounds that loops tell of chains in parts: beside true errors, whole chains and the executor."""

from __future__ import annotations

import shutil
from dataclasses import replace

import numpy as np
import pytest

from adagen.build import Toolchain
from adagen.build.toolchain import STANDARD, WARNINGS
from adagen.executor.solve import interpret
from adagen.model import Model
from adagen.states import random_states
from adagen.studies.random_states import hard_states
from benchmarks.stability.adversary import long_chains, robots
from benchmarks.stability.bounds import Certified, bounded, certified_plan
from tests.emit.test_parts import driven, graded
from tests.emitted import HALVED, NARROW, OPTIMISED, Builder, kernels_of
from tests.executor.test_certificate import _squares
from tests.long_doubles import LongDoubles
from tests.models import serial_chain
from tests.plan.test_parts import hinges
from tests.slow import slow

WHOLE = Certified("kernels")
PARTS = replace(WHOLE, parts=True)
LINE = Certified("unrolled", parts=True)
IN_FLOAT = Certified("kernels", scalar="float", parts=True)


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


def test_lines_of_a_certified_chain() -> None:
    text = kernels_of(certified_plan(hinges(24, seed=1), parts=True))
    assert "const MovedParts moved_0 = accelerate_weighed_in_parts<0, 23>(w, started_0);" in text
    assert "weigh_parts<0, 23>(w, swept_0, shown_0, forces_0, started_0, moved_0);" in text


@pytest.mark.parametrize(
    ("model", "ways"),
    [
        slow(driven(hinges(33, seed=2)), [WHOLE, PARTS, LINE]),
        (hinges(34, seed=3), [WHOLE, PARTS, IN_FLOAT]),
        slow(hinges(50, seed=3), [WHOLE, PARTS, IN_FLOAT]),
        slow(graded(serial_chain(41), 1e5), [WHOLE, PARTS]),
        slow(graded(serial_chain(39), 1e-5), [WHOLE, PARTS]),
        slow(hinges(200, seed=4), [WHOLE, PARTS]),
    ],
    ids=["driven", "random", "more", "heavy outwards", "light outwards", "long"],
)
def test_bounds_hold_and_are_of_use(model: Model, ways: list[Certified], quick: Toolchain) -> None:
    found = bounded(model, hard_states(model, 12, seed=1), ways, quick)
    assert set(found) == set(ways)
    whole = found.pop(WHOLE)
    for way, one in found.items():
        assert one.refused == 0
        assert (one.ratios <= 1).all(), f"{way}: {one.ratios.max()}"
        if way.scalar == "double":
            assert np.median(one.bounds / (one.errors + whole.bounds)) < 100


@pytest.mark.slow
@pytest.mark.parametrize("k", range(6))
def test_hard_chains_keep_their_bounds(k: int, quick: Toolchain) -> None:
    model = robots(k + 1, seed=12, families=[long_chains])[k]
    found = bounded(model, hard_states(model, 20, seed=3), [PARTS, LINE], quick)
    assert LINE in found  # loops sweep slender links in their own axes, and then no parts
    for way, one in found.items():
        assert (one.ratios <= 1).all(), f"{way}: {one.ratios.max()}"


@pytest.mark.parametrize("joints", [27, slow(24), slow(64)])
def test_loops_tell_the_bound_of_the_executor(joints: int, quick: Toolchain) -> None:
    """Axes differ, and so do last digits, of which bounds are made."""
    model = driven(hinges(joints, seed=joints))
    states = random_states(model, 6, seed=2)
    one = bounded(model, states, [PARTS], quick)[PARTS]
    squares = [_squares(certified_plan(model, parts=True), state)[1:] for state in states.each]
    known = [np.sqrt(error / answer) for error, answer in squares]
    assert np.median(one.bounds / known) == pytest.approx(1, rel=0.5)
    assert (one.bounds / known < 4).all() and (known / one.bounds < 4).all()


@pytest.mark.parametrize(
    ("compiler", "flags"),
    [
        ("g++", HALVED),
        slow("g++", OPTIMISED),
        slow("g++", NARROW),
        slow("clang++", OPTIMISED),
        slow("clang++", NARROW),
    ],
)
def test_bounds_of_other_compilers(compiler: str, flags: tuple[str, ...], builder: Builder) -> None:
    """Without warnings, too."""
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    model = driven(hinges(28, seed=5))
    other = builder.with_compiler(compiler).toolchain
    toolchain = replace(other, flags=(*STANDARD, *WARNINGS, "-Werror", *flags))
    one = bounded(model, random_states(model, 4, seed=2), [PARTS], toolchain)[PARTS]
    assert (one.ratios <= 1).all() and one.bounds.max() < 1e-12


@pytest.mark.slow
def test_a_chain_of_a_thousand_joints(quick: Toolchain) -> None:
    """Beside the answers of the whole chain in long doubles: exact ones would take minutes."""
    model = hinges(1000, seed=6)
    states = random_states(model, 6, seed=3)
    whole, more = certified_plan(model), LongDoubles()
    truth = [interpret(whole, *state, more) for state in states.each]
    found = bounded(model, states, [WHOLE, PARTS], quick, truth)
    for one in found.values():
        assert one.refused == 0
        assert (one.ratios <= 1).all() and one.bounds.max() < 1e-11
