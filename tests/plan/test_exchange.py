"""Form segment by pairwise exchanges: both sides of a cut join it."""

from __future__ import annotations

from dataclasses import replace
from itertools import groupby

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.errors import UsageError
from adagen.model import Inertia
from adagen.model.kinds import REVOLUTE, SPHERICAL, JointKind
from adagen.plan import make_plan, plan_from_json, plan_to_json
from adagen.plan.steps import (
    Append,
    Arrive,
    Kinematics,
    Passage,
    Receive,
    Send,
    Step,
    Traverse,
)
from adagen.plan.types import Plan, Process
from adagen.program import check
from adagen.program.lower import lower
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from tests.emit.test_messages import unguarded
from tests.links import with_inertia
from tests.models import random_tree, serial_chain
from tests.plan.test_fused import balanced
from tests.plan.test_gather import by_process, error
from tests.schedules import random_schedule

PROFILE = load_profile("default")


@settings(max_examples=8)
@given(st.integers(1, 12), st.integers(1, 8), st.booleans(), st.integers(0, 2**32 - 1))
def test_any_schedule_of_any_tree_can_exchange(
    joints: int, processes: int, floating: bool, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, branching=0.6, floating=floating)
    plan = make_plan(model, random_schedule(model, processes, rng), meeting="exchange")
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    assert error(model, plan) < 1e-8


@pytest.mark.parametrize(
    ("joints", "processes", "kind"), [(9, 4, REVOLUTE), (13, 5, REVOLUTE), (7, 3, SPHERICAL)]
)
def test_motions_of_a_serial_chain_are_told(joints: int, processes: int, kind: JointKind) -> None:
    model = serial_chain(joints, kind=kind)
    schedule = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="exchange")
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    assert error(model, plan) < 1e-11
    assert unguarded(plan) == []
    for process in plan.processes:
        told = [step for step in process.steps if isinstance(step, Traverse)]
        assert len(told) == 1  # nobody asks how the outermost part moves, but it waits meanwhile
        cuts = sum(len(path.shares) for path in plan.processes) // processes + 1
        assert len(process.reads) <= len(process.owns) + cuts  # and nobody passes others' joints
    assert plan_from_json(plan_to_json(plan)) == plan


@pytest.mark.parametrize("processes", [4, 5, 8])
@pytest.mark.parametrize("fan", [4, 16])
def test_several_groups_put_their_passages_together_at_once(processes: int, fan: int) -> None:
    """Nobody waits for as many messages one after the other, or is told what it does not need."""
    model = serial_chain(3 * processes)
    pairs = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    plan = make_plan(model, replace(pairs, fan=fan), meeting="exchange")
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    assert error(model, plan) < 1e-11
    assert unguarded(plan) == []
    turns = [passage_turns(p) for p in (plan, make_plan(model, pairs, meeting="exchange"))]
    assert turns[0] < turns[1]
    for process in plan.processes:
        told = {
            passage
            for step in process.steps
            if isinstance(step, Receive)
            for passage in plan.messages[step.message].passages
        }
        used = {passage for step in process.steps for passage in used_by(step)}
        assert told <= used


@pytest.mark.parametrize("fan", [2, 8])
def test_what_a_process_only_joins_is_asked_for_while_it_waits(fan: int) -> None:
    model = serial_chain(24)
    schedule = named_schedule("balanced", Topology.of(model), 8, profile=PROFILE)
    plan = make_plan(model, replace(schedule, fan=fan), meeting="exchange")
    for process in plan.processes:
        told = next(
            k
            for k, step in enumerate(process.steps)
            if isinstance(step, Send) and plan.messages[step.message].sweep == "assembly"
        )
        placed = {s.joint for s in process.steps[:told] if isinstance(s, Kinematics)}
        assert placed == set(process.owns)
        arrived = [s.passage.link for s in process.steps[:told] if isinstance(s, Arrive)]
        assert process.owns[0] in arrived or process.owns[0] == 0
    # At the ground nobody waits before its own part is swept, unless others ask it for more.
    early = plan.processes[0].steps[: plan.processes[0].steps.index(Kinematics(0))]
    assert any(isinstance(step, Receive) for step in early) == (fan == 2)


def test_processes_without_work_stay_idle() -> None:
    model = serial_chain(12)
    schedule = named_schedule("balanced", Topology.of(model), 4, profile=PROFILE)
    plan = make_plan(model, replace(schedule, processes=6), meeting="exchange")
    assert [bool(process.steps) for process in plan.processes] == [True] * 4 + [False] * 2
    assert error(model, plan) < 1e-11


def passage_turns(plan: Plan) -> int:
    """Return how many times a process sends passages again after it has waited, at the most."""
    return max(
        len(list(groupby(own)))
        for process in plan.processes
        if (
            own := [
                type(s) for s in process.steps[: _first(process)] if isinstance(s, Send | Receive)
            ]
        )
    )


def _first(process: Process) -> int:
    return next(k for k, step in enumerate(process.steps) if isinstance(step, Kinematics))


def used_by(step: Step) -> tuple[Passage, ...]:
    match step:
        case Append(_, near, far):
            return near, far
        case Arrive(passage, _):
            return (passage,)
    return ()


def test_exchanges_take_as_many_messages_as_there_are_levels() -> None:
    """On 8 processes each sends three times what it shows, and three times how it moves at most."""
    model = serial_chain(24)
    schedule = named_schedule("balanced", Topology.of(model), 8, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="exchange")
    assert {message.sweep for message in plan.messages} == {"kinematics", "assembly"}
    for p, process in enumerate(plan.processes):
        sent = [plan.messages[s.message] for s in process.steps if isinstance(s, Send)]
        taken = [plan.messages[s.message] for s in process.steps if isinstance(s, Receive)]
        for own in (sent, taken):
            assert sum(message.sweep == "assembly" for message in own) == 3
        assert {m.target for m in sent if m.sweep == "assembly"} == {p ^ 1, p ^ 2, p ^ 4}


def test_a_joint_that_a_process_only_joins_is_another_ones() -> None:
    model = serial_chain(16)
    schedule = named_schedule("balanced", Topology.of(model), 4, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="exchange")
    assert sorted(j for process in plan.processes for j in process.owns) == list(range(16))
    assert all(process.shares for process in plan.processes)
    kinds = {type(step) for process in plan.processes for step in process.steps}
    assert {Arrive, Kinematics} <= kinds


def test_slaved_joints_do_not_exchange() -> None:
    model = random_tree(np.random.default_rng(3), 6, mimics=1)
    with pytest.raises(UsageError, match="cannot exchange pair by pair: joint"):
        make_plan(model, by_process(model, 2), meeting="exchange")


def test_joints_past_links_without_mass_do_not_exchange() -> None:
    model = with_inertia(serial_chain(8), 3, Inertia.zero())
    with pytest.raises(UsageError, match="past links without mass"):
        make_plan(model, balanced(model, 2, "segment"), meeting="exchange")
