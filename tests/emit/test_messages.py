"""No message overwrites one that was not read yet, however evaluations follow one another.

A message lives in two places of its own, taken in turn: each is written anew two evaluations later.
That is safe only if every process that writes it knows, from what it received, that it was read.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.emit.messages import message_size
from adagen.emit.symbols import Symbols
from adagen.model import Model
from adagen.plan import MEETINGS, Plan, make_plan
from adagen.plan.steps import Receive, Send
from adagen.program import lower
from adagen.program.message_reuse import overwritten
from adagen.schedule import Topology, load_profile
from adagen.search import find_schedule, named_schedule
from tests.models import random_tree, serial_chain
from tests.schedules import random_schedule


def unguarded(plan: Plan) -> list[int]:
    """Return the messages whose next writing does not come after their reading."""
    operations = [process.operations for process in lower(plan, "unrolled").processes]
    return overwritten(plan.messages, operations)


PROFILE = load_profile("default")
WAYS = [("ada", "join"), *(("segment", meeting) for meeting in MEETINGS)]


@pytest.mark.parametrize(("form", "meeting"), WAYS)
@settings(max_examples=60)
@given(st.integers(1, 10), st.integers(1, 6), st.integers(0, 3), st.integers(0, 2**32 - 1))
def test_every_message_is_read_before_its_place_is_written_again(
    form: str, meeting: str, joints: int, processes: int, mimics: int, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    takes_mimics = meeting not in ("gather", "exchange")
    model = random_tree(rng, joints, mimics=mimics * takes_mimics, branching=0.6)
    model = grounded(model, rng)
    plan = make_plan(model, random_schedule(model, processes, rng), form=form, meeting=meeting)
    assert unguarded(plan) == []
    assert unguarded(plan.recovering()) == []
    symbols = Symbols(lower(plan, "unrolled"))
    assert all(message_size(symbols, message) > 0 for message in plan.messages)


def test_messages_of_another_way_are_guarded_too() -> None:
    """In the second pose in which the ground cannot be taken for a body, and so on."""
    schedule = named_schedule("balanced", Topology.of(serial_chain(20)), 2, profile=PROFILE)
    plan = make_plan(serial_chain(20), schedule, meeting="gather")
    again = plan.recovering()
    sent = {step.message for p in again.processes for step in p.steps if isinstance(step, Send)}
    assert sent.isdisjoint(
        s.message for p in plan.processes for s in p.steps if isinstance(s, Send)
    )
    assert sent
    assert unguarded(again) == []


def test_the_check_sees_what_it_is_for() -> None:
    model = serial_chain(6)
    schedule = random_schedule(model, 3, np.random.default_rng(1))
    plan = make_plan(model, schedule, meeting="join")
    down = [k for k, message in enumerate(plan.messages) if message.sweep == "disassembly"]
    assert down
    assert unguarded(without_receiving(plan, down[0]))


def test_the_check_sees_an_exchange_that_goes_one_way() -> None:
    """Both processes of an exchange send first, which a single place would not stand."""
    model = serial_chain(6)
    schedule = find_schedule(Topology.of(model), 2, profile=load_profile("paper"))
    plan = make_plan(model, schedule, meeting="gather")
    assert [message.sweep for message in plan.messages] == ["assembly", "assembly"]
    assert unguarded(plan) == []
    assert unguarded(without_receiving(plan, 0))


def without_receiving(plan: Plan, message: int) -> Plan:
    """Return a plan in which a message is not waited for."""
    return replace(
        plan,
        processes=tuple(
            replace(process, steps=tuple(s for s in process.steps if s != Receive(message)))
            for process in plan.processes
        ),
    )


def grounded(model: Model, rng: np.random.Generator) -> Model:
    """Return the model with some joints moved onto the ground: subtrees that meet only there."""
    joints = [replace(joint, parent=0) if rng.random() < 0.3 else joint for joint in model.joints]
    return replace(model, joints=tuple(joints))
