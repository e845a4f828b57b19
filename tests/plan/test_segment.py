"""Form `segment`: what it does inside a process, and where it keeps digits that others lose."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.executor import interpret
from adagen.model import Model
from adagen.paper.restricted import joined_between_processes
from adagen.plan import make_plan
from adagen.plan.cuts import cuttable_joints
from adagen.plan.steps import (
    Articulate,
    FreeBase,
    InvertRoot,
    Join,
    LinkBias,
    Propagate,
    Receive,
    Send,
)
from adagen.plan.types import Plan
from adagen.reference import exact_forward_dynamics
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule
from adagen.states import random_states
from tests.links import with_light_link
from tests.models import human_figure, serial_chain, star, three_axis_chain
from tests.schedules import random_schedule


def planned(model: Model, processes: int, form: str = "segment", meeting: str = "auto") -> Plan:
    """Return the plan of the best schedule that may be cut only where digits are kept."""
    schedule = find_schedule(
        Topology.of(model),
        processes,
        profile=load_profile("paper"),
        cuttable=cuttable_joints(model),
    )
    return make_plan(model, schedule, form=form, meeting=meeting)


def error(model: Model, plan: Plan, states: int = 3) -> float:
    """Return the largest forward error relative to the largest true acceleration."""
    sample = random_states(model, states, seed=11)
    worst = 0.0
    for q, v, tau in sample.each:
        truth = exact_forward_dynamics(model, q, v, tau).value
        worst = max(
            worst, float(np.abs(interpret(plan, q, v, tau) - truth).max() / abs(truth).max())
        )
    return worst


def test_one_process_is_the_serial_algorithm() -> None:
    """No joins, no inversions, one articulated-body step for each joint."""
    plan = planned(serial_chain(9), 1)
    steps = plan.processes[0].steps
    assert sum(isinstance(step, Articulate) for step in steps) == 9
    assert not any(isinstance(step, Join | InvertRoot | Propagate | LinkBias) for step in steps)


def test_a_floating_figure_on_two_processes_needs_one_handshake() -> None:
    """Both halves are plain recursions towards the cut: nothing is carried outwards."""
    plan = planned(human_figure(), 2, meeting="join")
    steps = [step for process in plan.processes for step in process.steps]
    assert sum(isinstance(step, Join) for step in steps) == 1
    assert sum(isinstance(step, FreeBase) for step in steps) == 1
    assert not any(isinstance(step, Propagate) for step in steps)
    assert sum(isinstance(step, Send) for step in steps) == 2
    assert sum(isinstance(step, Receive) for step in steps) == 2


def test_a_grounded_segment_carries_its_mobility_outwards_only_to_the_cut() -> None:
    plan = planned(serial_chain(20), 2, meeting="join")
    outward = [s.joint for p in plan.processes for s in p.steps if isinstance(s, Propagate)]
    (cut,) = [s.joint for p in plan.processes for s in p.steps if isinstance(s, Join)]
    assert outward == list(range(cut))


@pytest.mark.parametrize("processes", [1, 2, 4])
@pytest.mark.parametrize("ratio", [1e-6, 1e-9, 1e-12])
def test_light_links_cost_no_digits(ratio: float, processes: int) -> None:
    model = with_light_link(serial_chain(12), 6, ratio)
    assert error(model, planned(model, processes)) < 1e-10


def test_form_ada_loses_the_digits_that_form_segment_keeps() -> None:
    model = with_light_link(serial_chain(12), 6, 1e-9)
    assert error(model, planned(model, 1, "ada")) > 1e-8
    assert error(model, planned(model, 1)) < 1e-11


@pytest.mark.parametrize("processes", [1, 2, 4])
def test_massless_links_are_no_obstacle(processes: int) -> None:
    model = three_axis_chain(4)
    assert error(model, planned(model, processes)) < 1e-10


@pytest.mark.parametrize("arms", [3, 8])
def test_many_handles_on_one_hub(arms: int) -> None:
    model = star(arms, floating=True)
    for seed in range(4):
        schedule = random_schedule(model, 4, np.random.default_rng(seed))
        assert error(model, make_plan(model, schedule)) < 1e-11


def test_cuts_are_kept_away_from_light_and_massless_links() -> None:
    for model in (with_light_link(serial_chain(12), 6, 1e-9), three_axis_chain(4)):
        allowed = cuttable_joints(model)
        assert not all(allowed)
        schedule = find_schedule(
            Topology.of(model), 4, profile=load_profile("paper"), cuttable=allowed
        )
        assert all(allowed[j] for j in joined_between_processes(schedule.root))
    allowed = cuttable_joints(with_light_link(serial_chain(12), 6, 1e-9))
    assert not allowed[5]
    assert not allowed[6]
    assert allowed[1]
    assert allowed[10]


def test_ordinary_robots_may_be_cut_anywhere() -> None:
    for model in (serial_chain(60), human_figure(), star(5, floating=True)):
        assert all(cuttable_joints(model))
