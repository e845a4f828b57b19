"""Emitted programs that join several joints as one, and what they say near gimbal lock."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from adagen.emit import program_of
from adagen.model import Inertia, Mimic, Model
from adagen.model.kinds import FLOATING, PLANAR, REVOLUTE, SPHERICAL, JointKind
from adagen.plan import Plan, make_plan
from adagen.plan.clusters import fold_of
from adagen.plan.steps import FusedJoin
from adagen.schedule import load_profile
from adagen.search import named_schedule
from adagen.states import States, random_states, write_states
from tests.emitted import ROUNDING, Builder, energy_errors
from tests.models import AXES, Part, assemble, rod, three_axis_chain, vector
from tests.slow import slow

PROFILE = load_profile("default")


def balanced(model: Model, processes: int, form: str) -> Plan:
    """Return a plan that joins runs of joints as one."""
    seen = fold_of(model, form)
    found = named_schedule("balanced", seen.topology, processes, profile=PROFILE)
    plan = make_plan(model, seen.unfold(found, PROFILE), form=form)
    assert any(isinstance(step, FusedJoin) for p in plan.processes for step in p.steps)
    return plan


def slaved_chain() -> Model:
    """Return three balls of three axes, two of which follow others."""
    model = three_axis_chain(3)
    joints = list(model.joints)
    joints[4] = replace(joints[4], mimic=Mimic(1, -0.5, 0.3))
    joints[8] = replace(joints[8], mimic=Mimic(6, 1.5, 0.1))
    return replace(model, joints=tuple(joints))


@pytest.mark.parametrize(
    ("model", "form", "processes"),
    [
        (three_axis_chain(4), "ada", 1),
        (three_axis_chain(4), "segment", 3),
        slow(slaved_chain(), "ada", 2),
    ],
    ids=["ada", "cuts of form segment", "slaved"],
)
def test_runs_are_solved(
    model: Model, form: str, processes: int, builder: Builder, tmp_path: Path
) -> None:
    solver = builder.solver(balanced(model, processes, form), name="runs")
    states = random_states(model, 4, seed=9)
    assert solver.error(model, states, tmp_path, "--check") < ROUNDING["double"]


def wrists(*kinds: JointKind) -> Model:
    """Return four joints, of the kinds in turn, each before three axes and two massless links."""
    step, parts = vector(0.3, 0.0, 0.0), list[Part]()
    for i in range(4):
        for k, axis in enumerate("-xyz"):
            body = rod(1.0, step) if k in (0, 3) else Inertia.zero()
            above = parts[-1].name if parts else None
            place = step if k < 2 and parts else np.zeros(3)
            kind = kinds[i % len(kinds)] if k == 0 else REVOLUTE
            turns = vector(*AXES["z" if k == 0 else axis])
            parts.append(Part(f"w{i}{axis}", above, kind, body, place, axis=turns))
    return assemble("wrists", parts)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("model", "processes", "scalar", "more"),
    [
        pytest.param(three_axis_chain(4), 2, "double", 1, marks=pytest.mark.slow),
        slow(three_axis_chain(8), 3, "float", 1),
        pytest.param(slaved_chain(), 2, "double", 1, marks=pytest.mark.slow),
        (wrists(SPHERICAL, PLANAR), 3, "double", 1),
        slow(wrists(FLOATING), 3, "double", 10),
    ],
    ids=["chain", "long chain", "slaved", "spherical and planar", "floating"],
)
def test_loops_join_runs(
    model: Model, processes: int, scalar: str, more: int, builder: Builder, tmp_path: Path
) -> None:
    """Mobilities get to the runs across joints of all kinds. Free bodies magnify rounding."""
    plan = replace(balanced(model, processes, "segment"), scalar=scalar)
    solver = builder.solver(plan, name="runs", shape="kernels")
    states = random_states(model, 4, seed=9)
    assert solver.error(model, states, tmp_path, "--check") < more * ROUNDING[scalar]


@pytest.mark.slow
def test_loops_refine_runs(builder: Builder, tmp_path: Path) -> None:
    model = three_axis_chain(4)
    plan = balanced(model, 2, "segment")
    solver = builder.solver(plan, name="runs", refine=3)
    assert program_of(plan, refine=3).shape == "kernels"
    states = random_states(model, 4, seed=3)
    assert energy_errors(model, states, solver.solve(model, states, tmp_path)).max() < 1e-14
    said = np.array(json.loads((tmp_path / "result.json").read_text())["corrections"])
    assert (said[:, 1] < 1e-2 * said[:, 0]).all()


def tilted(model: Model, angle: float) -> States:
    """Return a state in which the second ball is an angle away from gimbal lock."""
    states = random_states(model, 1, seed=1)
    q = states.q.copy()
    q[:, 4] = np.pi / 2 + angle
    return replace(states, q=q)


@pytest.mark.parametrize(
    ("form", "shape", "balls"),
    [slow("ada", "joints", 2), ("ada", "unrolled", 2), slow("segment", "kernels", 4)],
)
def test_gimbal_lock_is_told(
    form: str, shape: str, balls: int, builder: Builder, tmp_path: Path
) -> None:
    model = three_axis_chain(balls)
    solver = builder.solver(balanced(model, 2, form), name="runs", shape=shape)
    names = 'joints "b01x", "b01y", "b01z": '
    given, result = tmp_path / "s.json", tmp_path / "r.json"
    write_states(tilted(model, 0.0), model, given)
    done = solver.run("--states", given, "--result", result)
    assert (done.status, done.stdout) == (1, "")
    assert f"state 1: {names}gimbal lock" in done.stderr
    assert not result.exists()
    near = tilted(model, 1e-4)
    write_states(near, model, given)
    done = solver.run("--states", given, "--result", result, "--json")
    assert done.status == 0
    assert done.stderr.splitlines() == [f"warning: {json.loads(done.stdout)['warnings'][0]}"]
    assert f"warning: {names}near gimbal lock" in done.stderr
    write_states(tilted(model, 0.1), model, given)
    done = solver.run("--states", given, "--result", result, "--json")
    assert (done.status, done.stderr) == (0, "")
    assert "warnings" not in json.loads(done.stdout)
