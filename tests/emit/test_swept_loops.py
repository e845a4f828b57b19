"""Residuals of robots with closed loops that a loop over records of joints sweeps."""

from __future__ import annotations

import ctypes
from dataclasses import replace

import numpy as np
import pytest

from adagen.build import Toolchain
from adagen.emit import emit, stem_of
from adagen.executor import Swept, chosen_grouping, simulate
from adagen.model import Model
from adagen.plan import Plan
from adagen.plan.certificate import looped
from adagen.plan.steps import Certify
from adagen.states import States
from adagen.studies.stability.loaded import loaded
from benchmarks.closed_robots import MECHANISMS
from benchmarks.stability.bounds import Certified, bounded, certified_plan
from benchmarks.stability.mechanisms import FAMILIES, mechanisms, worst_states
from tests.emitted import Builder
from tests.slow import only, slow, spread

ALL = 1000  # rows: more than there are
LINE, LOOP, PART = (Certified("unrolled", looped=rows) for rows in (0, ALL, 2))
RANDOM = dict(enumerate(mechanisms(2 * len(FAMILIES), 7)))


@pytest.fixture(scope="module")
def quick(builder: Builder) -> Toolchain:
    return builder.quick


def _model(name: int | str) -> Model:
    return MECHANISMS[name]() if isinstance(name, str) else RANDOM[name][1]


def _states(model: Model, count: int, seed: int) -> States:
    """Half of them as near singular ones as are found, at all speeds."""
    found = worst_states(model, count, seed)
    fast, strong = 10.0 ** np.random.default_rng(seed).uniform(-2, 2, size=(2, found.count, 1))
    return States(found.q, found.v * fast, found.tau * strong)


def _in_loop(model: Model) -> Plan:
    plan = looped(certified_plan(model), ALL)
    assert plan is not None
    return plan


def _swept(plan: Plan) -> Swept:
    (line,) = simulate(plan, chosen_grouping(plan))
    assert line.machine.swept is not None
    return line.machine.swept


@pytest.mark.parametrize(
    "name",
    [
        "leg with a parallel ankle",
        *only(RANDOM, 0, 7),  # others take longest to compile
        *(slow(f"{name} feet") for name in ("g1 on both", "talos on both", "a1 on four point")),
    ],
    ids=lambda name: str(name if isinstance(name, str) else RANDOM[name][0]),
)
def test_bounds_are_those_without_a_loop(name: int | str, quick: Toolchain) -> None:
    """Also of poses that are solved again in another way."""
    model = _model(name)
    found = bounded(model, _states(model, 16, seed=5), [LINE, LOOP, PART], quick)
    assert found[LINE].errors.size > 0
    for way in (LOOP, PART):
        assert found[way].refused == found[LINE].refused
        assert (found[way].ratios <= 3).all()
        np.testing.assert_allclose(found[way].bounds, found[LINE].bounds, rtol=0.3)
        np.testing.assert_allclose(found[way].errors, found[LINE].errors, rtol=1e-6)


@pytest.mark.parametrize("name", ["a1 on four point feet", *spread(range(6), 1)])
def test_poses_that_are_solved_again_leave_nothing_behind(
    name: int | str, quick: Toolchain
) -> None:
    """Nor do states that are not finite: what the loop finds in memory is its own."""
    model = _model(name)
    plan = _in_loop(model)
    text, stem = emit(plan, shape="unrolled")[f"{stem_of(plan)}.cpp"], stem_of(plan)
    assert "sweep_rows<" in text
    states, qdd = _states(model, 24, seed=3), np.zeros(model.nv)
    turns = list(range(states.count))
    bounds: dict[int, list[float]] = {k: [] for k in turns}
    with loaded(text, stem, plan, quick) as call:
        for k in (*turns, *turns[::-1]):
            q, v, tau = (rows[k].copy() for rows in (states.q, states.v, states.tau))
            call("solve", ctypes.c_int, q, np.full_like(v, np.nan), tau, qdd)
            if call("solve", ctypes.c_int, q, v, tau, qdd) == 0:
                bounds[k].append(call("error_bound", ctypes.c_double))
    known = [each for each in bounds.values() if each]
    assert known and all(len(each) == 2 and each[0] == each[1] for each in known)


def test_rows_as_far_from_the_ground_share_records() -> None:
    """Legs that hold and arms, in four lanes."""
    plan = _in_loop(_model("g1 on both feet"))
    swept = _swept(plan)
    assert (swept.lanes, swept.count, len(swept.rows)) == (4, 16, 10)
    assert swept.floats and swept.closed
    joints = [j for row in swept.rows for j in row.joints if j is not None]
    assert sorted(joints) == list(range(1, len(plan.joints)))
    assert [row.next for row in swept.rows].count(False) == 2
    for row in swept.rows:
        assert all(each.near > row.place for each in row.passes)


def test_rows_that_do_not_wait_for_each_other_share_records() -> None:
    """Arms that are longer than legs, and a head that has time: as many records as joints."""
    plan = _in_loop(_model("talos on both feet"))
    swept = _swept(plan)
    assert (swept.lanes, swept.count, len(swept.rows)) == (4, 18, 10)
    joints = [j for row in swept.rows for j in row.joints if j is not None]
    assert sorted(joints) == list(range(1, len(plan.joints)))
    assert [row.next for row in swept.rows].count(False) == 3


def test_links_within_gather_in_all_their_lanes() -> None:
    """A single joint in the loop, on a row of more lanes."""
    swept = _swept(_in_loop(RANDOM[4][1]))
    assert swept.count == 1 and swept.lanes == 4


def test_joints_within_a_closure_stay_statements() -> None:
    """Hinges within the top of one, and those that are none."""
    plan = _in_loop(_model("leg with a parallel ankle"))
    names = [plan.joints[j].name for row in _swept(plan).rows for j in row.joints if j is not None]
    assert sorted(names) == ["ankle_pitch", "ankle_roll"]


def test_poses_that_are_solved_again_have_no_loop() -> None:
    plan = _in_loop(_model("a1 on four point feet"))
    assert plan.recovers
    (certify,) = plan.steps_of(Certify)
    assert certify.looped == ALL
    (again,) = plan.recovering().steps_of(Certify)
    assert again.looped == 0
    assert replace(plan, processes=plan.for_batches.processes).steps_of(Certify)
