"""Runs of spherical joints in shape kernels: inwards to either end, and among hinges."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.calibrate.samples import by_method
from adagen.model import Model
from adagen.model.kinds import REVOLUTE, SPHERICAL
from adagen.plan import make_plan
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from adagen.states import random_states, write_states
from tests.emitted import ROUNDING, Builder, plan_of, text_of
from tests.models import random_tree, serial_chain
from tests.slow import all_but, slow, spread

PROFILE = load_profile("default")
BY_COLUMNS = by_method(PROFILE, "columns")


def balls_among_hinges() -> Model:
    """A chain with a ball after every three hinges."""
    kinds = [REVOLUTE, REVOLUTE, REVOLUTE, SPHERICAL]
    return random_tree(np.random.default_rng(4), 16, kinds, branching=0, floating=True)


@pytest.mark.parametrize(
    ("model", "sweeps"),
    spread(
        [
            (serial_chain(12, kind=SPHERICAL, floating=True), ("inward<", "inward_reversed<")),
            (
                random_tree(
                    np.random.default_rng(3), 14, [SPHERICAL], branching=0.2, floating=True
                ),
                ("inward<", "inward_reversed<"),
            ),
            (balls_among_hinges(), ("inward_in_columns<", "inward_in_columns_reversed<")),
        ],
        1,
    ),
    ids=["chain", "branches", "among hinges"],
)
@pytest.mark.parametrize("scalar", all_but(["double", "float"], "float"))
def test_runs_are_swept_to_a_root_between_their_ends(
    model: Model, sweeps: tuple[str, ...], scalar: str, builder: Builder, tmp_path: Path
) -> None:
    schedule = named_schedule("balanced", Topology.of(model), 2, profile=PROFILE)
    plan = make_plan(model, schedule, scalar=scalar, meeting="gather")
    text = text_of(plan, shape="kernels", profile=BY_COLUMNS)
    calls = text.partition("void run_0(")[2]
    assert all(sweep in calls for sweep in sweeps)
    solver = builder.solver(plan, name="balls", shape="kernels", profile=BY_COLUMNS)
    states = random_states(model, 4, seed=5)
    assert solver.error(model, states, tmp_path, "--check") < 20 * ROUNDING[scalar]


@pytest.mark.parametrize("processes", [slow(1), 2])
def test_needles_keep_the_digits_that_their_inertia_leaves(
    processes: int, builder: Builder, tmp_path: Path
) -> None:
    """Their inertias' condition is 7e5: errors of 2e-10 by pivots taken one after another, too."""
    model = serial_chain(20, kind=SPHERICAL, mass=1.0, length=1.0, radius=1e-3, floating=True)
    schedule = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="gather")
    solver = builder.solver(plan, name="needles", shape="kernels")
    assert solver.error(model, random_states(model, 6, seed=1), tmp_path) < 1e-9


@pytest.mark.parametrize(
    ("mass", "scalar"),
    [slow(1e-40, "double"), (1e40, "double"), (1e-12, "float"), slow(1e9, "float")],
)
def test_units_do_not_matter(mass: float, scalar: str, builder: Builder, tmp_path: Path) -> None:
    """Pivots are found from fourth powers of inertias in double, of none in float."""
    model = serial_chain(8, kind=SPHERICAL, mass=mass, floating=True)
    states = random_states(model, 3, seed=2)
    states = replace(states, tau=states.tau * mass)
    solver = builder.solver(plan_of(model, 1, scalar=scalar), name="units")
    assert solver.error(model, states, tmp_path) < 5 * ROUNDING[scalar]


@pytest.mark.parametrize("mass", [1e-79, 1e79])
def test_inertias_beyond_the_range_of_numbers_are_refused(
    mass: float, builder: Builder, tmp_path: Path
) -> None:
    model = serial_chain(8, kind=SPHERICAL, mass=mass, floating=True)
    states = random_states(model, 3, seed=2)
    write_states(replace(states, tau=states.tau * mass), model, tmp_path / "s.json")
    solver = builder.solver(plan_of(model, 1), name="range", shape="kernels")
    done = solver.run("--states", tmp_path / "s.json", "--result", tmp_path / "r.json")
    assert (done.status, done.stdout) == (1, "")
    assert "factorization failed" in done.stderr
