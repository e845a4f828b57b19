"""The schedule for a form of the algorithm, and choosing the number of processes."""

from __future__ import annotations

import pytest

from adagen.plan import make_plan
from adagen.predict import best_schedule, choose_processes
from adagen.schedule import Topology, find_schedule, load_profile, validate
from adagen.schedule.restricted import joined_between_processes
from tests.models import human_figure, serial_chain
from tests.predict.costs import step_profile

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
