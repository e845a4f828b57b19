"""Outputs of a scene and forces of loops, on one robot with closed loops."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from adagen.errors import UsageError
from adagen.executor import interpret
from adagen.model import LINK_ACCELERATION, REACTION_FORCE, Model, Output
from adagen.model.links import Frame
from adagen.plan import make_plan
from adagen.reference.closed import closed_forward_dynamics
from adagen.reference.double import inverse_dynamics
from adagen.schedule import load_profile
from adagen.search import best_schedule
from tests.executor.test_closed_lanes import figure, linkages
from tests.mechanisms import four_bar, states_of


def with_outputs(model: Model) -> Model:
    """Return a robot of whose every second link the acceleration is asked for, at some frame."""
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    frame = Frame("frame", turn, np.array([0.1, -0.2, 0.05]))
    links = range(len(model.links) - 1, 0, -2)
    outputs = tuple(Output(LINK_ACCELERATION, k, frame, model.links[k].name) for k in links)
    return replace(model, outputs=outputs)


@pytest.mark.parametrize(
    "make", [lambda: four_bar(floating=True), lambda: linkages(3, hips=1, geared=True), figure]
)
def test_both_are_given_behind_the_accelerations(make: Callable[[], Model]) -> None:
    """Link accelerations are those of the open tree that moves likewise; forces are as without."""
    closed = make()
    model = with_outputs(closed)
    tree = replace(model, loops=(), couplings=())
    schedule = best_schedule(model, 1, load_profile("default"))
    plan = make_plan(model, schedule, loop_forces=True)
    forces = make_plan(closed, schedule, loop_forces=True)
    free = make_plan(tree, best_schedule(tree, 1, load_profile("default")))
    states = states_of(closed, 3)
    for q, v, tau in states.each:
        qdd = closed_forward_dynamics(closed, q, v, tau)
        needed = inverse_dynamics(tree, q, v, qdd)
        moved = interpret(free, q, v, needed)
        alone = interpret(forces, q, v, tau)
        for each in plan.alternatives:
            for lanes in (False, True):
                found = interpret(each, q, v, tau, lanes=lanes)
                first = plan.entry_of_loop(0)
                assert len(found) == plan.nqdd == len(moved) + len(alone) - model.nv
                size = np.abs(moved).max()
                np.testing.assert_allclose(found[:first], moved, rtol=0, atol=1e-11 * size)
                size = np.abs(alone).max()
                np.testing.assert_allclose(
                    found[first:], alone[model.nv :], rtol=0, atol=1e-10 * size
                )


def test_reaction_forces_at_loops_are_refused_by_name() -> None:
    model = four_bar()
    output = Output(REACTION_FORCE, 1, Frame("", np.eye(3), np.zeros(3)), "p0")
    schedule = best_schedule(model, 1, load_profile("default"))
    with pytest.raises(UsageError, match="'p0' is not computed for robots with closed loops"):
        make_plan(replace(model, outputs=(output,)), schedule)
