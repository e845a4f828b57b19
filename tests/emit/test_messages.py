"""No message overwrites one that was not read yet, however evaluations follow one another.

A message lives in a place of its own that is written anew in the next evaluation. That is safe
only if every process that writes it knows, from what it received, that the last one was read.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.emit.processes import message_size
from adagen.emit.words import Words
from adagen.model import Model
from adagen.plan import FORMS, Plan, make_plan
from adagen.plan.steps import Receive, Send
from tests.models import random_tree, serial_chain
from tests.schedules import random_schedule

Event = tuple[int, str, int]  # evaluation, "send" or "receive", message


def unguarded(plan: Plan) -> list[int]:
    """Return the messages whose next writing does not come after their reading."""
    before: dict[Event, set[Event]] = {}
    for process in plan.processes:
        last: Event | None = None
        for evaluation in range(2):
            for step in process.steps:
                if isinstance(step, Send | Receive):
                    what = "send" if isinstance(step, Send) else "receive"
                    event = (evaluation, what, step.message)
                    before[event] = {last} if last else set()
                    if what == "receive":
                        before[event].add((evaluation, "send", step.message))
                    last = event
    wrong = []
    for number in range(len(plan.messages)):
        seen, waiting = set[Event](), [(1, "send", number)]
        while waiting:
            event = waiting.pop()
            if event not in seen:
                seen.add(event)
                waiting += before[event]
        if (0, "receive", number) not in seen:
            wrong.append(number)
    return wrong


@pytest.mark.parametrize("form", FORMS)
@settings(max_examples=60, deadline=None)
@given(st.integers(1, 10), st.integers(1, 6), st.integers(0, 3), st.integers(0, 2**32 - 1))
def test_every_message_is_read_before_its_place_is_written_again(
    form: str, joints: int, processes: int, mimics: int, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, joints, mimics=mimics, branching=0.6)
    model = grounded(model, rng)
    plan = make_plan(model, random_schedule(model, processes, rng), form=form)
    assert unguarded(plan) == []
    assert all(message_size(Words(plan), message) > 0 for message in plan.messages)


def test_the_check_sees_what_it_is_for() -> None:
    model = serial_chain(6)
    plan = make_plan(model, random_schedule(model, 3, np.random.default_rng(1)))
    down = [k for k, message in enumerate(plan.messages) if message.sweep == "disassembly"]
    assert down
    lossy = replace(
        plan,
        processes=tuple(
            replace(process, steps=tuple(s for s in process.steps if s != Receive(down[0])))
            for process in plan.processes
        ),
    )
    assert unguarded(lossy)


def grounded(model: Model, rng: np.random.Generator) -> Model:
    """Return the model with some joints moved onto the ground: subtrees that meet only there."""
    joints = [replace(joint, parent=0) if rng.random() < 0.3 else joint for joint in model.joints]
    return replace(model, joints=tuple(joints))
