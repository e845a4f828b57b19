"""Alike closures of a robot share straight lines, one in each SIMD lane."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.executor import Grouping, chosen_grouping, interpret, simulate
from adagen.graph import BALLS, DOUBLE, FLOAT
from adagen.model import (
    BASE,
    FLOATING,
    REVOLUTE,
    LoopEnd,
    Model,
    NamedCoupling,
    NamedLoop,
    Passive,
)
from adagen.plan import Plan, make_plan
from adagen.plan.similar_closures import side_by_side
from adagen.plan.steps import Articulate
from adagen.schedule import Schedule, load_profile
from adagen.schedule.tree import Gathered
from adagen.search import best_schedule
from adagen.search.closed_loops import _layouts
from tests.emitted import EXACT, Builder
from tests.executor.plans import in_lanes_off
from tests.executor.test_closures import plan_of, worst
from tests.mechanisms import quadruped, standing, states_of, with_loops
from tests.models import Part, assemble, human_figure, rod, vector
from tests.slow import all_but, slow

ACROSS = vector(0.0, 1.0, 0.0)


def linkages(
    count: int,
    *,
    hips: int = 0,
    geared: bool = False,
    floating: bool = True,
    kind: str = "revolute",
    odd: bool = False,
) -> Model:
    """Return a body with limbs, each a four-bar behind some hips; of an odd one a bar is longer.

    Args:
        count: how many limbs.
        hips: joints between the body and each four-bar.
        geared: whether a wheel on each limb's first bar is geared to that bar.
        floating: whether the body floats; else it is on a hinge.
        kind: of the loops.
        odd: whether the last limb's loop is a point.
    """
    root = FLOATING if floating else REVOLUTE
    parts = [Part(BASE, None, root, rod(5.0, vector(0.3, 0.1, 0.0)))]
    loops, couplings = [], []
    for n in range(count):
        last, place = BASE, vector(0.1 * n, 0.05, 0.0)
        for k in range(hips):
            axis = np.eye(3)[k % 3]
            parts.append(
                Part(f"h{n}{k}", last, REVOLUTE, rod(1.0, vector(0.1, 0.02, 0)), place, axis=axis)
            )
            last, place = f"h{n}{k}", vector(0.1, 0.0, 0.0)
        one, two, three = 0.2 + 0.01 * n, 0.5, 0.4
        for name, above, length, at in (
            (f"crank{n}", last, one, place),
            (f"coupler{n}", f"crank{n}", two, vector(one, 0, 0)),
            (f"rocker{n}", last, three, place + vector(0.45, 0, 0)),
        ):
            parts.append(
                Part(name, above, REVOLUTE, rod(1.0, vector(length, 0, 0)), at, axis=ACROSS)
            )
        word = "point" if odd and n == count - 1 else kind
        pin = LoopEnd(f"coupler{n}_link", (two, 0, 0)), LoopEnd(f"rocker{n}_link", (three, 0, 0))
        loops.append(NamedLoop(f"pin{n}", word, *pin, (0.0, 1.0, 0.0)))
        if geared:
            wheel = rod(0.1, vector(0.05, 0.0, 0.0))
            parts.append(Part(f"wheel{n}", f"crank{n}", REVOLUTE, wheel, axis=ACROSS))
            terms = (f"wheel{n}", 1.0), (f"coupler{n}", 2.0 + n)
            couplings.append(NamedCoupling(f"gear{n}", terms, 0.1 * n))
    model = assemble("linkages", parts, floating=floating)
    return with_loops(model, tuple(loops), tuple(couplings))


def tripod() -> Model:
    """Return the quadruped with one foot in the air."""
    return replace(quadruped(), loops=quadruped().loops[:3])


def figure() -> Model:
    """Return a human figure on both feet."""
    return standing(human_figure(), "weld", "left_ankle_link", "right_ankle_link")


def affected(model: Model) -> Model:
    """Return a robot with damping, friction, springs and rotors at its hinges."""
    rng = np.random.default_rng(3)
    joints = [
        replace(joint, passive=Passive(*rng.uniform(0.1, 1.0, size=6)))
        if joint.kind == REVOLUTE
        else joint
        for joint in model.joints
    ]
    return replace(model, joints=tuple(joints))


def lanes_of(plan: Plan, grouping: Grouping) -> list[int]:
    """Return how many closures go together, for each that stands for several."""
    return [
        len(lanes)
        for process, limbs in zip(plan.processes, grouping, strict=True)
        for lanes in side_by_side(plan, process.steps, limbs).values()
    ]


CASES: dict[str, tuple[Callable[[], Model], list[int]]] = {
    "four feet": (quadruped, [4]),
    "three feet, one lane idle": (tripod, [3]),
    "two feet": (figure, [2]),
    "four-bars on one body": (lambda: linkages(2), [2]),
    "four-bars on a hinge": (lambda: linkages(2, floating=False), [2]),
    "four-bars behind hips": (lambda: linkages(2, hips=2), [2]),
    "four-bars with gears": (lambda: linkages(2, hips=1, geared=True), [2]),
    "three four-bars": (lambda: linkages(3, hips=1, kind="cylindrical"), [3]),
    "four-bars with effects": (lambda: affected(linkages(2, hips=1)), [2]),
    "one that is unlike": (lambda: linkages(3, hips=1, odd=True), [2]),
}


@pytest.mark.parametrize("name", all_but(CASES, "four feet", "one that is unlike"))
def test_alike_closures_share_lanes(name: str) -> None:
    """They do, it is less work, and what is computed is the same but for rounding."""
    make, expected = CASES[name]
    model = make()
    plan, states = plan_of(model), states_of(model, 3)
    grouping = chosen_grouping(plan)
    assert lanes_of(plan, grouping) == expected
    (apart,), (together,) = simulate(plan), simulate(plan, grouping)
    assert together.operations.arithmetic < 0.8 * apart.operations.arithmetic
    assert worst(model, plan, states) < 1e-12
    assert in_lanes_off(plan, states, grouping) < 1e-12


def test_feet_that_are_held_unlike_keep_their_hips_out_of_lanes() -> None:
    """What the ground holds is seen from it, by way of the hips."""
    feet = (("point", "left_ankle_link"), ("planar", "right_ankle_link"))
    model = human_figure()
    loops = [loop for kind, foot in feet for loop in standing(model, kind, foot).loops]
    model = replace(standing(model, "point", feet[0][1]), loops=tuple(loops))
    plan, states = plan_of(model), states_of(model, 2)
    grouping = chosen_grouping(plan)
    assert grouping[0]
    assert lanes_of(plan, grouping) == []
    for state in states.each:
        exact = interpret(plan, *state)
        found = interpret(plan, *state, lanes=grouping)
        assert np.abs(found - exact).max() < 1e-12 * np.abs(exact).max()


def test_an_open_loop_in_a_lane_is_refused_by_its_name() -> None:
    model = linkages(3, hips=1, geared=True)
    plan, states = plan_of(model), states_of(model, 1)
    grouping = chosen_grouping(plan)
    assert lanes_of(plan, grouping) == [3]
    q, v, tau = states.q[0], states.v[0], states.tau[0]
    names = [joint.name for joint in model.joints]
    for n in range(3):
        rocker = model.q_start[names.index(f"rocker{n}")]
        moved = q + 0.01 * (np.arange(model.nq) == rocker)
        with pytest.raises(FloatingPointError, match=f'loop "pin{n}": it is open'):
            interpret(plan, moved, v, tau, lanes=grouping)
        wheel = model.q_start[names.index(f"wheel{n}")]
        moved = q + 0.01 * (np.arange(model.nq) == wheel)
        with pytest.raises(FloatingPointError, match=f'coupling "gear{n}": it is open'):
            interpret(plan, moved, v, tau, lanes=grouping)


@pytest.mark.parametrize("make", [tripod, lambda: linkages(2, hips=1, geared=True)])
def test_forces_of_loops_in_lanes(make: Callable[[], Model]) -> None:
    model = make()
    states = states_of(model, 2)
    schedule = best_schedule(model, 1, load_profile("default"))
    plan = make_plan(model, schedule, loop_forces=True)
    grouping = chosen_grouping(plan)
    assert lanes_of(plan, grouping)
    assert in_lanes_off(plan, states, grouping) < 1e-11


@pytest.mark.parametrize(
    ("name", "scalar"),
    [slow("three feet, one lane idle", "double"), ("four-bars with gears", "float")],
)
def test_emitted_lanes_compute_what_the_executor_does(
    name: str, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    make, _ = CASES[name]
    model = make()
    plan, states = plan_of(model, scalar=scalar), states_of(model, 3)
    assert lanes_of(plan, chosen_grouping(plan))
    solver = builder.solver(plan, EXACT, name="lanes", shape="unrolled")
    found = solver.solve(model, states, tmp_path)
    algebra = FLOAT if scalar == "float" else DOUBLE
    expected = np.array([interpret(plan, *row, algebra, lanes=True) for row in states.each])
    np.testing.assert_array_equal(found.astype(expected.dtype), expected)


def test_what_is_done_instead_goes_side_by_side_only_where_it_is_alike(
    builder: Builder, tmp_path: Path
) -> None:
    """In poses in which a first choice is poor, too, emitted code is right."""
    model = linkages(2, hips=1)
    plan, states = plan_of(model), states_of(model, 40, seed=5)
    found = builder.solver(plan, EXACT, name="poor", shape="unrolled").solve(
        model, states, tmp_path
    )
    for k, state in enumerate(states.each):
        exact = np.array([float(x) for x in interpret(plan, *state, BALLS)])
        assert np.abs(found[k] - exact).max() < 1e-11 * np.abs(exact).max()


def test_lanes_of_processes_that_meet_away_from_the_base() -> None:
    """Joints are swept towards the middle of a robot, some of them from the base outwards."""
    model = figure()
    alone = best_schedule(model, 2, load_profile("default"))
    states = states_of(model, 1)
    found = {step for layout in layouts(model, 2) for step in swept_back(model, alone, layout)}
    assert found
    for layout in layouts(model, 2):
        plan = make_plan(model, replace(alone, meeting="gather", gathered=layout))
        grouping = chosen_grouping(plan)
        assert any(grouping)
        for q, v, tau in states.each:
            exact = np.array([float(x) for x in interpret(plan, q, v, tau, BALLS)])
            answer = interpret(plan, q, v, tau, lanes=grouping)
            assert np.abs(answer - exact).max() < 1e-12 * np.abs(exact).max()


def layouts(model: Model, processes: int) -> list[Gathered]:
    """Return where processes may gather, and who may have what."""
    found, _ = _layouts(model, plan_of(model), processes)
    return list(found)


def swept_back(model: Model, schedule: Schedule, layout: Gathered) -> set[Articulate]:
    """Return the steps of a layout in which a joint's parent link is the far one."""
    plan = make_plan(model, replace(schedule, meeting="gather", gathered=layout))
    steps = (step for process in plan.processes for step in process.steps)
    return {step for step in steps if isinstance(step, Articulate) and step.reversed}
