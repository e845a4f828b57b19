"""What --check says is at fault: the solver, conditioning or the model."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.emit.runtime import joined
from adagen.model import REVOLUTE, SPHERICAL, Inertia, Link, Model
from adagen.reference import exact_forward_dynamics, inverse_dynamics
from adagen.states import random_states, write_states
from adagen.studies.stability import robots
from tests.emitted import QUICK, Builder, Solver, plan_of, text_of
from tests.models import (
    Part,
    assemble,
    human_figure,
    motion_capture_figure,
    rod,
    serial_chain,
    vector,
)
from tests.slow import slow, spread

ILL: dict[str, Callable[[], Model]] = {
    "a light link": lambda: robots.with_mass(30, 15, 1e-8),
    "masses graded by 1e8": lambda: robots.graded(30, 1e8),
    "a tip of 1e8 kg": lambda: robots.with_mass(30, 30, 1e8),
    "a chain of 200": lambda: robots.rods(200),
    "a coil of 100": lambda: robots.coil(100),
    "a figure of motion capture": motion_capture_figure,
}


def verdict(solver: Solver, *words: str | Path) -> dict[str, Any]:
    """Return what --check of a solver says, its exit status by the name of "status"."""
    done = solver.run("--check", "--json", *words)
    told = json.loads(done.stdout)["check"]
    assert isinstance(told, dict)
    return told | {"status": done.status}


def spoilt(text: str, entry: int, factor: float) -> str:
    """Return the source of a solver that answers another acceleration at an entry of qdd."""
    told = f"qdd[{entry}] *= Number({factor!r});"
    text, count = re.subn(
        r"(    run\(\);\n)(    return finish\(w\.status\);)", rf"\1    {told}\n\2", joined(text)
    )
    assert count >= 1
    return text


@pytest.mark.parametrize(
    ("robot", "shape"),
    [
        *spread([(robot, "kernels") for robot in ILL], 2),
        *spread([(robot, "unrolled") for robot in ILL if robot != "a chain of 200"], 1),
    ],
)
def test_a_right_solver_is_right_on_ill_conditioned_robots(
    robot: str, shape: str, builder: Builder
) -> None:
    model = ILL[robot]()
    solver = builder.solver(plan_of(model, 1), QUICK, shape=shape)
    told = verdict(solver)
    assert (told["status"], told["ok"]) == (0, True)
    assert told["backward_error_max"] < 1e-14
    assert told["fault"] in (None, "conditioning")


@pytest.mark.parametrize("robot", spread(ILL, 3))
def test_a_spoilt_solver_is_wrong_there_and_its_joint_is_named(
    robot: str, builder: Builder
) -> None:
    model = ILL[robot]()
    plan = plan_of(model, 1)
    joint = len(model.joints) // 2
    text = spoilt(text_of(plan, shape="kernels"), model.v_start[joint], 1 + 1e-5)
    program = builder.compile(text, "spoilt_p1", QUICK)
    told = verdict(Solver(program, 1, builder.toolchain))
    assert (told["status"], told["ok"], told["fault"]) == (1, False, "solver")
    assert told["joint"] == model.joints[joint].name


@pytest.mark.parametrize("scalar", ["double", "float"])
def test_well_conditioned_robots_keep_their_digits(scalar: str, builder: Builder) -> None:
    solver = builder.solver(plan_of(human_figure(), 1, scalar=scalar), QUICK)
    told = verdict(solver)
    assert (told["status"], told["fault"]) == (0, None)
    assert told["digits"] > (13 if scalar == "double" else 4.5)


def test_digits_that_are_sure_are_right(builder: Builder, tmp_path: Path) -> None:
    model = motion_capture_figure()
    states = random_states(model, 5, seed=3)
    solver = builder.solver(plan_of(model, 1), QUICK, shape="kernels")
    found = solver.solve(model, states, tmp_path)
    told = verdict(solver, "--states", tmp_path / "states.json", "--result", tmp_path / "r.json")
    truth = [exact_forward_dynamics(model, *row).value for row in states.each]
    errors = [
        np.abs(x - t).max() / np.abs(t).max() for x, t in zip(found, np.array(truth), strict=True)
    ]
    assert max(errors) < 3 * told["forward_error"] < 1e-3


def test_conditioning_is_a_warning_with_the_digits_that_are_left(builder: Builder) -> None:
    solver = builder.solver(plan_of(robots.with_mass(30, 30, 1e12), 1), QUICK)
    told = verdict(solver)
    assert (told["status"], told["ok"], told["fault"]) == (0, True, "conditioning")
    assert 2 < told["digits"] < 6
    said = solver.run("--check").stdout
    name = re.escape(json.dumps(told["joint"]))
    place = f"state {told['state']}, joint {name}"
    assert re.search(rf"check  [\d.]+ digits of the accelerations are certain: {place}\n", said)
    assert "the robot is ill-conditioned there" in said


def test_digits_that_loops_lose_are_told(builder: Builder, tmp_path: Path) -> None:
    light = Inertia(1e-6, np.zeros(3), np.eye(3) * 1e-12)
    place = vector(0.0, 0.0, 0.3)
    parts = [
        Part("ball", None, SPHERICAL, light),
        Part("along", "ball", REVOLUTE, rod(1.0, place), axis=vector(0.0, 0.0, 1.0)),
        Part("across", "along", REVOLUTE, rod(1.0, place), place, axis=vector(0.0, 1.0, 0.0)),
    ]
    model = assemble("ball", parts)
    loops = builder.solver(plan_of(model, 1), QUICK, shape="kernels")
    line = verdict(builder.solver(plan_of(model, 1), QUICK, shape="unrolled"))
    told, states = verdict(loops), random_states(model, 5, seed=1)
    assert (told["status"], line["status"], line["fault"]) == (0, 0, None)
    assert line["digits"] > 10
    assert loops.error(model, states, tmp_path) < 10 * told["forward_error"]
    if told["fault"] is not None:
        assert "another shape, or --refine, may keep some more" in loops.run("--check").stdout


def test_a_link_that_no_body_is_is_the_models_fault(builder: Builder) -> None:
    model = serial_chain(4)
    links = list(model.links)
    none = Inertia(0.5, np.array([0.1, 0.0, 0.0]), np.diag([1e-4, 1e-4, 1.0]) - np.eye(3) * 2e-2)
    links[3] = Link(links[3].name, none)
    plan = plan_of(replace(model, links=tuple(links)), 1)
    done = builder.solver(plan, QUICK).run("--check")
    assert done.status == 1
    assert "factorization failed" in done.stderr
    assert 'the link that joint "j002" moves has an inertia that no real body has' in done.stderr


def test_batches_and_processes_are_judged_alike(builder: Builder) -> None:
    model = robots.with_mass(12, 6, 1e-6)
    many = verdict(builder.solver(plan_of(model, 1), QUICK, batch=2))
    two = verdict(builder.solver(plan_of(model, 2), QUICK))
    for told in (many, two):
        assert (told["status"], told["fault"]) == (0, None)
        assert told["backward_error_max"] < 1e-10
    assert many["digits"] > 13
    assert 7 < two["digits"] < many["digits"]  # they meet beside the light link


def heavy_tip(links: int) -> Model:
    """Return rods of 1 g with a tip of 1000 kg."""
    inertias = [robots.rod(1e-3, 0.2)] * (links - 1) + [robots.rod(1e3, 0.2)]
    return robots.chain("heavy tip", inertias, lengths=[0.2] * links)


@pytest.mark.parametrize("factor", [None, slow(1 + 1e-5)])
def test_a_large_backward_error_is_excused_by_conditioning_alone(
    factor: float | None, builder: Builder, tmp_path: Path
) -> None:
    """Torques of slow motions: the forces of the tip are huge beside what they leave over."""
    model = heavy_tip(32)
    states = random_states(model, 10, seed=1)
    calm = np.random.default_rng(1).uniform(-3, 3, (10, model.nv))
    torques = [inverse_dynamics(model, *row) for row in zip(states.q, states.v, calm, strict=True)]
    states = replace(states, tau=np.array(torques))
    text = text_of(plan_of(model, 2), shape="kernels")
    if factor is not None:
        text = spoilt(text, 3, factor)
    solver = Solver(builder.compile(text, "heavy_p2", QUICK), 2, builder.toolchain)
    write_states(states, model, tmp_path / "s.json")
    words = ("--states", tmp_path / "s.json", "--result", tmp_path / "r.json")
    told = verdict(solver, *words)
    assert told["backward_error_max"] > told["tolerance"]
    if factor is None:
        assert (told["status"], told["ok"], told["fault"]) == (0, True, "conditioning")
        assert solver.error(model, states, tmp_path) < 3 * told["forward_error"] < 3e-6
        assert (
            "last digits of the state move the accelerations as much"
            in solver.run("--check", *words).stdout
        )
    else:
        assert (told["status"], told["ok"], told["fault"]) == (1, False, "solver")
