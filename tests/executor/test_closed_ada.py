"""Form ada of robots with closed loops: joint by joint, loops solved for at the end."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from adagen.errors import UsageError
from adagen.executor import interpret, simulate
from adagen.model import (
    BASE,
    FLOATING,
    LOOP_KINDS,
    PLANAR,
    PRISMATIC,
    REVOLUTE,
    SPHERICAL,
    WORLD,
    Inertia,
    JointKind,
    LoopEnd,
    Model,
    NamedLoop,
)
from adagen.plan import Plan, make_plan, plan_from_json, plan_to_json
from adagen.plan.refine import corrected, why_not_in_lines
from adagen.program import check
from adagen.program.lower import lower
from adagen.reference.closed import closed_forward_dynamics
from adagen.schedule import load_profile
from adagen.search import best_schedule
from tests.emitted import QUICK, Builder, forward_error, truth_of
from tests.executor.test_closures import worst
from tests.mechanisms import MECHANISMS, four_bar, looped_tree, quadruped, states_of, with_loops
from tests.models import Part, assemble, rod, vector
from tests.slow import every_other, slow


def ada_plan(model: Model, processes: int, *, loop_forces: bool = False) -> Plan:
    """Return the plan of form ada."""
    schedule = best_schedule(model, processes, load_profile("default"), form="ada")
    return make_plan(model, schedule, form="ada", loop_forces=loop_forces)


@pytest.mark.parametrize("processes", [1, 2])
@pytest.mark.parametrize("name", sorted(MECHANISMS))
def test_mechanisms_move_as_dense_algebra_says(name: str, processes: int) -> None:
    model = MECHANISMS[name]()
    plan = ada_plan(model, processes)
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states_of(model, 4)) < 1e-10
    assert plan_from_json(plan_to_json(plan)) == plan


def test_messages_have_room_for_accelerations_of_balls() -> None:
    """A joint at a loop tells all its accelerations, of every right-hand side."""
    model = looped_tree("point", 4, joints=9, kinds=(SPHERICAL,))
    plan = ada_plan(model, 3)
    assert any(message.sweep == "slaved" for message in plan.messages)
    for process in simulate(plan):
        for number, content in process.machine.sent.items():
            room = plan.messages[number].numbers(plan.right_hand_sides, plan.joints)
            assert len(content) <= room


@pytest.mark.parametrize(("kind", "floating"), every_other(LOOP_KINDS))
def test_loops_of_every_kind_between_processes(kind: str, floating: bool) -> None:
    model = looped_tree(kind, 4, joints=9, floating=floating)
    plan = ada_plan(model, 3)
    assert sum(bool(process.owns) for process in plan.processes) > 1
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states_of(model, 3)) < 1e-10


@pytest.mark.parametrize(
    "make", [quadruped, four_bar, lambda: looped_tree("universal", 4, joints=9)]
)
def test_forces_are_those_of_form_segment(make: Callable[[], Model]) -> None:
    model = make()
    schedule = best_schedule(model, 1, load_profile("default"))
    segment = make_plan(model, schedule, loop_forces=True)
    states = states_of(model, 3, seed=5)
    for processes in (1, 2):
        plan = ada_plan(model, processes, loop_forces=True)
        for q, v, tau in states.each:
            found, expected = (interpret(one, q, v, tau, once=True) for one in (plan, segment))
            assert np.abs(found - expected).max() < 1e-9 * np.abs(expected).max()


def arms_with_linkages() -> Model:
    """Return two arms of two joints, each with a four-bar at its end."""
    along = vector(0.0, 1.0, 0.0)
    parts, loops = [], []
    for side, place in (("l", 0.0), ("r", 1.0)):
        body = rod(1.0, vector(0.1, 0.2, 0.3))
        parts += [
            Part(f"{side}_turn", None, REVOLUTE, body, vector(place, 0, 0), axis=vector(0, 0, 1.0)),
            Part(f"{side}_lift", f"{side}_turn", REVOLUTE, body, vector(0, 0, 0.3), axis=along),
            Part(f"{side}_crank", f"{side}_lift", REVOLUTE, body, axis=along),
            Part(f"{side}_bar", f"{side}_crank", REVOLUTE, body, vector(0.2, 0, 0), axis=along),
            Part(f"{side}_rocker", f"{side}_lift", REVOLUTE, body, vector(0.5, 0, 0), axis=along),
        ]
        ends = (
            LoopEnd(f"{side}_bar_link", (0.45, 0, 0)),
            LoopEnd(f"{side}_rocker_link", (0.35, 0, 0)),
        )
        loops.append(NamedLoop(side, "revolute", *ends, (0.0, 1.0, 0.0)))
    return with_loops(assemble("arms", parts), tuple(loops))


@pytest.mark.parametrize("processes", [1, 2, 4])
def test_joints_before_a_loop_are_nothing_to_it(processes: int) -> None:
    """What carries a linkage is another process's, and need not be told for the loop's sake."""
    model = arms_with_linkages()
    plan = ada_plan(model, processes)
    assert sum(bool(process.owns) for process in plan.processes) == processes
    told = {j for message in plan.messages if message.sweep == "slaved" for j in message.joints}
    assert not {model.joints[j].name for j in told} & {"l_turn", "l_lift", "r_turn", "r_lift"}
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states_of(model, 4)) < 1e-10


def crossed_legs(*, pinned: str = "rod") -> Model:
    """Return a plate on three legs: crossed hinges through a link without mass, and a slide.

    Args:
        pinned: the link of the first leg that the ground holds: its rod, or its massless cross.
    """
    across, along = vector(1.0, 0.0, 0.0), vector(0.0, 1.0, 0.0)
    parts = [Part(BASE, None, FLOATING, rod(5.0, vector(0.3, 0.2, 0.1)))]
    pins = []
    for leg in "abc":
        place = vector(0.4 * "abc".index(leg), 0.3 * (leg == "b"), -0.2)
        body = rod(1.0, vector(0.1, 0.1, -0.4))
        parts += [
            Part(f"cross_{leg}", BASE, REVOLUTE, Inertia.zero(), place, axis=across),
            Part(f"tube_{leg}", f"cross_{leg}", REVOLUTE, body, axis=along),
            Part(f"rod_{leg}", f"tube_{leg}", PRISMATIC, body, axis=vector(0.0, 0.0, 1.0)),
        ]
        link = f"{pinned if leg == 'a' else 'rod'}_{leg}_link"
        x, y, z = map(float, place if link.startswith("rod") else 0.7 * place)
        ends = LoopEnd(link, (0.0, 0.0, -0.5)), LoopEnd(WORLD, (x, y, z - 0.5))
        pins.append(NamedLoop(f"pin_{leg}", "point", *ends))
    return with_loops(assemble("plate", parts, floating=True), tuple(pins))


def light_base() -> Model:
    """Return a five-bar whose floating root link has no mass."""
    pin = vector(0.0, 1.0, 0.0)
    body = rod(1.0, vector(0.3, 0.05, 0.0))
    parts = [Part(BASE, None, FLOATING, Inertia.zero())]
    for side, place in (("l", -0.1), ("r", 0.1)):
        parts += [
            Part(f"{side}1", BASE, REVOLUTE, body, vector(place, 0, 0), axis=pin),
            Part(f"{side}2", f"{side}1", REVOLUTE, body, vector(0.3, 0, 0), axis=pin),
        ]
    ends = LoopEnd("l2_link", (0.3, 0.0, 0.0)), LoopEnd("r2_link", (0.3, 0.0, 0.0))
    return with_loops(
        assemble("light", parts, floating=True), (NamedLoop("pin", "revolute", *ends, (0, 1, 0)),)
    )


@pytest.mark.parametrize("processes", [1, 3])
@pytest.mark.parametrize(
    "make", [slow(crossed_legs), partial(crossed_legs, pinned="cross"), light_base]
)
def test_links_without_mass_are_joined_in_runs_and_clusters(
    make: Callable[[], Model], processes: int
) -> None:
    model = make()
    states, plan = states_of(model, 3), ada_plan(model, processes)
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states) < 1e-10
    assert plan_from_json(plan_to_json(plan)) == plan
    if processes == 1:
        refined = np.array(
            [interpret(corrected(plan, 1), *row) for row in states.each], dtype=float
        )
        assert forward_error(refined, truth_of(model, states)) < 1e-14


def open_four_bar(kind: JointKind = REVOLUTE, held: str = "revolute") -> Model:
    """Return a four-bar whose coupler has no mass and hangs on the crank alone in the tree.

    Args:
        kind: of the joint by which it does.
        held: kind of the loop by which the rocker holds it.
    """
    pin = vector(0.0, 1.0, 0.0)
    parts = [
        Part("p0", None, REVOLUTE, rod(1.0, vector(0.2, 0, 0)), axis=pin),
        Part("p1", "p0", kind, Inertia.zero(), vector(0.2, 0, 0), axis=pin),
        Part("p2", None, REVOLUTE, rod(1.0, vector(0.4, 0, 0)), vector(0.45, 0, 0), axis=pin),
    ]
    ends = LoopEnd("p1_link", (0.5, 0.0, 0.0)), LoopEnd("p2_link", (0.4, 0.0, 0.0))
    pinned = NamedLoop("pin", held, *ends, (0.0, 1.0, 0.0))
    return with_loops(assemble("open", parts), (pinned,))


def pinned_base() -> Model:
    """Return a four-bar all of whose links hang in one chain on a floating link without mass."""
    pin = vector(0.0, 1.0, 0.0)
    parts = [Part(BASE, None, FLOATING, Inertia.zero())]
    for name, parent, length, place in (
        ("p0", BASE, 0.2, 0.0),
        ("p1", "p0", 0.5, 0.2),
        ("p2", "p1", 0.4, 0.5),
    ):
        body = rod(1.0, vector(length, 0.1, 0))
        parts.append(Part(name, parent, REVOLUTE, body, vector(place, 0, 0), axis=pin))
    ends = LoopEnd("p2_link", (0.4, 0.0, 0.0)), LoopEnd(f"{BASE}_link", (0.45, 0.0, 0.0))
    pinned = NamedLoop("pin", "revolute", *ends, (0.0, 1.0, 0.0))
    return with_loops(assemble("base", parts, floating=True), (pinned,))


@pytest.mark.parametrize("processes", [1, 2])
@pytest.mark.parametrize("make", [open_four_bar, partial(open_four_bar, SPHERICAL), pinned_base])
def test_motions_that_only_loops_resist_get_artificial_inertia(
    make: Callable[[], Model], processes: int
) -> None:
    """It is taken off again: accelerations and forces are those of the robot itself."""
    model = make()
    states = states_of(model, 4)
    plan = ada_plan(model, processes)
    segment = make_plan(model, best_schedule(model, 1, load_profile("default")), loop_forces=True)
    forces = ada_plan(model, processes, loop_forces=True)
    assert plan.lent
    check(lower(plan, "unrolled"))
    assert worst(model, plan, states) < 1e-10
    for row in states.each:
        found, expected = (interpret(one, *row, once=True) for one in (forces, segment))
        assert np.abs(found - expected).max() < 1e-9 * np.abs(expected).max()
    assert plan_from_json(plan_to_json(plan)) == plan
    assert "only loops resist" in (why_not_in_lines(plan) or "")


def test_motions_without_artificial_inertia_are_refused_by_name() -> None:
    """A joint that turns and slides has inertias of two units."""
    with pytest.raises(UsageError, match=r"joint p1 \(link p1_link\) moves no inertia.*segment"):
        ada_plan(open_four_bar(PLANAR, "weld"), 1)


def test_emitted_for_two_processes(builder: Builder, tmp_path: Path) -> None:
    model = crossed_legs()
    plan = ada_plan(model, 2)
    solver = builder.solver(plan, QUICK, name="ada")
    states = states_of(model, 3)
    found = solver.solve(model, states, tmp_path)
    truth = np.array([closed_forward_dynamics(model, *row) for row in states.each])
    assert np.abs(found - truth).max() < 1e-10 * np.abs(truth).max()
