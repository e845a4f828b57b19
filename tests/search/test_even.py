"""Robots cut so that no segment takes longer than must be."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from adagen.plan import make_plan
from adagen.schedule import Topology, load_profile, validate
from adagen.schedule.segment_costs import SegmentCosts
from adagen.search import find_schedule
from adagen.search.equal_segments import even_cuts
from tests.models import random_tree, serial_chain

DEFAULT = load_profile("default")
assert DEFAULT.steps is not None
LOOPS = replace(
    DEFAULT, steps=replace(DEFAULT.steps, table={**DEFAULT.steps.table, "kinematics.step": 0.0})
)
"""As the search prices loops: no joint's kinematics are a call of their own."""


@settings(max_examples=40)
@given(st.integers(2, 40), st.integers(2, 8), st.booleans(), st.integers(0, 2**32 - 1))
def test_there_are_no_more_segments_than_asked_for(
    joints: int, segments: int, floating: bool, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    topology = Topology.of(random_tree(rng, joints, branching=0.4, floating=floating))
    costs = SegmentCosts(topology, DEFAULT)
    cuttable = rng.random(len(topology)) < 0.7
    cuts = even_cuts(costs, cuttable, segments)
    assert len(cuts) < segments and len(set(cuts)) == len(cuts)
    assert all(cuttable[p] for p in cuts)


@pytest.mark.parametrize("segments", [5, 8])
def test_the_outermost_segment_of_a_long_chain_is_the_longest(segments: int) -> None:
    """It carries no mobility: one process passes several times as many joints as those within."""
    costs = SegmentCosts(Topology.of(serial_chain(500)), DEFAULT)
    cuts = even_cuts(costs, np.ones(500, dtype=np.bool_), segments)
    sizes = np.diff([0, *sorted(cuts), 500]).tolist()
    assert len(sizes) == segments
    assert sizes[-1] > 1.5 * max(sizes[:-1])
    assert sizes[1:-1] == sorted(sizes[1:-1], reverse=True)  # who is further out passes more


@pytest.mark.parametrize("segments", [5, 8])
def test_inner_segments_are_about_as_long_as_each_other(segments: int) -> None:
    costs = SegmentCosts(Topology.of(serial_chain(500)), LOOPS)
    cuts = even_cuts(costs, np.ones(500, dtype=np.bool_), segments)
    sizes = np.diff([0, *sorted(cuts), 500])
    assert sizes[1:-1].max() < 1.5 * sizes[1:-1].min()


def test_even_cuts_share_a_chain_among_all_processes() -> None:
    model = serial_chain(1200)
    found = find_schedule(Topology.of(model), 8, profile=DEFAULT, expansions=64)
    validate(found, Topology.of(model))
    assert all(process.owns for process in make_plan(model, found).processes)
