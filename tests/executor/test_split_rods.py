"""Halves of rods that welds fix to the other halves count to these."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.executor import chosen_grouping, interpret, simulate
from adagen.executor.solve import Run, SingularPoseError
from adagen.model import (
    BASE,
    FLOATING,
    REVOLUTE,
    SPHERICAL,
    Inertia,
    LoopEnd,
    Model,
    NamedLoop,
    Passive,
)
from adagen.plan import Plan, make_plan
from adagen.plan.closure_steps import closures_in
from adagen.plan.similar_closures import side_by_side
from adagen.plan.split_rods import RodHalf, rod_halves_in
from adagen.program import check
from adagen.program.lower import lower
from adagen.reference.certified import exact_forward_dynamics
from adagen.reference.closed import closed_states, closest, pose_of
from adagen.schedule import load_profile
from adagen.search import best_schedule
from adagen.states import States
from tests.emitted import EXACT, Builder
from tests.executor.plans import in_lanes_off
from tests.executor.test_closed_lanes import lanes_of
from tests.executor.test_closures import plan_of, worst
from tests.mechanisms import states_of, with_loops
from tests.models import Part, assemble, rod, vector
from tests.slow import every_other

Array = NDArray[np.float64]
X, Y, Z = np.eye(3)
NO_INERTIA = Inertia.zero()
PLACES = vector(0.1, 0.12, 0.3), vector(-0.1, 0.15, 0.28)
"""Where cranks hang on a shin."""
PINS = vector(0.08, 0.1, 0.02), vector(-0.08, 0.11, 0.03)
"""Where rods hang on a foot."""


def ankles(
    *,
    hinges: bool = False,
    legs: int = 1,
    mirrored: bool = False,
    floating: bool = True,
    turn: Array | None = None,
) -> Model:
    """Return legs whose feet two rods hold, each closed in its middle by a weld.

    One half of a rod hangs on the foot by two crossed hinges, the other one on a crank by a ball.

    Args:
        hinges: whether balls are three hinges, with links without inertia in between.
        legs: how many.
        mirrored: whether the second leg names its cranks the other way round, and what welds join.
        floating: whether the body floats; else it is on a hinge.
        turn: of the first hinge of each ball on its crank.
    """
    first = np.eye(3) if turn is None else turn
    root = FLOATING if floating else REVOLUTE
    parts, loops = [Part(BASE, None, root, rod(5.0, vector(0.3, 0.1, 0.0)))], []
    for leg in range(legs):
        turned = mirrored and leg > 0
        shin, foot = f"shin{leg}", f"foot{leg}"
        place = vector(0.0, 0.2 * leg, 0.0)
        parts += [
            Part(shin, BASE, REVOLUTE, rod(2.0, vector(0.02, 0.03, 0.3)), place, axis=Y),
            Part(f"roll{leg}", shin, REVOLUTE, NO_INERTIA, axis=X),
            Part(foot, f"roll{leg}", REVOLUTE, rod(1.0, vector(0.05, 0.2, 0.01)), axis=Y),
        ]
        for k in range(2):
            side = 1 - k if turned else k
            crank, half, rest = f"crank{leg}{side}", f"half{leg}{k}", f"rest{leg}{k}"
            length = 0.01 * leg
            parts += [
                Part(f"cross{leg}{k}", foot, REVOLUTE, NO_INERTIA, PINS[k], axis=X),
                Part(half, f"cross{leg}{k}", REVOLUTE, rod(0.2, vector(0.01, 0, 0.15)), axis=Y),
                Part(
                    crank,
                    shin,
                    REVOLUTE,
                    rod(0.3, vector(0.06, 0.01, 0)),
                    PLACES[k] + vector(0.0, 0.0, length),
                    axis=Y,
                ),
            ]
            tip = vector(0.06, 0.01, 0.0)
            body = rod(0.15, vector(0.02, 0.01, -0.14))
            if hinges:
                parts += [
                    Part(f"one{leg}{k}", crank, REVOLUTE, NO_INERTIA, tip, first, axis=X),
                    Part(f"two{leg}{k}", f"one{leg}{k}", REVOLUTE, NO_INERTIA, axis=Y),
                    Part(rest, f"two{leg}{k}", REVOLUTE, body, axis=Z),
                ]
            else:
                parts.append(Part(rest, crank, SPHERICAL, body, tip))
            ends = (
                LoopEnd(f"{half}_link", (0.01, 0.0, 0.15)),
                LoopEnd(f"{rest}_link", (0, 0, -0.13)),
            )
            loops.append(NamedLoop(f"weld{leg}{k}", "weld", *(ends[::-1] if turned else ends)))
    return with_loops(assemble("ankles", parts, floating=floating), tuple(loops))


def rod_halves_of(plan: Plan) -> list[RodHalf]:
    """Return what hangs in the usual way of a plan's processes."""
    return [
        half
        for process in plan.processes
        for one in closures_in(process.steps).values()
        for half in rod_halves_in(plan, one)
    ]


@pytest.mark.parametrize(("hinges", "floating"), every_other((False, True)))
def test_halves_that_hang_count_to_the_others(hinges: bool, floating: bool) -> None:
    """It is the answer of dense algebra, with far fewer operations than with all unknowns."""
    model = ankles(hinges=hinges, floating=floating)
    plan, states = plan_of(model), states_of(model, 6)
    assert len(rod_halves_of(plan)) == 2
    assert {len(half.joints) for half in rod_halves_of(plan)} == {3 if hinges else 1}
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states) < 1e-11
    forces = make_plan(model, best_schedule(model, 1, load_profile("default")), loop_forces=True)
    assert not rod_halves_of(forces)
    counts = [simulate(each)[0].operations.arithmetic for each in (plan, forces)]
    assert counts[0] < 0.85 * counts[1]


