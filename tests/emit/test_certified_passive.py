"""Bounds of robots whose torques balance strong dampers, springs and friction."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.build import Toolchain
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL, JointKind, Model
from adagen.states import random_states
from benchmarks.stability.balanced import balanced
from benchmarks.stability.bounds import Certified, bounded
from benchmarks.stability.mechanisms import worst_states
from tests.emitted import Builder
from tests.mechanisms import looped_tree
from tests.models import random_tree, serial_chain, star
from tests.slow import spread

ALL = 1000  # rows: more than there are


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


def _tree(seed: int, *kinds: JointKind, floating: bool = False) -> Model:
    return random_tree(np.random.default_rng(seed), 8, kinds=kinds, floating=floating)


HINGES, SLIDES = _tree(3, REVOLUTE), _tree(4, REVOLUTE, PRISMATIC, floating=True)
BALLS, ARMS, CHAIN = _tree(5, REVOLUTE, SPHERICAL), star(5, 3, floating=True), serial_chain(40)
LINE, LOOPS = Certified("unrolled"), Certified("kernels")
IN_LOOP, SOME_IN_LOOP = Certified("unrolled", looped=ALL), Certified("unrolled", looped=3)
CASES = {
    "hinges in loops": (HINGES, LOOPS),
    "hinges in a batch of loops": (HINGES, Certified("kernels", batch=True)),
    "balls in loops": (BALLS, LOOPS),
    "slides in a line": (SLIDES, LINE),
    "balls in a line": (BALLS, LINE),
    "slides in loops": (SLIDES, LOOPS),
    "slides in a line with a loop": (SLIDES, IN_LOOP),
    "arms in a line with a loop": (ARMS, IN_LOOP),
    "arms on two processes": (ARMS, Certified("kernels", processes=2)),
    "a chain in parts": (CHAIN, Certified("kernels", parts=True)),
    "a chain in loops": (CHAIN, LOOPS),
    "some slides in a loop": (SLIDES, SOME_IN_LOOP),
    "arms in lines of two processes": (ARMS, Certified("unrolled", processes=2)),
    "hinges in a batch of lines": (HINGES, Certified("unrolled", batch=True)),
}


@pytest.mark.parametrize("name", spread(CASES, 4))
def test_bounds_hold_what_passive_forces_take(name: str, quick: Toolchain) -> None:
    model, way = CASES[name]
    robot, states = balanced(model, random_states(model, 15, seed=2), 1e5, seed=2)
    found = bounded(robot, states, [way], quick)[way]
    assert found.refused == 0 and found.errors.max() > 1e-12
    assert (found.ratios <= 1).all() and np.isfinite(found.bounds).all()


@pytest.mark.parametrize("kind", spread(("revolute", "spherical", "universal"), 1))
def test_so_do_those_of_closed_loops(kind: str, quick: Toolchain) -> None:
    model = looped_tree(kind, 1, joints=9, kinds=(REVOLUTE, PRISMATIC))
    robot, states = balanced(model, worst_states(model, 10, seed=4), 1e5, seed=2)
    ways = bounded(robot, states, [LINE, IN_LOOP], quick)
    assert set(ways) == {LINE, IN_LOOP}
    for way, found in ways.items():
        assert found.refused < 10 and found.errors.max() > 1e-12, way
        assert (found.ratios <= 1).all(), way
