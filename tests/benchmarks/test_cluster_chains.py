"""Chains on the processes of a cluster: predicted times and what they consist of."""

from __future__ import annotations

from dataclasses import replace

import pytest

from adagen.cost import timeline
from adagen.emit.shapes import predict, priced_program
from adagen.plan import make_plan
from adagen.schedule import load_profile
from adagen.schedule.fat_tree import parse_fabric
from adagen.search import best_schedule
from benchmarks.cluster_chains import Chain
from benchmarks.critical_path import JOINTS, KINDS, LATENCY, limits
from tests.models import human_figure, serial_chain
from tests.slow import slow

PROFILE = load_profile("default")
LEVELS = """
[[level]]
name = "node"
size = 4
[[level]]
name = "switch"
size = 4
send = 0.1
latency = {latency}
number = 0.001
"""


@pytest.mark.parametrize(
    ("figure", "processes"),
    [
        *(("chain", 1), ("chain", 2), ("human", 4)),
        *(slow("chain", 4), slow("human", 1), slow("human", 2)),
    ],
)
def test_the_way_back_takes_the_whole_time(figure: str, processes: int) -> None:
    model = serial_chain(150) if figure == "chain" else human_figure()
    plan = make_plan(model, best_schedule(model, processes, PROFILE))
    program = priced_program(plan, profile=PROFILE)
    line = timeline(program, PROFILE)
    found = limits(program, line)
    assert sum(found.times.values()) == pytest.approx(line.makespan)
    assert set(found.times) == set(KINDS) and min(found.times.values()) >= 0
    if processes == 1:
        assert found.hops == 0 and found.times[LATENCY] == 0 and found.most == JOINTS


@pytest.mark.slow
def test_a_chain_within_a_node_is_played_as_on_one_machine() -> None:
    model = serial_chain(300)
    chain, fabric = Chain(model, PROFILE), parse_fabric(LEVELS.format(latency=50), "x")
    four = chain.on(4, fabric.links)
    assert four is not None
    found = best_schedule(model, 4, PROFILE, in_parts=True)
    assert four.time == pytest.approx(found.makespan, rel=0.02)
    assert sum(four.limits.times.values()) == pytest.approx(four.time)
    one = replace(best_schedule(model, 1, PROFILE, in_parts=True), shape="kernels")
    assert one.parts == 8
    assert chain.alone() == predict(make_plan(model, one), PROFILE).makespan > four.time


def test_latency_between_nodes_is_what_limits_in_the_end() -> None:
    chain = Chain(serial_chain(300), PROFILE)
    near = chain.on(16, parse_fabric(LEVELS.format(latency=0), "x").links)
    far = chain.on(16, parse_fabric(LEVELS.format(latency=50), "x").links)
    assert near is not None and far is not None
    assert far.time > near.time + 2 * 50  # two levels of pairs are on different nodes
    assert far.limits.most == LATENCY != near.limits.most


def test_processes_without_joints_are_not_predicted() -> None:
    fabric = parse_fabric(LEVELS.format(latency=1), "x")
    assert Chain(serial_chain(20), PROFILE).on(16, fabric.links) is None
