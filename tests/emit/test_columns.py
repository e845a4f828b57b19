"""Shape kernels: runs of joints taken inwards by columns."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from adagen.calibrate.samples import by_method
from adagen.cost import programmed
from adagen.model import Inertia, Model
from adagen.model.kinds import PRISMATIC, REVOLUTE, SPHERICAL
from adagen.plan import make_plan
from adagen.schedule import load_profile
from adagen.states import random_states
from tests.cost.costs import step_profile
from tests.emitted import NARROW, OPTIMISED, QUICK, ROUNDING, Builder, kernels_of, plan_of, text_of
from tests.links import with_inertia
from tests.models import ALL_KINDS, random_tree, serial_chain
from tests.schedules import random_schedule
from tests.slow import slow

BY_COLUMNS = by_method(load_profile("default"), "columns")
MANY_HINGES = (*ALL_KINDS, REVOLUTE, REVOLUTE, PRISMATIC, PRISMATIC)


def chain_of_all_kinds(seed: int, n: int, floating: bool = False) -> Model:
    return random_tree(
        np.random.default_rng(seed), n, MANY_HINGES, branching=0.0, floating=floating
    )


def tree(seed: int) -> Model:
    return random_tree(np.random.default_rng(seed), 12, MANY_HINGES, branching=0.15)


def test_runs_of_hinges_are_taken_by_columns_where_that_is_cheaper() -> None:
    assert "columns<" not in kernels_of(plan_of(serial_chain(8, kind=SPHERICAL), 1))
    assert "inward_in_columns<0, 0, 5, true>(w);" in kernels_of(plan_of(serial_chain(6), 1))
    for joints, run in ((3, 0.0), (3, 1.0), (30, 1.0)):
        profile = step_profile(
            articulate__revolute=0.2,
            articulate_columns__revolute=0.1,
            articulate_columns__run=run,
        )
        program = programmed(plan_of(serial_chain(joints), 1), "kernels", profile)
        methods = {o.method for o in program.processes[0].operations if o.does == "articulate"}
        assert methods == {"columns" if run < 0.1 * joints else "each"}


def test_links_are_told_by_columns_once() -> None:
    # The ground's side is held by the first joints, whose slots lie among those of the others.
    text = kernels_of(plan_of(serial_chain(80), 2, meeting="gather"))
    process = text[text.index("void run_0(") : text.index("void run_1(")]
    assert "hold<" in process
    told = re.findall(r"set_up_columns<block\((\d+)\), block\((\d+)\) \+ 1>", process)
    slots = [slot for a, b in told for slot in range(int(a), int(b) + 1)]
    assert len(told) == 2
    assert len(slots) == len(set(slots))


def test_states_of_a_batch_keep_their_lanes() -> None:
    assert "inward_in_columns<" not in kernels_of(plan_of(serial_chain(6), 1), batch=1)


@pytest.mark.parametrize(
    ("flags", "scalar"),
    [
        (QUICK, "double"),
        slow(QUICK, "float"),
        slow(OPTIMISED, "double"),  # float in test_strips.py
        slow(NARROW, "double"),
        (NARROW, "float"),
    ],
)
def test_chains_of_all_kinds_are_solved(
    flags: tuple[str, ...], scalar: str, builder: Builder, tmp_path: Path
) -> None:
    model = chain_of_all_kinds(4, 9)
    plan = plan_of(model, 1, scalar=scalar)
    assert "inward_in_columns<" in text_of(plan, shape="kernels", profile=BY_COLUMNS)
    states = random_states(model, 4, seed=5)
    solver = builder.solver(plan, flags, name="columns", shape="kernels", profile=BY_COLUMNS)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING[scalar]


@pytest.mark.parametrize("seed", [*(pytest.param(k, marks=pytest.mark.slow) for k in (2, 3)), 9])
def test_chains_swept_from_both_ends_are_solved(
    seed: int, builder: Builder, tmp_path: Path
) -> None:
    model = chain_of_all_kinds(seed, 14, floating=True)
    plan = plan_of(model, 2)
    text = text_of(plan, shape="kernels", profile=BY_COLUMNS)
    assert "inward_in_columns_reversed<" in text
    states = random_states(model, 4, seed=seed)
    solver = builder.solver(plan, name="columns", shape="kernels", profile=BY_COLUMNS)
    assert solver.error(model, states, tmp_path, "--check") < 5 * ROUNDING["double"]


@pytest.mark.parametrize(("seed", "processes"), [(2, 1), slow(6, 1), slow(5, 2), slow(9, 2)])
def test_runs_that_others_meet_on_the_way_are_solved(
    seed: int, processes: int, builder: Builder, tmp_path: Path
) -> None:
    model = tree(seed)
    plan = make_plan(model, random_schedule(model, processes, np.random.default_rng(seed)))
    assert "inward_in_columns<" in text_of(plan, shape="kernels", profile=BY_COLUMNS)
    states = random_states(model, 4, seed=seed)
    solver = builder.solver(plan, name="columns", shape="kernels", profile=BY_COLUMNS)
    assert solver.error(model, states, tmp_path, "--check") < 20 * ROUNDING["double"]


def test_a_link_thinner_than_a_float_shows_is_solved(builder: Builder, tmp_path: Path) -> None:
    """Joint 6 is swept in its own axes, where the little inertia about it is not rounded away."""
    thin = Inertia(1.0, np.zeros(3), np.diag([1.0, 1.0, 1e-10]))
    model = with_inertia(serial_chain(6, axes="z"), 6, thin)
    solver = builder.solver(plan_of(model, 1, scalar="float"), name="thin", shape="kernels")
    assert solver.error(model, random_states(model, 2), tmp_path) < ROUNDING["float"]
