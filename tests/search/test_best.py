"""The schedule for a form of the algorithm, and choosing the number of processes."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.calibrate.robots import chain, robot
from adagen.emit.shapes import SHAPES
from adagen.paper.restricted import joined_between_processes
from adagen.plan import make_plan
from adagen.schedule import Topology, load_profile, validate
from adagen.search import best_schedule, choose_processes, find_schedule
from tests.cost.costs import step_profile
from tests.models import human_figure, random_tree, serial_chain

PROFILE = load_profile("default")


def test_it_cuts_where_it_may() -> None:
    model = serial_chain(40)
    allowed = [j % 3 == 0 for j in range(40)]
    topology = Topology.of(model)
    found = find_schedule(topology, 4, profile=PROFILE, cuttable=allowed)
    assert all(allowed[j] for j in joined_between_processes(found.root))
    free = find_schedule(topology, 4, profile=PROFILE)
    assert free.lower_bound <= free.makespan <= found.makespan


@pytest.mark.parametrize("form", ["segment", "ada"])
@pytest.mark.parametrize("profile", ["paper", "default"])
def test_the_best_schedule_suits_its_form(form: str, profile: str) -> None:
    model = human_figure()
    found = best_schedule(model, 4, load_profile(profile), form)
    validate(found, Topology.of(model))
    make_plan(model, found, form=form)


def test_as_many_processes_as_pay_are_chosen() -> None:
    model = serial_chain(24)

    def chosen(**changes: float) -> int:
        profile = step_profile((), **changes)

        def schedule(processes: int):  # type: ignore[no-untyped-def]  # noqa: ANN202
            return best_schedule(model, processes, profile, gather=False)

        return choose_processes(model, profile, "segment", 4, schedule)[0].processes

    assert chosen(join__revolute=9.0) == 1
    assert chosen(articulate__revolute=9.0) >= 3


@settings(max_examples=20)
@given(st.integers(1, 9), st.integers(1, 3), st.booleans(), st.integers(0, 2**32 - 1))
def test_what_is_chosen_can_be_emitted(
    joints: int, processes: int, floating: bool, seed: int
) -> None:
    """Also where joints of several freedoms stand on the ground, whose mobility is not a body."""
    model = random_tree(np.random.default_rng(seed), joints, branching=0.4, floating=floating)
    plan = make_plan(model, best_schedule(model, processes, PROFILE))
    assert any(shape.why_not(plan) is None for shape in SHAPES.values())


def test_a_planar_joint_on_the_ground_does_not_keep_processes_apart() -> None:
    model = robot("planar", chain(6), ["planar", *["revolute"] * 5])
    plan = make_plan(model, best_schedule(model, 2, PROFILE))
    assert any(shape.why_not(plan) is None for shape in SHAPES.values())
