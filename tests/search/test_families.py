"""The best of all families: what is proven of it, and robots so long that not all is looked at."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.calibrate.schedules import random_schedule
from adagen.emit.shapes import predict
from adagen.model import Model
from adagen.paper.restricted import joined_between_processes
from adagen.plan import make_plan
from adagen.plan.cuts import cuttable_joints
from adagen.schedule import Topology, load_profile, schedule_to_json, validate
from adagen.search import best_schedule, find_schedule, schedule_from_json
from adagen.search.price import played
from adagen.urdf import read_robot
from tests.models import binary, human_figure, random_tree, serial_chain, some_rubbing, star
from tests.real import real_robot
from tests.search.test_meeting_places import with_hands
from tests.slow import slow

PROFILE = load_profile("zen4")


@settings(max_examples=6)
@given(
    st.integers(2, 10),
    st.sampled_from([2, 3, 4]),
    st.booleans(),
    st.booleans(),
    st.integers(0, 2**32 - 1),
)
def test_nothing_that_is_joined_is_faster(
    joints: int, processes: int, floating: bool, friction: bool, seed: int
) -> None:
    """Random schedule trees, played through, beside what is proven."""
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, branching=0.4, floating=floating)
    model = some_rubbing(model, seed) if friction else model
    best, topology = best_schedule(model, processes, PROFILE), Topology.of(model)
    loops = best_schedule(model, processes, PROFILE, shape="kernels")
    assert loops.lower_bound <= loops.makespan == played(model, loops, PROFILE)
    assert best.lower_bound <= best.makespan <= loops.makespan + 1e-5
    assert best.makespan == predict(make_plan(model, best), PROFILE).makespan
    validate(best, topology)
    cuttable = cuttable_joints(model)
    found = find_schedule(topology, processes, profile=PROFILE, cuttable=cuttable)
    assert loops.makespan <= played(model, found, PROFILE)
    for k in range(6):
        other = random_schedule(topology, processes, PROFILE, seed + k)
        if all(cuttable[j] for j in joined_between_processes(other.root)):
            time = played(model, other, PROFILE) + 1e-9
            assert loops.lower_bound <= time
            assert best.lower_bound <= time


@pytest.mark.parametrize(
    "model",
    [
        star(4, 4),
        *(
            pytest.param(model, marks=pytest.mark.slow)
            for model in (human_figure(), binary(4, floating=True), star(6, 5))
        ),
    ],
)
def test_one_process_is_a_candidate_in_each_shape(model: Model) -> None:
    """What is taken is not slower than one process in the shape that it is emitted in."""
    for processes in (2, 4):
        alone = find_schedule(
            Topology.of(model),
            processes,
            profile=PROFILE,
            cuttable=[False] * len(model.joints),
        )
        for shape in ("auto", "kernels", "unrolled"):
            best = best_schedule(model, processes, PROFILE, shape=shape)
            one = predict(make_plan(model, alone), PROFILE, shape).makespan
            assert best.makespan == predict(make_plan(model, best), PROFILE, shape).makespan
            assert best.makespan <= one
            assert (best.straight_lines > 0) == (shape != "kernels")
            assert best.verdict == "optimal" or shape == "unrolled"


def test_of_straight_lines_little_is_proven() -> None:
    """Whoever exchanges anything waits for it: only what is done sooner cannot be beaten."""
    arm = best_schedule(serial_chain(3), 2, PROFILE, shape="unrolled")
    assert arm.verdict == "optimal"
    figure = best_schedule(human_figure(), 2, PROFILE, shape="unrolled")
    assert 0.0 < figure.lower_bound < figure.makespan
    least = f"take {figure.lower_bound:.2g} us at least"
    among = f"others among {figure.among} {least}"
    assert figure.proven == f"no useful bound: proven is only that {among}"
    near = replace(figure, lower_bound=figure.makespan / 1.2)
    assert near.proven.startswith("at most 20.0% above the optimum among loops")


def test_schedules_by_name_are_candidates() -> None:
    found = best_schedule(serial_chain(12), 2, PROFILE)
    assert {"balanced", "sequential", "middle-out"} <= set(found.families)


def test_long_chains_are_shared_out() -> None:
    """With a budget that does not grow with the chain; the bound is that of all schedules."""
    model = serial_chain(700)
    best = best_schedule(model, 4, PROFILE)
    alone = find_schedule(
        Topology.of(model), 4, profile=PROFILE, cuttable=[False] * len(model.joints)
    )
    assert best.makespan < 0.7 * played(model, alone, PROFILE)
    assert best.makespan == predict(make_plan(model, best), PROFILE).makespan


@pytest.mark.slow
def test_the_gap_of_a_long_chain_is_small() -> None:
    assert best_schedule(serial_chain(700), 4, PROFILE).gap < 0.15


@pytest.mark.parametrize("model", [serial_chain(24), slow(serial_chain(60)), slow(human_figure())])
def test_more_processes_are_not_slower(model: Model) -> None:
    """Processes that do not pay stay idle."""
    times = [best_schedule(model, processes, PROFILE).makespan for processes in (1, 2, 4, 8)]
    assert times == sorted(times, reverse=True)


def test_the_file_tells_what_was_searched() -> None:
    model = human_figure()
    best, topology = best_schedule(model, 3, PROFILE), Topology.of(model)
    told = json.loads(schedule_to_json(best, topology))
    assert {"alone", "gathered", "joined"} <= set(told["families"])
    assert told["straight_lines"] == best.straight_lines > 0
    assert best.proven.endswith(f" among loops and {best.straight_lines} straight lines")
    assert told["candidates"] == best.candidates > 1
    again = schedule_from_json(json.dumps(told), topology, PROFILE)
    assert again.families == ()  # it is priced by its tree anew
    assert make_plan(model, again) == make_plan(model, best)


def test_fewer_processes_are_searched_where_the_budget_strikes() -> None:
    """Two hands: the search of four processes ends before it comes to the best layout of two."""
    model = with_hands(2, 3, 2, floating=False)

    def least(processes: int, expansions: int) -> float:
        found = best_schedule(model, processes, PROFILE, expansions=expansions, shape="kernels")
        return found.makespan

    alone, two = least(1, 20), least(2, 1000)
    assert two < 0.9 * alone
    assert least(4, 20) <= two
    assert least(8, 20) <= two


def test_more_processes_are_not_predicted_slower() -> None:
    """The straight line that is best on two processes is no candidate of those on four alone."""
    path = real_robot("g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf")
    model = read_robot(path, floating=True).model
    two, four = (best_schedule(model, processes, PROFILE) for processes in (2, 4))
    assert two.meeting == four.meeting == "gather"
    assert four.makespan <= two.makespan
