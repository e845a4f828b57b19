"""Schedules of form segment under measured costs: exact against enumeration, and below the plan."""

from __future__ import annotations

import numpy as np
import pytest

from adagen.plan import make_plan
from adagen.predict import predict
from adagen.schedule import Topology, find_schedule, makespan_of, preorder, validate
from adagen.schedule.chains import WHOLE, Chain
from adagen.schedule.profile import TICKS
from adagen.schedule.segments import SegmentCosts
from tests.models import human_figure, random_tree, serial_chain, star
from tests.predict.costs import step_profile

PROFILE = step_profile(
    (),
    process__evaluation=0.05,
    root__invert=0.08,
    articulate__revolute=0.06,
    join__revolute=0.15,
    # What the search leaves out is small on any machine: roots below their joints.
    articulate__reversed=0.003,
    propagate__reversed=0.003,
    deliver__reversed=0.003,
    accelerate__reversed=0.003,
)


def brute(costs: SegmentCosts, chain: Chain, processes: int) -> int:
    """Return the best time over all cuts and all divisions of the processes."""
    best = costs.price(chain).total
    for position in costs.chains.positions(chain) if processes > 1 else []:
        root, end = costs.chains.split(chain, position)
        if not (costs.chains.positions(root) and costs.chains.positions(end)):
            continue
        for first in range(1, processes):
            a, b = brute(costs, root, first), brute(costs, end, processes - first)
            away = costs.transit(root), costs.transit(end)
            together = min(max(a, b + away[1]), max(b, a + away[0]))
            best = min(best, costs.cut(chain, position) + together)
    return best


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("processes", [1, 2, 3, 4])
def test_the_search_is_exact(seed: int, processes: int) -> None:
    model = random_tree(np.random.default_rng(seed), 8, floating=seed % 3 == 0)
    topology = Topology.of(model)
    found = find_schedule(topology, processes, profile=PROFILE)
    truth = brute(SegmentCosts(topology, PROFILE), WHOLE, processes) / TICKS
    assert found.verdict == "optimal"
    assert found.makespan == pytest.approx(truth, abs=1e-9)
    assert makespan_of(found.root) == found.makespan
    validate(found, topology)


@pytest.mark.parametrize("processes", [1, 2, 4, 6, 8])
def test_the_plan_never_takes_less_than_is_proven(processes: int) -> None:
    for model in (human_figure(), serial_chain(20), star(6, 3), serial_chain(12, floating=True)):
        found = find_schedule(Topology.of(model), processes, profile=PROFILE)
        line = predict(make_plan(model, found, form="segment"), PROFILE)
        assert line.makespan >= found.lower_bound * (1 - 1e-9)
        assert line.makespan < 1.25 * found.makespan


def test_fewer_expansions_leave_a_gap_that_is_told() -> None:
    topology = Topology.serial(60)
    found = find_schedule(topology, 8, profile=PROFILE, expansions=3)
    best = find_schedule(topology, 8, profile=PROFILE)
    assert found.verdict == "gap" and found.lower_bound <= best.makespan <= found.makespan
    assert found.gap == pytest.approx(found.makespan / found.lower_bound - 1)


def test_joints_that_must_not_be_cut_are_not() -> None:
    topology = Topology.serial(16)
    free = find_schedule(topology, 2, profile=PROFILE)
    allowed = [j != free.root.joint for j in range(16)]
    found = find_schedule(topology, 2, profile=PROFILE, cuttable=allowed)
    assert found.root.joint != free.root.joint and found.makespan >= free.makespan
    none = find_schedule(topology, 2, profile=PROFILE, cuttable=[False] * 16)
    assert {node.processes[0] for node in preorder(none.root)} == {0}


def test_small_robots_leave_processes_idle() -> None:
    dear = step_profile((), join__revolute=3.0, disassemble__revolute=3.0)
    found = find_schedule(Topology.serial(6), 4, profile=dear)
    assert found.makespan == find_schedule(Topology.serial(6), 1, profile=dear).makespan
