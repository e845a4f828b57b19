"""Emitted solvers whose processes exchange pair by pair: right by every channel and shape."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.model import Model
from adagen.plan import make_plan
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from adagen.states import random_states
from tests.emit.test_strips import balls_and_hinges
from tests.emitted import ROUNDING, Builder, kernels_of
from tests.models import human_figure, random_tree, serial_chain
from tests.schedules import random_schedule
from tests.slow import slow

PROFILE = load_profile("default")


@pytest.mark.parametrize(
    ("model", "processes", "channel", "scalar"),
    [
        pytest.param(serial_chain(160), 8, "auto", "double", marks=pytest.mark.slow),
        (serial_chain(72), 4, "message", "double"),
        slow(balls_and_hinges(60, seed=4), 3, "auto", "double"),
        slow(serial_chain(40), 5, "auto", "float"),
        pytest.param(human_figure(), 4, "auto", "double", marks=pytest.mark.slow),
    ],
    ids=["eight in a window", "four by messages", "balls", "float", "figure"],
)
def test_loops_that_exchange_are_solved(
    model: Model, processes: int, channel: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    schedule = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="exchange", channel=channel, scalar=scalar)
    states = random_states(model, 4, seed=processes)
    solver = builder.solver(plan, name="exchange", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < 5 * ROUNDING[scalar]


@pytest.mark.slow
def test_loops_of_four_that_tell_each_other_at_once_are_solved(
    builder: Builder, tmp_path: Path
) -> None:
    model = serial_chain(72)
    schedule = named_schedule("balanced", Topology.of(model), 4, profile=PROFILE)
    plan = make_plan(model, replace(schedule, fan=4), meeting="exchange")
    solver = builder.solver(plan, name="exchange", shape="kernels")
    states = random_states(model, 4, seed=4)
    assert solver.error(model, states, tmp_path, "--check") < 5 * ROUNDING["double"]


def test_long_parts_are_traversed_in_strips() -> None:
    schedule = named_schedule("balanced", Topology.of(serial_chain(160)), 8, profile=PROFILE)
    text = kernels_of(make_plan(serial_chain(160), schedule, meeting="exchange"))
    assert "starts_0 = traverse_in_strips<0, " in text and " traverse<" not in text
    assert " outward_traversed<0, " in text and "  pass_outward" not in text


def test_straight_lines_that_exchange_are_solved(builder: Builder, tmp_path: Path) -> None:
    rng = np.random.default_rng(11)
    model = random_tree(rng, 10, branching=0.4)
    plan = make_plan(model, random_schedule(model, 4, rng), meeting="exchange")
    states = random_states(model, 4, seed=1)
    solver = builder.solver(plan, name="exchange", shape="unrolled")
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


@pytest.mark.slow
def test_corrections_of_exchanges_are_solved(builder: Builder, tmp_path: Path) -> None:
    model = serial_chain(20)
    schedule = named_schedule("balanced", Topology.of(model), 3, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="exchange")
    states = random_states(model, 4, seed=1)
    solver = builder.solver(plan, name="exchange", shape="kernels", refine=1)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]
