"""A process's long chain in parts, one in each lane of loops: answers beside exact ones."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from adagen.model import Model, Passive
from adagen.plan import make_plan
from adagen.schedule import Topology, load_profile
from adagen.search import named_schedule
from adagen.states import random_states
from tests.emitted import CHECKED, NARROW, OPTIMISED, QUICK, ROUNDING, Builder, kernels_of, text_of
from tests.models import serial_chain
from tests.plan.test_parts import hinges, hung, in_parts
from tests.slow import slow, spread


@pytest.mark.parametrize(
    ("flags", "joints", "scalar"),
    [
        *spread(
            [
                (QUICK, 24, "double"),
                (OPTIMISED, 33, "double"),
                (NARROW, 39, "double"),
                (QUICK, 50, "float"),
                (OPTIMISED, 64, "float"),
            ],
            2,
        ),
        (CHECKED, 26, "double"),
        slow(CHECKED, 49, "float"),
    ],
)
def test_parts_are_solved(
    flags: tuple[str, ...], joints: int, scalar: str, builder: Builder, tmp_path: Path
) -> None:
    """Also where the last row of joints leaves lanes empty, which is so of 33, 39 and 50."""
    model = hinges(joints, seed=joints)
    lanes = 8 if scalar == "double" else 16
    schedule = named_schedule("sequential", Topology.of(model), 1, profile=load_profile("default"))
    plan = make_plan(model, replace(schedule, parts=lanes), scalar=scalar)
    text = kernels_of(plan)
    assert f"inward_in_parts<0, {joints - 1}>(w);" in text
    assert f"accelerate_in_parts<0, {joints - 1}>(w, started_0);" in text
    states = random_states(model, 4, seed=5)
    solver = builder.solver(plan, flags, name="parts", shape="kernels")
    assert solver.error(model, states, tmp_path, "--check") < 100 * ROUNDING[scalar]


def graded(model: Model, factor: float) -> Model:
    """Return a chain whose links' masses grow outwards, by a factor in all."""
    links = []
    for k, link in enumerate(model.links):
        times = factor ** (k / len(model.joints))
        body = link.inertia
        more = replace(body, mass=times * body.mass, tensor=times * body.tensor)
        links.append(replace(link, inertia=more))
    return replace(model, links=tuple(links))


@pytest.mark.parametrize("factor", [1e3, slow(1e-3)])
def test_joins_in_lanes_keep_digits_of_graded_masses(
    factor: float, builder: Builder, tmp_path: Path
) -> None:
    """Light parts beside heavy ones on either side, axes alternating: beside exact answers."""
    model = graded(serial_chain(41), factor)
    solver = builder.solver(in_parts(model), name="parts", shape="kernels")
    whole = builder.solver(in_parts(model, parts=0), name="parts", shape="kernels")
    states = random_states(model, 4, seed=9)
    known = whole.error(model, states, tmp_path, "--check")
    assert solver.error(model, states, tmp_path, "--check") < max(1e-12, 20 * known)


def driven(model: Model) -> Model:
    """Return a robot with dampers, springs and rotors at its joints."""
    joints = tuple(
        replace(
            joint,
            passive=Passive(damping=0.1, stiffness=0.4 * (j % 2), rotor_inertia=0.02 * (j % 3)),
        )
        for j, joint in enumerate(model.joints)
    )
    return replace(model, joints=joints)


def test_passive_forces_and_rotors_act_in_parts(builder: Builder, tmp_path: Path) -> None:
    model = driven(hinges(27, seed=8))
    plan = in_parts(model)
    assert "inward_in_parts<" in kernels_of(plan)
    solver = builder.solver(plan, name="parts", shape="kernels")
    assert solver.error(model, random_states(model, 4, seed=6), tmp_path, "--check") < 1e-11


@pytest.mark.parametrize("processes", [1, slow(2)])
def test_a_batch_is_solved_state_by_state(processes: int, builder: Builder, tmp_path: Path) -> None:
    """Lanes are for parts; the head says so."""
    model = hinges(30, seed=11)
    plan = in_parts(model)
    assert "#define ADAGEN_STATE_BY_STATE" in text_of(plan, batch=processes)
    assert "one after the other" in text_of(plan, batch=processes)
    solver = builder.solver(plan, name="parts", batch=processes)
    states = random_states(model, 11, seed=10)
    assert solver.error(model, states, tmp_path, "--check") < 1e-11


def test_straight_lines_join_the_same_parts(builder: Builder, tmp_path: Path) -> None:
    model = hinges(24, seed=9)
    solver = builder.solver(in_parts(model), name="parts", shape="unrolled")
    assert solver.error(model, random_states(model, 4, seed=7), tmp_path, "--check") < 1e-11


@pytest.mark.parametrize("processes", [2, slow(3)])
def test_each_of_several_processes_parts_its_own(
    processes: int, builder: Builder, tmp_path: Path
) -> None:
    model = hinges(40 * processes, seed=processes)
    plan = in_parts(model, processes, meeting="exchange")
    text = kernels_of(plan)
    assert text.count(" = inward_in_parts<") == processes
    solver = builder.solver(plan, name="parts", shape="kernels")
    assert solver.error(model, random_states(model, 4, seed=8), tmp_path, "--check") < 1e-11


@pytest.mark.parametrize(
    ("kind", "processes"),
    spread([("floating", 1), ("floating", 2), ("prismatic", 1), ("planar", 2)], 2),
)
def test_chains_that_hang_on_another_joint_part_their_hinges(
    kind: str, processes: int, builder: Builder, tmp_path: Path
) -> None:
    model = hung(kind, 40 * processes, seed=processes)
    plan = in_parts(model, processes, meeting="exchange" if processes > 1 else "join")
    assert kernels_of(plan).count(" = inward_in_parts<") == processes
    solver = builder.solver(plan, name="parts", shape="kernels")
    assert solver.error(model, random_states(model, 4, seed=8), tmp_path, "--check") < 1e-11