@pytest.mark.parametrize("hinges", [False, True])
def test_torques_of_balls_go_to_what_they_join(hinges: bool) -> None:
    """Damping, friction and springs at them, too."""
    model = affected_balls(ankles(hinges=hinges))
    plan, states = plan_of(model), states_of(model, 4)
    assert len(rod_halves_of(plan)) == 2
    states = States(states.q, states.v, 20.0 * states.tau)
    assert worst(model, plan, states) < 1e-11


def affected_balls(model: Model) -> Model:
    """Return a robot with damping and friction, and springs at hinges, but without rotors."""
    hinge = Passive(damping=0.3, friction=0.2, stiffness=0.7, rest=0.1)
    effects = {REVOLUTE: hinge, SPHERICAL: Passive(damping=0.4)}
    joints = [replace(joint, passive=effects.get(joint.kind, Passive())) for joint in model.joints]
    return replace(model, joints=tuple(joints))


@pytest.mark.parametrize(("hinges", "mirrored"), every_other((False, True)))
def test_legs_that_mirror_each_other_share_lanes(hinges: bool, mirrored: bool) -> None:
    """Joints that correspond need not come in the same order, nor the two links of a weld."""
    model = ankles(hinges=hinges, legs=2, mirrored=mirrored)
    plan, states = plan_of(model), states_of(model, 3)
    grouping = chosen_grouping(plan)
    assert lanes_of(plan, grouping) == [2]
    ((_, other),) = side_by_side(plan, plan.processes[0].steps, grouping[0]).values()
    assert len(other.exchanged) == (2 if mirrored else 0)
    assert (list(other.path) == sorted(other.path)) is not mirrored
    assert in_lanes_off(plan, states, grouping) < 1e-11


def test_emitted_legs_compute_what_the_executor_does(builder: Builder, tmp_path: Path) -> None:
    model = ankles(hinges=True, legs=2, mirrored=True)
    plan, states = plan_of(model), states_of(model, 3)
    assert lanes_of(plan, chosen_grouping(plan)) == [2]
    solver = builder.solver(plan, EXACT, name="mirrored", shape="unrolled")
    found = solver.solve(model, states, tmp_path)
    expected = np.array([interpret(plan, *row, lanes=True) for row in states.each])
    np.testing.assert_array_equal(found, expected)


def test_a_half_that_is_turned_is_refused_by_its_name() -> None:
    """The weld is looked at as a whole, though its turns are no rows."""
    model = ankles(hinges=True)
    plan, states = plan_of(model), states_of(model, 1)
    q, v, tau = states.q[0], states.v[0], states.tau[0]
    last = [joint.name for joint in model.joints].index("rest01")
    turned = q + 1e-3 * (np.arange(model.nq) == model.q_start[last])
    with pytest.raises(FloatingPointError, match='loop "weld01": it is open'):
        interpret(plan, turned, v, tau)
    faster = v + 1e-1 * (np.arange(model.nv) == model.v_start[last])
    with pytest.raises(FloatingPointError, match='loop "weld01": the velocity'):
        interpret(plan, q, faster, tau)


@pytest.mark.parametrize(("short", "poor"), [(0.1, False), (1e-3, True)])
def test_hinges_near_one_plane_are_solved_in_another_way(short: float, poor: bool) -> None:
    """Where the middle hinge of a ball turns by nearly 90 degrees, its inverse is large."""
    model, q = at_angle(np.pi / 2 - short)
    plan = plan_of(model)
    assert len(rod_halves_of(plan)) == 2
    v, tau = np.zeros(model.nv), np.random.default_rng(1).uniform(-1, 1, model.ntau)
    usual = Run(plan, {"q": q, "v": v, "tau": tau})
    if poor:
        with pytest.raises(SingularPoseError):
            usual.check()
    else:
        usual.check()
    truth = exact_forward_dynamics(model, q, v, tau).value  # in doubles 1e-9 of it are lost
    assert np.abs(interpret(plan, q, v, tau) - truth).max() < 1e-12 * np.abs(truth).max()


def at_angle(angle: float) -> tuple[Model, Array]:
    """Return an ankle whose balls are hinges, closed where one's middle hinge is at an angle."""
    balls = ankles()
    closed = closed_states(balls, 1, seed=4)[0][0]
    names = [joint.name for joint in balls.joints]

    def turned(k: int) -> Array:
        links = (names.index(f"{word}0{k}") + 1 for word in ("crank", "rest"))
        crank, rest = (pose_of(balls, closed, link)[0] for link in links)
        return crank.T @ rest

    fixed = turned(0) @ _about_y(angle).T
    model, q = ankles(hinges=True, turn=fixed), []
    for joint in model.joints:
        if joint.name[:3] in ("one", "two", "res"):
            a, b, c = _angles(fixed.T @ turned(int(joint.name[-1])))
            q.append([{"one": a, "two": b, "res": c}[joint.name[:3]]])
        else:
            first = balls.q_start[names.index(joint.name)]
            q.append(list(closed[first : first + joint.kind.nq]))
    # Angles of a turn near gimbal lock lose digits, which would leave the loop open.
    return model, closest(model, np.concatenate(q)[None])[0]


def _about_y(angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def _angles(turn: Array) -> tuple[float, float, float]:
    """Angles about x, then y, then z that make up a turn."""
    a = np.arctan2(-turn[1, 2], turn[2, 2])
    b = np.arctan2(turn[0, 2], np.hypot(turn[0, 0], turn[0, 1]))
    return float(a), float(b), float(np.arctan2(-turn[0, 1], turn[0, 0]))
