"""Shape kernels: chains that are swept tile by tile, and constants that stand once."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import program_of
from adagen.executor import interpret
from adagen.model import REVOLUTE, Model
from adagen.plan.certificate import certified
from adagen.program import tiles
from adagen.program.tiles import TILE
from adagen.reference import joint_space_inertia
from adagen.schedule import step_costs
from adagen.schedule.caches import swept_whole
from adagen.states import random_states
from tests.emitted import NARROW, QUICK, Builder, kernels_of, plan_of
from tests.models import random_tree, serial_chain


@pytest.fixture
def soon(monkeypatch: pytest.MonkeyPatch) -> None:
    """Chains are swept tile by tile as soon as there are two tiles."""
    monkeypatch.setattr(tiles, "swept_whole", lambda _: TILE)


LONGEST = swept_whole(step_costs(None))


def drawn(joints: int, seed: int) -> Model:
    return random_tree(np.random.default_rng(seed), joints, kinds=[REVOLUTE], branching=0.0)


def test_long_chains_are_swept_tile_by_tile() -> None:
    long, short = (plan_of(serial_chain(n), 1) for n in (LONGEST + 1, LONGEST))
    assert program_of(long, "kernels").slots.tile == TILE
    assert program_of(short, "kernels").slots.tile == 0
    text = kernels_of(long)
    assert "sweep_tiles<" in text
    assert "sweep_tiles<" not in kernels_of(short)


@pytest.mark.usefixtures("soon")
def test_what_needs_all_joints_again_is_swept_as_a_whole() -> None:
    model = drawn(2 * TILE, 1)
    plan = plan_of(model, 1)
    assert program_of(plan, "kernels").slots.tile == TILE
    for other in (
        certified(plan),
        plan_of(replace(model, wanted=(3,)), 1),
        plan_of(replace(model, at_rest=True), 1),
    ):
        assert program_of(other, "kernels").slots.tile == 0


def test_code_does_not_grow_with_a_chain() -> None:
    bodies = []
    for joints in (LONGEST + 500, LONGEST + 1000):
        text = kernels_of(plan_of(serial_chain(joints), 1))
        lines = text.split("// ---- processes")[1].splitlines()
        bodies.append(len(lines))
    assert bodies[0] == bodies[1]


def test_constants_of_links_that_are_alike_stand_once() -> None:
    alike = kernels_of(plan_of(serial_chain(600), 1))
    kinds = re.search(r"kBlockKindCount = (\d+);", alike)
    assert kinds is not None
    assert 0 < int(kinds[1]) < 20
    assert "kBlockKindCount" not in kernels_of(plan_of(drawn(300, 1), 1))


@pytest.mark.usefixtures("soon")
@pytest.mark.parametrize(
    ("scalar", "joints", "flags"),
    [
        ("double", 2 * TILE + 1, NARROW),
        ("float", 3 * TILE, QUICK),
        pytest.param("double", 3 * TILE, QUICK, marks=pytest.mark.slow),
        pytest.param("float", 2 * TILE + 1, QUICK, marks=pytest.mark.slow),
        pytest.param("float", 3 * TILE, NARROW, marks=pytest.mark.slow),
        pytest.param("double", 2 * TILE + 1, QUICK, marks=pytest.mark.slow),
        pytest.param("double", 3 * TILE, NARROW, marks=pytest.mark.slow),
        pytest.param("float", 2 * TILE + 1, NARROW, marks=pytest.mark.slow),
    ],
)
def test_tiles_answer_as_other_algorithms_do(
    joints: int, scalar: str, flags: tuple[str, ...], builder: Builder, tmp_path: Path
) -> None:
    model = drawn(joints, joints)
    plan = plan_of(model, 1, scalar=scalar)
    assert "sweep_tiles<" in kernels_of(plan)
    solver = builder.solver(plan, flags, name="tiles", shape="kernels")
    judged = solver.run("--check", "--seed", "2")  # by inverse dynamics of its own
    assert judged.status == 0, judged.stderr
    if scalar == "double":
        states = random_states(model, 2, seed=1)
        found = solver.solve(model, states, tmp_path)
        for (q, v, tau), qdd in zip(states.each, found, strict=True):
            inertia = joint_space_inertia(model, q)
            apart, size = (
                np.sqrt(x @ inertia @ x) for x in (qdd - interpret(plan, q, v, tau), qdd)
            )
            assert apart <= 1e-10 * size
