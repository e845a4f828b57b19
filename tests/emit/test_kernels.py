"""Shape kernels: every way in which segments meet, on robots of all joint kinds."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest

from adagen.cost import programmed
from adagen.emit.shapes import SHAPES
from adagen.model import Model
from adagen.model.kinds import PRISMATIC, SPHERICAL
from adagen.plan import make_plan
from adagen.plan.steps import Join
from adagen.schedule import Topology, load_profile
from adagen.schedule.tree import Named
from adagen.search import best_schedule, named_schedule
from adagen.states import random_states
from adagen.urdf import read_robot
from tests.emitted import ROUNDING, Builder, energy_errors, plan_of
from tests.golden.examples import FOLDER
from tests.links import with_light_link
from tests.models import binary, human_figure, random_tree, serial_chain, star
from tests.schedules import random_schedule
from tests.slow import all_but, spread

PROFILE = load_profile("default")


def floating_tree(seed: int) -> Model:
    return random_tree(np.random.default_rng(seed), 9, branching=0.5, floating=True)


def on_the_ground() -> Model:
    """The shipped humanoid, pelvis held: two joints of its waist are like those of an ankle."""
    return read_robot(FOLDER / "models" / "humanoid.urdf").model


@pytest.mark.parametrize(
    ("model", "name", "processes", "meeting"),
    spread(
        [
            (human_figure(), "sequential", 2, "join"),  # the base itself is joined
            (human_figure(), "balanced", 3, "join"),
            (human_figure(), "balanced", 4, "gather"),
            (on_the_ground(), "balanced", 4, "join"),  # a limb that a handle's force goes through
            (serial_chain(24, axes="xy"), "balanced", 2, "gather"),  # the ground as a body
            (serial_chain(12, kind=SPHERICAL), "balanced", 2, "gather"),  # held by nine freedoms
            (serial_chain(20, kind=PRISMATIC), "balanced", 2, "gather"),
            (serial_chain(24, axes="xyz"), "balanced", 3, "join"),
        ],
        1,
    ),
    ids=[
        "base joined",
        "three joined",
        "four gathered",
        "humanoid",
        "from the ground",
        "by balls from the ground",
        "by slides from the ground",
        "chain joined",
    ],
)
def test_named_schedules_are_solved(
    model: Model, name: Named, processes: int, meeting: str, builder: Builder, tmp_path: Path
) -> None:
    schedule = named_schedule(name, Topology.of(model), processes, profile=PROFILE)
    plan = make_plan(model, schedule, meeting=meeting)
    assert SHAPES["kernels"].why_not(plan) is None
    states = random_states(model, 5, seed=2)
    solver = builder.solver(plan, name="kernels", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < 20 * ROUNDING["double"]


@pytest.mark.parametrize(("seed", "meeting"), spread(product((1, 2, 3), ("gather", "join")), 1))
def test_trees_of_all_kinds_are_solved(
    seed: int, meeting: str, builder: Builder, tmp_path: Path
) -> None:
    model = floating_tree(seed)
    schedule = random_schedule(model, 2, np.random.default_rng(seed))
    plan = make_plan(model, schedule, meeting=meeting)
    states = random_states(model, 4, seed=seed)
    solver = builder.solver(plan, name="tree", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


@pytest.mark.parametrize(
    ("model", "processes"),
    spread(
        [
            (star(4, 3, floating=True), 1),
            (star(5, 4), 1),
            (star(7, 3, floating=True), 1),
            (star(3, 2, kind=SPHERICAL, floating=True), 1),
            (star(3, 2, kind=PRISMATIC), 1),
            (binary(2), 1),
            (binary(4), 1),
            (binary(4, floating=True), 2),
            (human_figure(), 1),
            (human_figure(), 2),
        ],
        3,
    ),
    ids=[
        "legs",
        "arms",
        "seven",
        "three balls",
        "three slides",
        "on the ground",
        "tree",
        "tree by two",
        "figure",
        "figure by two",
    ],
)
def test_limbs_side_by_side_are_solved(
    model: Model, processes: int, builder: Builder, tmp_path: Path
) -> None:
    plan = make_plan(model, best_schedule(model, processes, PROFILE))
    assert any(programmed(plan, "kernels").slots.limbs)
    states = random_states(model, 5, seed=3)
    solver = builder.solver(plan, name="limbs", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


@pytest.mark.parametrize("seed", all_but((1, 2, 3, 4), 1, 3, 4))
def test_bushes_of_all_kinds_are_solved_by_one_process(
    seed: int, builder: Builder, tmp_path: Path
) -> None:
    model = random_tree(np.random.default_rng(seed), 14, branching=0.8, floating=seed % 2 == 0)
    plan = make_plan(model, best_schedule(model, 1, PROFILE))
    states = random_states(model, 4, seed=seed)
    solver = builder.solver(plan, name="bush", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


def test_inverting_among_light_links_keeps_digits(builder: Builder, tmp_path: Path) -> None:
    """Joints beside three links of 1e-7 of the others' mass: all but 1e-3 was lost there once."""
    model = serial_chain(14, axes="xyz")
    steps = (step for p in plan_of(model, 2, meeting="join").processes for step in p.steps)
    at = next(step.joint for step in steps if isinstance(step, Join))
    for link in (at, at + 1, at + 2):
        model = with_light_link(model, link, 1e-7)
    solver = builder.solver(plan_of(model, 2, meeting="join"), shape="kernels")
    states = random_states(model, 3, seed=1)
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-6
