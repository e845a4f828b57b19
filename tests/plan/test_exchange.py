"""Form segment by pairwise exchanges: both sides of a cut join it."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace

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
from adagen.plan.types import Plan
from adagen.program import check
from adagen.program.check import ProgramError
from adagen.program.lower import lower
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule, schedule_from_json
from tests.emit.test_messages import unguarded
from tests.links import with_inertia
from tests.models import Part, assemble, random_inertia, random_tree, serial_chain, vector
from tests.plan.test_fused import balanced
from tests.plan.test_gather import by_process, error
from tests.schedules import random_schedule
from tests.slow import slow

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


def test_what_stands_on_the_ground_shows_others_nothing() -> None:
    """The last join is of a bare link with the ground; another process knows what stands there."""
    rng = np.random.default_rng(3)
    legs = {"a": None, "b1": None, "b2": "b1", "c": None}
    turned = vector(0.6, 0.8, 0.0)
    parts = [
        Part(name, above, REVOLUTE, random_inertia(rng), vector(0.1, 0.2, 0.3), axis=turned)
        for name, above in legs.items()
    ]
    model = assemble("legs", parts)
    inner = {"joint": "c", "processes": [0, 1]}, {"joint": "b2", "processes": [1, 2]}
    middle = {"joint": "b1", "processes": [0, 2], "children": inner}
    tree = {"joint": "a", "processes": [0, 2], "children": [middle]}
    text = json.dumps({"root": tree, "meeting": "exchange"})
    plan = make_plan(model, schedule_from_json(text, Topology.of(model), PROFILE))
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    assert error(model, plan) < 1e-11


def test_a_bare_link_is_shown_by_those_who_join_it() -> None:
    """The first process of its joint's node has nothing but what stands beside on the ground."""
    rng = np.random.default_rng(4)
    limbs = {"a": None, "a1": "a", "a2": "a1", "b": None, "c": "a"}
    parts = [
        Part(
            name,
            above,
            REVOLUTE,
            random_inertia(rng),
            vector(0.1, 0.2, 0.3),
            axis=vector(0.6, 0.8, 0),
        )
        for name, above in limbs.items()
    ]
    model = assemble("limbs", parts)
    inner = {"joint": "b", "processes": [0, 1]}, {"joint": "c", "processes": [1, 2]}
    middle = {"joint": "a", "processes": [0, 2], "children": inner}
    outer = {"joint": "a1", "processes": [0, 2], "children": [middle]}
    tree = {
        "joint": "a2",
        "processes": [0, 2],
        "children": [outer],
    }
    text = json.dumps({"root": tree, "meeting": "exchange"})
    plan = make_plan(model, schedule_from_json(text, Topology.of(model), PROFILE))
    for shape in ("kernels", "unrolled"):
        check(lower(plan, shape))
    assert error(model, plan) < 1e-11


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
        assert process.reads == process.owns  # and nobody passes others' joints
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
    waits = [in_a_row(p) for p in (plan, make_plan(model, pairs, meeting="exchange"))]
    assert waits[0] < waits[1]
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
def test_motions_are_told_outwards_and_how_joints_at_cuts_lie_with_mobilities(fan: int) -> None:
    """Nobody waits for how joints beyond its own move, or computes the ones that it only joins."""
    model = serial_chain(24)
    schedule = named_schedule("balanced", Topology.of(model), 8, profile=PROFILE)
    plan = make_plan(model, replace(schedule, fan=fan), meeting="exchange")
    for message in plan.messages:
        assert bool(message.passages) == (message.sweep == "kinematics")
        assert not message.passages or message.source < message.target
        firsts = {plan.processes[p].owns[0] for p in range(1, 8)}
        hangs_on = {block.row - 1 for block in message.blocks if block.row - 1 in firsts}
        assert set(message.placements) == hangs_on
    for p, process in enumerate(plan.processes):
        assert process.reads == process.owns
        assert {step.joint for step in process.steps_of(Kinematics)} == set(process.owns)
        arrived = [step.passage.link for step in process.steps_of(Arrive)]
        assert arrived[-1:] == [process.owns[0]] * (p > 0)
    # At the ground nobody waits before its own part is swept.
    first = plan.processes[0].steps
    begun = next(step for step in first if isinstance(step, Receive))
    assert plan.messages[begun.message].sweep == "assembly"


def test_what_comes_with_a_mobility_is_checked() -> None:
    """A joint of which nobody says how it lies cannot be joined."""
    model = serial_chain(12)
    schedule = named_schedule("balanced", Topology.of(model), 4, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="exchange")
    number = next(k for k, message in enumerate(plan.messages) if message.placements)
    messages = list(plan.messages)
    messages[number] = replace(messages[number], placements=())
    for shape in ("kernels", "unrolled"):
        with pytest.raises(ProgramError, match="transform"):
            check(lower(replace(plan, messages=tuple(messages)), shape))


def test_processes_without_work_stay_idle() -> None:
    model = serial_chain(12)
    schedule = named_schedule("balanced", Topology.of(model), 4, profile=PROFILE)
    plan = make_plan(model, replace(schedule, processes=6), meeting="exchange")
    assert [bool(process.steps) for process in plan.processes] == [True] * 4 + [False] * 2
    assert error(model, plan) < 1e-11


def in_a_row(plan: Plan) -> int:
    """Return how many passages are sent one after the other, each when the one before is there."""
    known = [0] * len(plan.processes)
    sent: dict[int, int] = {}
    told = [k for k, message in enumerate(plan.messages) if message.passages]
    steps = [
        [s for s in process.steps if isinstance(s, Send | Receive) and s.message in told]
        for process in plan.processes
    ]
    while any(steps):
        for p, own in enumerate(steps):
            while own and (isinstance(own[0], Send) or own[0].message in sent):
                step = own.pop(0)
                if isinstance(step, Send):
                    sent[step.message] = known[p] + 1
                else:
                    known[p] = max(known[p], sent[step.message])
    return max(sent.values())


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


@pytest.mark.parametrize(("processes", "most"), [(16, 8), (24, 9), slow(64, 11)])
def test_passages_are_told_on_where_many_wait_for_one(processes: int, most: int) -> None:
    """By itself, one of 64 processes would send 32 messages, one after the other."""
    model = serial_chain(3 * processes)
    schedule = named_schedule("balanced", Topology.of(model), processes, profile=PROFILE)
    plan = make_plan(model, schedule, meeting="exchange")
    check(lower(plan, "kernels"))
    assert error(model, plan) < 1e-9
    told = Counter(message.source for message in plan.messages if message.passages)
    assert max(told.values()) <= most
