"""Shape kernels: runs of joints taken inwards by columns."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from adagen.model import Inertia, Model
from adagen.model.kinds import PRISMATIC, REVOLUTE, SPHERICAL
from adagen.plan import make_plan
from adagen.states import random_states, write_states
from tests.emitted import NARROW, OPTIMISED, QUICK, ROUNDING, Builder, kernels_of, plan_of
from tests.links import with_inertia
from tests.models import ALL_KINDS, random_tree, serial_chain
from tests.schedules import random_schedule

MANY_HINGES = (*ALL_KINDS, REVOLUTE, REVOLUTE, PRISMATIC, PRISMATIC)


def chain_of_all_kinds(seed: int, n: int, floating: bool = False) -> Model:
    return random_tree(
        np.random.default_rng(seed), n, MANY_HINGES, branching=0.0, floating=floating
    )


def tree(seed: int) -> Model:
    return random_tree(np.random.default_rng(seed), 12, MANY_HINGES, branching=0.15)


def test_only_runs_of_hinges_and_of_some_length_are_taken_by_columns() -> None:
    assert "columns<" not in kernels_of(plan_of(serial_chain(8, kind=SPHERICAL), 1))
    assert "inward_in_columns<0, 0, 5, true>(w);" in kernels_of(plan_of(serial_chain(6), 1))
    assert "columns<" not in kernels_of(plan_of(serial_chain(3), 1))


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


@pytest.mark.parametrize("flags", [QUICK, OPTIMISED, NARROW], ids=["wide", "optimised", "narrow"])
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_chains_of_all_kinds_are_solved(
    flags: tuple[str, ...], scalar: str, builder: Builder, tmp_path: Path
) -> None:
    model = chain_of_all_kinds(4, 9)
    plan = plan_of(model, 1, scalar=scalar)
    assert "inward_in_columns<" in kernels_of(plan)
    states = random_states(model, 4, seed=5)
    solver = builder.solver(plan, flags, name="columns", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING[scalar]


@pytest.mark.parametrize("seed", [2, 3, 9])
def test_chains_swept_from_both_ends_are_solved(
    seed: int, builder: Builder, tmp_path: Path
) -> None:
    model = chain_of_all_kinds(seed, 14, floating=True)
    plan = plan_of(model, 2)
    assert "inward_in_columns_reversed<" in kernels_of(plan)
    states = random_states(model, 4, seed=seed)
    solver = builder.solver(plan, name="columns", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < 5 * ROUNDING["double"]


@pytest.mark.parametrize(("seed", "processes"), [(2, 1), (6, 1), (5, 2), (9, 2)])
def test_runs_that_others_meet_on_the_way_are_solved(
    seed: int, processes: int, builder: Builder, tmp_path: Path
) -> None:
    model = tree(seed)
    plan = make_plan(model, random_schedule(model, processes, np.random.default_rng(seed)))
    assert "inward_in_columns<" in kernels_of(plan)
    states = random_states(model, 4, seed=seed)
    solver = builder.solver(plan, name="columns", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < 20 * ROUNDING["double"]


def test_a_joint_that_cannot_be_eliminated_is_named(builder: Builder, tmp_path: Path) -> None:
    # About joint 6's axis the last link is lighter by more than the digits of a float.
    thin = Inertia(1.0, np.zeros(3), np.diag([1.0, 1.0, 1e-10]))
    model = with_inertia(serial_chain(6, axes="z"), 6, thin)
    solver = builder.solver(plan_of(model, 1, scalar="float"), name="thin", shape="kernels")
    write_states(random_states(model, 2), model, tmp_path / "s.json")
    done = solver.run("--states", tmp_path / "s.json", "--result", tmp_path / "r.json")
    assert (done.status, done.stdout) == (1, "")
    assert f'joint "{model.joints[5].name}": factorization failed' in done.stderr
