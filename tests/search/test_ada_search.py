"""Form ada under the price that is played, against every place at which two processes may part."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.emit.shapes import predict
from adagen.model import Model
from adagen.paper.bounds import Rules
from adagen.paper.successors import Space
from adagen.paper.tie_break import Builder
from adagen.plan import make_plan
from adagen.schedule import Schedule, Topology, load_profile, makespan_of, validate
from adagen.schedule.chains import WHOLE
from adagen.schedule.search_result import Found
from adagen.search import find_schedule
from adagen.search.ada_search import played_schedule
from tests.models import random_tree, serial_chain, some_rubbing

PROFILE = load_profile("default")
JOINS = PROFILE.joins_only()


def played(model: Model, schedule: Schedule) -> float:
    return predict(make_plan(model, schedule, form="ada"), PROFILE, "joints").makespan


def well_formed(schedule: Schedule, model: Model) -> None:
    """Its tree is one of the robot's; its makespan is the played one, and not that of the tree."""
    validate(replace(schedule, makespan=makespan_of(schedule.root)), Topology.of(model))


def by_joins(model: Model, processes: int) -> Schedule:
    return find_schedule(Topology.of(model), processes, profile=JOINS)


def every_parting(model: Model) -> list[Schedule]:
    """All schedules whose two processes part at the root, each chain in the order of III-D."""
    topology = Topology.of(model)
    space = Space(topology, JOINS, Rules.of(2, "always"))
    found = []
    for position in range(len(topology)):
        builder = Builder(space)
        joint = space.chains.original[position]
        builder.draft.hang(-1, joint, False)
        builder.draft.ranges[joint] = (0, 2)
        root, end = space.chains.split(WHOLE, position)
        if not (space.chains.positions(root) and space.chains.positions(end)):
            continue
        builder.leaf(root, joint, False, (0, 1))
        builder.leaf(end, joint, True, (1, 2))
        found.append(Found(builder.draft, 0, 0).schedule(topology, 2, JOINS, "work"))
    return found


@pytest.mark.parametrize("seed", range(10))
def test_no_place_to_part_at_is_faster_on_two_processes(seed: int) -> None:
    rng = np.random.default_rng(seed)
    model = random_tree(rng, int(rng.integers(4, 13)), floating=seed % 2 == 0)
    model = some_rubbing(model, seed) if seed % 4 > 1 else model
    first = by_joins(model, 2)
    found = played_schedule(model, first, PROFILE)
    well_formed(found, model)
    assert found.makespan == pytest.approx(played(model, found))
    times = [played(model, each) for each in every_parting(model)]
    assert found.makespan <= min([played(model, first), *times]) + 1e-12
    assert found.lower_bound <= min([found.makespan, *times])


def test_the_chain_of_16_parts_elsewhere_than_eq_11_has_it() -> None:
    model = serial_chain(16)
    first = by_joins(model, 2)
    found = played_schedule(model, first, PROFILE)
    assert found.makespan < 0.92 * played(model, first)
    assert found.root.joint != first.root.joint


@pytest.mark.parametrize("processes", [1, 3, 4, 8])
def test_it_is_never_slower_than_what_eq_11_finds(processes: int) -> None:
    for model in (serial_chain(24), random_tree(np.random.default_rng(4), 20)):
        first = by_joins(model, processes)
        found = played_schedule(model, first, PROFILE)
        well_formed(found, model)
        assert found.processes == processes
        assert found.lower_bound <= found.makespan <= played(model, first) + 1e-12
