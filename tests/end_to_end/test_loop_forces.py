"""Forces of closed loops: right, of least squares where they are not unique, and given by all."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import adagen
from adagen.cli.main import main
from adagen.errors import UsageError
from adagen.executor import interpret
from adagen.library import read
from adagen.model import Model
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.reference.closed import closed_forward_dynamics, constraints, pose_of
from adagen.reference.double import inverse_dynamics
from adagen.schedule import load_profile
from adagen.schedule.tree import Gathered
from adagen.search import best_schedule
from tests.emitted import QUICK, Builder
from tests.end_to_end.test_loops import write_bars
from tests.mechanisms import MECHANISMS, four_bar, geared, looped_tree, quadruped, states_of

Array = NDArray[np.float64]


@pytest.fixture
def bars(tmp_path: Path) -> Path:
    """A four-bar linkage in a folder."""
    return write_bars(tmp_path)


def forces_of(model: Model) -> Plan:
    """Return a plan of one process with forces of loops."""
    schedule = best_schedule(model, 1, load_profile("default"))
    return make_plan(model, schedule, loop_forces=True)


def pushing(model: Model, q: Array, forces: Array) -> Array:
    """Return the generalized forces of wrenches of loops, [f; m] on link 2 in axes of frame 2.

    Both links feel them where frame 2 is: the power of f and m in the motion of link 2 against
    link 1, by differences of poses.
    """
    found = np.zeros(model.nv)
    for k in range(model.nv):
        ends = []
        for step in (1e-6, -1e-6):
            moved = q.copy()
            moved[k] += step
            ends.append(_relative(model, moved, q))
        rates = (ends[0] - ends[1]) / 2e-6
        found[k] = float(np.sum(rates * forces.reshape(-1, 6)))
    return found


def _relative(model: Model, q: Array, start: Array) -> Array:
    """Motion of each loop's link 2 against link 1 at frame 2, in axes of frame 2 at the start."""
    found = []
    for loop in model.loops:
        turn2, place2 = pose_of(model, q, loop.link2)
        turn1, place1 = pose_of(model, q, loop.link1)
        old2, old_place2 = pose_of(model, start, loop.link2)
        old1, old_place1 = pose_of(model, start, loop.link1)
        at = old_place2 + old2 @ loop.frame2.translation
        one = place1 + turn1 @ old1.T @ (at - old_place1)  # the same place, fixed to link 1
        two = place2 + turn2 @ loop.frame2.translation
        told = np.array(loop.turn2) if loop.turn2 else np.eye(3)
        axes = old2 @ loop.frame2.rotation @ told.T
        spin = (turn2 @ old2.T) - (turn1 @ old1.T)
        about = np.array([spin[2, 1], spin[0, 2], spin[1, 0]])
        found.append(np.concatenate([axes.T @ (two - one), axes.T @ about]))
    return np.array(found)


@pytest.mark.parametrize("kind", ["weld", "spherical", "revolute", "universal", "cylindrical"])
def test_forces_are_what_the_equations_of_motion_lack(kind: str) -> None:
    """M qdd + h - tau is what the loops' forces do, each at its place and in its axes."""
    model = looped_tree(kind, 4, joints=9)
    states = states_of(model, 3)
    for plan in forces_of(model).alternatives:
        for q, v, tau in states.each:
            found = interpret(plan, q, v, tau, once=True)
            left = inverse_dynamics(model, q, v, found[: model.nv]) - tau
            pushed = pushing(model, q, found[model.nv :])
            assert np.abs(left - pushed).max() < 1e-6 * max(1.0, np.abs(left).max())


@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "gear"])
def test_forces_are_those_of_least_squares(name: str) -> None:
    """A planar pin has five rows, two of which are independent."""
    model = MECHANISMS[name]()
    states = states_of(model, 3)
    for plan in forces_of(model).alternatives:
        for q, v, tau in states.each:
            found = interpret(plan, q, v, tau, once=True)
            left = inverse_dynamics(model, q, v, found[: model.nv]) - tau
            rows = constraints(model, q).rows
            least = np.linalg.lstsq(rows.T, left, rcond=1e-9)[0]
            assert np.abs(rows.T @ least - left).max() < 1e-9 * max(1.0, np.abs(left).max())
            size = np.linalg.norm(found[model.nv :])
            assert size == pytest.approx(float(np.linalg.norm(least)), rel=1e-9)


@pytest.mark.slow
def test_accelerations_are_the_same_beside_forces(builder: Builder, tmp_path: Path) -> None:
    """Emitted for two processes: each gives the forces of its own loops."""
    model = quadruped()
    schedule = best_schedule(model, 2, load_profile("default"))
    two_legs_each = Gathered((1,), (None, *[0] * 6, *[1] * 6))
    schedule = replace(schedule, meeting="gather", gathered=two_legs_each)
    plan = make_plan(model, schedule, loop_forces=True)
    assert plan_from_json(plan_to_json(plan)) == plan
    assert [len(plan.force_entries(process)) for process in plan.processes] == [12, 12]
    states = states_of(model, 4, seed=5)
    solver = builder.solver(plan, QUICK, shape="unrolled", name="forces")
    found = solver.solve(model, states, tmp_path)
    told = json.loads((tmp_path / "result.json").read_text())["loops"]
    for s, (q, v, tau) in enumerate(states.each):
        expected = interpret(plan, q, v, tau, once=True)
        truth = closed_forward_dynamics(model, q, v, tau)
        assert np.abs(found[s] - truth).max() < 1e-10 * np.abs(truth).max()
        given = np.hstack([told[loop.name]["force"][s] for loop in model.loops])
        size = np.abs(expected[model.nv :]).max()
        assert np.abs(given - expected[model.nv :]).max() < 1e-10 * size


def test_python_and_batches_give_forces_behind_accelerations(bars: Path) -> None:
    robot = read(bars / "bars.urdf", scene=bars / "bars.toml")
    states = states_of(robot.model, 5)
    plan = forces_of(robot.model)
    expected = interpret(plan, states.q.T, states.v.T, states.tau.T).T
    for batch in (False, True):
        solver = adagen.compile(robot, loop_forces=True, batch=batch).build()
        assert solver.nqdd == 9
        found = solver(states.q, states.v, states.tau)
        assert found.shape == (5, 9)
        assert np.abs(found - expected).max() < 1e-9 * np.abs(expected).max()
        assert solver.force("eye pin") == slice(3, 9)
        with pytest.raises(UsageError, match='there is no force of "pin"'):
            solver.force("pin")


def test_forces_are_refused_where_there_are_none() -> None:
    with pytest.raises(UsageError, match="the robot has no loops and couplings"):
        forces_of(replace(four_bar(), loops=()))


def test_forces_of_couplings_are_in_the_result(bars: Path) -> None:
    words = [str(bars / "bars.urdf"), "--scene", str(bars / "bars.toml"), "--loop-forces"]
    words += ["--states", str(bars / "states.json"), "--result", str(bars / "result.json")]
    assert main(["solve", *words]) == 0
    told = json.loads((bars / "result.json").read_text())
    assert np.shape(told["loops"]["eye pin"]["force"]) == (3, 6)
    assert "couplings" not in told
    model = geared()
    assert forces_of(model).nqdd == model.nv + 1
