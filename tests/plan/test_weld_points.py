"""Welds are looked at where joints turn about, and hold the same."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from adagen.executor import interpret, simulate
from adagen.graph import count_operations
from adagen.model import REVOLUTE, LoopEnd, Model, NamedLoop
from adagen.plan import Plan, make_plan
from adagen.plan.constants import loops_of
from adagen.reference.closed import closed_forward_dynamics
from adagen.schedule import load_profile
from adagen.search import best_schedule
from tests.mechanisms import states_of, with_loops
from tests.models import Part, assemble, rod, vector

AXES = vector(1.0, 0.0, 0.0), vector(0.0, 1.0, 0.0), vector(0.0, 0.0, 1.0)


def rodded(cross: float = 0.02) -> Model:
    """Return two cranks and a rod between them, welded in its middle, on three hinges each end.

    Args:
        cross: mass of the links between hinges, kg.
    """
    parts = []
    for side, place in (("l", 0.0), ("r", 0.5)):
        length = vector(0.3, 0.0, 0.1)
        parts.append(
            Part(side, None, REVOLUTE, rod(1.0, length), vector(place, 0, 0), axis=AXES[1])
        )
        last = side
        for k, axis in enumerate(AXES):
            body = rod(0.3 if k == 2 else cross, vector(0.2, 0.1, 0.1))
            at = vector(0.3, 0.0, 0.1) if k == 0 else vector(0.0, 0.0, 0.0)
            parts.append(Part(f"{side}{k}", last, REVOLUTE, body, at, axis=axis))
            last = f"{side}{k}"
    ends = LoopEnd("l2_link", (0.25, 0.0, 0.0)), LoopEnd("r2_link", (-0.25, 0.0, 0.0))
    return with_loops(assemble("rodded", parts), (NamedLoop("weld", "weld", *ends),))


def plan_of(model: Model, *, loop_forces: bool = False) -> Plan:
    schedule = best_schedule(model, 1, load_profile("default"))
    return make_plan(model, schedule, loop_forces=loop_forces)


def test_a_weld_is_held_at_the_centre_of_hinges_that_follow() -> None:
    model = rodded()
    plan, given = plan_of(model), loops_of(model)[0]
    (loop,) = plan.loops
    assert (0.0, 0.0, 0.0) in (loop.translation1, loop.translation2)
    assert loop != given
    apart = np.subtract(given.translation2, given.translation1)
    np.testing.assert_allclose(np.subtract(loop.translation2, loop.translation1), apart)
    states = states_of(model, 3)
    other = replace(plan, loops=(given,))
    for row in states.each:
        found, expected = (interpret(one, *row, once=True) for one in (plan, other))
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9 * abs(expected).max())
    counts = []
    for one in (plan, other):
        machine = simulate(one)[0].machine
        operations = count_operations(machine.graph, machine.roots())
        counts.append(operations.multiply + operations.add)
    assert counts[0] < 0.95 * counts[1]


def test_forces_that_are_asked_for_are_those_at_frame_2() -> None:
    model = rodded()
    assert plan_of(model, loop_forces=True).loops == loops_of(model)


@pytest.mark.parametrize("cross", [0.0, 1e-16])
def test_a_massless_cross_in_gimbal_lock_is_refused(cross: float) -> None:
    """What its motion meets is the difference of inertias of the size of the rod's."""
    model, states, refused = rodded(cross), states_of(rodded(0.0), 6), []
    plan = plan_of(model)
    middle = [joint.name for joint in model.joints].index("l1")
    for row in states.each:
        if abs(np.cos(row[0][middle])) < 1e-8:
            with pytest.raises(FloatingPointError, match="without inertia"):
                interpret(plan, *row)
            refused.append(row)
        else:
            assert np.isfinite(interpret(plan, *row)).all()
    assert refused


def test_a_weld_that_holds_one_hinge_fast_stays_where_its_rows_say_so() -> None:
    """On the hinge's axis a row of places says nothing, and one of them is what is kept."""
    hinge = vector(0.0, 0.0, 0.5)
    parts = [
        Part("a", None, REVOLUTE, rod(1.0, hinge), vector(0, 0, 0), axis=AXES[1]),
        Part("b", "a", REVOLUTE, rod(1.0, hinge), hinge, axis=AXES[0]),
    ]
    ends = LoopEnd("a_link", (0.0, 0.0, 1.5)), LoopEnd("b_link", (0.0, 0.0, 1.0))
    model = with_loops(assemble("held", parts), (NamedLoop("weld", "weld", *ends),))
    plan = plan_of(model)
    assert plan.loops == loops_of(model)
    states = states_of(model, 2)
    for q, v, tau in states.each:
        expected = closed_forward_dynamics(model, q, v, tau)
        np.testing.assert_allclose(interpret(plan, q, v, tau, once=True), expected, atol=1e-12)
