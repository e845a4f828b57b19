"""Batches that process 0 hands out, played through: what bounds them, and by what."""

from __future__ import annotations

import pytest

from adagen.cost.handout import Batch, Helper, handed_out
from adagen.schedule.costs import ChannelCosts

NEAR = Helper(ChannelCosts(0.0, 0.0, 0.0), far=False)
LAN = Helper(ChannelCosts(1.0, 20.0, 0.01), far=True)


def test_one_process_takes_all_states_one_after_the_other() -> None:
    found = handed_out(Batch(1000, 0.5, 30, 10), [])
    assert found.makespan == pytest.approx(500) == pytest.approx(found.computing)
    assert (found.link, found.handing, found.limit) == (0, 0, "computing")


@pytest.mark.parametrize("count", [1, 3, 15, 255])
def test_where_messages_cost_nothing_all_share_alike(count: int) -> None:
    states = 20000
    found = handed_out(Batch(states, 1.0, 30, 10), [NEAR] * count)
    assert found.makespan == pytest.approx(states / (count + 1), rel=0.1)
    assert found.makespan >= found.computing
    assert found.limit == "computing"


def test_a_link_is_as_fast_as_its_numbers() -> None:
    batch = Batch(50000, 1.0, 1000, 10)  # 10 us to send a state that takes 1 us
    found = handed_out(batch, [LAN] * 8)
    assert found.limit == "the link of process 0's host"
    assert found.makespan >= found.link > found.computing
    near = handed_out(batch, [Helper(LAN.costs, far=False)] * 8)
    assert (near.link, near.limit) == (0, "process 0, which hands out")


def test_long_work_hides_latency_and_short_work_does_not() -> None:
    long = handed_out(Batch(10000, 50.0, 30, 10), [LAN] * 3)
    assert long.computing <= long.makespan < 1.15 * long.computing  # the last pieces
    assert long.limit == "computing"
    few = handed_out(Batch(64, 0.1, 30, 10), [LAN] * 3)
    assert few.makespan > 40 and few.limit == "latency, and the batch's end"
