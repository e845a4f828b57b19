"""Layouts priced by their shares, and said by schedules: what is composed is what is played."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.emit.shapes import SHAPES, predict
from adagen.model import BASE, FLOATING, REVOLUTE, Model
from adagen.plan import can_gather, make_plan
from adagen.plan.constants import joints_of
from adagen.schedule import CostProfile, Topology, load_profile, validate
from adagen.search import find_schedule
from adagen.search.layouts import Layout, LayoutPrices, MeetingPlace
from adagen.search.limbs import Core, Robot
from adagen.search.meeting_places import in_place
from adagen.search.price import Pricing
from tests.cost.costs import step_profile
from tests.models import (
    Part,
    assemble,
    human_figure,
    random_tree,
    rod,
    serial_chain,
    some_rubbing,
    vector,
)

DEFAULT = load_profile("default")
OTHERS = step_profile((1.0, 0.5, 2.0))
"""Every coefficient another number, and processes of unequal speed."""


def some_frame(robot: Robot, rng: np.random.Generator) -> MeetingPlace:
    """Return a place to meet for some of a robot's trees."""
    cores = []
    for number, tree in enumerate(robot.trees):
        if rng.random() < 0.3:
            continue
        root = int(rng.choice(tree.links))
        joints: list[int] = []
        for _ in range(int(rng.integers(0, 3))):
            links = (root, *(j + 1 for j in joints))
            more = [j for link in links for j in robot.at[link] if j not in joints]
            joints += [int(rng.choice(more))] if more else []
        cores.append(Core(number, root, tuple(sorted(joints))))
    return MeetingPlace(tuple(cores), robot.limbs(cores))


def some_layouts(robot: Robot, processes: int, rng: np.random.Generator, count: int):  # type: ignore[no-untyped-def] # noqa: ANN201
    """Yield layouts in which all trees that are shared have limbs of two processes."""
    for _ in range(count):
        place = some_frame(robot, rng)
        of = rng.integers(0, processes, len(place.limbs))
        shares = tuple(tuple(np.flatnonzero(of == p).tolist()) for p in range(processes))
        layout = Layout(place, shares)
        if all(len(layout.taking_part(core.tree)) > 1 for core in place.cores):
            yield layout


def compared(model: Model, processes: int, profile: CostProfile, seed: int, count: int) -> int:
    """Compare the prices of some layouts with those of their plans; return how many."""
    robot, topology = Robot(joints_of(model)), Topology.of(model)
    pattern = find_schedule(topology, processes, profile=profile, expansions=0)
    prices = LayoutPrices(robot, Pricing(make_plan(model, pattern), profile))
    seen = 0
    for layout in some_layouts(robot, processes, np.random.default_rng(seed), count):
        if not in_place(layout, robot):
            continue
        schedule = replace(pattern, meeting="gather", gathered=layout.gathered(robot))
        validate(schedule, topology)
        plan, time = make_plan(model, schedule), prices.time(layout)
        if SHAPES["kernels"].why_not(plan) is not None:
            assert time is None
            continue
        assert time == pytest.approx(predict(plan, profile, "kernels").makespan, abs=1e-12)
        seen += 1
    return seen


@settings(max_examples=60)
@given(
    st.integers(2, 22),
    st.integers(2, 3),
    st.booleans(),
    st.booleans(),
    st.sampled_from([0.1, 0.4]),
    st.sampled_from([DEFAULT, OTHERS]),
    st.integers(0, 2**32 - 1),
)
def test_what_is_composed_is_what_is_played(
    joints: int,
    processes: int,
    floating: bool,
    friction: bool,
    branching: float,
    profile: CostProfile,
    seed: int,
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, branching=branching, floating=floating)
    model = some_rubbing(model, seed) if friction else model
    if can_gather(model):
        compared(model, processes, profile, seed, 6)


@pytest.mark.parametrize("profile", [DEFAULT, OTHERS])
def test_long_runs_are_parted_by_what_others_pass(profile: CostProfile) -> None:
    for model in (serial_chain(40), serial_chain(50, floating=True)):
        assert compared(model, 2, profile, 3, 40) > 5


def test_limbs_with_friction_and_without_are_not_alike() -> None:
    rough = some_rubbing(human_figure(), 3)
    assert compared(rough, 3, OTHERS, 1, 60) > 10
    kinds = [
        len({limb.kind for limb in Robot(joints_of(model)).limbs((Core(0, 1),))})
        for model in (human_figure(), rough)
    ]
    assert kinds[0] < kinds[1]


def test_layouts_of_a_figure_are_what_schedules_say() -> None:
    assert compared(human_figure(), 3, DEFAULT, 1, 60) > 10


def test_limbs_that_are_alike_are_of_a_kind() -> None:
    robot = Robot(joints_of(human_figure()))
    limbs = robot.limbs((Core(0, 1),))
    joints = [[j for k in limbs if k.kind == limb.kind for j in k.joints] for limb in limbs]
    assert any(len(each) > len(limb) for each, limb in zip(joints, limbs, strict=True))
    assert sorted(j for limb in limbs for j in limb.joints) == list(range(1, len(robot.joints)))


def test_limbs_that_prolong_a_run_are_of_their_own_kind() -> None:
    """Three limbs alike at the end of a spine: one goes on with its run, and is passed with it."""
    names = [f"s{k}" for k in range(10)]
    rows = list(zip([BASE, *names[:-1]], names, strict=True))
    for limb in "tuv":
        names = [f"{limb}{k}" for k in range(9)]
        rows += zip(["s9", *names[:-1]], names, strict=True)
    body = rod(1.0, vector(0.2, 0.0, 0.0))
    parts = [Part(name, parent, REVOLUTE, body) for parent, name in rows]
    model = assemble("fork", [Part(BASE, None, FLOATING, body), *parts], floating=True)
    robot = Robot(joints_of(model))
    kinds = [limb.kind for limb in robot.limbs((Core(0, 11),))[1:]]
    assert kinds[0] != kinds[1] == kinds[2]
    assert compared(model, 3, DEFAULT, 4, 60) > 10
