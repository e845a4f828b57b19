"""The order of the statements in shape unrolled."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.emit.unrolled.arrangement import values_of
from adagen.emit.unrolled.order import (
    LIMIT,
    LIMIT_OF_BATCHES,
    LIMIT_OF_LONG,
    Pace,
    by_step,
    by_waits,
    in_functions,
    limit_of_functions,
)
from adagen.executor import simulate
from adagen.graph import Graph, live_nodes
from adagen.plan import make_plan
from adagen.plan.steps import Kinematics
from adagen.plan.types import Process
from adagen.schedule import step_costs
from adagen.schedule.costs import ASSUMED
from tests.emitted import plan_of
from tests.models import random_tree, serial_chain
from tests.schedules import random_schedule

SHIPPED = step_costs(None)
COSTS = replace(SHIPPED, table={**SHIPPED.table, **ASSUMED})  # every line by what waits
CACHE, AHEAD = COSTS["unrolled.cache"], int(COSTS["unrolled.ahead"])


def most_alive(graph: Graph, order: Sequence[int]) -> int:
    """Return how many values are alive at most: computed, and yet to be used."""
    turn = {k: n for n, k in enumerate(order)}
    last = dict(turn)
    for user in order:
        last.update({k: turn[user] for k in graph.nodes[user].args if k in turn})
    ends = np.bincount(list(last.values()), minlength=len(order))
    return int((np.arange(1, len(order) + 1) - np.cumsum(ends)).max())


@settings(max_examples=25)
@given(seed=st.integers(0, 10**6), processes=st.integers(1, 3), batch=st.booleans())
def test_everything_is_computed_once_and_after_what_it_uses(
    seed: int, processes: int, batch: bool
) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, int(rng.integers(1, 6)), floating=bool(rng.integers(2)))
    form = ("segment", "ada")[seed % 2]
    plan = make_plan(model, random_schedule(model, processes, rng), form=form)
    for one, process in zip(simulate(plan), plan.processes, strict=True):
        graph = one.machine.graph
        live = live_nodes(graph, one.machine.roots())
        values = {k for k in live if graph.nodes[k].op not in ("constant", "input")}
        order = by_step(graph, process, values)
        if not batch:
            order = by_waits(graph, order, Pace.of(one.operations, len(values), COSTS))
        assert sorted(order) == sorted(values)
        turn = {k: n for n, k in enumerate(order)}
        assert all(turn[a] < turn[k] for k in order for a in graph.nodes[k].args if a in turn)


@pytest.mark.parametrize("joints", [12, 40])
def test_what_a_link_takes_is_computed_while_its_motion_is_at_hand(joints: int) -> None:
    plan = plan_of(serial_chain(joints), 1)
    one = simulate(plan)[0]
    graph = one.machine.graph
    live = live_nodes(graph, one.machine.roots())
    values = {k for k in live if graph.nodes[k].op not in ("constant", "input")}
    order = by_step(graph, plan.processes[0], values)
    assert most_alive(graph, order) < 0.8 * most_alive(graph, sorted(values))


def test_of_a_single_state_what_most_waits_for_comes_first() -> None:
    graph = Graph()
    x = graph.input("x")
    short = [x + k for k in range(1, 81)]
    power = [x * x]
    for _ in range(40):
        power.append(power[-1] * x)
    values = {value.index for value in (*short, *power)}
    steps = by_step(graph, Process(steps=(Kinematics(0),), reads=(0,), owns=(0,)), values)
    assert steps == sorted(values)
    order = by_waits(graph, steps, Pace(1.0, 2.0, CACHE, AHEAD))
    assert order[0] == power[0].index
    assert set(order[-3:]) == {value.index for value in power[-3:]}
    # Waiting that takes no time: the chain is not begun late all the same.
    busy = by_waits(graph, steps, Pace(1.0, 0.0, CACHE, AHEAD))
    assert busy[:40] == [value.index for value in power[:40]]


def test_nothing_far_ahead_is_begun_early() -> None:
    """What is alive at once stays bounded, however long the stretch."""
    graph = Graph()
    x = graph.input("x")
    ends = []
    for k in range(4 * AHEAD // 10):  # the later, the more waits for its first value
        value = x + k
        for _ in range(9):
            value = value * x
        ends.append(value)
    total = ends[0]
    for value in ends[1:]:
        total = total + value
    values = set(live_nodes(graph, [total])) - {x.index}
    values = {k for k in values if graph.nodes[k].op != "constant"}
    process = Process(steps=(Kinematics(0),), reads=(0,), owns=(0,))
    order = by_waits(graph, by_step(graph, process, values), Pace(1.0, 1.0, CACHE, AHEAD))
    assert sorted(order) == sorted(values)
    late = max(turn - n for n, turn in enumerate(order_of(order, sorted(values))))
    assert late <= AHEAD + 100


@pytest.mark.parametrize(("cycle", "waits"), [(1.0, False), (20.0, True)])
def test_in_several_functions_waiting_has_to_count(cycle: float, waits: bool) -> None:
    plan = plan_of(serial_chain(12), 1)
    one = simulate(plan)[0]
    graph, process = one.machine.graph, plan.processes[0]
    live = live_nodes(graph, one.machine.roots())
    values = {k for k in live if graph.nodes[k].op not in ("constant", "input")}
    pace = Pace(2.0, cycle, CACHE, AHEAD)
    steps = in_functions(graph, process, values, 1000, None)
    assert [k for cut in steps for k in cut] == by_step(graph, process, values)
    cuts = in_functions(graph, process, values, 1000, pace)
    assert len(cuts) > 1
    assert list(map(sorted, cuts)) == list(map(sorted, steps))
    assert (cuts != steps) == waits
    (alone,) = in_functions(graph, process, values, len(values), pace)
    assert alone == by_waits(graph, by_step(graph, process, values), pace)


def test_functions_are_cut_where_the_fewest_values_are_alive() -> None:
    """Of all divisions into functions that are long enough, none has fewer values alive at cuts."""
    plan = plan_of(serial_chain(3), 1)
    one = simulate(plan)[0]
    graph, process = one.machine.graph, plan.processes[0]
    live = live_nodes(graph, one.machine.roots())
    values = {k for k in live if graph.nodes[k].op not in ("constant", "input")}
    order = by_step(graph, process, values)
    longest, least = 100, 60
    found = in_functions(graph, process, values, longest, None)
    assert [k for function in found for k in function] == order
    assert all(least <= len(function) <= longest for function in found[:-1])
    assert len(found[-1]) <= longest
    turns = {k: turn for turn, k in enumerate(order)}
    last = dict(turns)
    for k in order:
        for operand in graph.nodes[k].args:
            if operand in turns:
                last[operand] = max(last[operand], turns[k])
    alive = [sum(turns[k] < place <= last[k] for k in order) for place in range(len(order) + 1)]
    best = [0.0] + [float("inf")] * len(order)
    for end in range(1, len(order) + 1):
        shortest = least if end < len(order) else 1
        for begin in range(max(0, end - longest), end - shortest + 1):
            best[end] = min(best[end], best[begin] + alive[end])
    ends = list(accumulate(map(len, found)))
    assert sum(alive[end] for end in ends) == best[-1]
    assert sum(alive[k] for k in range(longest, len(order), longest)) > best[-1]


def test_a_profile_may_keep_the_order_of_steps() -> None:
    plan = plan_of(serial_chain(6), 1)
    one = simulate(plan)[0]
    graph = one.machine.graph
    live = live_nodes(graph, one.machine.roots())
    values = {k for k in live if graph.nodes[k].op not in ("constant", "input")}
    pace = Pace(1.0, 20.0, CACHE, 0)
    (kept,) = in_functions(graph, plan.processes[0], values, len(values), pace)
    assert kept == by_step(graph, plan.processes[0], values)
    (other,) = in_functions(graph, plan.processes[0], values, len(values), replace(pace, ahead=9))
    assert other != kept and sorted(other) == sorted(kept)


def test_long_lines_may_keep_the_order_of_steps_where_short_ones_do_not() -> None:
    (short,), (long,) = (simulate(plan_of(serial_chain(n), 1)) for n in (3, 9))
    few, many = len(values_of(short)), len(values_of(long))
    costs = replace(COSTS, table={**COSTS.table, "unrolled.urgent": float(few)})
    assert Pace.of(short.operations, few, costs).ahead == AHEAD
    assert Pace.of(long.operations, many, costs).ahead == 0
    assert Pace.of(long.operations, many, COSTS).ahead == AHEAD


def test_long_lines_have_short_functions() -> None:
    pace = Pace(1.0, 1.0, CACHE, AHEAD)
    assert limit_of_functions(8000, pace) == LIMIT
    assert limit_of_functions(9000, pace) == LIMIT_OF_LONG < LIMIT
    assert limit_of_functions(4000, pace, short=True) == LIMIT_OF_LONG
    half = Pace(1.0, 1.0, CACHE / 2, AHEAD)
    assert limit_of_functions(4000, half) == LIMIT
    assert limit_of_functions(4500, half) == LIMIT_OF_LONG
    assert limit_of_functions(9000, None) == LIMIT_OF_BATCHES


def order_of(order: Sequence[int], by_turn: Sequence[int]) -> list[int]:
    """Return the turn in one order of each value of another."""
    turn = {k: n for n, k in enumerate(by_turn)}
    return [turn[k] for k in order]
