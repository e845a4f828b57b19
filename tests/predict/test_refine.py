"""Improving schedules by their plans, and choosing the number of processes."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.plan import make_plan
from adagen.predict import best_schedule, choose_processes, predict
from adagen.predict.refine import refine
from adagen.schedule import Topology, find_schedule, load_profile, validate
from adagen.schedule.restricted import joined_between_processes
from tests.models import human_figure, random_tree, serial_chain
from tests.predict.costs import step_profile

PROFILE = load_profile("default")


@pytest.mark.parametrize("processes", [1, 2, 3, 4, 8])
@pytest.mark.parametrize("seed", range(4))
def test_it_only_ever_improves(seed: int, processes: int) -> None:
    model = random_tree(np.random.default_rng(seed), 24, floating=seed % 2 == 0)
    topology = Topology.of(model)
    found = find_schedule(topology, processes, profile=PROFILE)
    better = refine(model, found, PROFILE, [True] * len(topology))
    validate(better, topology)
    times = [predict(make_plan(model, s), PROFILE).makespan for s in (found, better)]
    assert times[1] <= times[0]
    assert better.lower_bound <= found.lower_bound <= times[1] * (1 + 1e-9)


def test_somewhere_it_does_improve() -> None:
    model = serial_chain(40)
    found = find_schedule(Topology.of(model), 8, profile=PROFILE)
    better = refine(model, found, PROFILE, [True] * 40)
    times = [predict(make_plan(model, s), PROFILE).makespan for s in (found, better)]
    assert times[1] < 0.995 * times[0]
    assert refine(model, found, PROFILE, [True] * 40, trials=0) is found


def test_it_cuts_where_it_may() -> None:
    model = serial_chain(40)
    allowed = [j % 3 == 0 for j in range(40)]
    found = find_schedule(Topology.of(model), 4, profile=PROFILE, cuttable=allowed)
    better = refine(model, found, PROFILE, allowed)
    assert all(allowed[j] for j in joined_between_processes(better.root))


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
            return best_schedule(model, processes, profile)

        return choose_processes(model, profile, "segment", 4, schedule)[0].processes

    assert chosen(join__revolute=9.0) == 1
    assert chosen(articulate__revolute=9.0) >= 3
