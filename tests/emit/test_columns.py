"""Shape kernels: runs of joints taken inwards by columns."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import emit
from adagen.model import Inertia, Model
from adagen.plan import Plan, make_plan
from adagen.schedule import Topology, load_profile, named_schedule
from adagen.states import random_states, write_states
from tests.emitted import QUICK, Builder, forward_error, truth_of
from tests.models import random_tree, serial_chain
from tests.schedules import random_schedule

PROFILE = load_profile("default")
OPTIMISED = ("-O3", *QUICK[1:])
NARROW = ("-O1", "-march=x86-64-v2", "-DNDEBUG", "-fno-math-errno")  # no register for a column


def chain_of_all_kinds(seed: int, floating: bool = False) -> Model:
    return random_tree(np.random.default_rng(seed), 9, branching=0.0, floating=floating)


def tree(seed: int) -> Model:
    return random_tree(np.random.default_rng(seed), 12, branching=0.15)


def divided(model: Model, processes: int, scalar: str = "double", meeting: str = "join") -> Plan:
    schedule = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    return make_plan(model, schedule, meeting=meeting, scalar=scalar)


def text_of(plan: Plan, batch: int = 0) -> str:
    files = emit(plan, name="x", shape="kernels", batch=batch)
    return next(text for name, text in files.items() if name.endswith(".cpp"))


def test_only_runs_of_some_length_are_taken_by_columns() -> None:
    assert "inward_in_columns<0, 0, 5, true>(w);" in text_of(divided(serial_chain(6), 1))
    assert "columns<" not in text_of(divided(serial_chain(3), 1))


def test_states_of_a_batch_keep_their_lanes() -> None:
    assert "inward_in_columns<" not in text_of(divided(serial_chain(6), 1), batch=1)


@pytest.mark.parametrize("flags", [QUICK, OPTIMISED, NARROW], ids=["wide", "optimised", "narrow"])
@pytest.mark.parametrize(("scalar", "limit"), [("double", 1e-9), ("float", 2e-3)])
def test_chains_of_all_kinds_are_solved(
    flags: tuple[str, ...], scalar: str, limit: float, builder: Builder, tmp_path: Path
) -> None:
    model = chain_of_all_kinds(4)
    plan = divided(model, 1, scalar)
    assert "inward_in_columns<" in text_of(plan)
    states = random_states(model, 4, seed=5)
    solver = builder.solver(plan, flags, name="columns", shape="kernels")
    found = solver.solve(model, states, tmp_path, "--check")
    assert forward_error(found, truth_of(model, states)) < limit


@pytest.mark.parametrize("seed", [1, 2, 8])
def test_chains_swept_from_both_ends_are_solved(
    seed: int, builder: Builder, tmp_path: Path
) -> None:
    model = random_tree(np.random.default_rng(seed), 14, branching=0.0, floating=True)
    plan = divided(model, 2)
    assert "inward_in_columns_reversed<" in text_of(plan)
    states = random_states(model, 4, seed=seed)
    solver = builder.solver(plan, name="columns", shape="kernels")
    found = solver.solve(model, states, tmp_path, "--check")
    assert forward_error(found, truth_of(model, states)) < 1e-9


@pytest.mark.parametrize(("seed", "processes"), [(1, 1), (3, 1), (5, 2), (11, 2)])
def test_runs_that_others_meet_on_the_way_are_solved(
    seed: int, processes: int, builder: Builder, tmp_path: Path
) -> None:
    model = tree(seed)
    plan = make_plan(model, random_schedule(model, processes, np.random.default_rng(seed)))
    assert "inward_in_columns<" in text_of(plan)
    states = random_states(model, 4, seed=seed)
    solver = builder.solver(plan, name="columns", shape="kernels")
    found = solver.solve(model, states, tmp_path, "--check")
    assert forward_error(found, truth_of(model, states)) < 1e-9


def test_a_joint_that_cannot_be_eliminated_is_named(builder: Builder, tmp_path: Path) -> None:
    model = serial_chain(6, axes="z")
    links = list(model.links)
    # About joint 6's axis the last link is lighter by more than the digits of a float.
    links[6] = replace(links[6], inertia=Inertia(1.0, np.zeros(3), np.diag([1.0, 1.0, 1e-10])))
    model = replace(model, links=tuple(links))
    solver = builder.solver(divided(model, 1, "float"), name="thin", shape="kernels")
    write_states(random_states(model, 2), model, tmp_path / "s.json")
    done = solver.run("--states", tmp_path / "s.json", "--result", tmp_path / "r.json")
    assert (done.status, done.stdout) == (1, "")
    assert f'joint "{model.joints[5].name}": factorization failed' in done.stderr
