"""Bounds that emitted solvers tell beside true errors, in hard states of random robots."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.build import Toolchain
from adagen.executor import certificate
from adagen.executor.run import lines_of
from adagen.model import PRISMATIC, REVOLUTE, SPHERICAL
from adagen.states import States
from adagen.studies.random_states import hard_states
from adagen.urdf import read_robot
from benchmarks.stability.adversary import FAMILIES, arms, robots
from benchmarks.stability.bounds import FACTOR, Bounded, Certified, bounded
from tests.emitted import Builder
from tests.golden.make_models import MODELS
from tests.models import random_tree, serial_chain
from tests.real import real_robot
from tests.slow import slow, spread

LOOPS, LINE = Certified("kernels"), Certified("unrolled")
WAYS = [LOOPS, LINE, Certified("kernels", batch=True), Certified("unrolled", batch=True)]
IN_FLOAT = [Certified("kernels", scalar="float"), Certified("unrolled", scalar="float")]


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


def _hold(found: dict[Certified, Bounded]) -> None:
    for way, one in found.items():
        assert (one.ratios <= FACTOR).all(), f"{way}: {one.ratios.max()}"


@pytest.mark.parametrize("k", spread(range(len(FAMILIES)), 3), ids=lambda k: FAMILIES[k].__name__)
def test_no_bound_is_exceeded_by_more_than_three(k: int, quick: Toolchain) -> None:
    model = robots(k + 1, seed=8)[k]
    way = WAYS[k % len(WAYS)]
    found = bounded(model, hard_states(model, 40, seed=8), [LINE, way], quick)
    assert LINE in found
    assert found[LINE].errors.size + found[LINE].refused == 40
    _hold(found)


@pytest.mark.parametrize(
    ("name", "ways"),
    [
        slow("chain16", WAYS),
        slow("humanoid", WAYS[:2]),
        slow("human40", WAYS[:1]),
        ("mobile", WAYS),
    ],
)
def test_bounds_of_ordinary_robots_are_small_in_every_shape(
    name: str, ways: list[Certified], quick: Toolchain
) -> None:
    model = read_robot(MODELS / f"{name}.urdf").model
    found = bounded(model, hard_states(model, 11, seed=1), ways, quick)
    assert set(found) == set(ways)
    _hold(found)
    for one in found.values():
        assert one.refused == 0
        assert np.median(one.bounds) < 1e-12


@pytest.mark.parametrize(
    "name", [slow("go1_description/urdf/go1.urdf"), "ur_description/urdf/ur5_robot.urdf"]
)
def test_bounds_of_real_robots(name: str, quick: Toolchain) -> None:
    model = read_robot(real_robot(name), floating=True).model
    found = bounded(model, hard_states(model, 11, seed=2), [LOOPS, LINE, *IN_FLOAT], quick)
    assert {LOOPS, LINE} <= set(found)
    _hold(found)


def test_there_is_something_to_be_bounded(
    quick: Toolchain, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without its allowance for rounding the certificate would not hold: the tests can fail."""
    model = robots(10, seed=8)[9]
    states = hard_states(model, 40, seed=8)
    kept = bounded(model, states, [LINE], quick)[LINE]
    monkeypatch.setattr(certificate, "ROUNDING", 1e-9)
    lines_of.cache_clear()
    bare = bounded(model, states, [LINE], quick)[LINE]
    lines_of.cache_clear()
    assert (kept.ratios <= FACTOR).all()
    assert (bare.ratios > FACTOR).any()


@pytest.mark.parametrize(
    ("way", "k"), [(replace(LOOPS, processes=2), 19), slow(replace(LINE, processes=3), 7)]
)
def test_bounds_of_processes_that_share_a_robot(way: Certified, k: int, quick: Toolchain) -> None:
    model = robots(k + 1, seed=104)[k]
    assert FAMILIES[k % len(FAMILIES)].__name__ == "trees"
    found = bounded(model, hard_states(model, 40, seed=8), [way], quick)
    assert found[way].errors.size == 40
    assert np.median(found[way].bounds) < 1e-12
    _hold(found)


@pytest.mark.parametrize(
    ("way", "k"),
    [
        (Certified("kernels", batch=True, processes=2), 4),
        slow(Certified("unrolled", batch=True, processes=3), 1),
        slow(Certified("kernels", batch=True, scalar="float", processes=3), 7),
    ],
)
def test_bounds_of_states_that_are_handed_out(way: Certified, k: int, quick: Toolchain) -> None:
    model = robots(k + 1, seed=8)[k]
    found = bounded(model, hard_states(model, 300, seed=8), [way], quick)
    assert found[way].errors.size + found[way].refused == 300
    assert found[way].errors.size > 200
    assert np.isfinite(found[way].bounds).mean() > 0.5
    _hold(found)


ELSEWHERE = [
    Certified(shape, processes=2, elsewhere=True, scalar=scalar)
    for shape in ("kernels", "unrolled")
    for scalar in ("double", "float")
]


@pytest.mark.parametrize(
    ("k", "ways"), [(4, ELSEWHERE[::3]), slow(4, ELSEWHERE[1:3]), slow(6, ELSEWHERE)]
)
def test_bounds_of_processes_that_gather_elsewhere(
    k: int, ways: list[Certified], quick: Toolchain
) -> None:
    """Arms that the ground holds beyond where processes gather; many in singular poses."""
    model = robots(k + 1, 1, [arms])[k]
    found = bounded(model, hard_states(model, 100, seed=8), ways, quick)
    assert set(found) == set(ways)
    for way, one in found.items():
        if way.scalar == "double":
            assert one.errors.size >= 90
            assert np.isfinite(one.bounds).mean() > 0.95
    _hold(found)


@pytest.mark.slow
def test_bounds_of_floating_robots_that_gather_beyond_their_base(quick: Toolchain) -> None:
    kinds = (REVOLUTE, PRISMATIC, SPHERICAL)
    model = random_tree(np.random.default_rng(5), 14, floating=True, kinds=kinds)
    found = bounded(model, hard_states(model, 40, seed=3), ELSEWHERE, quick)
    assert set(found) == set(ELSEWHERE)
    for way, one in found.items():
        assert one.errors.size == 40
        assert np.median(one.bounds) < (1e-12 if way.scalar == "double" else 1e-3)
    _hold(found)


@pytest.mark.parametrize("way", [slow(ELSEWHERE[0]), ELSEWHERE[2]], ids=["kernels", "unrolled"])
def test_a_pose_in_which_the_ground_holds_no_link_has_a_bound(
    way: Certified, quick: Toolchain
) -> None:
    """A straight arm is solved without an inverse of a mobility."""
    model, still = serial_chain(14), np.zeros((3, 14))
    states = States(still, still.copy(), np.ones((3, 14)))
    (one,) = bounded(model, states, [way], quick).values()
    assert (one.bounds < 1e-10).all()
    _hold({way: one})


def test_no_bound_is_found_with_factors_of_no_digits(quick: Toolchain) -> None:
    """Ball joints with slender links, as loops in float: see seen_by in kernels/certify.hpp."""
    model, way = robots(22, seed=104)[21], IN_FLOAT[0]
    found = bounded(model, hard_states(model, 400, seed=104), [way], quick)
    assert found[way].errors.max() > 0.1
    _hold(found)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10, 13))
def test_no_bound_is_exceeded_on_many(seed: int, quick: Toolchain) -> None:
    for model in robots(2 * len(FAMILIES), seed):
        _hold(bounded(model, hard_states(model, 60, seed), [*WAYS, *IN_FLOAT], quick))
