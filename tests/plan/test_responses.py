"""Runs from the ground whose mobility is asked for at the last link only."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.model import KINDS, Model
from adagen.plan import Plan, make_plan
from adagen.plan.responses import mentions, responses
from adagen.plan.steps import HoldMobility, Propagate, Send
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from tests.emitted import kernels_of
from tests.models import random_tree, serial_chain

PROFILE = load_profile("default")
KINDS_PASSED = [KINDS["revolute"], KINDS["prismatic"], KINDS["spherical"]]


def gathered(model: Model) -> Plan:
    schedule = named_schedule("balanced", Topology.of(model), 2, profile=PROFILE)
    return make_plan(model, schedule, meeting="gather")


def carried(plan: Plan) -> tuple[int, list[Propagate]]:
    """The process that carries mobilities from the ground on, and its steps that do."""
    for p, process in enumerate(plan.processes):
        steps = [step for step in process.steps if isinstance(step, Propagate)]
        if steps:
            return p, steps
    raise AssertionError("no process carries a mobility")


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_what_holds_a_chain_is_asked_for_at_one_link(seed: int) -> None:
    rng = np.random.default_rng(seed)
    plan = gathered(random_tree(rng, 20, KINDS_PASSED, branching=0.0))
    p, steps = carried(plan)
    (run,) = responses(plan, steps, mentions(plan, plan.processes[p]))
    assert list(run) == steps
    assert len(steps) > 1
    text = kernels_of(plan)
    assert f"respond<{run[0].joint}, {run[-1].joint}>(w, " in text


def test_a_mobility_that_is_asked_for_is_computed() -> None:
    plan = gathered(serial_chain(20))
    p, steps = carried(plan)
    asked = steps[3].block  # say that a message tells it
    told = replace(plan.messages[0], blocks=(asked,))
    plan = replace(plan, messages=(told, *plan.messages[1:]))
    named = mentions(plan, plan.processes[p])
    found = [list(run) for run in responses(plan, steps, named)]
    assert found == [steps[:4], *([step] for step in steps[4:])]


def test_where_nothing_is_held_all_mobilities_are_carried() -> None:
    plan = gathered(serial_chain(20))
    p, steps = carried(plan)
    process = plan.processes[p]
    free = tuple(step for step in process.steps if not isinstance(step, HoldMobility))
    assert any(isinstance(step, Send) for step in free)
    found = list(responses(plan, steps, mentions(plan, replace(process, steps=free))))
    assert found == [[step] for step in steps]
