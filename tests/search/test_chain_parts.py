"""Long chains that one process sweeps in parts: where the search takes them."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from adagen.cost import timeline
from adagen.errors import InputError
from adagen.library.request import Request
from adagen.library.scheduling import schedule_of
from adagen.model import Model
from adagen.plan import make_plan
from adagen.plan.certificate import certified
from adagen.plan.steps import Join
from adagen.program.lower import lower
from adagen.schedule import Topology, load_profile, schedule_to_json
from adagen.schedule.caches import solved_in_lanes
from adagen.search import best_schedule, predicted_time, schedule_from_json
from adagen.search.chain_parts import certifies, joined, keeps_digits
from tests.links import with_light_link
from tests.models import serial_chain
from tests.plan.test_parts import hinges, hung
from tests.slow import slow

XEON = load_profile("xeon")


def best(model: Model, processes: int = 1, **options: object) -> int:
    """Return in how many parts processes of the best schedule sweep their own."""
    found = best_schedule(model, processes, XEON, **{"in_parts": True, **options})  # type: ignore[arg-type]
    return found.parts


def test_a_long_chain_is_parted_where_that_is_faster() -> None:
    model = serial_chain(400)
    found = best_schedule(model, 1, XEON, in_parts=True)
    whole = replace(found, parts=0)
    times = [predicted_time(model, each, XEON, "segment") for each in (found, whole)]
    assert found.parts == 8 and found.makespan == times[0] < 0.8 * times[1]
    assert best(serial_chain(40)) == best(model, in_parts=False) == 0
    assert best(model, scalar="float") == 16
    assert best(model, scalar="float", certify=True) == 0  # such bounds would be infinite


def test_no_part_is_cut_where_that_costs_digits() -> None:
    """A light link at a single one of the cuts leaves the chain whole."""
    model = serial_chain(400)
    cuts = sorted(joined(replace(best_schedule(model, 1, XEON), parts=8), model))
    assert cuts == list(range(0, 400, 50))
    assert best(with_light_link(model, cuts[3] + 1, 1e-6)) == 0
    allowed = [j != cuts[3] for j in range(400)]
    assert not keeps_digits(replace(best_schedule(model, 1, XEON), parts=8), model, allowed)


@pytest.mark.parametrize("kind", ["floating", slow("prismatic")])
def test_a_long_chain_on_another_joint_is_parted_where_that_is_faster(kind: str) -> None:
    model = hung(kind, 400, seed=3)
    for processes in (1, 2):
        found = best_schedule(model, processes, XEON, in_parts=True)
        whole = best_schedule(model, processes, XEON)
        assert found.parts == 8 and found.makespan < 0.8 * whole.makespan
        assert found.makespan == predicted_time(model, found, XEON, "segment")


def test_a_base_without_inertia_leaves_the_chain_whole() -> None:
    model = hung("floating", 400, seed=3)
    assert best(with_light_link(model, 1, 1e-9)) == 0 < best(model)


def test_processes_of_several_part_their_own() -> None:
    model = serial_chain(450)
    found = best_schedule(model, 2, XEON, in_parts=True)
    assert (found.parts, found.meeting) == (8, "exchange")
    whole = best_schedule(model, 2, XEON)
    assert found.makespan < 0.8 * whole.makespan
    assert found.lower_bound <= found.makespan
    joins = [len(list(p.steps_of(Join))) for p in make_plan(model, found).processes]
    assert joins == [9, 8]


@pytest.mark.parametrize("most", [4, slow(8)])
def test_more_processes_are_not_predicted_slower(most: int) -> None:
    """Where as many as there are would take longer, fewer of them work."""
    model = serial_chain(200)
    counts = [count for count in (1, 2, 4, 8) if count <= most]
    alone, two, *more = (best_schedule(model, count, XEON, in_parts=True) for count in counts)
    assert alone.parts == two.parts == 8
    for few, many in pairwise([alone, two, *more]):
        assert many.makespan <= few.makespan + 1e-9


@pytest.mark.parametrize(
    "asked",
    [
        *({"batch": True}, {"certify": True, "batch": True}),
        *({"certify": True, "shape": "unrolled"}, {"reproducible": True}, {"refine": 1}),
        *(
            {"target": "embedded"},
            {"shape": "unrolled"},
            {"objective": "accuracy"},
            {"form": "ada"},
            {"parts": "none"},
        ),
    ],
    ids=lambda asked: " ".join(asked),
)
def test_chains_stay_whole_where_parts_cannot_be_or_are_not_wanted(
    asked: dict[str, object],
) -> None:
    model = hinges(300, seed=1)
    request = Request(profile="xeon", **asked)  # type: ignore[arg-type]
    assert schedule_of(model, request).parts == 0


@pytest.mark.parametrize("processes", [1, slow(2)])
def test_certified_chains_are_parted_where_that_is_faster(processes: int) -> None:
    """By prices of certified programs, and on one process only."""
    model = hinges(600, seed=1)
    asked = Request(profile="xeon", certify=True, procs=processes)
    found = schedule_of(model, asked)
    assert found.parts == 8 and not found.gathered
    plan = certified(make_plan(model, found))
    line = timeline(lower(plan, "kernels"), XEON)
    whole = certified(make_plan(model, replace(found, parts=0)))
    assert line.makespan == pytest.approx(found.makespan)
    assert line.makespan < 0.8 * timeline(lower(whole, "kernels"), XEON).makespan
    assert schedule_of(model, replace(asked, parts="none")).parts == 0
    assert schedule_of(hinges(40, seed=1), asked).parts == 0


def test_certified_chains_stay_whole_where_loops_cannot_weigh_parts() -> None:
    """A link so slender that its joint is swept in its own axes."""
    model = hinges(400, seed=1)
    links = list(model.links)
    body = links[70].inertia
    along = 1e-13 * np.outer(model.joints[69].axis, model.joints[69].axis)
    links[70] = replace(links[70], inertia=replace(body, com=0 * body.com, tensor=along))
    slender = replace(model, links=tuple(links))
    found = replace(best_schedule(model, 1, XEON), parts=8)
    assert certifies(found, model)
    assert not certifies(found, slender)
    assert best(slender, certify=True) == 0


def test_batches_of_long_chains_are_in_parts() -> None:
    """State by state, where eight states would not fit the cache; four are solved in lanes."""
    model = hinges(600, seed=2)
    assert not solved_in_lanes(600, XEON.measured)
    for profile, parts in (("xeon", 8), ("avx2", 0)):
        assert schedule_of(model, Request(profile=profile)).parts == 8
        assert schedule_of(model, Request(profile=profile, batch=True)).parts == parts
    assert schedule_of(model, Request(profile="xeon", batch=True, parts="none")).parts == 0


@pytest.mark.slow
def test_parts_of_too_many_joints_would_take_long_to_assess() -> None:
    plain, longer = (best_schedule(hinges(n, seed=2), 1, XEON, in_parts=True) for n in (3000, 3001))
    assert (plain.parts, longer.parts) == (8, 0)


def test_a_file_may_ask_for_parts() -> None:
    model = serial_chain(30)
    topology = Topology.of(model)
    text = schedule_to_json(replace(best_schedule(model, 1, XEON), parts=8), topology)
    assert schedule_from_json(text, topology, XEON).parts == 8
    for wrong in ("1", "65", "true", '"8"'):
        with pytest.raises(InputError, match='"parts" is a number from 2 to 64, or 0'):
            schedule_from_json(text.replace('"parts": 8', f'"parts": {wrong}'), topology, XEON)
